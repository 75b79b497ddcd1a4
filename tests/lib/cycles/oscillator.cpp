// What the oscillators refuse.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/cycles/harmonic_balance.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;

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
  CHECK_THROWS_AS(car_on_track(car, wheelset::cn_table(), 0), InputError);
  CHECK_THROWS_AS(car_on_track(car, wheelset::cn_table(), -1), InputError);
  CHECK_THROWS_AS(car_on_track(car, {}, 10), InputError);
  Oscillator o = car_on_track(car, wheelset::cn_table(), 10);
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

TEST_CASE("An oscillator whose parts do not fit is refused, whichever part it is", "[oscillator]") {
  using Eigen::MatrixXd, Eigen::VectorXd;
  const MatrixXd one = MatrixXd::Identity(3, 3);
  Oscillator good{one, one, one, one, 1.0, {}, {}};
  good.channels.push_back({VectorXd::Ones(3), false, MatrixXd::Ones(3, 1), saturation(1, 1)});
  const MatrixXd rows = MatrixXd::Ones(2, 3);
  const auto law = [](const double*, double* f, double*) { f[0] = 0; };
  good.couplings.push_back({rows, rows, rows, MatrixXd::Ones(3, 1), law});
  CHECK_NOTHROW(compile(good));
  const MatrixXd wide(3, 4), high(4, 3), short_rows(1, 3), wide_rows(2, 4);
  Oscillator nine = good;
  nine.mass = nine.damping = nine.damping_by_speed = nine.stiffness = MatrixXd::Identity(10, 10);
  nine.channels.clear(), nine.couplings.clear();
  std::vector<Oscillator> bad{nine};
  const auto add = [&](auto&& change) { change(bad.emplace_back(good)); };
  for (const MatrixXd& m : {wide, high}) {
    add([&](Oscillator& o) { o.mass = m; });
    add([&](Oscillator& o) { o.damping = m; });
    add([&](Oscillator& o) { o.damping_by_speed = m; });
    add([&](Oscillator& o) { o.stiffness = m; });
    add([&](Oscillator& o) { o.channels[0].force = m; });
  }
  add([](Oscillator& o) { o.channels[0].row = VectorXd::Ones(4); });
  add([](Oscillator& o) { o.channels[0].force = MatrixXd::Ones(4, 1); });
  add([](Oscillator& o) { o.channels[0].law = {}; });
  for (const MatrixXd& m : {short_rows, wide_rows}) {
    add([&](Oscillator& o) { o.couplings[0].of_motion = m; });
    add([&](Oscillator& o) { o.couplings[0].of_rate = m; });
    add([&](Oscillator& o) { o.couplings[0].of_rate_by_speed = m; });
  }
  add([](Oscillator& o) { o.couplings[0].force = MatrixXd::Ones(4, 1); });
  add([](Oscillator& o) { o.couplings[0].law = nullptr; });
  for (std::size_t k = 0; k < bad.size(); ++k) {
    CAPTURE(k);
    CHECK_THROWS_WITH(compile(bad[k]), Catch::Contains("do not fit"));
  }
}

TEST_CASE("Harmonic balance refuses a start at rest, or of another size", "[oscillator]") {
  const Oscillator o = car_on_track(assemble({}, Suspension::dampers), wheelset::cn_table(), 40);
  CHECK_THROWS_WITH(balance(o, first_harmonic(o, Eigen::VectorXcd::Zero(9), 20, 5)),
                    Catch::Contains("rest"));
  CHECK_THROWS_AS(balance(o, {}), InputError);
  CHECK_THROWS_AS(first_harmonic(o, Eigen::VectorXcd::Ones(9), 20, 0), InputError);
}

TEST_CASE("A cycle that is not there is not returned as one", "[oscillator]") {
  // Far below the critical speed every motion dies out.
  const Oscillator o = car_on_track(assemble({}, Suspension::dampers), wheelset::new_wheel_table(),
                                    60 * units::foot);
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(9);
  q[X_TF] = q[X_TR] = 0.3 * units::inch;
  const Cycle cycle = balance(o, first_harmonic(o, q, 8, 9));
  CHECK_FALSE(cycle.converged);
  CHECK_FALSE(cycle.reason.empty());
}
