// A fit of spectra without scatter: which bins it takes, and the errors that follow from their
// number, in closed form.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::spectra;
using Eigen::Index;

namespace {

constexpr double A = 3e-7, df = 8e-4;
constexpr Index rail = 105;  // the bin of its line

double at(Index k) {
  return df * static_cast<double>(k);
}

Spectrum spectrum(double averages, const TrackParameters& track = {.A = A}, Index last = 1024) {
  Spectrum s;
  s.df = df, s.averages = averages, s.band_variance = 2.5 / averages;
  s.noise_bandwidth = 1.5 * df, s.segments = 9;
  s.density = Eigen::VectorXd::Zero(last + 1);
  for (Index k = 1; k <= last; ++k) s.density[k] = random_psd(track, s.frequency(k));
  return s;
}

FitOptions one_slope() {
  return {.rail_length = 1 / (rail * df), .slopes = Slopes::one};
}

// psi(n) - ln n and psi'(n) of a whole number.
double log_bias(double n) {
  double psi = -0.577215664901532861;
  for (int k = 1; k < n; ++k) psi += 1.0 / k;
  return psi - std::log(n);
}
double log_variance(double n) {
  double sum = units::pi * units::pi / 6;
  for (int k = 1; k < n; ++k) sum -= 1.0 / (k * k);
  return sum;
}

// The bins of a band that are not left out.
std::vector<Index> taken(const FitOptions& o, double low, double high) {
  std::vector<Index> bins;
  for (Index k = 1; at(k) <= high; ++k)
    if (at(k) >= low && !masked(o, at(k))) bins.push_back(k);
  return bins;
}

}  // namespace

TEST_CASE("unit: a fit takes the bins of its band from the fourth on to 0.95 of the Nyquist one") {
  for (const auto& [low, high] : {std::pair{0.01, 0.5}, {1e-5, 0.5}, {0.01, 9.0}, {0.0031, 0.3}}) {
    FitOptions o = one_slope();
    o.low = low, o.high = high;
    const auto fit = fit_track_spectrum(spectrum(10), o);
    CAPTURE(low, high);
    CHECK(fit.bins ==
          std::ssize(taken(o, std::max(low, 3.99 * df), std::min(high, 0.95 * 1024 * df))));
  }
}

TEST_CASE("unit: roughness is free of the logarithm's bias, and its error that of so many bins") {
  for (const int K : {2, 10, 40}) {
    const FitOptions o = one_slope();
    auto s = spectrum(K);
    for (Index k = 1; k <= 1024; ++k) s.density[k] *= std::exp(k % 2 == 0 ? 0.3 : -0.3);
    const auto bins = taken(o, 0.01, 0.95 * 1024 * df);
    const auto N = static_cast<double>(bins.size());
    double mean = 0;
    for (const Index k : bins) mean += (k % 2 == 0 ? 0.3 : -0.3) / N;
    const auto fit = fit_track_spectrum(s, o);
    CAPTURE(K);
    CHECK(std::log(fit.A.value / A) == Approx(mean - log_bias(K)).epsilon(1e-10));
    CHECK(fit.A.error == Approx(fit.A.value * std::sqrt(log_variance(K) * 2.5 / N)).epsilon(1e-9));
    CHECK(fit.misfit == Approx(std::sqrt((0.09 - mean * mean) / log_variance(K))).epsilon(1e-9));
    CHECK(fit.corner == CornerState::none);
    CHECK(fit.phi_c.value == 0);
    CHECK(fit.parameters().phi_c == no_corner);
  }
}

TEST_CASE("unit: twelfths of an octave are means of phi^2 S, each with the averages of its bins") {
  FitOptions o = one_slope();
  o.averaging = Averaging::bands, o.low = 0.0104;
  constexpr int K = 10;  // four bins are as good as one segment's ten averages, and one more each
  std::vector<double> averages;
  int band = -1, count = 0;
  const auto close = [&] {
    if (count > 0) averages.push_back(std::max<double>(K, 4 * count));
    count = 0;
  };
  for (const Index k : taken(o, o.low, 0.95 * 1024 * df)) {
    const int here = static_cast<int>(std::floor(12 * std::log2(at(k) / o.low)));
    if (here != band) close();
    band = here, ++count;
  }
  close();
  double weight = 0, bias = 0;
  for (const double n : averages) weight += n, bias += n * log_bias(n);
  const auto fit = fit_track_spectrum(spectrum(K), o);
  CHECK(fit.bins == std::ssize(averages));
  CHECK(std::log(fit.A.value / A) == Approx(-bias / weight).epsilon(1e-9));
  CHECK(fit.A.error == Approx(fit.A.value / std::sqrt(weight)).epsilon(1e-9));
}

TEST_CASE("unit: a corner is fitted from 3 times the first bin to half of the last, less 3 %") {
  const double first = 13 * df, end = std::floor(0.95 * 1024) * df;  // of the band from 0.01 on
  FitOptions o = one_slope();
  o.slopes = Slopes::two;
  for (const double share : {0.9, 1.0, 1.02, 1.04, 1.1}) {
    const auto low = fit_track_spectrum(spectrum(1e9, {.A = A, .phi_c = 3 * first * share}), o);
    const auto high = fit_track_spectrum(spectrum(1e9, {.A = A, .phi_c = 0.5 * end / share}), o);
    CAPTURE(share);
    CHECK(low.corner == (share < 1.03 ? CornerState::at_low_bound : CornerState::fitted));
    CHECK(high.corner == (share < 1.03 ? CornerState::at_high_bound : CornerState::fitted));
    const double steep = A * std::pow(3 * first * share, 2);
    CHECK(low.steep.value == Approx(steep).epsilon(1e-6));
    CHECK(high.A.value == Approx(A).epsilon(1e-6));
    CHECK(high.parameters().phi_c == high.phi_c.value);
    if (share < 1.03) continue;
    CHECK(low.phi_c.value == Approx(3 * first * share).epsilon(1e-6));
    CHECK(high.phi_c.value == Approx(0.5 * end / share).epsilon(1e-6));
  }
}

TEST_CASE("unit: the errors of a corner and of its steep part are those of the straight lines") {
  // Left of the corner ln A is the mean of n bins, right of it ln A + 2 ln phi_c that of m: as if
  // each were fitted alone.
  FitOptions o = one_slope();
  o.slopes = Slopes::two;
  const double phi_c = 0.2502;
  const auto fit = fit_track_spectrum(spectrum(10, {.A = A, .phi_c = phi_c}), o);
  double n = 0, m = 0;
  for (const Index k : taken(o, 0.01, 0.95 * 1024 * df)) ++(at(k) < phi_c ? n : m);
  const double unit = log_variance(10) * 2.5;
  CHECK(fit.phi_c.value == Approx(phi_c).epsilon(1e-9));
  CHECK(fit.A.error == Approx(fit.A.value * std::sqrt(unit / n)).epsilon(1e-9));
  CHECK(fit.steep.value == Approx(fit.A.value * phi_c * phi_c).epsilon(1e-9));
  CHECK(fit.steep.error == Approx(fit.steep.value * std::sqrt(unit / m)).epsilon(1e-9));
  CHECK(fit.phi_c.error == Approx(phi_c * 0.5 * std::sqrt(unit / n + unit / m)).epsilon(1e-9));
}

TEST_CASE("unit: a floor is taken in where it betters the fit by four standard errors") {
  FitOptions o = one_slope();
  int taken_in = 0;
  for (int k = 0; k < 40; ++k) {
    const auto s = spectrum(10, {.A = A, .noise = 5e-8 * std::pow(1.04, k)});
    o.noise = NoiseModel::none;
    const double plain = fit_track_spectrum(s, o).regression.squares;
    o.noise = NoiseModel::fitted;
    const auto with = fit_track_spectrum(s, o);
    o.noise = NoiseModel::automatic;
    const auto chosen = fit_track_spectrum(s, o);
    const double gain = (plain - with.regression.squares) / (log_variance(10) * 2.5);
    CAPTURE(k, gain);
    CHECK(chosen.noise.value == (gain > 16 ? with.noise.value : 0));
    CHECK(with.noise.value * std::exp(log_bias(10)) ==
          Approx(5e-8 * std::pow(1.04, k)).epsilon(1e-3));
    taken_in += gain > 16 ? 1 : 0;
  }
  CHECK(taken_in > 5);
  CHECK(taken_in < 35);
}

namespace {

// What is put above the random part on the bins from `first` on, as shares of a density.
struct Raised {
  Index first;
  std::vector<double> share;
  double density;
};

}  // namespace

TEST_CASE(
    "unit: a line is the power within its half width, with the scatter of what it stands on") {
  for (const int K : {10, 400})
    for (const double times : {0.05, 0.3, 1.0, 40.0})
      for (const bool broad : {false, true}) {
        FitOptions o = one_slope();
        o.line_half_width = 24.75 * df;
        auto s = spectrum(K);
        const double bias = std::exp(-log_bias(K)), top = times * A / std::pow(rail * df, 2);
        const std::vector<double> shape =
            broad ? std::vector{0.2, 0.6, 1.0, 0.8, 0.3} : std::vector{0.0, 0.0, 1.0, 0.0, 0.0};
        // The fitted model stands above the one put there by the bias of the logarithm.
        std::vector<double> model, excess;
        for (Index k = 81; k <= 129; ++k) {
          model.push_back(bias * A / std::pow(at(k), 2));
          const bool on = k >= rail - 2 && k <= rail + 2;
          excess.push_back(on ? top * shape[static_cast<std::size_t>(k - rail + 2)] : 0);
          s.density[k] = model.back() + excess.back();
        }
        const auto fit = fit_track_spectrum(s, o);
        double Q = 0, g = 0, squares = 0, beat = 0, own = 0;
        for (std::size_t i = 0; i < model.size(); ++i) {
          Q += excess[i] * df, g += model[i] * df;
          squares += model[i] * model[i], beat += model[i] * excess[i],
              own += excess[i] * excess[i];
        }
        const double cell = s.band_variance * df * df;
        const double slope = log_variance(K) * 2.5 / static_cast<double>(fit.bins);
        const double chance = cell * squares + g * g * slope;
        const double all = chance + 2 * cell * beat + (broad ? cell * own : 0);
        CAPTURE(K, times, broad);
        CHECK(fit.Q_1.value == Approx(Q).epsilon(1e-9));
        CHECK(fit.Q_1.error == Approx(std::sqrt(all)).epsilon(1e-9));
        CHECK(fit.A_Q_covariance == Approx(-fit.A.value * slope * g).epsilon(1e-9));
        CHECK(fit.C_1 == Approx(top).epsilon(1e-9));
        CHECK(fit.beta == Approx(Q / top).epsilon(1e-9));
        CHECK(fit.half_width == Approx((broad ? 1.25 + 1.6 : 1) * df).epsilon(1e-6));
        const double limit = 1.645 * std::sqrt(chance);
        const auto dip = [](double q) { return 3 * units::pi * std::sqrt(q / 2); };
        CHECK(fit.line_significant == (Q > limit));
        CHECK(fit.B_threshold == Approx(dip(limit)).epsilon(1e-9));
        CHECK(fit.B_printed.value == Approx(dip(Q)).epsilon(1e-9));
        const double error =
            Q > std::sqrt(all) ? 0.5 * dip(Q) * std::sqrt(all) / Q : dip(std::sqrt(all));
        CHECK(fit.B_printed.error == Approx(error).epsilon(1e-9));
        CHECK(fit.B_exact.value == Approx(0.5 * dip(Q)).epsilon(1e-9));
        CHECK(fit.B_exact.error == Approx(0.5 * error).epsilon(1e-9));
      }
}

TEST_CASE("unit: a line as wide as what is summed is taken to end beside it") {
  for (const int beside : {0, 1, 2}) {  // bins to either side, as high as the middle one
    FitOptions o = one_slope();
    o.line_half_width = (beside + 0.5) * df;
    auto s = spectrum(1e9);
    for (Index k = rail - beside; k <= rail + beside; ++k)
      s.density[k] = 2 * A / std::pow(rail * df, 2) + random_psd({.A = A}, at(k));
    CHECK(fit_track_spectrum(s, o).half_width == Approx((2 * beside + 1) * df).epsilon(1e-6));
  }
}

TEST_CASE("unit: a line below what it stands on has no dip, no peak and no width") {
  auto s = spectrum(1000);
  for (Index k = 81; k <= 129; ++k) s.density[k] *= 0.5;
  const auto fit = fit_track_spectrum(s, one_slope());
  CHECK(fit.Q_1.value < 0);
  for (const double none : {fit.C_1, fit.beta, fit.half_width, fit.B_printed.value})
    CHECK(none == 0);
  CHECK(fit.B_printed.error > 0);
  CHECK_FALSE(fit.line_significant);
}

TEST_CASE("unit: from a chord's offsets come the profile's own numbers") {
  FitOptions o = one_slope();
  auto s = spectrum(1e9);
  s.density[rail] += 1e-3;
  const auto profile = fit_track_spectrum(s, o);
  o.chord = 7;
  for (Index k = 0; k < s.density.size(); ++k) s.density[k] *= squared_gain(7, s.frequency(k));
  for (const auto averaging : {Averaging::bins, Averaging::bands}) {
    o.averaging = averaging;
    const auto offsets = fit_track_spectrum(s, o);
    CHECK(offsets.A.value == Approx(profile.A.value).epsilon(1e-6));
    CHECK(offsets.Q_1.value == Approx(profile.Q_1.value).epsilon(1e-6));
  }
}

TEST_CASE("unit: how few bins, how near an end of the band and how long a chord a fit takes") {
  const auto fits = [](auto&& change) {
    FitOptions o = one_slope();
    o.line_half_width = 0.5 * df;  // the line is one bin
    change(o);
    try {
      fit_track_spectrum(spectrum(10), o);
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  for (const int more : {6, 7, 8, 9})  // bins beside the line
    CHECK(fits([&](FitOptions& o) {
            o.low = (rail - 2.5) * df, o.high = (rail + more - 1.5) * df;
          }) == (more >= 8));
  for (const double away : {0.9, 1.1}) {
    CHECK(fits([&](FitOptions& o) { o.low = (rail - away) * df; }) == (away > 1));
    CHECK(fits([&](FitOptions& o) { o.high = (rail + away) * df; }) == (away > 1));
  }
  for (const double share : {0.1243, 0.1257})
    CHECK(fits([&](FitOptions& o) { o.chord = share / df, o.rail_length = share / df / 13; }) ==
          (share < 0.125));
}

TEST_CASE("unit: scattered dips raise A by the mean of what they add over the bins of the fit") {
  FitOptions o = one_slope();
  for (const double low : {0.01, 1e-4}) {
    o.low = low;
    const auto s = spectrum(1e9);
    auto fit = fit_track_spectrum(s, o);
    fit.B_exact.value = 0.008;
    double sum = 0;
    const auto bins = taken(o, std::max(low, 3.99 * df), 0.95 * 1024 * df);
    for (const Index k : bins) {
      // Of independent dips: 2 m^2 B^2 l |D|^2, over the random part.
      const double nu = at(k) * o.rail_length;
      const double added = 2 * std::pow(0.3 * 0.008 * dip_transform(nu), 2) * o.rail_length;
      sum += std::log1p(added / (fit.A.value / std::pow(at(k), 2)));
    }
    CHECK(scatter_bias(s, o, fit, 0.3) ==
          Approx(std::expm1(sum / static_cast<double>(bins.size()))).epsilon(1e-9));
  }
}

TEST_CASE("unit: another rail is named from 8 to 40 m where its line has twice the power") {
  // Lines of a power each, of Hann's shape on three bins, on a track of one slope.
  const auto named = [](Index bin, double power, double own, double chord = 0) {
    auto s = spectrum(100);
    const auto line = [&](Index k, double q) {
      s.density[k] += q / df * 2 / 3;
      s.density[k - 1] += q / df / 6, s.density[k + 1] += q / df / 6;
    };
    line(bin, power), line(rail, own);
    FitOptions o = one_slope();
    o.chord = chord;
    if (chord > 0)
      for (Index k = 0; k < s.density.size(); ++k)
        s.density[k] *= squared_gain(chord, s.frequency(k));
    return contradicting_rail(s, o, fit_track_spectrum(s, o)).value_or(0);
  };
  const double Q = 2e-5;
  for (const double share : {1.9, 2.1})
    CHECK(named(60, share * Q, Q) == Approx(share > 2 ? 1 / (60 * df) : 0).epsilon(2e-3));
  // A bin is 0.0008 cycles a metre; the line must be one within the limits.
  for (const Index bin : {32, 33, 34, 154, 155, 156}) {
    const bool within = at(bin) > 1 / 40.0 + df && at(bin) < 1 / 8.0 - df;
    const double found = named(bin, 5 * Q, 0);
    CAPTURE(bin, found);
    CHECK((std::abs(found * at(bin) - 1) < 5e-3) == within);
  }
}
