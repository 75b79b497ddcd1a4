// Stiff and singular ends of the car's equations.
#include <catch2/catch.hpp>
#include <cmath>

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

TEST_CASE("The motion's size may be anything: laws of pieces scale with it", "[extreme]") {
  // Every length in the law a million times smaller: the same motion, a million times smaller.
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    Oscillator o{one, 0.1 * one, 0 * one, one, 1, {}};
    o.channels.push_back(
        {Eigen::VectorXd::Ones(1),
         false,
         -one,
         {scale * Eigen::Vector4d{-2, -1, 1, 2}, scale * Eigen::RowVector4d{-20, 0, 0, 20}}});
    HistoryOptions options;
    options.scale = State::Constant(scale);
    const History h = integrate(o, scale * Eigen::Vector2d{3, 0}, 10, options);
    Oscillator plain = o;
    plain.channels[0].law = {Eigen::Vector4d{-2, -1, 1, 2}, Eigen::RowVector4d{-20, 0, 0, 20}};
    const History ref = integrate(plain, Eigen::Vector2d{3, 0}, 10, {});
    CHECK(h.y[0] / scale == Approx(ref.y[0]).epsilon(1e-9));
  }
}
