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
