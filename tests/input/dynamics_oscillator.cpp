// What the oscillators refuse.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "dynamics/harmonic_balance.hpp"
#include "dynamics/history.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"
#include "wheelrail/paper_pairs.hpp"

using namespace railbook;
using namespace railbook::dynamics;

TEST_CASE("Piecewise linear laws refuse knots out of order, NaN, and one knot", "[oscillator]") {
  CHECK_THROWS_AS(PiecewiseLinear(Eigen::Vector2d{1, 1}, Eigen::RowVector2d{0, 1}), InputError);
  CHECK_THROWS_AS(PiecewiseLinear(Eigen::Vector2d{1, 0}, Eigen::RowVector2d{0, 1}), InputError);
  CHECK_THROWS_AS(PiecewiseLinear(Eigen::Vector2d{0, 1}, Eigen::RowVector2d{0, NAN}), InputError);
  CHECK_THROWS_AS(PiecewiseLinear(Eigen::VectorXd::Zero(1), Eigen::MatrixXd::Zero(1, 1)),
                  InputError);
  CHECK_THROWS_AS(PiecewiseLinear(Eigen::Vector2d{0, 1}, Eigen::RowVector3d{0, 1, 2}), InputError);
  CHECK_THROWS_AS(saturation(0, 1), InputError);
  CHECK_THROWS_AS(saturation(1, -1), InputError);
}

TEST_CASE("Integration refuses V = 0, no duration, and a start beyond the table", "[oscillator]") {
  const auto car = assemble({}, Suspension::dampers);
  CHECK_THROWS_AS(car_on_track(car, wheelrail::cn_table(), 0), InputError);
  CHECK_THROWS_AS(car_on_track(car, wheelrail::cn_table(), -1), InputError);
  CHECK_THROWS_AS(car_on_track(car, {}, 10), InputError);
  Oscillator o = car_on_track(car, wheelrail::cn_table(), 10);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  CHECK_THROWS_AS(integrate(o, y, 0, {}), InputError);
  CHECK_THROWS_AS(integrate(o, y, 1, {.tolerance = 0}), InputError);
  CHECK_THROWS_AS(integrate(o, Eigen::VectorXd::Zero(16), 1, {}), InputError);
  HistoryOptions watching;
  watching.watch = {Eigen::VectorXd::Zero(3)};
  CHECK_THROWS_AS(integrate(o, y, 1, watching), InputError);
  y[X_TF] = units::inch;
  CHECK_THROWS_WITH(integrate(o, y, 1, {}), Catch::Contains("displacement"));
  y[X_TF] = NAN;
  CHECK_THROWS_AS(integrate(o, y, 1, {}), InputError);
  o.mass(0, 0) = -1;
  CHECK_THROWS_WITH(compile(o), Catch::Contains("positive definite"));
  o.mass.resize(3, 3);
  CHECK_THROWS_AS(compile(o), InputError);
}

TEST_CASE("A state of one to nine coordinates is padded to nine and back, others are refused",
          "[oscillator]") {
  for (const Eigen::Index n : {1, 4, 9}) {
    const Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(2 * n, 1, 2);
    const State state = padded(y);
    CHECK(unpadded(state, n) == y);
    CHECK(state[9] == y[n]);
    CHECK(state.sum() == Approx(y.sum()));
  }
  for (const Eigen::Index size : {0, 3, 17, 20})
    CHECK_THROWS_WITH(
        padded(Eigen::VectorXd::Zero(size)),
        "state of " + std::to_string(size) + " numbers; allowed: an even count from 2 to 18");
}

TEST_CASE("Harmonic balance refuses a start at rest, or of another size", "[oscillator]") {
  const Oscillator o = car_on_track(assemble({}, Suspension::dampers), wheelrail::cn_table(), 40);
  CHECK_THROWS_WITH(balance(o, first_harmonic(o, Eigen::VectorXcd::Zero(9), 20, 5)),
                    Catch::Contains("rest"));
  CHECK_THROWS_AS(balance(o, {}), InputError);
  CHECK_THROWS_AS(first_harmonic(o, Eigen::VectorXcd::Ones(9), 20, 0), InputError);
}

TEST_CASE("A cycle that is not there is not returned as one", "[oscillator]") {
  // Far below the critical speed every motion dies out.
  const Oscillator o = car_on_track(assemble({}, Suspension::dampers), wheelrail::new_wheel_table(),
                                    60 * units::foot);
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(9);
  q[X_TF] = q[X_TR] = 0.3 * units::inch;
  const Cycle cycle = balance(o, first_harmonic(o, q, 8, 9));
  CHECK_FALSE(cycle.converged);
  CHECK_FALSE(cycle.reason.empty());
}
