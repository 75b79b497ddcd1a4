// The accuracy that lib/cycles and lib/vehicle state of laws, cycles as harmonics, the car and
// motions in time.
#include <Eigen/LU>
#include <cmath>

#include <railbook/cycles/floquet.hpp>
#include <railbook/cycles/harmonic_balance.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/cycle_solver.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/body_by_body.hpp"
#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using namespace railbook::tests;

namespace {

const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);

Eigen::VectorXd random_vector(RandomStream& draw, Eigen::Index n, double size = 1) {
  return Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index) { return size * draw(-1, 1); });
}

// The paper's car with every datum between a half and twice of it.
CarParameters random_car(RandomStream& draw) {
  CarParameters car;
  for (const CarDatum& datum : car_data()) car.*datum.member *= draw.decades(0.5, 2);
  return car;
}

}  // namespace

TEST_CASE("claim: piecewise linear laws") {
  Claim law_claim("cycles::PiecewiseLinear"), fewer("cycles::simplified"),
      clamp("cycles::saturation"), samples("cycles::sampled");
  RandomStream draw(2);
  for (int k = 0; k < 250; ++k) {
    const Eigen::Index n = 3 + k % 9;
    Eigen::VectorXd knots(n);
    Eigen::MatrixXd values(1, n);
    knots[0] = draw(-1, 1), values(0, 0) = draw(-1, 1);
    for (Eigen::Index i = 1; i < n; ++i)
      knots[i] = knots[i - 1] + draw.decades(1e-3, 1), values(0, i) = draw(-1, 1);
    const PiecewiseLinear law(knots, values);
    const auto at = [&](Long s) {
      Eigen::Index i = 0;
      while (i + 2 < n && s >= knots[i + 1]) ++i;
      return values(0, i) + (s - knots[i]) * ((Long{values(0, i + 1)} - values(0, i)) /
                                              (Long{knots[i + 1]} - knots[i]));
    };
    const double steepest = law.slopes().cwiseAbs().maxCoeff(), wide = knots[n - 1] - knots[0] + 2;
    for (int m = 0; m < 4; ++m) {
      const double a = m == 0 ? knots[k % n] : draw(knots[0] - 0.5, knots[n - 1] + 0.5);
      // Both ends in one piece, pieces apart, and either side of a knot.
      const double b = m == 1   ? knots[k % n] + draw(-1, 1) * draw.decades(1e-9, 1e-3)
                       : m == 2 ? a + draw(-1, 1) * draw.decades(1e-9, 1e-3)
                                : draw(knots[0] - 0.5, knots[n - 1] + 0.5);
      law_claim.error(static_cast<double>(std::abs(law(a)[0] - at(a))) / (steepest * wide));
      if (a == b) continue;
      const PiecewiseLinear::Mean mean = law.mean(0, a, law.piece(a), b, law.piece(b));
      const Long low = std::min(a, b), high = std::max(a, b);
      Long sum = 0, from = low;
      for (Eigen::Index i = 0; i <= n; ++i) {
        const Long to = i < n ? std::min(high, std::max(low, Long{knots[i]})) : high;
        sum += (to - from) * at((from + to) / 2), from = to;
      }
      law_claim.error(static_cast<double>(std::abs(mean.value - sum / (high - low))) /
                      (steepest * wide));
      // The derivatives lose what the way is short.
      const Long by_b = (at(b) - sum / (high - low)) / (Long{b} - a);
      law_claim.error(static_cast<double>(std::abs(mean.by_b - by_b)) * std::abs(b - a) /
                      (steepest * wide));
    }
    // Straight over some knots but for less than allowed.
    const double allowed = draw.decades(1e-12, 1e-3);
    Eigen::MatrixXd bent(1, 30);
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(30, 0, 1);
    double slope = 0, value = 0;
    for (Eigen::Index i = 0; i < 30; ++i) {
      if (i % 7 == 0) slope = draw(-1, 1);
      value += slope / 29;
      bent(0, i) = value + 0.3 * allowed * draw(-1, 1);
    }
    const PiecewiseLinear whole(places, bent), shorter = simplified(whole, allowed);
    REQUIRE(shorter.pieces() <= whole.pieces());
    for (int m = 0; m < 4; ++m) {
      const double s = draw(0, 1), most = bent.cwiseAbs().maxCoeff();
      fewer.error(std::abs(shorter(s)[0] - whole(s)[0]) / (allowed * most));
      const double level = draw.decades(1e-3, 1e6), width = draw.decades(1e-6, 1),
                   v = m == 0 ? width * (1 + draw(-1, 1) * 1e-15) : width * draw(-5, 5);
      clamp.error(
          static_cast<double>(std::abs(saturation(level, width)(v)[0] -
                                       level * std::clamp(Long{v} / width, Long{-1}, Long{1})) /
                              level));
      const int pieces = 1 + k;
      const double low = draw(-3, 0), high = low + draw(0.1, 5), h = (high - low) / pieces,
                   place = draw(low, high);
      samples.error(
          std::abs(sampled([](double x) { return std::sin(x); }, low, high, pieces)(place)[0] -
                   std::sin(place)) /
          (h * h / 8 + 1e-15));
    }
  }
}

TEST_CASE("claim: cycles as harmonics") {
  Claim orders("cycles::orders_up_to"), first("cycles::first_harmonic"),
      period("cycles::from_period"), kept("cycles::with_orders"), state("cycles::state_at"),
      ends("cycles::extremes"), half("cycles::amplitude"), apart("cycles::distance"),
      growth("cycles::exponent"), scale("vehicle::scaled");
  RandomStream draw(3);
  Oscillator o{Eigen::MatrixXd::Identity(3, 3), {}, {}, {}, 0.02, {}, {}};
  for (int k = 0; k < 1000; ++k) {
    const bool all = k % 2 == 0;
    const int highest = 1 + k % 12;
    const auto found = orders_up_to(highest, all);
    orders.error(found.front() == (all ? 0 : 1) &&
                         found.back() == (all || highest % 2 == 1 ? highest : highest - 1)
                     ? 0
                     : 1);
    const double omega = draw.decades(1e-2, 1e3), phase = draw(0, 6.2);
    Eigen::VectorXcd shape(3);
    for (auto& s : shape) s = {draw(-1, 1), draw(-1, 1)};
    Cycle cycle = first_harmonic(o, shape, omega, highest, all);
    const Long c = std::cos(Long{phase}), s = std::sin(Long{phase});
    Eigen::VectorXd y = state_at(cycle, phase);
    for (Eigen::Index n = 0; n < 3; ++n) {
      first.error(
          static_cast<double>(std::abs(y[n] - (shape[n].real() * c - shape[n].imag() * s))));
      first.error(static_cast<double>(
          std::abs(y[n + 3] / Long{omega} + (shape[n].real() * s + shape[n].imag() * c))));
    }
    // Every order at random; one in three of nearly equal humps.
    for (Eigen::Index n = 0; n < cycle.motion.cols(); ++n)
      for (Eigen::Index m = 0; m < 3; ++m)
        cycle.motion(m, n) =
            std::complex<double>{draw(-1, 1), draw(-1, 1)} / (1.0 + static_cast<double>(n));
    if (k % 3 == 0) {
      cycle.motion.row(0).setZero();
      cycle.motion(0, cycle.motion.cols() - 1) = std::polar(1.0, draw(0, 6.2));
      cycle.motion(0, all ? 1 : 0) += std::polar(draw.decades(1e-9, 0.1), draw(0, 6.2));
    }
    y = state_at(cycle, phase);
    Long q = 0, v = 0;
    for (std::size_t n = 0; n < cycle.orders.size(); ++n) {
      const auto z = cycle.motion(0, static_cast<Eigen::Index>(n));
      const Long angle = cycle.orders[n] * Long{phase};
      q += z.real() * std::cos(angle) - z.imag() * std::sin(angle);
      v -= cycle.orders[n] * (z.real() * std::sin(angle) + z.imag() * std::cos(angle));
    }
    state.error(static_cast<double>(std::abs(y[0] - q)));
    state.error(static_cast<double>(std::abs(y[3] / Long{omega} - v)) / highest);
    if (k % 4 == 0) {
      const int samples = 4 * highest + k % 50;
      Eigen::MatrixXd states(6, samples);
      for (int n = 0; n < samples; ++n)
        states.col(n) = state_at(cycle, 2 * units::pi * n / samples);
      Cycle back = from_period(o, states, omega, highest, all);
      // The mean has no phase.
      Eigen::MatrixXcd exact = cycle.motion;
      if (all) exact.col(0) = exact.col(0).real().cast<std::complex<double>>();
      for (Eigen::Index n = 0; n < exact.cols(); ++n)
        period.error((back.motion.col(n) - exact.col(n)).norm());
      const Cycle more = with_orders(cycle, highest + 5, true),
                  again = with_orders(more, highest, all);
      for (Eigen::Index n = 0; n < exact.cols(); ++n)
        kept.error((again.motion.col(n) - cycle.motion.col(n)).norm());
    }
    const Eigen::VectorXd row = Eigen::VectorXd::Unit(3, 0);
    const auto [low, high] = extremes(cycle, row);
    Long least = 1e9L, most = -1e9L;
    for (int n = 0; n < 512; ++n) {
      const double x = state_at(cycle, 2 * units::pi * n / 512)[0];
      least = std::min(least, Long{x}), most = std::max(most, Long{x});
    }
    ends.error(
        static_cast<double>(std::max({Long{0}, low - least - 1e-12L, most - high - 1e-12L})));
    half.error(std::abs(amplitude(cycle, row) - 0.5 * (high - low)));
    REQUIRE(high - static_cast<double>(most) < 0.02 * highest);

    const double turn = draw(0, 6.2), larger = draw.decades(1e-6, 10),
                 faster = draw.decades(1e-6, 1);
    o.channels.clear();
    for (Eigen::Index n = 0; n < 3; ++n)
      o.channels.push_back(
          {Eigen::VectorXd::Unit(3, n), false, Eigen::VectorXd::Unit(3, n), saturation(1, 1)});
    const Cycle here = first_harmonic(o, shape, omega, 1);
    Cycle there = first_harmonic(o, shape * std::polar(1 + larger, turn), omega * (1 + faster), 1);
    apart.error(std::abs(distance(o, here, there) / std::max(larger, faster) - 1) *
                std::max(larger, faster));
    Vector9c one_shape;
    for (auto& z : one_shape) z = {draw(-1, 1), draw(-1, 1)};
    const double T = 2 * units::pi / omega;
    const std::complex<double> multiplier = std::polar(draw.decades(1e-3, 10), draw(-3, 3)),
                               grown = std::exp(exponent(multiplier, T) * T / 2.0);
    growth.error(std::abs(grown / multiplier - 1.0));
    const Motion motion{one_shape, {0, omega}, draw.decades(1, 100)},
        same = motion_of(scaled(motion));
    scale.error((same.shape - motion.shape).norm() + std::abs(same.speed / motion.speed - 1) +
                std::abs(same.lambda.imag() / omega - 1));
  }
}

TEST_CASE("claim: the car against its bodies one by one") {
  Claim dampers("vehicle::equivalent_dampers"), load("vehicle::axle_load"),
      forces("vehicle::assemble"), lateral("vehicle::wheelset_lateral"),
      yaw("vehicle::wheelset_yaw"), rates_claim("cycles::at_speed"),
      channels("vehicle::car_on_track"), compiled("cycles::compile");
  RandomStream draw(4);
  const auto& table = wheelset::cn_table();
  for (int k = 0; k < 500; ++k) {
    const CarParameters data = random_car(draw);
    const Dampers d = equivalent_dampers(data);
    dampers.relative(d.lateral, 4 * Long{data.lateral_friction} /
                                    (long_pi * data.damper_frequency * data.damper_travel));
    dampers.relative(d.warp, 4 * Long{data.warp_friction} /
                                 (long_pi * data.damper_frequency * data.damper_angle));
    load.relative(axle_load(data),
                  Long{9.80665L} / 4 *
                      (Long{data.body_mass} + 2 * Long{data.bolster_mass} +
                       4 * Long{data.sideframe_mass} + 4 * Long{data.wheelset_mass}));
    load.relative(axle_load(data),
                  Long{9.80665L} * (data.wheelset_mass + Long{data.sideframe_mass} +
                                    Long{data.bolster_mass} / 2 + Long{data.body_mass} / 4));
    const FreightCar car = assemble(data, k % 2 == 0 ? Suspension::dampers : Suspension::friction);
    const double speed = draw.decades(1, 100);
    const Vector9 q = random_vector(draw, 9, 0.01),
                  v = random_vector(draw, 9, draw.decades(1e-5, 0.1)), w = random_vector(draw, 9);
    for (int i = 0; i < 4; ++i) {
      const auto at = body_by_body::axle(data, q, i >= 2, i % 2 == 1);
      lateral.error(std::abs(wheelset_lateral(data, i).dot(q) - at.x));
      yaw.error(std::abs(wheelset_yaw(i).dot(q) - at.yaw));
    }
    // Power of all forces in any virtual motion, and the kinetic energy.
    const auto geometry = [&](double x) {
      const auto c = table.at(x);
      return WheelContacts{data.wheel_radius + table.half_spacing * c.R,
                           data.wheel_radius - table.half_spacing * c.R, c.D, -c.D, c.Phi};
    };
    const CarAtSpeed rates = at_speed(car, speed);
    const Vector9 acceleration = rates.acceleration(q, v, [&](double x_over_a) {
      const auto c = table.at(x_over_a * data.half_gauge);
      return Constraint{c.R * table.half_spacing / data.half_gauge, c.D, c.Phi};
    });
    const double power = force_power(data, car.has_friction, speed, geometry, q, v, w),
                 inertia = w.dot(car.mass * acceleration);
    const double size = (car.mass * acceleration).cwiseAbs().dot(w.cwiseAbs());
    forces.error(std::abs(0.5 * v.dot(car.mass * v) / kinetic_energy(data, v) - 1));
    forces.error(std::abs(inertia - power) / size);
    rates_claim.error(std::abs(inertia - power) / size);
    rates_claim.error((at_speed(car, 2 * speed).stiffness - rates.stiffness).norm() /
                      rates.stiffness.norm());
  }
  for (int k = 0; k < 500; ++k) {
    // The same car by its tables, channel by channel; its half gauge is the tables' half spacing.
    CarParameters data = random_car(draw);
    data.half_gauge = table.half_spacing;
    const FreightCar car = assemble(data, k % 2 == 0 ? Suspension::dampers : Suspension::friction);
    const double speed = draw.decades(1, 100);
    const Oscillator o = car_on_track(car, table, speed);
    const Compiled c = compile(o);
    State y, dy;
    y << random_vector(draw, 9, 3e-3), random_vector(draw, 9, draw.decades(1e-5, 0.1));
    c.rate(y, dy);
    const CarAtSpeed rates = at_speed(car, speed);
    const Vector9 exact = rates.acceleration(y.head<9>(), y.tail<9>(), [&](double x_over_a) {
      const auto at = table.at(x_over_a * data.half_gauge);
      return Constraint{at.R, at.D, at.Phi};
    });
    // Each force by itself is as large as this.
    const double size = (rates.damping.cwiseAbs() * y.tail<9>().cwiseAbs() +
                         rates.stiffness.cwiseAbs() * y.head<9>().cwiseAbs())
                            .maxCoeff();
    channels.error((dy.tail<9>() - exact).cwiseAbs().maxCoeff() / size);
    channels.error((dy.head<9>() - y.tail<9>()).norm());
    // M q'' by the oscillator's own matrices.
    Eigen::VectorXd left = o.mass * dy.tail<9>() +
                           (o.damping + o.inverse_speed * o.damping_by_speed) * y.tail<9>() +
                           o.stiffness * y.head<9>();
    for (const Channel& channel : o.channels)
      left -=
          channel.force * channel.law(channel.row.dot(channel.of_rate ? y.tail<9>() : y.head<9>()));
    compiled.error((o.mass.inverse() * left).cwiseAbs().maxCoeff() / size);
    compiled.error((padded(unpadded(y, 9)) - y).norm());
  }
}

TEST_CASE("claim: rest and motions in time") {
  Claim still("cycles::rest"), time("cycles::integrate"), swings("cycles::swing");
  RandomStream draw(5);
  for (int k = 0; k < 1000; ++k) {
    // q'' = -l q for q > 0, -r q for q < 0, started at its upper end: half periods pi/root.
    const double l = draw.decades(0.1, 10), r = draw.decades(0.1, 10), top = draw.decades(1e-3, 1);
    Oscillator o{one, 0 * one, 0 * one, 0 * one, 1.0, {}};
    o.channels.push_back({Eigen::VectorXd::Ones(1),
                          false,
                          -one,
                          {Eigen::Vector3d{-1, 0, 1}, Eigen::RowVector3d{-r, 0, l}}});
    HistoryOptions options;
    options.watch = {Eigen::VectorXd::Ones(1)};
    const Long period = long_pi * (1 / std::sqrt(Long{l}) + 1 / std::sqrt(Long{r}));
    const History h =
        integrate(o, Eigen::Vector2d{top, 0}, static_cast<double>(4.1L * period), options);
    const Long past = 0.1L * period, quarter = long_pi / 2 / std::sqrt(Long{l});
    const Long q = past < quarter ? top * std::cos(std::sqrt(Long{l}) * past)
                                  : -top * std::sqrt(Long{l} / r) *
                                        std::sin(std::sqrt(Long{r}) * (past - quarter));
    time.error(static_cast<double>(std::abs(h.y[0] - q)) / top);
    const Swing s = swing(h, 0, 3);
    swings.relative(s.found ? s.omega : 0, 2 * long_pi / period);
    swings.relative(s.amplitude, top * (1 + std::sqrt(Long{l} / r)) / 2);
    // A push that is no odd function: k q = f(q), of a spring with a bend.
    const double push = draw(-0.5, 0.5);
    Oscillator pushed{one, one, 0 * one, draw.decades(0.1, 10) * one, 1.0, {}};
    pushed.channels.push_back(
        {Eigen::VectorXd::Ones(1),
         false,
         -one,
         {Eigen::Vector3d{-1, 0, 1}, Eigen::RowVector3d{-r - push, -push, l - push}}});
    const Eigen::VectorXd at = rest(pushed);
    still.relative(at[0], push / (Long{pushed.stiffness(0, 0)} + (push > 0 ? l : r)));
  }
}
