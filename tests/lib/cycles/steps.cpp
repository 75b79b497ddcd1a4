// How branches are walked: the rules of the step, each end that a branch may have, and what is told
// of its points.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/continuation.hpp>
#include <railbook/cycles/detail/cycle_equations.hpp>
#include <railbook/cycles/step_length.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/seen_by.hpp"

using namespace railbook;
using namespace railbook::cycles;
using Eigen::VectorXd;
using tests::seen_by;

namespace {

// Circles of radius^2 = rho where p = place(rho), given what pushes them out: push(rho) - drag(p) =
// 0; omega^2 = 1 + rho/2.
template <class Push, class Drag>
Family circles(Push push, Drag drag) {
  Family family;
  family.oscillator = seen_by(2, [=](const Complex* s, Complex* f) {
    const Complex rho = s[0] * s[0] + s[1] * s[1], radial = s[0] * s[2] + s[1] * s[3];
    for (int i = 0; i < 2; ++i) f[i] = push(rho) * s[2 + i] - (0.5 * rho + 4.0 * radial) * s[i];
  });
  family.set = [=](Oscillator& o, double p) { o.damping(0, 0) = o.damping(1, 1) = drag(p); };
  family.watch = {VectorXd::Unit(2, 0)};
  return family;
}
Family straight() {
  return circles([](Complex rho) { return -rho; }, [](double p) { return -p; });
}
// (p - 1)^2 + (rho - 1)^2 = 1/4.
Family ring() {
  return circles([](Complex rho) { return 0.25 - (rho - 1.0) * (rho - 1.0); },
                 [](double p) { return (p - 1) * (p - 1); });
}
Cycle circle(const Family& family, double rho) {
  Eigen::VectorXcd shape(2);
  shape << std::sqrt(rho), Complex{0, -std::sqrt(rho)};
  return first_harmonic(family.oscillator, shape, std::sqrt(1 + 0.5 * rho), 7);
}
ContinuationOptions within(double lowest, double highest) {
  ContinuationOptions options;
  options.lowest = lowest, options.highest = highest;
  options.multiplier_steps = 0;
  return options;
}

}  // namespace

TEST_CASE("A ring is walked once round, whichever way", "[steps]") {
  const Family family = ring();
  for (const Direction way : {Direction::larger_parameter, Direction::smaller_parameter,
                              Direction::larger_cycles, Direction::smaller_cycles}) {
    const double begin = 1 - 0.3, side = way == Direction::larger_cycles ? 0.4 : -0.4;
    const auto branch = follow_from(family, circle(family, 1 + side), begin, way, within(-5, 5));
    CHECK(branch.stop == BranchStop::closed);
    REQUIRE(branch.points.size() > 8);
    const LimitCycle &first = branch.points.front(), &last = branch.points.back();
    CHECK(first.parameter == Approx(begin).epsilon(1e-12));
    CHECK(last.parameter == Approx(begin).margin(2e-3));
    CHECK(last.largest == Approx(first.largest).epsilon(2e-3));
    // The angle about the middle grows by a whole turn; towards larger circles on the left of it
    // clockwise.
    double turned = 0;
    for (std::size_t k = 1; k < branch.points.size(); ++k) {
      const auto at = [&](std::size_t i) {
        const LimitCycle& c = branch.points[i];
        return Complex{c.parameter - 1, c.largest * c.largest - 1};
      };
      CHECK(std::abs(at(k)) == Approx(0.5).epsilon(1e-6));
      turned += std::arg(at(k) / at(k - 1));
    }
    CHECK(std::abs(turned) == Approx(2 * units::pi).epsilon(5e-3));
    const bool larger = way == Direction::larger_cycles, up = way == Direction::larger_parameter;
    if (larger || way == Direction::smaller_cycles)
      CHECK((branch.points[1].largest > first.largest) == larger);
    else
      CHECK((branch.points[1].parameter > begin) == up);
    std::vector<double> folds;
    for (const SpecialCycle& s : branch.special) {
      CHECK((s.kind == CycleEvent::fold && s.located));
      folds.push_back(s.at.parameter);
      CHECK(s.at.largest == Approx(1).epsilon(1e-6));
    }
    std::sort(folds.begin(), folds.end());
    REQUIRE(folds.size() == 2);
    CHECK(folds[0] == Approx(0.5).epsilon(1e-7));
    CHECK(folds[1] == Approx(1.5).epsilon(1e-7));
    // Twice across each parameter within.
    for (const double p : {0.6, 1.0, 1.4}) {
      const auto found = cycles_at(family, branch, p, within(-5, 5));
      REQUIRE(found.size() == 2);
      for (const LimitCycle& c : found)
        CHECK(std::abs(c.largest * c.largest - 1) ==
              Approx(std::sqrt(0.25 - (p - 1) * (p - 1))).epsilon(1e-8));
    }
    for (const double p : {0.49, 1.51}) CHECK(cycles_at(family, branch, p, within(-5, 5)).empty());
  }
}

TEST_CASE("Each end of a branch, where it is asked for", "[steps]") {
  const Family family = straight();
  const auto walked = [&](const ContinuationOptions& options,
                          Direction way = Direction::larger_cycles) {
    return follow_from(family, circle(family, 0.25), 0.25, way, options);
  };
  const auto up = within(0.01, 2);
  const auto check_end = [](const LimitCycleBranch& branch, BranchStop stop, double last,
                            double beyond) {
    CAPTURE(to_string(branch.stop), branch.points.size());
    CHECK(branch.stop == stop);
    REQUIRE(branch.points.size() > 2);
    const double before = branch.points[branch.points.size() - 2].parameter,
                 end = branch.points.back().parameter;
    CHECK((before - last) * beyond <= 0);
    CHECK((end - last) * beyond > 0);
  };
  check_end(walked(up), BranchStop::parameter, 2, 1);
  check_end(walked(within(0.01, 0.5)), BranchStop::parameter, 0.5, 1);
  auto options = up;
  options.first_amplitude = 1;
  check_end(walked(within(0.1, 2), Direction::smaller_cycles), BranchStop::parameter, 0.1, -1);
  // Half of the first cycle, or of the first amplitude where that is less.
  check_end(walked(options, Direction::smaller_cycles), BranchStop::small_cycle, 0.0625, -1);
  options.first_amplitude = 0.4;
  check_end(walked(options, Direction::smaller_parameter), BranchStop::small_cycle, 0.04, -1);
  options = up;
  options.largest_amplitude = 0.8;
  check_end(walked(options), BranchStop::amplitude, 0.64, 1);
  options.most_points = 4;
  CHECK(walked(options).stop == BranchStop::points);
  CHECK(walked(options).points.size() == 4);
  options.smallest_step = 1;
  CHECK(walked(options).stop == BranchStop::step);
  CHECK(walked(options).points.size() == 1);
  options = up;
  std::size_t seen = 1;
  options.go_on = [&](const LimitCycle& c) { return ++seen, c.parameter < 1; };
  const auto asked = walked(options);
  check_end(asked, BranchStop::asked, 1, 1);
  CHECK(seen == asked.points.size());
  for (int stop = 0; stop < 9; ++stop)
    for (int other = 0; other < stop; ++other)
      CHECK(std::string(to_string(BranchStop(stop))) != to_string(BranchStop(other)));
  // No circle has a radius whose square is negative.
  const auto none =
      follow_from(family, circle(family, 0.25), -0.5, Direction::larger_cycles, within(-1, 1));
  CHECK(none.stop == BranchStop::start);
  CHECK(none.points.empty());
}

TEST_CASE("A part of a step: straight, or a parabola where it turns", "[steps]") {
  for (const double root : {0.02, 0.3, 0.5, 0.9, 1.0}) {
    CHECK(zero_fraction(-root, 1 - root, false, false) == Approx(root));
    CHECK(zero_fraction(-root * root, 1 - root * root, true, false) == Approx(root));
    const double left = (1 - root) * (1 - root);
    CHECK(zero_fraction(1 - left, -left, false, true) == Approx(root));
    CHECK(zero_fraction(-root, 1 - root, true, true) == Approx(root));
  }
  // A ring closes where it passes its first point, near, and on the way to its second.
  const Eigen::Vector2d from{1, 1}, way{2, 1}, aside{-1, 2};
  const auto part = [&](double along, double off, double ahead) {
    const Eigen::Vector2d first = from + along * way + off * aside;
    return closes_on_start(first, first + ahead * way, from, from + way);
  };
  for (const double along : {0.01, 0.4, 0.99}) {
    CHECK(part(along, 0, 1) == Approx(along));
    CHECK(part(along, 0.099, 1) == Approx(along));
    CHECK(part(along, -0.099, 0.01) == Approx(along));
    CHECK(part(along, 0.101, 1) == 0);
    CHECK(part(along, 0, -1) == 0);
  }
  CHECK(closes_on_start(from + way, from + 2 * way, from, from + way) == 1);
  for (const double along : {-0.01, 1.01}) CHECK(part(along, 0, 1) == 0);
  CHECK(closes_on_start(from, from + way, from, from + way) == 0);
}
