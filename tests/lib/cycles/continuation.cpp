// Continuation of limit cycles against normal forms with exact branches: circular motions of a
// plane oscillator, on which other coordinates ride.
#include <railbook/cycles/continuation.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/roots.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/seen_by.hpp"

using namespace railbook;
using namespace railbook::cycles;
using tests::seen_by;

namespace {

using Complex = std::complex<double>;

Eigen::VectorXd first_row(int n) {
  return Eigen::VectorXd::Unit(n, 0);
}
Eigen::VectorXcd circle(int n) {
  Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(n);
  shape[0] = 1;
  shape[1] = Complex{0, -1};
  return shape;
}
// What a branch cost: a walk that is a little wrong still arrives, and takes longer. The counts are
// today's; a change for the better changes them with its reason.
struct Work {
  int points, newton_steps, rejected_steps;
};
void check_work(const LimitCycleBranch& branch, const Work& known) {
  CHECK(static_cast<int>(branch.points.size()) == Approx(known.points).margin(1));
  CHECK(branch.newton_steps == Approx(known.newton_steps).epsilon(0.03));
  CHECK(branch.rejected_steps == Approx(known.rejected_steps).margin(1));
}
std::vector<SpecialCycle> of_kind(const LimitCycleBranch& branch, CycleEvent kind) {
  std::vector<SpecialCycle> found;
  for (const SpecialCycle& s : branch.special)
    if (s.kind == kind) found.push_back(s);
  return found;
}

// Circles of radius^2 = p in the first two coordinates, omega^2 = 1 + p / 2; `rest` adds forces on
// the others. The term with q q', zero on circles, keeps the motion from turning back on itself:
// without it circles are unstable.
template <class Rest>
Family on_circles(int n, Rest rest) {
  Family family;
  family.oscillator = seen_by(n, [=](const Complex* s, Complex* f) {
    const Complex rho = s[0] * s[0] + s[1] * s[1];
    for (int i = 0; i < n; ++i) f[i] = 0;
    const Complex radial = s[0] * s[n] + s[1] * s[n + 1];
    for (int i = 0; i < 2; ++i) f[i] = -rho * s[n + i] - (0.5 * rho + 2.0 * radial) * s[i];
    rest(rho, s, f);
  });
  family.set = [](Oscillator& o, double p) { o.damping(0, 0) = o.damping(1, 1) = -p; };
  family.watch = {first_row(n)};
  return family;
}
// The branch of its circles from p = 0 to 0.6.
ContinuationOptions to_06() {
  ContinuationOptions options;
  options.highest = 0.6;
  options.lowest = -1;
  options.first_amplitude = 0.1;
  return options;
}
LimitCycleBranch circles(const Family& family) {
  const int n = int(family.oscillator.coordinates());
  return follow_from_hopf(family, circle(n), 1, 0, to_06());
}

}  // namespace

TEST_CASE("Continuation: Duffing's two turning points", "[continuation]") {
  // z'' + d z' + z + b |z|^2 z = g exp(i W t) in the plane, driven by circles u'' + (|u|^2 - 1) u'
  // + W^2 u = 0 of radius 1: rho ((1 + b rho - W^2)^2 + d^2 W^2) = g^2 exactly, and one frequency.
  constexpr double d = 0.1, b = 0.5, g = 0.2;
  Family family;
  family.oscillator = seen_by(4, [=](const Complex* s, Complex* f) {
    const Complex rho = s[0] * s[0] + s[1] * s[1], size = s[2] * s[2] + s[3] * s[3];
    for (int i = 0; i < 2; ++i) {
      f[i] = -b * rho * s[i] + g * s[2 + i];
      f[2 + i] = -(size - 1.0) * s[6 + i];
    }
  });
  family.set = [](Oscillator& o, double w) {
    o.damping(0, 0) = o.damping(1, 1) = d;
    o.stiffness(2, 2) = o.stiffness(3, 3) = w * w;
  };
  family.watch = {first_row(4)};
  ContinuationOptions options;
  options.lowest = 0.3;
  options.highest = 2.5;
  Oscillator start = family.oscillator;
  family.set(start, 0.5);
  Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(4);
  shape << 0.27, Complex{0, -0.27}, 1, Complex{0, -1};
  const auto branch = follow_from(family, first_harmonic(start, shape, 0.5, 7), 0.5,
                                  Direction::larger_parameter, options);
  CHECK(branch.stop == BranchStop::parameter);
  // dW/d rho = 0 there: with a = 1 + b rho - W^2 = -g^2 / (2 b rho^2).
  const auto turning = [&](double rho) {
    return std::pow(g, 4) / (4 * b * b * std::pow(rho, 4)) - g * g / rho +
           d * d * (1 + b * rho + g * g / (2 * b * rho * rho));
  };
  const auto folds = of_kind(branch, CycleEvent::fold);
  REQUIRE(folds.size() == 2);
  double bracket[2][2] = {{1, 20}, {0.1, 1}};
  for (std::size_t k = 0; k < 2; ++k) {
    const double rho = num::find_root(turning, bracket[k][0], bracket[k][1]).x;
    CAPTURE(rho);
    CHECK(folds[k].at.parameter ==
          Approx(std::sqrt(1 + b * rho + g * g / (2 * b * rho * rho))).epsilon(1e-7));
    CHECK(folds[k].at.largest == Approx(std::sqrt(rho)).epsilon(1e-5));
  }
  check_work(branch, {40, 193, 2});
}

TEST_CASE("Continuation: a torus point of known place", "[continuation]") {
  // A third coordinate whose damping 0.3 - p changes sign at p = 0.3.
  const Family family = on_circles(3, [](Complex rho, const Complex* s, Complex* f) {
    f[2] = -(0.3 - rho) * s[5] - 0.7 * s[2];
  });
  const auto branch = circles(family);
  const auto found = of_kind(branch, CycleEvent::torus);
  REQUIRE(found.size() == 1);
  CHECK(found[0].located);
  CHECK(found[0].at.parameter == Approx(0.3).epsilon(1e-6));
  CHECK(branch.points[found[0].after].stable);
  CHECK(branch.points.back().unstable == 2);
  for (const LimitCycle& p : branch.points) {
    // exp of the exponents over half a period.
    const double rate = 0.5 * (p.parameter - 0.3), half = units::pi / p.cycle.omega;
    double nearest = 1;
    for (const Complex m : p.multipliers.map)
      nearest = std::min(nearest, std::abs(std::abs(m) - std::exp(rate * half)));
    CHECK(nearest < 1e-6);
  }
}

TEST_CASE("Continuation: a branch that breaks symmetry ends where it comes back",
          "[continuation]") {
  // w'' + w' + (rho - 0.2)(rho - 0.4) w + b w^3 = 0 stands aside between the two places: b w^2 =
  // (rho - 0.2)(0.4 - rho). No cycle is as far aside as the second size: less is tried then.
  constexpr double b = 2;
  for (const double size : {0.05, 0.6}) {
    const Family family = on_circles(3, [=](Complex rho, const Complex* s, Complex* f) {
      f[2] = -s[5] + (1.0 - (rho - 0.2) * (rho - 0.4)) * s[2] - b * s[2] * s[2] * s[2];
    });
    const auto branch = circles(family);
    const auto found = of_kind(branch, CycleEvent::symmetry_breaking);
    REQUIRE(found.size() == 2);
    // What leaves there is found from a thousandth of the way, not from a hundredth, nor at points
    // of another kind.
    for (const double off : {1e-3, -1e-3, 0.02, -0.02}) {
      const auto beside = cycles_at(family, branch, 0.2 + off, to_06());
      REQUIRE(beside.size() == 1);
      for (const CycleEvent kind : {CycleEvent::symmetry_breaking, CycleEvent::torus}) {
        const auto leaving = follow_secondary(family, {kind, beside[0], 0, true}, to_06(), size);
        const bool there = std::abs(off) < 0.01 && kind == CycleEvent::symmetry_breaking;
        CHECK(leaving.points.empty() == !there);
        CHECK((leaving.stop == BranchStop::start) == !there);
      }
    }
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(found[k].at.parameter == Approx(k == 0 ? 0.2 : 0.4).epsilon(1e-6));
      const auto aside = follow_secondary(family, found[k], to_06(), size);
      CHECK(aside.stop == BranchStop::joined);
      REQUIRE(aside.points.size() > 3);
      double least = 1, most = 0;
      const double side = aside.points[0].cycle.motion(2, 0).real();
      for (const LimitCycle& p : aside.points) {
        const double w = p.cycle.motion(2, 0).real();
        CHECK(w * side > 0);
        CHECK(b * w * w ==
              Approx((p.parameter - 0.2) * (0.4 - p.parameter)).epsilon(1e-6).margin(1e-9));
        CHECK(p.stable);
        least = std::min(least, p.parameter);
        most = std::max(most, p.parameter);
      }
      CHECK(most - least > 0.1);
      for (const SpecialCycle& s : aside.special) CHECK(s.after + 1 < aside.points.size());
      // Whoever asked for the end gets it.
      ContinuationOptions two = to_06();
      int asked = 0;
      two.go_on = [&](const LimitCycle&) { return ++asked < 2; };
      const auto stopped = follow_secondary(family, found[k], two, size);
      CHECK(stopped.stop == BranchStop::asked);
      CHECK(stopped.points.size() == 3);
    }
  }
}

TEST_CASE("Continuation: the period doubles at a known place, and the branch that leaves there",
          "[continuation]") {
  // A second plane, U'' + c U' + k U + b |U|^2 U = g z conj(U), driven by the circle z: U = A exp(i
  // omega t / 2) where (k - omega^2 / 4 + b |A|^2)^2 + (c omega / 2)^2 = g^2 p.
  constexpr double c = 0.1, k = 0.35, g = 0.15, b = 0.5;
  Family family = on_circles(4, [=](Complex, const Complex* s, Complex* f) {
    const Complex size = s[2] * s[2] + s[3] * s[3];
    for (int i = 2; i < 4; ++i) f[i] = -c * s[4 + i] + (1 - k - b * size) * s[i];
    f[2] += g * (s[0] * s[2] + s[1] * s[3]);
    f[3] += g * (s[1] * s[2] - s[0] * s[3]);
  });
  family.rest = Eigen::VectorXd::Zero(4);
  const auto size = [&](double p) {
    const double square = 1 + 0.5 * p;
    return (std::sqrt(g * g * p - 0.25 * c * c * square) - (k - 0.25 * square)) / b;
  };
  const double place = num::find_root(size, 0.2, 0.6).x;
  const auto branch = circles(family);
  const auto found = of_kind(branch, CycleEvent::period_doubling);
  REQUIRE(branch.special.size() == 1);
  REQUIRE(found.size() == 1);
  CHECK(found[0].located);
  CHECK(found[0].at.parameter == Approx(place).epsilon(1e-6));
  CHECK(branch.points[found[0].after].stable);
  CHECK(branch.points.back().unstable == 1);
  const auto doubled = follow_secondary(family, found[0], to_06());
  REQUIRE(doubled.points.size() > 3);
  CHECK(doubled.stop == BranchStop::parameter);
  for (const LimitCycle& p : doubled.points) {
    CHECK(p.cycle.omega == Approx(0.5 * std::sqrt(1 + 0.5 * p.parameter)).epsilon(1e-9));
    CHECK(std::norm(p.cycle.motion(2, 1)) == Approx(size(p.parameter)).epsilon(1e-6));
    CHECK(p.stable);
  }
}

TEST_CASE("Continuation: van der Pol's cycle from its first to its later days", "[continuation]") {
  // Rayleigh's q'' - e (q' - q'^3 / 3) + q = 0.
  Family family;
  family.oscillator =
      seen_by(1, [](const Complex* s, Complex* f) { f[0] = -s[1] * s[1] * s[1] / 3.0; });
  // The law is weighed by its force's matrix.
  family.set = [](Oscillator& o, double e) {
    o.damping(0, 0) = -e;
    o.couplings[0].force(0, 0) = e;
  };
  family.watch = {first_row(1)};
  ContinuationOptions options;
  options.highest = 2;
  options.tail = 1e-9;
  Oscillator start = family.oscillator;
  family.set(start, 0.1);
  const auto branch =
      follow_from(family, first_harmonic(start, 2 * Eigen::VectorXcd::Ones(1), 1, 7), 0.1,
                  Direction::larger_parameter, options);
  CHECK(branch.stop == BranchStop::parameter);
  const auto at = cycles_at(family, branch, 1, options);
  REQUIRE(at.size() == 1);
  CHECK(2 * units::pi / at[0].cycle.omega == Approx(6.6632868593).epsilon(1e-9));
  // Liouville: the log of the other multiplier is the integral of e (1 - q'^2).
  double trace = 0;
  constexpr int samples = 1024;
  for (int j = 0; j < samples; ++j) {
    const double v = state_at(at[0].cycle, 2 * units::pi * j / samples)[1];
    trace += (1 - v * v) * (2 * units::pi / at[0].cycle.omega) / samples;
  }
  CHECK(at[0].leading == Approx(std::exp(trace)).epsilon(2e-5));
  CHECK(at[0].stable);
  check_work(branch, {16, 34, 0});

  // Back again: harmonics are taken off as the cycle becomes a circle; a step that does so may
  // leave a few times the tail.
  options.lowest = 0.01;
  const auto back =
      follow_from(family, branch.points.back().cycle, 2, Direction::smaller_parameter, options);
  CHECK(back.stop == BranchStop::parameter);
  const auto highest = [](const LimitCycle& c) { return c.cycle.orders.back(); };
  CHECK(highest(branch.points.back()) == 77);
  CHECK(highest(back.points.front()) == 77);
  CHECK(highest(back.points.back()) == 13);
  for (const LimitCycle& c : back.points) CHECK(c.tail < 10 * options.tail);
  check_work(back, {17, 120, 0});
}

TEST_CASE("Continuation: Duffing's free oscillation has the period of the elliptic integral",
          "[continuation]") {
  // q'' + p q' + q + q^3 = 0 has cycles at p = 0 only, of any amplitude.
  Family family;
  family.oscillator = seen_by(1, [](const Complex* s, Complex* f) { f[0] = -s[0] * s[0] * s[0]; });
  family.set = [](Oscillator& o, double p) { o.damping(0, 0) = p; };
  family.watch = {first_row(1)};
  ContinuationOptions options;
  options.first_amplitude = 2;
  options.tail = 1e-8;
  options.most_points = 1;
  const auto branch = follow_from_hopf(family, Eigen::VectorXcd::Ones(1), 1.9, 0.05, options);
  REQUIRE(branch.points.size() == 1);
  const LimitCycle& p = branch.points[0];
  CHECK(p.neutral);
  CHECK(p.parameter == Approx(0).margin(1e-9));
  const double a = p.largest, m = a * a / (2 * (1 + a * a));
  const double period = 4 * std::comp_ellint_1(std::sqrt(m)) / std::sqrt(1 + a * a);
  CHECK(2 * units::pi / p.cycle.omega == Approx(period).epsilon(1e-9));
}
