// The accuracy that lib/spectra states of its model, estimates and fits, on seeded inputs over its
// range: in 80-bit arithmetic, by scans, and by how far estimates lie from the truth in units of
// the error they state.
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/records/places.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/log_regression.hpp>
#include <railbook/spectra/rail_line.hpp>
#include <railbook/spectra/synthetic_track.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::records;
using namespace railbook::spectra;
using namespace railbook::tests;

namespace {

// The distance from the nearest whole number, exactly.
Long turn(Long x) {
  return x - std::round(x);
}

double off(Long found, Long exact, Long scale) {
  return static_cast<double>(std::abs(found - exact) / scale);
}

}  // namespace

TEST_CASE("claim: dips, lines and the random part") {
  Claim sensitivity("spectra::rail_chord_sensitivity"), shape("spectra::dip_shape"),
      scatter("spectra::joint_scatter_psd"), sine("spectra::rectified_sine"),
      variance("spectra::rectified_sine_variance"), strength("spectra::line_strength"),
      power("spectra::line_power"), random("spectra::random_psd"),
      broad("spectra::broadened_line_power"), dip("spectra::dip_from_line_power"),
      convert("spectra::convert_dip"), gain("spectra::squared_gain");
  RandomStream draw(41);
  for (int k = 0; k < 1000; ++k) {
    const double L = draw.decades(0.1, 100), l = draw.decades(1, 100), B = draw.decades(1e-5, 1);
    sensitivity.error(off(rail_chord_sensitivity(L, l),
                          std::abs(std::sin(long_pi * Long{L} / (2 * Long{l}))), 1 + Long{L} / l));
    const double u = k % 2 == 0 ? draw(-0.5, 0.5) : 0.5 - draw.decades(1e-15, 0.5);
    const Long half = std::sin(long_pi / 2 * (0.5L - std::abs(Long{u})));
    shape.relative(dip_shape(u), 2 * half * half);
    const JointDips joints{l, B, draw(0, 0.4),
                           k % 2 == 0 ? draw(-0.9999, 0.9999) : 1 - draw.decades(1e-4, 1)};
    const double phi =
        (std::floor(draw(1, 8)) + (k % 3 == 0 ? draw(-0.5, 0.5) : draw.decades(1e-9, 0.1))) / l;
    const Long nu = static_cast<double>(phi * l), rho = joints.correlation;
    const Long s = std::sin(long_pi * turn(nu)),
               lift = joints.scatter * B * Long{dip_transform(phi * l)};
    scatter.relative(joint_scatter_psd(joints, phi), 2 * lift * lift * l * (1 - rho * rho) /
                                                         ((1 - rho) * (1 - rho) + 4 * rho * s * s));
    const double x = draw(-1e4, 1e4);
    sine.error(off(rectified_sine(x, l, B), B * std::abs(std::sin(long_pi * turn(Long{x} / l))),
                   B * (1 + std::abs(Long{x}) / l)));
    variance.relative(rectified_sine_variance(B), Long{B} * B * (0.5L - 4 / (long_pi * long_pi)));
    const int n = static_cast<int>(draw.decades(1, 2e9));
    const Long printed = 2 * Long{B} / (long_pi * (2 * Long(n) - 1) * (2 * Long(n) + 1));
    strength.relative(line_strength(n, B, LineConvention::printed), printed);
    strength.relative(line_strength(n, B, LineConvention::exact_one_sided), 2 * printed);
    power.relative(line_power(n, B, LineConvention::printed), printed * printed / 2);
    power.relative(line_power(n, B, LineConvention::exact_one_sided), 2 * printed * printed);
    const TrackParameters track{.A = draw.decades(1e-12, 1e-3),
                                .phi_c = k % 5 == 0 ? no_corner : draw.decades(1e-3, 10),
                                .noise = k % 2 == 0 ? 0 : draw.decades(1e-15, 1e-3)};
    const Long p = draw.decades(1e-6, 1e4), roll = std::min(Long{1}, track.phi_c / p);
    random.relative(random_psd(track, static_cast<double>(p)),
                    track.A * roll * roll / (p * p) + track.noise);
    broad.relative(broadened_line_power(L, l), Long{L} * l);
    const Long dip_printed = 3 * long_pi * std::sqrt(Long{B} / 2);
    dip.relative(dip_from_line_power(B, LineConvention::printed), dip_printed);
    dip.relative(dip_from_line_power(B, LineConvention::exact_one_sided), dip_printed / 2);
    convert.error(
        convert_dip(B, LineConvention::printed, LineConvention::exact_one_sided) == B / 2 ? 0 : 1);
    convert.error(
        convert_dip(B, LineConvention::exact_one_sided, LineConvention::printed) == 2 * B ? 0 : 1);
    const double seen = draw.decades(1e-8, 1) / L;
    gain.relative(squared_gain(L, seen),
                  4 * std::pow(std::sin(long_pi * Long{L} * seen / 2), Long{4}));
  }
}

TEST_CASE("claim: classes and their chances") {
  Claim coefficient("spectra::random_coefficient"), classes_of("spectra::classify"),
      range("spectra::coefficient_range"), chances("spectra::class_probabilities"),
      normal("spectra::normal_exceedance"), chebyshev("spectra::chebyshev_exceedance");
  RandomStream draw(42);
  for (int k = 0; k < 1000; ++k) {
    ClassRule rule;
    rule.chord = draw(5, 30), rule.alpha = draw(1, 4), rule.gamma = draw(0.5, 4);
    const Long c = Long{rule.alpha} * rule.alpha * long_pi * long_pi * rule.chord / 2;
    coefficient.relative(random_coefficient(rule), c);
    const double A = draw.decades(1e-9, 1e-4);
    double B = draw.decades(1e-5, 0.1);
    const int m = 1 + k % 6;
    const double limit = rule.limits[static_cast<std::size_t>(m - 1)];
    if (k % 2 == 0) B = limit / rule.gamma * (1 - draw.decades(1e-15, 0.1));
    const Long d = std::sqrt(c * A + Long{rule.gamma} * B * rule.gamma * B);
    const auto found = classify(A, B, rule);
    int best = 0;
    while (best < classes && d <= rule.limits[static_cast<std::size_t>(best)]) ++best;
    classes_of.error(found.track_class == best ? 0 : 1);
    classes_of.error(off(found.margin,
                         1 - d / rule.limits[static_cast<std::size_t>(std::max(best, 1) - 1)],
                         1 + d / limit));
    // The periodic part as it is rounded, from which the rest is taken.
    const Long periodic = rule.gamma * B;
    const auto k_at = [&](Long D) {
      return std::max(Long{0}, (D - periodic) * (D + periodic) / A);
    };
    const auto between = coefficient_range(A, B, m, rule);
    if (periodic <= limit) {
      range.relative(between.high, k_at(limit));
      range.relative(between.low, m < classes ? k_at(rule.limits[static_cast<std::size_t>(m)]) : 0);
    } else {
      range.error(between.low > between.high ? 0 : 1);
    }
    SpectrumFit fit;
    fit.A = {A, A * draw.decades(1e-4, 1)};
    fit.Q_1 = {draw.decades(1e-10, 1e-4), draw.decades(1e-10, 1e-4)};
    fit.A_Q_covariance = draw(-0.9, 0.9) * fit.A.error * fit.Q_1.error;
    const Long q = std::pow(3 * long_pi * rule.gamma, Long{2}) / 2;
    const Long mean = c * A + q * fit.Q_1.value,
               error = std::sqrt(c * c * fit.A.error * fit.A.error +
                                 q * q * fit.Q_1.error * fit.Q_1.error +
                                 2 * c * q * fit.A_Q_covariance);
    const auto below = [&](int i) {
      const Long D = i < classes ? Long{rule.limits[static_cast<std::size_t>(i)]} : -1;
      return i >= classes ? Long{0} : std::erfc((mean - D * D) / (error * std::sqrt(Long{2}))) / 2;
    };
    const auto share = class_probabilities(fit, rule);
    const Long scale = 1 + mean / error;  // of what the mean's rounding does
    chances.error(off(share[0], 1 - below(0), scale));
    for (int i = 1; i <= classes; ++i)
      chances.error(off(share[static_cast<std::size_t>(i)], below(i - 1) - below(i), scale));
    const double alpha = draw.decades(1e-6, 25);
    normal.error(off(normal_exceedance(alpha), std::erfc(alpha / std::sqrt(Long{2})),
                     std::erfc(alpha / std::sqrt(Long{2})) * (1 + Long{alpha} * alpha)));
    chebyshev.relative(chebyshev_exceedance(alpha), std::min(Long{1}, 1 / (Long{alpha} * alpha)));
  }
}

TEST_CASE("claim: records made and placed") {
  Claim joints("spectra::JointSequence"), made("spectra::TrackGenerator"),
      all("spectra::synthesize"), noise("spectra::ShapedNoise"), places("records::PlaceMap"),
      weights("spectra::window_weights");
  RandomStream draw(43);
  for (int k = 0; k < 20; ++k) {
    const double spacing = draw.decades(0.2, 1), l = spacing * draw.decades(3, 100),
                 B = draw.decades(1e-4, 0.1);
    std::vector<double> z(100, 0.0), pieces(100, 0.0);
    JointSequence sequence({l, B, 0, 0}, spacing, num::RandomSource{1, 2});
    sequence.add(z);
    SyntheticTrack track;
    track.spacing = spacing, track.rail_length = l, track.memory_dip = draw(0, 0.01),
    track.memory_length = draw(5, 20), track.grade = draw(-0.01, 0.01),
    track.wave_amplitude = draw(0, 1), track.wave_length = draw.decades(10, 1e4), track.dip = B,
    track.dip_scatter = 0.3;
    track.seed = static_cast<std::uint64_t>(k);
    const auto whole = synthesize(track, 100);
    TrackGenerator generator(track);
    for (std::size_t at = 0; at < 100; at += 10) generator.fill({pieces.data() + at, 10});
    SyntheticTrack plain = track;
    plain.dip = 0;
    const auto smooth = synthesize(plain, 100);
    for (std::size_t i = 0; i < 100; ++i) {
      const Long x = i * Long{spacing};
      joints.error(off(z[i], B * (std::abs(std::sin(long_pi * turn(x / l))) - 1), B * (1 + x / l)));
      all.error(whole[i] == pieces[i] ? 0 : 1);
      const Long exact = track.grade * x -
                         4 * Long{track.memory_dip} / (3 * long_pi) *
                             std::cos(2 * long_pi * turn(x / track.memory_length)) +
                         track.wave_amplitude * std::sin(2 * long_pi * turn(x / track.wave_length));
      made.error(off(smooth[i], exact, 1 + x));
    }
    const TrackParameters random{.A = 1e-7, .phi_c = 0.13};
    const NoiseShape wanted{[&](double phi) { return random_psd(random, phi); }, spacing,
                            1e-4 / spacing, 0.13};
    const ShapedNoise process(wanted, num::RandomSource{3, 4});
    for (int i = 0; i < 50; ++i) {
      const double phi = draw.decades(1e-3, 0.5) / spacing;
      const double cut = 1 + std::pow(wanted.low_cut / phi, 2);
      noise.error(std::abs(process.density(phi) * cut / random_psd(random, phi) - 1));
    }
    PlaceMap map(spacing);
    std::vector<double> positions;
    double at = 0;
    for (int i = 0; i < 100; ++i) positions.push_back(at += spacing * draw(0.6, 1.4));
    for (std::size_t i = 0; i < 100; ++i) map.add(i, {&positions[i], 1});
    for (std::size_t i = 0; i < 100; ++i)
      places.error(std::abs(map.at(i) - positions[i]) / spacing);
    const Eigen::Index n = 8 + 3 * k;
    const std::array<std::array<Long, 4>, 4> terms{{{1, 0, 0, 0},
                                                    {0.5L, 0.5L, 0, 0},
                                                    {0.54L, 0.46L, 0, 0},
                                                    {0.35875L, 0.48829L, 0.14128L, 0.01168L}}};
    for (std::size_t w = 0; w < 4; ++w) {
      const auto found = window_weights(static_cast<Window>(w), n);
      for (Eigen::Index i = 0; i < n; ++i) {
        const Long angle = 2 * long_pi * static_cast<Long>(i) / static_cast<Long>(n);
        Long sum = 0;
        for (std::size_t j = 0; j < 4; ++j)
          sum += (j % 2 == 0 ? 1 : -1) * terms[w][j] * std::cos(static_cast<Long>(j) * angle);
        weights.error(off(found[i], sum, 1));
      }
    }
  }
}

TEST_CASE("claim: Welch's estimate and the errors that it states") {
  Claim bins("spectra::welch"), streamed("spectra::Welch"), spaced("spectra::respaced"),
      bands("spectra::band_average");
  RandomStream draw(44);
  for (int k = 0; k < 60; ++k) {
    const WelchOptions options{.segment = 32, .parts = 2, .window = static_cast<Window>(k % 4)};
    const double spacing = draw.decades(1e-2, 10), rise = draw(-1, 1);
    std::vector<double> x;
    for (int i = 0; i < 80; ++i) x.push_back(draw.normal(1) + rise * i);
    const Spectrum found = welch(x, spacing, options);
    Welch parts(spacing, options);
    for (std::size_t i = 0; i < 80; i += 5) parts.push({x.data() + i, 5});
    const Spectrum again = parts.spectrum(), other = respaced(welch(x, 1, options), spacing);
    const auto window = window_weights(options.window, 32);
    std::vector<Long> density(17, 0);
    Long norm = 0, largest = 0;
    for (const double w : window) norm += Long{w} * w;
    for (std::size_t first = 0; first + 32 <= 80; first += 16) {
      Long sum = 0, moment = 0;
      for (int i = 0; i < 32; ++i) {
        const Long v = x[first + static_cast<std::size_t>(i)];
        sum += v, moment += (i - 15.5L) * v;
      }
      for (int m = 0; m <= 16; ++m) {
        std::complex<Long> line = 0;
        for (int i = 0; i < 32; ++i)
          line += Long{window[i]} *
                  (x[first + static_cast<std::size_t>(i)] - sum / 32 -
                   12 * moment / (32 * 1023) * (i - 15.5L)) *
                  std::polar(Long{1}, -2 * long_pi * static_cast<Long>(m * i % 32) / 32);
        density[static_cast<std::size_t>(m)] +=
            (m % 16 == 0 ? 1 : 2) * std::norm(line) * spacing / (norm * 4);
      }
    }
    for (const Long d : density) largest = std::max(largest, d);
    for (Eigen::Index m = 0; m <= 16; ++m) {
      const Long exact = density[static_cast<std::size_t>(m)];
      bins.error(off(found.density[m], exact, largest * (1 + std::abs(rise) * 80)));
      streamed.error(off(again.density[m], exact, largest * (1 + std::abs(rise) * 80)));
      spaced.error(off(other.density[m], found.density[m], largest));
    }
  }
  // White noise of density 2: how far bands lie from it in units of their stated error.
  double squares = 0;
  long count = 0;
  for (int k = 0; k < 400; ++k) {
    std::vector<double> x;
    for (int i = 0; i < 512; ++i) x.push_back(draw.normal(1));
    const auto band = band_average(welch(x, 1, {.segment = 64}), 1, 0.05, 0.45);
    for (Eigen::Index i = 0; i < band.density.size(); ++i) {
      const double z = (band.density[i] / 2 - 1) / band.relative_error[i];
      bands.error(std::abs(z));
      squares += z * z, ++count;
    }
  }
  CHECK(std::sqrt(squares / static_cast<double>(count)) == Approx(1).margin(0.1));
}

TEST_CASE("claim: fits of slopes, corners and floors") {
  Claim one("spectra::fit_one_slope"), two("spectra::fit_two_slopes"),
      floor("spectra::fit_with_noise"), track("spectra::fit_track_spectrum");
  RandomStream draw(45);
  int settled = 0;
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Index n = 8 + k % 30;
    LogPoints points{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
    const double A = draw.decades(1e-9, 1e-4), corner = draw.decades(0.02, 0.5);
    double at = -4.6;
    Long sum = 0, weight = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      points.log_phi[i] = at += draw(0.2, 1.8) * 4.4 / static_cast<double>(n);
      points.weight[i] = draw.decades(0.1, 10);
      points.log_density[i] =
          std::log(A) - 2 * at + std::min(0.0, 2 * (std::log(corner) - at)) + draw.normal(0.1);
      sum += points.weight[i] * (points.log_density[i] + 2 * Long{at}), weight += points.weight[i];
    }
    one.error(off(fit_one_slope(points).log_A, sum / weight, std::abs(sum / weight)));
    const double low = 0.015, high = 0.6;
    points.log_phi[0] = -4.7, points.log_phi[n - 1] = std::max(at, 0.1);
    const auto squares = [&](double log_corner) {  // the best A for a corner, and its squares
      double a = 0, w = 0, s = 0;
      const Eigen::ArrayXd bent =
          points.log_density + 2 * points.log_phi - (2 * (log_corner - points.log_phi)).min(0.0);
      a = (points.weight * bent).sum(), w = points.weight.sum();
      s = (points.weight * (bent - a / w).square()).sum();
      return s;
    };
    const LogFit fit = fit_two_slopes(points, low, high);
    const double unit = points.weight.sum();
    if (fit.corner == CornerState::fitted)
      two.error(std::abs(fit.squares - squares(fit.log_corner)) / unit);
    for (int i = 0; i < 4; ++i)
      two.error((fit.squares - squares(draw(std::log(low), std::log(high)))) / unit);
    // A floor that is there, under scatter: steps that begin at the truth find no better fit.
    LogPoints dense{
        Eigen::ArrayXd::LinSpaced(80, std::log(0.01), std::log(1.2)), {}, Eigen::ArrayXd::Ones(80)};
    const double bend = draw.decades(0.03, 0.3), noise = A * draw(0.05, 1) / (bend * bend);
    LogFit truth{.log_A = std::log(A),
                 .log_corner = std::log(bend),
                 .noise = noise,
                 .corner = CornerState::fitted};
    dense.log_density = dense.log_phi.unaryExpr(
        [&](double phi) { return truth.log_density(phi) + draw.normal(0.1); });
    LogFit start = truth;  // within a factor of two, as the fit of a track's spectrum begins
    start.log_A += draw(-0.5, 0.5), start.log_corner += draw(-0.3, 0.3),
        start.noise *= draw.decades(0.5, 2);
    const LogFit with = fit_with_noise(dense, start, low, high);
    const LogFit best = fit_with_noise(dense, truth, low, high);
    floor.error(with.converged && best.converged ? (with.squares - best.squares) / best.squares
                                                 : 0);
    settled += with.converged ? 1 : 0;
  }
  CHECK(settled > 900);
  // Spectra of 10 averages about the model: how far A lies from the truth in units of its stated
  // error.
  double squares = 0;
  int count = 0;
  const TrackParameters truth{.A = 1e-7, .phi_c = 0.13};
  for (int k = 0; k < 1000; ++k) {
    Spectrum s;
    s.df = 0.004, s.averages = 10, s.band_variance = 0.1, s.noise_bandwidth = s.df, s.segments = 10;
    s.density = Eigen::VectorXd::Zero(320);
    for (Eigen::Index i = 1; i < 320; ++i) {
      double product = 1;
      for (int j = 0; j < 10; ++j) product *= 1 - draw(0, 1);
      s.density[i] = -std::log(product) / 10 * random_psd(truth, s.frequency(i));
    }
    const SpectrumFit fit = fit_track_spectrum(s);
    const double z = (fit.A.value - truth.A) / fit.A.error;
    track.error(std::abs(z));
    squares += z * z, ++count;
  }
  CHECK(std::sqrt(squares / count) == Approx(1).margin(0.12));
}
