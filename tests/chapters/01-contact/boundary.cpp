// Where the pressures of one step of COUNTACT put its boundary: cases whose squares fall on a line,
// done by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "method/parts.hpp"

using namespace railbook::contact;
using namespace railbook::contact_chapter;
using namespace railbook::contact_chapter::detail;
using Catch::Matchers::Contains;

namespace {

const CellNumbers cells{3, 5, false};

CountactOptions options() {
  CountactOptions o;
  o.columns = uniform_columns(5);
  o.rows = 3;
  return o;
}

// Five columns of width 1 about x = 0, of half width 3: cells at y = 0 and 2. Squares of the
// pressures on the axis, each with its sign, and of those at y = 2 as a share of them.
CountactStep step_of(const std::vector<double>& squares, double share = 1.0 / 3) {
  CountactStep step;
  step.mesh.x_edges = Eigen::VectorXd::LinSpaced(6, -2.5, 2.5);
  step.mesh.half_width = Eigen::VectorXd::Constant(5, 3);
  step.p.resize(2, 5);
  for (Eigen::Index j = 0; j < 5; ++j) {
    const double square = squares[static_cast<std::size_t>(j)];
    step.p(0, j) = std::copysign(std::sqrt(std::abs(square)), square);
    step.p(1, j) = step.p(0, j) * std::sqrt(share);
  }
  return step;
}

void check(const Eigen::VectorXd& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == static_cast<Eigen::Index>(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(found[static_cast<Eigen::Index>(i)] == Approx(expected[i]).epsilon(1e-12).margin(1e-14));
}

}  // namespace

TEST_CASE("unit: squares on a line put the ends and the sides where the line reaches zero") {
  CountactStep step = step_of({2, 4, 9, 4, 1});
  const Update full = update_boundary(step, cells, options(), 1);
  CHECK(full.reason.empty());
  CHECK(step.new_x_min == Approx(-3));
  CHECK(step.new_x_max == Approx(2 + 1.0 / 3));
  check(step.new_half, {3, 3, 3, 3, 3});
  CHECK(step.move == Approx(0.5 / 5));
  CHECK_FALSE(step.stuck_left);
  CHECK_FALSE(step.stuck_right);
  CHECK(step.stuck_columns.empty());
  const double width = 16.0 / 15;  // of the new columns, from -3 to 7/3
  check(full.mesh.x_edges,
        {-3, -3 + width, -3 + 2 * width, -3 + 3 * width, -3 + 4 * width, 7.0 / 3});
  check(full.mesh.half_width, {3 * width / 2, 3, 3, 3, 3});  // from 0 at -3 to 3 at -2
  const Update part = update_boundary(step, cells, options(), 0.5);
  CHECK(part.mesh.x_edges[0] == Approx(-2.75));
  CHECK(part.mesh.x_edges[5] == Approx(2.5 - 1.0 / 12));
  CHECK(part.mesh.half_width[0] == Approx(3 * (31.0 / 60) / 0.75));  // half a column of 31/30
}

TEST_CASE("unit: the largest move is of either end or of the sides, inward or outward") {
  for (const bool right : {true, false}) {  // one end moves in by 0.4, the other by 1/6
    CountactStep step = right ? step_of({1, 4, 9, 4, 4 / 11.0}) : step_of({4 / 11.0, 4, 9, 4, 1});
    REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
    CHECK((right ? step.new_x_max : -step.new_x_min) == Approx(2.1));
    CHECK(step.move == Approx(0.4 / 5));
  }
  // From 2 at x = 1 to -2 at x = 2: the last column is dropped, which moves its side by all of its
  // width.
  CountactStep step = step_of({1, 4, 9, 4, -4});
  REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
  CHECK(step.new_x_max == Approx(1.5));
  check(step.new_half, {3, 3, 3, 3, 0});
  CHECK(step.move == Approx(1));
  step = step_of({-4, 4, 9, 4, 1});
  REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
  CHECK(step.new_x_min == Approx(-1.5));
  check(step.new_half, {0, 3, 3, 3, 3});
  for (const double share : {0.5, 0.2}) {  // sides at 4 and at 2.5
    step = step_of({2, 4, 9, 4, 2}, share);
    REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
    CHECK(step.new_half[2] == Approx(2 + 2 * share / (1 - share)));
    CHECK(step.move == Approx(share == 0.5 ? 1.0 / 3 : 0.5 / 3));
  }
}

TEST_CASE(
    "unit: where the pressure does not fall outward the boundary stays, and is reported to be "
    "stuck") {
  CountactStep step = step_of({4, 4, 9, 16.0 / 9, 1});
  step.p(1, 1) = step.p(0, 1);
  REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
  CHECK(step.stuck_left);
  CHECK_FALSE(step.stuck_right);
  CHECK(step.new_x_min == -2.5);
  CHECK(step.stuck_columns == std::vector<int>{1});
  CHECK(step.new_half[1] == 3);
  // Two points that include the largest pressure locate nothing either.
  step = step_of({4, 9, 4, 2, 1});
  REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
  CHECK(step.stuck_left);
  CHECK_FALSE(step.stuck_right);
  step = step_of({1, 2, 4, 9, 4});
  REQUIRE(update_boundary(step, cells, options(), 1).reason.empty());
  CHECK(step.stuck_right);
  CHECK_FALSE(step.stuck_left);
}

TEST_CASE("unit: a boundary that may only move inward stays where it would move outward") {
  CountactOptions inward = options();
  inward.inward_only = true;
  CountactStep step = step_of({2, 4, 9, 4, 1}, 0.5);
  REQUIRE(update_boundary(step, cells, inward, 1).reason.empty());
  CHECK(step.new_x_min == -2.5);
  CHECK(step.new_x_max == Approx(2 + 1.0 / 3));
  check(step.new_half, {3, 3, 3, 3, 3});
  // Not into the outer half of the last cell either: half way from its centre to the boundary.
  step = step_of({2, 4, 9, 4, 0.1}, 0.01);
  REQUIRE(update_boundary(step, cells, inward, 1).reason.empty());
  CHECK(step.new_x_max == Approx(2.25));
  check(step.new_half, {2.5, 2.5, 2.5, 2.5, 2.5});
}

TEST_CASE("unit: a step without a boundary says why") {
  CountactStep step = step_of({-1, -1, -1, -1, -1});
  CHECK_THAT(update_boundary(step, cells, options(), 1).reason, Contains("no pressure is left"));
  step = step_of({-1, -1, 9, 4, -1});
  CHECK_THAT(update_boundary(step, cells, options(), 1).reason,
             Contains("only 2 columns carry pressure"));
  step = step_of({-1, 4, 9, 4, -1});
  CHECK(update_boundary(step, cells, options(), 1).reason.empty());
  step = step_of({1, 4, 9, 4, 1});
  step.p(1, 2) = std::nan("");
  CHECK_THAT(update_boundary(step, cells, options(), 1).reason, Contains("not finite"));
}

TEST_CASE("unit: no candidate region leaves a body that ends beside the contact") {
  // A sphere that would touch over 1 cm, cut off nearer than that along or across: the outward
  // moves end there.
  const double approach = 1e-4, radius = 1;
  CountactOptions o;
  o.columns = uniform_columns(11);
  const auto solve = [&](double left, double right, double side) {
    const Gap cut = [=](double x, double y) {
      return x < left || x > right || std::abs(y) > side ? std::numeric_limits<double>::infinity()
                                                         : (x * x + y * y) / (2 * radius);
    };
    const CountactResult found = countact_1(cut, approach, 1e11, o);
    REQUIRE(found.history.size() > 2);
    for (const CountactStep& step : found.history) {
      CHECK(step.mesh.half_width.maxCoeff() <= side * (1 + 1e-9));
      CHECK(step.mesh.x_edges[0] >= left * (1 + 1e-9));
      CHECK(step.mesh.x_edges[11] <= right * (1 + 1e-9));
    }
    return found.history.back().mesh;
  };
  CHECK(solve(-1, 1, 9.3e-3).half_width.maxCoeff() > 0.95 * 9.3e-3);
  const ColumnMesh mesh = solve(-8e-3, 9e-3, 1);
  CHECK(mesh.x_edges[0] < 0.95 * -8e-3);
  CHECK(mesh.x_edges[11] > 0.95 * 9e-3);
}
