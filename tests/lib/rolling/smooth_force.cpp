// The smooth table of the full theory: linear at small creepage, within friction, with a continuous
// derivative, near the theory.
#include <railbook/rolling/smooth_force.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/random_stream.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

const KalkerCoefficients& linear() {
  static const KalkerCoefficients k = kalker_coefficients(1, 0.3);
  return k;
}
const ShareFunction& full() {
  static const ShareFunction theory = shares_of(solver("full", 1, 0.3, 8), 1, 0.3);
  return theory;
}
const SmoothForce& table() {
  static const SmoothForce force(full(), linear());
  return force;
}

}  // namespace

TEST_CASE("Smooth force: within friction, with the symmetries, near the theory", "[smooth_force]") {
  // Each of the three up to `reach`: largest and rms distance from the theory.
  const auto off_theory = [](double reach) {
    num::RandomStream draw(18);
    double largest = 0, squares = 0;
    constexpr int points = 300;
    for (int k = 0; k < points; ++k) {
      const double size = draw.decades(0.02 * reach, reach);
      const double x = size * draw(-1, 1), y = size * draw(-1, 1), z = size * draw(-1, 1);
      const auto f = table().at(x, y, z), turned = table().at(-x, -y, -z),
                 beside = table().at(-x, y, z);
      CHECK(std::hypot(f[0], f[1]) <= 1 + 1e-12);
      CHECK(std::hypot(f[0] + turned[0], f[1] + turned[1]) < 1e-12);
      CHECK(std::hypot(f[0] + beside[0], f[1] - beside[1]) < 1e-12);
      const ForceShares truth = full()({x / linear().c11, y / linear().c22, z / linear().c23});
      const double off = std::hypot(f[0] - truth.fx, f[1] - truth.fy);
      largest = std::max(largest, off);
      squares += off * off / points;
    }
    return std::pair{largest, std::sqrt(squares)};
  };
  const auto near = off_theory(2), far = off_theory(30);
  CAPTURE(near.first, near.second, far.second);
  CHECK(near.first < 0.06);
  CHECK(near.second < 0.015);
  // Where all slides and spin turns against lateral creepage, the force swings round within a cell
  // of the table.
  CHECK(far.second < 0.1);
  CHECK(std::hypot(table().at(1e9, 0, 0)[0], 0.0) == Approx(1).epsilon(1e-3));
}

TEST_CASE("Smooth force: no kink at the nodes or anywhere else", "[smooth_force]") {
  // Along a straight line a second difference of the step h falls with h, as it does for a
  // continuous derivative alone. The slope is that of the force.
  for (double u = -4; u < 4; u += 0.37) {
    const double t[3] = {0.4 * u, 0.1 + u, 0.3 - 0.2 * u}, h = 1e-6;
    double share[2], slope[6];
    table()(t, share, slope);
    for (std::size_t e = 0; e < 3; ++e) {
      double low[3] = {t[0], t[1], t[2]}, high[3] = {t[0], t[1], t[2]}, a[2], b[2];
      low[e] -= h, high[e] += h;
      table()(low, a, nullptr);
      table()(high, b, nullptr);
      for (std::size_t m = 0; m < 2; ++m)
        CHECK(slope[3 * m + e] == Approx((b[m] - a[m]) / (2 * h)).epsilon(1e-4).margin(1e-6));
    }
  }
  const auto bend = [](double h) {
    double worst = 0;
    for (double s = -4; s < 4; s += 0.01) {
      const auto at = [&](double u) { return table().at(0.4 * u, 0.1 + u, 0.3 - 0.2 * u); };
      const auto a = at(s - h), b = at(s), c = at(s + h);
      for (std::size_t i = 0; i < 2; ++i)
        worst = std::max(worst, std::abs(a[i] - 2 * b[i] + c[i]) / h);
    }
    return worst;
  };
  CHECK(bend(1e-5) < 0.2 * bend(1e-4));
}

TEST_CASE("Smooth force: too few nodes are refused", "[smooth_force]") {
  CHECK_THROWS_WITH(SmoothForce(full(), linear(), 3), Catch::Contains("nodes"));
}
