#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <vector>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/filters/complementary.hpp>
#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::spectra;
using namespace railbook::filters;

namespace {

std::vector<double> noise(std::size_t n, std::uint64_t stream) {
  const num::RandomSource random{11, stream};
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = 1e-4 * random.normal(k);
  return x;
}

// Largest difference of a against s b.
double difference(const std::vector<double>& a, const std::vector<double>& b, double s = 1) {
  double worst = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return 1;
    if (!std::isnan(a[i])) worst = std::max(worst, std::abs(a[i] - s * b[i]));
  }
  return worst;
}

}  // namespace

TEST_CASE("Hybrid filters: the double pole is the square of the single one at constant speed") {
  for (const double kappa : {1e-3, 0.05, 0.5, 5.0})
    for (const double theta : {0.01, 0.5, 2.0, units::pi}) {
      const auto bc = first_order_analog(kappa, theta) * first_order_digital(kappa, theta);
      const SecondOrderLowPass f{kappa, 1};
      const auto fg = second_order_analog(f, 1, theta) * second_order_digital(f, 1, theta);
      CHECK(std::abs(fg) == Approx(std::norm(bc)).epsilon(1e-11));
    }
}

TEST_CASE("Hybrid filters: unit gain at DC, and |C| by its closed form") {
  for (const double kappa : {1e-4, 0.1, 3.0, 50.0}) {
    CHECK(std::abs(first_order_digital(kappa, 0) - 1.0) < 1e-15);
    for (const double damping : {0.3, 1.0, 4.0})
      CHECK(std::abs(second_order_digital({kappa, damping}, 1, 0) - 1.0) < 1e-15);
    // Of a mode that is over before the next sample nothing is to be taken out.
    for (const double damping : {0.3, 1.0, 4.0})
      CHECK(second_order_digital({kappa, damping}, units::infinity, 1.1) == 1.0);
    const double theta = 1.1, ratio = std::sin(theta / 2) / std::sinh(kappa / 2);
    CHECK(std::norm(first_order_digital(kappa, theta)) == Approx(1 + ratio * ratio).epsilon(1e-12));
  }
}

TEST_CASE("Hybrid filters tend to the mean and the triangle as the corner falls") {
  for (const double theta : {0.1, 1.0, 3.0}) {
    const auto bc = first_order_analog(1e-6, theta) * first_order_digital(1e-6, theta);
    CHECK(std::abs(bc) == Approx(sinc_limit(theta)).epsilon(1e-9));
    CHECK(std::arg(bc) == Approx(-theta / 2).epsilon(1e-6));
  }
}

TEST_CASE("C and G are linear, and do not care about the unit of time") {
  const auto x = noise(200, 1), y = noise(200, 2);
  FirstOrderHybrid c[3] = {FirstOrderHybrid{2}, FirstOrderHybrid{2}, FirstOrderHybrid{2}};
  SecondOrderHybrid g[3] = {SecondOrderHybrid{{2, 0.8}}, SecondOrderHybrid{{2, 0.8}},
                            SecondOrderHybrid{{2, 0.8}}};
  FirstOrderHybrid scaled_c{2e-3};
  SecondOrderHybrid scaled_g{{2e-3, 0.8}};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double T = 0.01 * (1 + std::abs(1e4 * y[k]));
    const double a = c[0].push(x[k], T), b = c[1].push(y[k], T), ab = c[2].push(x[k] - 3 * y[k], T);
    const double A = g[0].push(x[k], T).mean, B = g[1].push(y[k], T).mean,
                 AB = g[2].push(x[k] - 3 * y[k], T).mean;
    const double late = scaled_c.push(x[k], 1e3 * T), later = scaled_g.push(x[k], 1e3 * T).mean;
    if (k < 2) continue;
    const double scale = 1e-4 / T;
    CHECK(ab == Approx(a - 3 * b).margin(1e-12 * scale));
    CHECK(AB == Approx(A - 3 * B).margin(1e-11 * scale / T));
    CHECK(late == Approx(a).margin(1e-12 * scale));
    CHECK(later == Approx(A).margin(1e-11 * scale / T));
  }
}

TEST_CASE("A change of speed leaves no transient: two histories, one future") {
  // Whatever came before, outputs two samples on are the same when the analog output is.
  FirstOrderHybrid a{3}, b{3};
  SecondOrderHybrid f{{3, 1}}, g{{3, 1}};
  for (int k = 0; k < 50; ++k) {
    a.push(std::sin(k), 0.1);
    f.push(std::sin(k), 0.1);
    b.push(1e3 * std::cos(k), 5);
    g.push(1e3 * std::cos(k), 5);
  }
  for (int k = 0; k < 5; ++k) {
    const double y = std::exp(-k), T = 0.2 + 0.1 * k;
    const double u = a.push(y, T), v = b.push(y, T), m = f.push(y, T).mean, n = g.push(y, T).mean;
    if (k >= 1) CHECK(u == v);
    if (k >= 2) CHECK(m == n);
  }
}

TEST_CASE("The stream is linear, shift-invariant and blind to a constant and a slope") {
  const auto x = noise(3000, 3), y = noise(3000, 4);
  std::vector<double> sum(x.size()), biased(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum[k] = x[k] + 2 * y[k];
    biased[k] = x[k] + 1e-3 + 1e-7 * static_cast<double>(k);
  }
  const Geometry a = geometry(x), b = geometry(y), c = geometry(sum), d = geometry(biased);
  std::vector<double> expected(a.chord.size());
  for (std::size_t k = 0; k < expected.size(); ++k) expected[k] = a.chord[k] + 2 * b.chord[k];
  CHECK(difference(c.chord, expected) < 1e-12);
  CHECK(difference(d.chord, a.chord) < 1e-9);
  std::vector<double> shifted(17, 0.0);
  shifted.insert(shifted.end(), x.begin(), x.end());
  const Geometry late = geometry(shifted);
  for (const std::size_t k : {330UL, 1000UL, 2669UL})
    CHECK(late.chord[k + 17] == Approx(a.chord[k]).margin(1e-13));
}

TEST_CASE("Run backwards, the stream gives the same backwards: zero phase") {
  auto x = noise(2000, 5);
  const auto forward = geometry(x).space_curve;
  std::reverse(x.begin(), x.end());
  auto backward = geometry(x).space_curve;
  std::reverse(backward.begin(), backward.end());
  CHECK(difference(forward, backward) < 1e-12);
}

TEST_CASE("The result does not depend on blocks or pieces") {
  const auto x = noise(9000, 6);
  const auto reference = geometry(x).chord;
  for (const std::size_t block : {7UL, 661UL, 5000UL, 20000UL}) {
    if (block == 7 && x.size() > 9000) continue;
    CHECK(difference(geometry(x, {.block = block}).chord, reference) < 1e-12);
  }
}

TEST_CASE("Chords add up: the chord of 2N from that of N") {
  // (1 - cos 2Nt) = 2 (1 + cos Nt)(1 - cos Nt)
  const auto m = noise(400, 7);
  const auto n31 = to_chord(m, 31), n62 = to_chord(m, 62);
  for (const std::size_t i : {0UL, 100UL, 200UL}) {
    const std::size_t j = i + n62.first - n31.first;
    CHECK(n62.offset[i] ==
          Approx(2 * n31.offset[j] + n31.offset[j - 31] + n31.offset[j + 31]).epsilon(1e-11));
  }
}

TEST_CASE("The complementary filter's paths add up to one for every step") {
  const double tau = time_constant(0.3125);
  for (const int poles : {1, 2, 5})
    for (const double T : {1e-4, 0.1, 10.0}) {
      ComplementaryFilter both{tau, poles}, low{tau, poles}, high{tau, poles};
      double last = 0;
      for (int k = 0; k < 50; ++k) {
        const double roll = std::sin(0.7 * k);
        const double a = both.push(roll, roll - last, T), b = low.push(roll, 0, T),
                     c = high.push(0, roll - last, T);
        CHECK(a == Approx(b + c).margin(1e-13));
        CHECK(a == Approx(roll).margin(1e-13));
        last = roll;
      }
    }
}
