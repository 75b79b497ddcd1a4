// Responses against numbers that tests/reference/responses.cpp works out from the formulas, and
// against filters driven by sines. Corners of 1 Hz.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/high_pass.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/units/constants.hpp>

#include "support/filter_weights.hpp"
#include "support/sine_drive.hpp"

using namespace railbook;
using namespace railbook::filters;

namespace {

constexpr double foot = units::foot, mph = units::mph, corner = 2 * units::pi;

// To the digits written down.
void same(double computed, double written, double unit) {
  CHECK(std::abs(computed - written) <= 0.5001 * unit);
}

double apart(const tests::Gains& a, const tests::Gains& b) {
  return std::max({std::abs(a.analog - b.analog) / std::abs(b.analog),
                   std::abs(a.digital - b.digital) / std::abs(b.digital),
                   std::abs(a.hybrid - b.hybrid) / std::abs(b.hybrid)});
}

}  // namespace

TEST_CASE("Gains of the hybrid filters at 9 and 80 mph, by formula and driven by sines") {
  struct Row {
    double phi, B_9, B_80, C_9, C_80, BC_9, BC_80, limit, FG_9, FG_80;
  };
  for (const Row& r :
       {Row{0.001, 0.99991, 0.99319, 1.00009, 1.00686, 1.00000, 1.00000, 1.00000, 1.00000, 1.00000},
        Row{0.01, 0.99140, 0.64865, 1.00851, 1.54141, 0.99984, 0.99984, 0.99984, 0.99967, 0.99967},
        Row{0.02, 0.96687, 0.39203, 1.03359, 2.54917, 0.99935, 0.99934, 0.99934, 0.99870, 0.99868},
        Row{0.05, 0.83461, 0.16803, 1.19330, 5.92684, 0.99594, 0.99589, 0.99589, 0.99189, 0.99180},
        Row{0.1, 0.60386, 0.08492, 1.62922, 11.5831, 0.98382, 0.98363, 0.98363, 0.96789, 0.96754},
        Row{0.2, 0.35423, 0.04257, 2.64301, 21.9730, 0.93623, 0.93550, 0.93549, 0.87652, 0.87516},
        Row{0.3, 0.24484, 0.02840, 3.51271, 30.2284, 0.86005, 0.85841, 0.85839, 0.73968, 0.73688},
        Row{0.4, 0.18609, 0.02130, 4.08292, 35.5302, 0.75977, 0.75686, 0.75683, 0.57726, 0.57284},
        Row{0.5, 0.14981, 0.01704, 4.28073, 37.3573, 0.64128, 0.63668, 0.63662, 0.41123,
            0.40536}}) {
    const double theta = 2 * units::pi * r.phi;
    INFO(r.phi << " cycle/ft");
    for (const bool fast : {false, true}) {
      const double T = foot / ((fast ? 80 : 9) * mph);
      const auto first = tests::first_order_gains(corner, T, theta);
      const auto second = tests::second_order_gains({corner, 1}, T, theta);
      same(std::abs(first.analog), fast ? r.B_80 : r.B_9, 1e-5);
      const double C = fast ? r.C_80 : r.C_9;
      same(std::abs(first.digital), C, C > 10 ? 1e-4 : 1e-5);
      same(std::abs(first.hybrid), fast ? r.BC_80 : r.BC_9, 1e-5);
      same(std::abs(second.hybrid), fast ? r.FG_80 : r.FG_9, 1e-5);
      CHECK(apart(tests::drive_first_order(corner, T, theta), first) < 1e-9);
      CHECK(apart(tests::drive_second_order({corner, 1}, T, theta), second) < 1e-8);
      const SecondOrderLowPass butterworth{corner, std::sqrt(0.5)};
      CHECK(apart(tests::drive_second_order(butterworth, T, theta),
                  tests::second_order_gains(butterworth, T, theta)) < 1e-8);
    }
    same(sinc_limit(theta), r.limit, 1e-5);
  }
}

TEST_CASE(
    "First-order hybrid filter: largest deviations from its limit, delay, offset of the "
    "directions") {
  struct Row {
    double mph, kappa, magnitude, magnitude_unit, complex, complex_unit, delay, offset, offset_unit;
  };
  for (const Row& r : {Row{1, 4.2840, 0.1923, 1e-4, 0.684, 1e-3, 0.21945, 171, 1},
                       Row{5, 0.8568, 0.01469, 1e-5, 0.1716, 1e-4, 0.42946, 43.0, 1e-1},
                       Row{9, 0.4760, 0.00466, 1e-5, 0.0961, 1e-4, 0.46048, 24.1, 1e-1},
                       Row{15, 0.2856, 0.00169, 1e-5, 0.0578, 1e-4, 0.47623, 14.5, 1e-1},
                       Row{30, 0.1428, 0.00042, 1e-5, 0.0289, 1e-4, 0.48810, 7.25, 1e-2},
                       Row{80, 0.0535, 0.00006, 1e-5, 0.0109, 1e-4, 0.49554, 2.72, 1e-2},
                       Row{120, 0.0357, 0.00003, 1e-5, 0.0072, 1e-4, 0.49703, 1.81, 1e-2}}) {
    INFO(r.mph << " mph");
    const double kappa = corner * foot / (r.mph * mph);
    double magnitude = 0, complex = 0;
    for (int i = 1; i <= 2000; ++i) {
      const double theta = units::pi * i / 2000, limit = sinc_limit(theta);
      const auto bc = first_order_analog(kappa, theta) * first_order_digital(kappa, theta);
      magnitude = std::max(magnitude, std::abs(std::abs(bc) - limit));
      complex = std::max(complex, std::abs(bc * std::polar(1.0, theta / 2) - limit));
    }
    same(kappa, r.kappa, 1e-4);
    same(magnitude, r.magnitude, r.magnitude_unit);
    same(complex, r.complex, r.complex_unit);
    same(centroid_delay(kappa), r.delay, 1e-5);
    same(2 * (0.5 - centroid_delay(kappa)) * foot / units::millimetre, r.offset, r.offset_unit);
    // The delay on a ramp, whose steady output comes out late by it.
    FirstOrderHybrid c{kappa};
    double late = 0;
    for (int k = 0; k < 5; ++k) late = k - c.push(k - 1 / kappa + 3 * std::exp(-kappa * k), 1);
    same(late, r.delay, 1e-5);
  }
}

TEST_CASE("What an approximate exponential leaves of the past") {
  struct Row {
    double kappa;
    std::array<double, 4> tail;
  };
  for (const Row& r : {Row{0.0535, {2.6e-2, -2.6e-2, 2.3e-4, -1.1e-8}},
                       Row{0.2, {9.4e-2, -8.8e-2, 3.0e-3, -2.0e-6}},
                       Row{0.476, {2.0e-1, -1.7e-1, 1.5e-2, -5.6e-5}},
                       Row{0.857, {3.3e-1, -2.5e-1, 4.1e-2, -4.9e-4}}}) {
    std::size_t way = 0;
    for (const auto how : {Decay::linear, Decay::reciprocal, Decay::pade11, Decay::pade22}) {
      const double written = r.tail[way++];
      // The analog filter holds 1 from an input that has ended when the last interval begins.
      FirstOrderHybrid c{1, how};
      c.push(1, r.kappa);
      const double left = c.push(std::exp(-r.kappa), r.kappa);
      same(left, written, std::pow(10.0, std::floor(std::log10(std::abs(written))) - 1));
      const DecayPair exact = decay(r.kappa), approximate = decay(r.kappa, how);
      CHECK(left == Approx((approximate.rest - exact.rest) / approximate.rest).margin(1e-15));
    }
  }
}

TEST_CASE("The 62-ft chord by short ones: gains driven by a sine") {
  struct Row {
    double wavelength, gain;
  };
  for (const Row& r : {Row{20, 1.95106}, Row{39, 0.72178}, Row{50, 1.72897}, Row{62, 2.00000},
                       Row{78, 1.79944}, Row{100, 1.36812}, Row{124, 1.00000}, Row{150, 0.73108},
                       Row{200, 0.43792}, Row{300, 0.20347}, Row{500, 0.07492}}) {
    const double theta = 2 * units::pi / r.wavelength;
    std::vector<double> z(63);
    for (std::size_t k = 0; k < z.size(); ++k)
      z[k] = std::cos(theta * (static_cast<double>(k) - 31));
    same(to_chord(spectra::mid_chord_offsets(z, 1, 2).offset, 31).offset.at(0), r.gain, 1e-5);
  }
  double square = 0;  // what the weights make of white noise
  for (const double w : chord_taps(31)) square += w * w;
  same(std::sqrt(square), 140.9645, 1e-4);
}

TEST_CASE("The default high-pass: gains by formula and through the chain") {
  struct Row {
    double wavelength, gain;
  };
  for (const Row& r : {Row{20, 1.00000}, Row{62, 0.99973}, Row{100, 0.99803}, Row{124, 0.99926},
                       Row{150, 1.00000}, Row{175, 0.99944}, Row{200, 0.99259}, Row{250, 0.93793},
                       Row{300, 0.84008}, Row{400, 0.62692}, Row{500, 0.46162}, Row{700, 0.26728},
                       Row{1000, 0.14029}, Row{2000, 0.03688}, Row{5000, 0.00598}}) {
    const HighPass filter;
    const double theta = 2 * units::pi / r.wavelength;
    same(high_pass_gain(filter, theta), r.gain, 1e-5);
    const std::size_t half = reach(filter) + 31;
    std::vector<double> z(2 * half + 1);
    for (std::size_t k = 0; k < z.size(); ++k)
      z[k] = 1e-3 * std::cos(theta * (static_cast<double>(k) - static_cast<double>(half)));
    const auto offsets = spectra::mid_chord_offsets(z, 1, 2).offset;
    same(geometry(offsets).space_curve.at(half - 1) / 1e-3, r.gain, 1e-5);
  }
  CHECK(high_pass_gain({}, 2 * units::pi / 360.7) == Approx(std::sqrt(0.5)).epsilon(2e-4));
  CHECK(high_pass_gain({}, 2 * units::pi / 473.5) == Approx(0.5).epsilon(2e-4));
  CHECK(high_pass_taps({}).size() == 601);
  CHECK(geometry(std::vector<double>(661, 1e-6)).space_curve.at(330) == Approx(7600e-6));
}

TEST_CASE("The complementary filter's gains, and driven at 100 samples a second") {
  struct Row {
    int poles;
    double hertz, low, high, high_unit;
  };
  const double tau = time_constant(0.3125), T = 0.01;
  same(tau, 0.5093, 1e-4);
  for (const Row& r : {Row{1, 0.05, 0.9874, 0.1580, 1e-4}, Row{1, 0.3125, 0.7071, 0.7071, 1e-4},
                       Row{1, 1.25, 0.2425, 0.9701, 1e-4}, Row{2, 0.3125, 0.5000, 1.118, 1e-3},
                       Row{2, 1.25, 0.0588, 1.052, 1e-3}}) {
    const auto low = low_pass_gain(tau, r.poles, r.hertz);
    same(std::abs(low), r.low, 1e-4);
    same(std::abs(1.0 - low), r.high, r.high_unit);
    const auto sampled = low_pass_gain(tau, r.poles, r.hertz, T);
    for (const bool gyro : {false, true}) {
      ComplementaryFilter real{tau, r.poles}, imaginary{tau, r.poles};
      std::complex<double> out, before;
      for (int k = 0; k * T <= 40 * tau * r.poles; ++k) {
        const auto angle = std::polar(1.0, 2 * units::pi * r.hertz * T * k), step = angle - before;
        out = gyro
                  ? std::complex{real.push(0, step.real(), T), imaginary.push(0, step.imag(), T)}
                  : std::complex{real.push(angle.real(), 0, T), imaginary.push(angle.imag(), 0, T)};
        before = angle;
      }
      CHECK(std::abs(out / before) ==
            Approx(std::abs(gyro ? 1.0 - sampled : sampled)).epsilon(1e-9));
    }
  }
}
