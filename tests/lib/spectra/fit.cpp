#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include <railbook/num/parallel.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using spectra::CornerState;

namespace {

// The spectrum a perfect measurement would give: no scatter, a Hann-shaped line of power q on the
// bins nearest phi_0.
spectra::Spectrum perfect(const spectra::TrackParameters& track, double averages,
                          Eigen::Index n = 2049) {
  spectra::Spectrum s;
  s.df = 1 / (4096 * units::foot);
  s.segments = static_cast<std::size_t>(averages);
  s.averages = averages;
  s.band_variance = 2.111 / averages;
  s.noise_bandwidth = 1.5 * s.df;
  s.density.resize(n);
  s.density[0] = 0;
  for (Eigen::Index k = 1; k < n; ++k) s.density[k] = spectra::random_psd(track, s.frequency(k));
  return s;
}

}  // namespace

TEST_CASE("unit: a perfect spectrum gives back its parameters") {
  for (const double phi_c : {0.05, 0.13, 0.18, 0.4}) {
    const auto s = perfect({.A = 2e-7, .phi_c = phi_c}, 1e12);
    const auto fit = spectra::fit_track_spectrum(s);
    CHECK(fit.A.value == Approx(2e-7).epsilon(1e-9));
    CHECK(fit.phi_c.value == Approx(phi_c).epsilon(1e-9));
    CHECK(fit.steep.value == Approx(2e-7 * phi_c * phi_c).epsilon(1e-9));
    CHECK(fit.corner == CornerState::fitted);
    CHECK(std::abs(fit.Q_1.value) < 1e-14);
    CHECK(fit.misfit < 1e-3);
  }
}

TEST_CASE("unit: without a rail no line is looked for, and none hides a bin") {
  const auto s = perfect({.A = 2e-7, .phi_c = 0.13}, 1e12);
  const spectra::FitOptions none{.rail_length = units::infinity};
  const auto fit = spectra::fit_track_spectrum(s, none), with = spectra::fit_track_spectrum(s);
  CHECK(fit.A.value == Approx(2e-7).epsilon(1e-9));
  CHECK(fit.bins > with.bins);
  CHECK(fit.B_printed.value == 0);
  CHECK_FALSE(fit.line_significant);
  CHECK_FALSE(spectra::contradicting_rail(s, none, fit).has_value());
  // A line is one that nobody named.
  auto lined = perfect({.A = 2e-7, .phi_c = 0.13}, 100);
  lined.density[300] *= 50;
  const auto seen = spectra::fit_track_spectrum(lined, none);
  const auto stray = spectra::stray_line(lined, none, seen);
  REQUIRE(stray.has_value());
  CHECK(stray->phi == Approx(lined.frequency(300)));
}

TEST_CASE("unit: a white floor is fitted when asked for, or when the data ask for it") {
  const spectra::TrackParameters track{.A = 5e-7, .phi_c = 0.13, .noise = 5.5e-8};
  const auto s = perfect(track, 1e8);
  for (const auto noise : {spectra::NoiseModel::fitted, spectra::NoiseModel::automatic}) {
    const auto fit = spectra::fit_track_spectrum(s, {.noise = noise});
    CHECK(fit.converged);
    CHECK(fit.A.value == Approx(5e-7).epsilon(1e-5));
    CHECK(fit.phi_c.value == Approx(0.13).epsilon(1e-5));
    CHECK(fit.noise.value == Approx(5.5e-8).epsilon(1e-5));
  }
  const auto without = spectra::fit_track_spectrum(s);
  CHECK(without.A.value < 0.5 * 5e-7);
  CHECK(without.misfit > 10);
  const auto clean = spectra::fit_track_spectrum(perfect({.A = 5e-7, .phi_c = 0.13}, 1e8),
                                                 {.noise = spectra::NoiseModel::automatic});
  CHECK(clean.noise.value == 0);
}

TEST_CASE("unit: the exact two-slope minimum is below every point of a fine grid") {
  std::mt19937_64 generator{9};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    spectra::LogPoints p{Eigen::ArrayXd::LinSpaced(60, std::log(0.01), std::log(1.0)),
                         Eigen::ArrayXd(60), Eigen::ArrayXd(60)};
    for (Eigen::Index i = 0; i < 60; ++i) {
      const double l = p.log_phi[i];
      p.log_density[i] =
          -15 - 2 * l + std::min(0.0, 2 * (std::log(0.13) - l)) + 0.5 * normal(generator);
      p.weight[i] = 0.5 + std::abs(normal(generator));
    }
    const auto fit = spectra::fit_two_slopes(p, 0.04, 0.5);
    double best = 1e300;
    for (double c = std::log(0.04); c <= std::log(0.5); c += 0.0005) {
      const Eigen::ArrayXd flat = p.log_density + 2 * p.log_phi - (2 * (c - p.log_phi)).min(0.0);
      const double a = (p.weight * flat).sum() / p.weight.sum();
      best = std::min(best, (p.weight * (flat - a).square()).sum());
    }
    CHECK(fit.squares <= best * (1 + 1e-12));
    CHECK(fit.squares == Approx(best).epsilon(1e-3));
  }
}

TEST_CASE("unit: scattered dips raise A by nearly the stated amount") {
  spectra::SyntheticTrack track{.A = 5e-7, .phi_c = 0.13, .dip = 0.011};
  double A[2];
  double said = 0;
  for (const double scatter : {0.0, 0.2}) {
    track.dip_scatter = scatter;
    const auto spectrum = spectra::welch(spectra::synthesize(track, 1'300'000), track.spacing);
    const auto fit = spectra::fit_track_spectrum(spectrum);
    if (scatter > 0) said = spectra::scatter_bias(spectrum, {}, fit, scatter);
    A[scatter > 0 ? 1 : 0] = fit.A.value;
  }
  CHECK(said > 0.03);
  CHECK(A[1] / A[0] - 1 == Approx(said).margin(0.012));  // two standard errors
}

TEST_CASE("unit: a fit that is asked for nothing looks for 39 ft from 0.01 to 1.2 cycles a metre") {
  const spectra::FitOptions none;
  CHECK(none.rail_length == Approx(39 * 0.3048).epsilon(1e-15));
  CHECK(none.low == 0.01);
  CHECK(none.high == 1.2);
  CHECK(none.chord == 0);
  CHECK(none.least_gain == 0.1);
  CHECK(none.line_half_width == 0.02);
  CHECK(none.foreign_lengths.empty());
  CHECK(none.slopes == spectra::Slopes::two);
  CHECK(none.noise == spectra::NoiseModel::none);
  CHECK(none.averaging == spectra::Averaging::bins);
}

namespace {

spectra::SyntheticTrack zone(double A, double phi_c, double B_printed, std::uint64_t seed) {
  spectra::SyntheticTrack track;
  track.seed = seed;
  track.A = A;
  track.phi_c = phi_c;
  track.dip = spectra::convert_dip(B_printed, spectra::LineConvention::printed,
                                   spectra::LineConvention::exact_one_sided);
  return track;
}

struct Scatter {
  double sum = 0, squares = 0, claimed = 0;
  int n = 0;
  void add(double value, double error) {
    sum += value;
    squares += value * value;
    claimed += error * error;
    ++n;
  }
  double mean() const { return sum / n; }
  double deviation() const { return std::sqrt((squares - sum * sum / n) / (n - 1)); }
  double claim() const { return std::sqrt(claimed / n); }
};

}  // namespace

// 80 records of 10 km: the mean must sit within 3.5 of its own standard errors of the truth, and
// the scatter within 25 % (3 standard errors of it) of what each fit claims.
TEST_CASE("property: estimates are unbiased and their claimed errors are their scatter") {
  struct Zone {
    double A, phi_c, B;
  };
  for (const auto [A, phi_c, B] : {Zone{5e-7, 0.13, 11e-3}, Zone{8e-7, 0.18, 25e-3}}) {
    for (const auto averaging : {spectra::Averaging::bins, spectra::Averaging::bands}) {
      Scatter a, c, q;
      const double Q = B * B * 2 / (9 * units::pi * units::pi);  // equation (2)
      for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        const auto record = spectra::synthesize(zone(A, phi_c, B, seed), 32808);
        const auto fit = spectra::fit_track_spectrum(spectra::welch(record, units::foot),
                                                     {.averaging = averaging});
        a.add(fit.A.value / A, fit.A.error / A);
        c.add(fit.phi_c.value / phi_c, fit.phi_c.error / phi_c);
        q.add(fit.Q_1.value / Q, fit.Q_1.error / Q);
      }
      for (const Scatter& s : {a, c, q}) {
        CHECK(std::abs(s.mean() - 1) < 3.5 * s.deviation() / std::sqrt(80.0) + 0.005);
        CHECK(s.deviation() / s.claim() == Approx(1).epsilon(0.25));
      }
    }
  }
}

TEST_CASE("property: without joints the line is found significant in 5 % of records") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    const auto record = spectra::synthesize(zone(2e-7, 0.13, 0, seed), 16404);
    if (spectra::fit_track_spectrum(spectra::welch(record, units::foot)).line_significant) ++found;
  }
  CHECK(found > 2);  // 12.5 expected, standard deviation 3.4
  CHECK(found < 26);
}

TEST_CASE("property: a line nobody named is found where it is, and none where there is none") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    auto track = zone(2e-7, 0.13, 8e-3, seed);
    const auto look = [&] {
      const auto spectrum = spectra::welch(spectra::synthesize(track, 40000), units::foot);
      return spectra::stray_line(spectrum, {}, spectra::fit_track_spectrum(spectrum));
    };
    if (look()) ++found;
    if (seed > 5) continue;
    track.memory_dip = 4e-3;
    const auto stray = look();
    REQUIRE(stray);
    CHECK(stray->phi == Approx(1 / (33 * units::foot)).margin(1e-3));
  }
  CHECK(found <= 1);  // one in 1000 expected
}

TEST_CASE("property: joints of random depth are not taken for a foreign line") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto track = zone(2e-7, 0.13, 8e-3, seed);
    track.dip_scatter = 1;
    track.dip_correlation = seed % 2 == 0 ? 0.0 : 0.5;
    const auto spectrum = spectra::welch(spectra::synthesize(track, 40000), units::foot);
    if (spectra::stray_line(spectrum, {}, spectra::fit_track_spectrum(spectrum))) ++found;
  }
  CHECK(found <= 2);
}

namespace {

spectra::SyntheticTrack base() {
  spectra::SyntheticTrack track;
  track.A = 5e-7;
  track.phi_c = 0.13;
  track.dip = 5.5e-3;
  return track;
}

spectra::SpectrumFit fit(const spectra::SyntheticTrack& track,
                         const spectra::FitOptions& options = {},
                         const spectra::WelchOptions& welch = {}) {
  const NoFpFault no_fault;
  auto record = spectra::synthesize(track, 500000);  // 152 km
  if (options.chord > 0)
    record = spectra::mid_chord_offsets(record, track.spacing, options.chord).offset;
  return spectra::fit_track_spectrum(spectra::welch(record, track.spacing, welch), options);
}

}  // namespace

TEST_CASE("extreme: a track of nothing but joints has its dip and no roughness") {
  auto track = base();
  track.A = 0;
  const auto f = fit(track);
  CHECK(f.A.value <= 1e-14);
  CHECK(f.B_exact.value == Approx(5.5e-3).epsilon(5e-3));
  CHECK(f.corner != CornerState::fitted);
}

TEST_CASE("extreme: corners out of the band leave the slope that can be seen") {
  auto track = base();
  for (const double phi_c : {0.005, 0.02}) {
    track.phi_c = phi_c;
    const auto f = fit(track);
    CHECK(f.corner == CornerState::at_low_bound);
    CHECK(f.steep.value == Approx(5e-7 * phi_c * phi_c).epsilon(0.01));
    CHECK(f.A.value < 5e-7);
  }
  for (const double phi_c : {0.8, spectra::no_corner}) {
    track.phi_c = phi_c;
    const auto f = fit(track);
    CHECK(f.corner == CornerState::at_high_bound);
    CHECK(f.A.value == Approx(5e-7).epsilon(0.01));
  }
  CHECK(fit(track, {.slopes = spectra::Slopes::one}).A.value == Approx(5e-7).epsilon(0.01));
}

TEST_CASE("extreme: sensor noise is distinguished from the track at any level") {
  auto track = base();
  for (const double sigma : {1e-5, 1e-4, 3e-4, 3e-3}) {
    track.sensor_noise = sigma;
    const auto f = fit(track, {.noise = spectra::NoiseModel::automatic});
    CHECK(std::abs(f.A.value / 5e-7 - 1) < 4 * f.A.error / 5e-7);
    CHECK(f.noise.value == Approx(2 * sigma * sigma * units::foot).epsilon(0.05).margin(1e-10));
    CHECK(f.misfit < 1.25);
  }
}

TEST_CASE("extreme: a chord's record gives the profile's parameters where the chord can see") {
  const auto f = fit(base(), {.chord = 62 * units::foot});
  CHECK(std::abs(f.A.value / 5e-7 - 1) < 0.02 + 4 * f.A.error / 5e-7);
  CHECK(f.phi_c.value == Approx(0.13).epsilon(0.02));
  CHECK(std::abs(f.B_exact.value - 5.5e-3) < 4 * f.B_exact.error);
}

TEST_CASE("extreme: a zero of the chord beside the rail's line does not make a dip of nothing") {
  const auto f =
      fit(base(), {.chord = 100 * units::foot});  // blind at 0.0656, the line is at 0.0841
  CHECK(std::abs(f.A.value / 5e-7 - 1) < 0.02 + 4 * f.A.error / 5e-7);
  CHECK(std::abs(f.B_exact.value - 5.5e-3) < 4 * f.B_exact.error);
}

TEST_CASE("extreme: the memory of old rails is kept out of the dip when it is named") {
  const spectra::FitOptions named{.foreign_lengths = {33 * units::foot}};
  auto track = base();
  track.memory_dip = 5e-3;
  CHECK(fit(track).B_exact.value > 7e-3);
  CHECK(std::abs(fit(track, named).B_exact.value - 5.5e-3) < 4 * fit(track, named).B_exact.error);
  track.memory_dip = 0;
  track.memory_modulation = 0.5;
  CHECK(fit(track).misfit > 1.25);
  CHECK(fit(track, named).misfit < 1.25);
  CHECK(std::abs(fit(track, named).B_exact.value - 5.5e-3) < 4 * fit(track, named).B_exact.error);
}

TEST_CASE("input: a fit refuses what cannot be fitted and says why") {
  spectra::SyntheticTrack track;
  track.A = 2e-7;
  const auto spectrum = spectra::welch(spectra::synthesize(track, 20000), units::foot);
  const auto refuses = [&](const spectra::FitOptions& options, const char* text) {
    CHECK_THROWS_WITH(spectra::fit_track_spectrum(spectrum, options), Catch::Contains(text));
    CHECK_THROWS_AS(spectra::fit_track_spectrum(spectrum, options), InputError);
  };
  refuses({.rail_length = 0}, "rail length");
  refuses({.rail_length = 500}, "rail wavenumber");
  refuses({.rail_length = 0.5}, "rail wavenumber");
  refuses({.low = 2, .high = 3}, "holds no usable bins");
  refuses({.low = -1}, "lower end of the band");
  refuses({.chord = -1}, "chord");
  refuses({.chord = 78 * units::foot}, "does not see a rail");
  refuses({.chord = 520 * units::foot}, "an eighth of a segment");
  for (const double foreign : {39., 78., 38.}) {  // the line of the rail itself would be left out
    INFO(foreign);
    refuses({.foreign_lengths = {foreign * units::foot}}, "have a line on that of the rail");
  }
  refuses({.foreign_lengths = {-1}}, "foreign rail length");
  const auto constant = spectra::welch(std::vector<double>(20000, 0.0), units::foot);
  CHECK_THROWS_WITH(spectra::fit_track_spectrum(constant), Catch::Contains("constant signal"));
  const auto coarse =
      spectra::welch(spectra::synthesize(track, 20000), units::foot, {.segment = 16});
  CHECK_THROWS_AS(spectra::fit_track_spectrum(coarse), InputError);
}

TEST_CASE(
    "unit: a rougher track takes from the line: their errors are correlated, and not beyond one") {
  const spectra::SyntheticTrack track{.A = 5e-7, .phi_c = 0.13, .dip = 0.011};
  const auto fit =
      spectra::fit_track_spectrum(spectra::welch(spectra::synthesize(track, 60000), track.spacing));
  CHECK(fit.A_Q_covariance < 0);
  CHECK(std::abs(fit.A_Q_covariance) < fit.A.error * fit.Q_1.error);
}
