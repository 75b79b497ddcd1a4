// Integration in exact pieces against closed forms and the other integrators.
#include <railbook/cycles/detail/pieces.hpp>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/history.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;

namespace {

Oscillator single(double damping, double stiffness, PiecewiseLinear law, bool of_rate) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  Oscillator o{one, damping * one, 0 * one, stiffness * one, 1.0, {}};
  o.channels.push_back({Eigen::VectorXd::Ones(1), of_rate, -one, std::move(law)});
  return o;
}

}  // namespace

TEST_CASE("On the tread, cut into many pieces, the car moves by the matrix exponential",
          "[pieces]") {
  const auto car = assemble({}, Suspension::dampers);
  Oscillator o = car_on_track(car, wheelset::new_wheel_table(), 150 * units::foot);
  // The linear tread as a law of 400 pieces whose bend is far beyond rounding's reach, but nil for
  // the motion.
  for (Channel& c : o.channels) {
    const Eigen::VectorXd slope = c.law.slopes().col(c.law.piece(0));
    Eigen::VectorXd knots = Eigen::VectorXd::LinSpaced(401, -0.02, 0.02);
    c.law = PiecewiseLinear{knots, slope * knots.transpose()};
  }
  StateMatrix J;
  const Compiled system = compile(o);
  system.jacobian(State::Zero(), J);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(J)};
  Eigen::VectorXd y0 = Eigen::VectorXd::Zero(18);
  y0[X_TF] = 0.004;
  y0[X_C] = -0.003;
  const double t = 1.7;
  const Eigen::VectorXcd part = solver.eigenvectors().inverse() * y0.cast<std::complex<double>>();
  const Eigen::VectorXd exact =
      (solver.eigenvectors() * (solver.eigenvalues() * t).array().exp().matrix().cwiseProduct(part))
          .real();
  const History h = integrate(o, y0, t, {});
  HistoryOptions sampled;
  sampled.watch = {Eigen::VectorXd::Ones(y0.size() / 2)};
  sampled.sample_step = t / 2.5;  // at 0, 1 and 2 steps
  CHECK(integrate(o, y0, t, sampled).sample_times.size() == 3);
  CHECK(h.steps > 300);
  CHECK((h.y - exact).lpNorm<Eigen::Infinity>() < 1e-11);
  HistoryOptions options{.integrator = Integrator::dopri5, .tolerance = 1e-11};
  CHECK((integrate(o, y0, t, options).y - exact).lpNorm<Eigen::Infinity>() < 1e-9);
  options.integrator = Integrator::radau5;
  options.tolerance = 1e-9;
  CHECK((integrate(o, y0, t, options).y - exact).lpNorm<Eigen::Infinity>() < 1e-8);
}

TEST_CASE("A bilinear oscillator keeps its period and energy over a thousand periods", "[pieces]") {
  // q'' = -q for q > 0, -9 q for q < 0: half periods pi and pi/3.
  const Oscillator o =
      single(0, 0, {Eigen::Vector3d{-1, 0, 1}, Eigen::RowVector3d{-9, 0, 1}}, false);
  HistoryOptions options;
  options.watch = {Eigen::VectorXd::Ones(1)};
  const double period = units::pi * (1 + 1.0 / 3);
  const History h = integrate(o, Eigen::Vector2d{0.5, 0}, 1000 * period, options);
  CHECK(h.y[0] == Approx(0.5).epsilon(1e-10));
  CHECK(std::abs(h.y[1]) < 1e-9);
  const Swing s = swing(h, 0, 900);
  CHECK(s.omega == Approx(2 * units::pi / period).epsilon(1e-13));
  CHECK(s.amplitude == Approx(0.5 * (0.5 + 0.5 / 3)).epsilon(1e-11));
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
