// Stiff and singular ends of the car's equations.
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/detail/pieces.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;

TEST_CASE("At a walking pace, 27000 1/s against 0.09 rad/s, the implicit method keeps the time",
          "[extreme]") {
  const double speed = 1 * units::foot;
  const Oscillator o =
      car_on_track(assemble({}, Suspension::dampers), wheelset::new_wheel_table(), speed);
  Eigen::VectorXd y0 = Eigen::VectorXd::Zero(18);
  y0[X_TF] = y0[X_TR] = 0.2 * units::inch;
  HistoryOptions options{.integrator = Integrator::radau5, .tolerance = 1e-8};
  const History implicit = integrate(o, y0, 20, options);
  CHECK(implicit.end == History::End::completed);
  CHECK(implicit.steps < 3000);
  const History exact = integrate(o, y0, 2, {});
  const History two = integrate(o, y0, 2, options);
  CHECK(exact.steps > 1000);
  CHECK((exact.y - two.y).head(9).lpNorm<Eigen::Infinity>() < 1e-8);
}

TEST_CASE("Friction that sticks a hundred times harder: exact pieces and the implicit method agree",
          "[extreme]") {
  CarParameters data;
  data.stick_speed /= 10;
  data.stick_rate /= 10;
  const Oscillator o =
      car_on_track(assemble(data, Suspension::friction), wheelset::cn_table(), 90 * units::foot);
  Eigen::VectorXd y0 = Eigen::VectorXd::Zero(18);
  y0[X_TF] = y0[X_TR] = 0.1 * units::inch;
  const History exact = integrate(o, y0, 0.5, {});
  HistoryOptions options{.integrator = Integrator::radau5, .tolerance = 1e-8};
  const History implicit = integrate(o, y0, 0.5, options);
  CHECK((exact.y - implicit.y).head(9).lpNorm<Eigen::Infinity>() < 1e-6);
}

TEST_CASE("The flow's derivative is that of finite differences, across knots", "[pieces]") {
  const auto car = assemble({}, Suspension::friction);
  const Oscillator o = car_on_track(car, wheelset::cn_table(), 100 * units::foot);
  State y0 = State::Zero();
  y0[X_TF] = 0.008;
  y0[X_TR] = 0.007;
  PieceIntegrator integrator{compile(o), HistoryOptions::default_scale()};
  const auto fly = [&](const State& y) {
    integrator.start(0, y);
    while (integrator.t() < 0.3 && integrator.step(0.3)) {
    }
    return integrator.y();
  };
  integrator.start(0, y0);
  integrator.follow_derivative();
  while (integrator.t() < 0.3 && integrator.step(0.3)) {
  }
  CHECK(integrator.knots() > 100);
  const StateMatrix derivative = integrator.derivative();
  for (const int i : {0, 2, 6, 9, 14}) {
    const double d = 1e-8;
    const State up = fly(y0 + d * State::Unit(i)), down = fly(y0 - d * State::Unit(i));
    const State difference = (up - down) / (2 * d);
    CHECK((difference - derivative.col(i)).norm() < 2e-4 * derivative.col(i).norm());
  }
}

TEST_CASE("A wheelset at the end of its table stops every integrator at the same time",
          "[pieces]") {
  const auto car = assemble({}, Suspension::dampers);
  const Oscillator o = car_on_track(car, wheelset::new_wheel_table(), 240 * units::foot);
  Eigen::VectorXd y0 = Eigen::VectorXd::Zero(18);
  y0[X_TF] = y0[X_TR] = 0.45 * units::inch;
  const History exact = integrate(o, y0, 20, {});
  REQUIRE(exact.end == History::End::left_table);
  CHECK(std::abs(o.channels[std::size_t(exact.channel)].row.dot(exact.y.head(9))) ==
        Approx(0.75 * units::inch).epsilon(1e-12));
  for (const Integrator i : {Integrator::dopri5, Integrator::radau5}) {
    HistoryOptions options;
    options.integrator = i;
    options.tolerance = i == Integrator::dopri5 ? 1e-10 : 1e-7;
    const History h = integrate(o, y0, 20, options);
    CHECK(h.end == History::End::left_table);
    CHECK(h.channel == exact.channel);
    CHECK(h.t == Approx(exact.t).epsilon(1e-5));
  }
}
