// Histories of shift and rolling against closed forms: Cattaneo and Mindlin, Carter, Spence; and
// against steady rolling.
#include <railbook/rolling/history.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/grid.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/num/roots.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

RollingCase steel_ball() {
  return {5e-3, 5e-3, 80e3, 82e9, 0.28, 0.3, {}};
}

// Cattaneo's and Mindlin's shift of a sphere for a force (Johnson, Contact Mechanics, 1985, 7.2).
double mindlin(const RollingCase& c, double share) {
  return 3 * c.friction * c.load / (16 * c.shear_modulus * c.a) * 2 * (2 - c.poisson) *
         (1 - std::pow(1 - share, 2.0 / 3));
}

}  // namespace

TEST_CASE("unit: a shift under a force is Cattaneo's and Mindlin's, there and back") {
  const RollingCase c = steel_ball();
  const double bound = c.friction * c.load;
  const auto at = [&](double share) {
    HistoryRow r;
    r.load = c.load, r.fx = share * bound;
    return r;
  };
  const auto steps = roll_history(c, {at(0.3), at(0.8), at(0.2), at(-0.4)}, {.along = 32});
  REQUIRE(steps.size() == 4);
  double there = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double share = k == 0 ? 0.3 : 0.8, before = there;
    there = mindlin(c, share);
    INFO("share " << share);
    CHECK(steps[k].forces.fx == Approx(share * bound).epsilon(1e-5));
    CHECK(steps[k].shift_x == Approx(there - before).epsilon(0.02));
    CHECK(std::abs(steps[k].shift_x - (there - before)) < 2 * steps[k].motion_error + 1e-8);
  }
  // Mindlin and Deresiewicz: unloading by dF shifts back twice what dF/2 shifts a fresh contact.
  CHECK(steps[2].shift_x == Approx(-2 * mindlin(c, 0.3)).epsilon(0.02));
  CHECK(steps[2].shift_x + steps[3].shift_x == Approx(-2 * mindlin(c, 0.6)).epsilon(0.02));
}

TEST_CASE("unit: after some contact lengths a force rolls with the creepage of steady rolling") {
  RollingCase c{6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3, {}};
  const double bound = c.friction * c.load;
  std::vector<HistoryRow> rows(2);
  rows[0].load = rows[1].load = c.load;
  rows[0].fx = rows[1].fx = 0.6 * bound;
  rows[1].distance = 8 * c.a;
  const auto steps = roll_history(c, rows);
  const auto steady = solve_for_forces(EllipseRolling(c.a / c.b, c.poisson), c, 0.6 * bound, {});
  CHECK(steps.back().creepage.longitudinal ==
        Approx(steady.rolling.creepage.longitudinal).epsilon(0.01));
  CHECK(std::abs(steps.back().creepage.longitudinal - steady.rolling.creepage.longitudinal) <
        steps.back().motion_error);
  CHECK(steps[1].creepage.longitudinal < 0.8 * steps.back().creepage.longitudinal);
  // Under a creepage that begins at once the force rises at first quickly, then slowly.
  for (HistoryRow& r : rows) r.fx.reset(), r.creepage = {1e-3, -5e-4, 0.2};
  rows[1].distance = 14 * c.a;
  const auto under_creepage = roll_history(c, rows);
  c.creepage = rows[1].creepage;
  const CreepForces end = solve_rolling(c);
  CHECK(under_creepage.back().forces.fx == Approx(end.fx).epsilon(0.015));
  CHECK(under_creepage.back().forces.fy == Approx(end.fy).margin(5e-3 * bound));
  for (const HistoryStep& s : under_creepage)
    if (s.distance > 3 * c.a) CHECK(s.forces.fx == Approx(end.fx).epsilon(0.08));
}

TEST_CASE(
    "property: a load that goes up and down leaves tractions, and the contact's size follows") {
  const RollingCase c = steel_ball();
  const double bound = c.friction * c.load;
  std::vector<HistoryRow> rows(3);
  for (HistoryRow& r : rows) r.load = c.load;
  rows[0].fx = 0.5 * bound;
  rows[1].load = 0.25 * c.load;  // less than the force takes: it slides down to mu N
  const auto steps = roll_history(c, rows);
  CHECK(steps[0].forces.stick_share > 0.5);
  CHECK(steps[1].forces.fx <= 0.25 * bound * (1 + 1e-9));
  CHECK(steps[1].forces.fx > 0.2 * bound);
  CHECK(steps[2].forces.fx ==
        Approx(steps[1].forces.fx).epsilon(0.02));  // pressed again, not moved
  // Rolling under a load that doubles on the way: at the end as if it had always been so.
  rows = {HistoryRow{}, HistoryRow{}, HistoryRow{}};
  for (HistoryRow& r : rows) r.creepage.longitudinal = 1e-3;
  rows[0].load = 0.5 * c.load, rows[1].load = rows[2].load = c.load;
  rows[1].distance = 2e-2, rows[2].distance = 0.1;
  RollingCase steady = c;
  steady.creepage.longitudinal = 1e-3;
  const CreepForces end = roll_history(c, rows).back().forces;
  const double off = std::abs(end.fx - solve_rolling(steady).fx);
  CHECK(off < 0.02 * end.fx);
  CHECK(off < end.error * bound);
}

// Spence: pressing unlike bodies with friction, the part c/a of the radius that sticks does not
// change as the load grows: c/(2a) ln((a + c)/(a - c)) = (beta/mu) K'(c/a) (Johnson 1985, 5.4).
TEST_CASE("unit: pressed step by step, unlike spheres stick in Spence's circle") {
  const double poisson = 0, dissimilarity = 0.25, friction = 0.3;
  const double beta = dissimilarity / (1 - poisson);
  const auto off = [&](double s) {
    return s / 2 * std::log((1 + s) / (1 - s)) -
           beta / friction * contact::elliptic_integrals(2 * std::log(s)).k;
  };
  const double stick = num::find_root(off, 0.05, 0.999, 1e-10).x;
  RollingCase c{5e-3, 5e-3, 80e3, 82e9, poisson, friction, {}};
  std::vector<HistoryRow> rows(48);
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].load = c.load * std::pow(double(k + 1) / double(rows.size()), 3);
  const auto steps =
      roll_history(c, rows, {.along = 48, .extrapolate = false, .dissimilarity = dissimilarity});
  const CreepForces& last = steps.back().forces;
  REQUIRE(last.converged);
  CHECK(std::abs(last.fx) < 1e-2 * friction * c.load);
  CHECK(std::sqrt(last.stick_share) == Approx(stick).margin(0.03));
}

TEST_CASE("unit: unlike bodies roll from rest to their steady tractions") {
  RollingCase c = steel_ball();
  std::vector<HistoryRow> rows(2);
  for (HistoryRow& r : rows) r.load = c.load, r.creepage.longitudinal = 2e-4;
  rows[1].distance = 8 * c.a;
  const auto unlike =
      roll_history(c, rows, {.along = 32, .extrapolate = false, .dissimilarity = 0.2});
  const auto alike = roll_history(c, rows, {.along = 32, .extrapolate = false});
  // The same cells in steady rolling.
  const double dx = 2 * c.a / 32;
  const contact::Grid grid{-c.a - dx, -c.b, dx, 2 * c.b / 16, 33, 16};
  Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells());
  constexpr int parts = 16;  // of a cell each way, for the mean
  for (Eigen::Index j = 0; j < grid.ny; ++j)
    for (Eigen::Index i = 0; i < grid.nx; ++i)
      for (int k = 0; k < parts * parts; ++k) {
        const double x = grid.x(i) + ((k % parts + 0.5) / parts - 0.5) * grid.dx;
        const double y = grid.y(j) + ((k / parts + 0.5) / parts - 0.5) * grid.dy;
        p[j * grid.nx + i] +=
            std::sqrt(std::max(0.0, 1 - x * x / (c.a * c.a) - y * y / (c.b * c.b)));
      }
  p *= c.load / (p.sum() * grid.dx * grid.dy);
  c.creepage.longitudinal = 2e-4;
  const RollingOptions same{.remedy = false, .estimate = false};
  const double k0 = solve_rolling(grid, p, c, same).fx;
  const double k2 = solve_rolling_unlike(grid, p, c, same, 0.2).fx;
  CHECK(alike.back().forces.fx == Approx(k0).epsilon(0.01));
  CHECK(unlike.back().forces.fx == Approx(k2).epsilon(0.01));
  CHECK(std::abs(k2 - k0) > 0.03 * std::abs(k0));
}

TEST_CASE("input: a history that cannot be is refused, named by its row") {
  const RollingCase c = steel_ball();
  const auto message = [&](const std::vector<HistoryRow>& rows, const HistoryOptions& o = {}) {
    try {
      roll_history(c, rows, o);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  using Catch::Contains;
  HistoryRow good;
  good.load = c.load;
  CHECK(message({good}) == "accepted");
  CHECK_THAT(message({}), Contains("no row"));
  HistoryRow row = good;
  row.distance = -1;
  CHECK_THAT(message({good, row}), Contains("distance of row 2") && Contains("rolls forward"));
  row.distance = 1e9;
  CHECK_THAT(message({good, row}), Contains("steps of a cell"));
  row = good, row.load = 0;
  CHECK_THAT(message({row}), Contains("load of row 1"));
  row = good, row.fx = c.friction * c.load;
  CHECK_THAT(message({row}), Contains("force along of row 1"));
  row = good, row.creepage.spin = units::nan;
  CHECK_THAT(message({good, row}), Contains("row 2"));
  CHECK_THAT(message({good}, {.along = 7}), Contains("an even number"));
}
