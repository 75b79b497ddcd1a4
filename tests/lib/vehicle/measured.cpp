// What is measured of motions, where a range, a table or a count ends, and what may be zero.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/continuation.hpp>
#include <railbook/cycles/detail/cycle_equations.hpp>
#include <railbook/cycles/floquet.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/cycles/multipliers.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/vehicle/linear_stability.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/seen_by.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using Eigen::MatrixXd, Eigen::VectorXd;
using tests::seen_by;

namespace {

// q'' + 2 d q' + w^2 q = 0 in one coordinate that a channel with a limit watches; and another one
// at rest.
Oscillator ringing(double d, double w, double limit) {
  MatrixXd one = MatrixXd::Identity(2, 2);
  Oscillator o{one, 2 * d * one, 0 * one, w * w * one, 1.0, {}, {}};
  o.channels.push_back({VectorXd::Unit(2, 0), false, 0 * one.leftCols(1), saturation(1, 1), limit});
  return o;
}
HistoryOptions watching(Integrator integrator) {
  HistoryOptions options;
  options.integrator = integrator;
  options.tolerance = 1e-10;
  options.scale.setOnes();
  options.watch = {VectorXd::Unit(2, 0), -2 * VectorXd::Unit(2, 0)};
  return options;
}
constexpr Integrator all_three[] = {Integrator::pieces, Integrator::dopri5, Integrator::radau5};

}  // namespace

TEST_CASE("Turns, rises and samples of a motion that dies out, by every integrator", "[measured]") {
  const double d = 0.05, w0 = 2, w = std::sqrt(w0 * w0 - d * d), T = 2 * units::pi / w;
  // q = exp(-d t) cos(w t).
  const Oscillator o = ringing(d, w0, 5);
  for (const Integrator integrator : all_three) {
    auto options = watching(integrator);
    options.sample_step = 0.37;
    const double duration = 5.3 * T;
    const History h = integrate(o, Eigen::Vector4d{1, 0, -d, 0}, duration, options);
    CHECK(h.end == History::End::completed);
    CHECK(h.t == Approx(duration).epsilon(1e-12));
    CHECK((h.steps > 3 && h.evaluations >= h.steps));
    const double late = std::atan(d / w) / w;  // before each crest of the cosine
    for (std::size_t row = 0; row < 2; ++row) {
      const double factor = row == 0 ? 1 : -2;
      const auto& turns = h.turns[row];
      // The first crest is just before the start.
      REQUIRE(turns.size() == 10);
      for (std::size_t k = 0; k < turns.size(); ++k) {
        const double t = T * double(k + 1) / 2 - late, sign = k % 2 == 0 ? -1 : 1;
        CHECK(turns[k].t == Approx(t).margin(1e-6));
        CHECK(turns[k].x == Approx(factor * sign * std::exp(-d * t) * std::cos(w * late)));
      }
      const auto& rises = h.rises[row];
      REQUIRE(rises.size() == 5 + row);
      for (std::size_t k = 0; k < rises.size(); ++k)
        CHECK(rises[k] == Approx(T * (double(k) + (row == 0 ? 0.75 : 0.25))).epsilon(1e-7));
      REQUIRE(h.samples.cols() == Eigen::Index(h.sample_times.size()));
      REQUIRE(h.sample_times.size() == std::size_t(duration / 0.37) + 1);
      for (std::size_t k = 0; k < h.sample_times.size(); ++k) {
        const double t = 0.37 * double(k);
        CHECK(h.sample_times[k] == Approx(t));
        CHECK(h.samples(Eigen::Index(row), Eigen::Index(k)) ==
              Approx(factor * std::exp(-d * t) * std::cos(w * t)).margin(1e-7));
      }
      // Halves of peak to peak of two periods, each e^(-dT) of the one before.
      const Swing s = swing(h, row, 2);
      REQUIRE(s.found);
      CHECK(s.omega == Approx(w).epsilon(1e-7));
      const double crest = std::abs(factor) * std::cos(w * late), fall = std::exp(-d * T / 2);
      // A period from a rise on holds its crest and the trough behind it.
      const auto half = [&](double n) {
        return 0.5 * crest * std::exp(d * late) * std::pow(fall, n) * (1 + fall);
      };
      const double first = row == 0 ? 6 : 7;
      CHECK(s.amplitude == Approx(0.5 * (half(first) + half(first + 2))));
      CHECK(s.spread == Approx(half(first) - half(first + 2)));
      CHECK(swing(h, row, 4 + int(row)).found);
      CHECK_FALSE(swing(h, row, 5 + int(row)).found);
    }
    // As many steps as are allowed, and no more.
    options.most_steps = 3;
    const History cut = integrate(o, Eigen::Vector4d{1, 0, -d, 0}, duration, options);
    CHECK(cut.end == History::End::stalled);
    CHECK(cut.t < duration);
    CHECK(cut.steps <= 4);
  }
}

TEST_CASE("A motion that grows past the end of its table, on either side", "[measured]") {
  const double d = -0.1, w0 = 3, w = std::sqrt(w0 * w0 - d * d);
  for (const Integrator integrator : all_three)
    for (const double side : {1.0, -1.0})
      for (const double limit : {0.7, 2.0, 3.7}) {
        const Oscillator o = ringing(d, w0, limit);
        const auto q = [&](double t) { return std::exp(-d * t) * std::sin(w * t) * 0.5; };
        const History h =
            integrate(o, Eigen::Vector4d{0, 0, side * 0.5 * w, 0}, 100, watching(integrator));
        CHECK(h.end == History::End::left_table);
        CHECK(h.channel == 0);
        CHECK(std::abs(q(h.t)) == Approx(limit).epsilon(1e-6));
        // The first time.
        double most = 0;
        for (double t = 0; t < h.t - 1e-3; t += 1e-3) most = std::max(most, std::abs(q(t)));
        CHECK(most < limit);
      }
}

TEST_CASE("A critical speed belongs to each range that holds it, however near an end",
          "[measured]") {
  // With and without what holds the body sideways, which makes the pencil singular and the speeds
  // be searched.
  for (const double factor : {1.0, 0.0}) {
    CarParameters data;
    data.lateral_stiffness *= factor;
    const QuasiLinearCar car{assemble(data, Suspension::dampers), wheelset::heumann_table()};
    const auto all = hopf_points(car, 2, 150);
    REQUIRE_FALSE(all.empty());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double v = all[k].motion.speed;
      for (const double part : {1e-7, 1e-3}) {
        CHECK(hopf_points(car, v * (1 - part), v * (1 + part)).size() == 1);
        CHECK(hopf_points(car, v * (1 - part), 150).size() == all.size() - k);
        CHECK(hopf_points(car, v * (1 + part), 150).size() == all.size() - k - 1);
        CHECK(hopf_points(car, 2, v * (1 + part)).size() == k + 1);
        CHECK(hopf_points(car, 2, v * (1 - part)).size() == k);
      }
      CHECK(all[k].residual < 1e-9);
      // The adjoint is the left null vector.
      const auto z = car.dynamic_stiffness(car.small(), all[k].motion.lambda, v);
      CHECK((z.adjoint() * all[k].adjoint).norm() < 1e-9 * z.norm());
      CHECK(all[k].adjoint.norm() == Approx(1));
    }
  }
}

TEST_CASE("What may be zero of a car, and what may not", "[measured]") {
  std::string zero;
  for (const CarDatum& datum : car_data()) {
    CarParameters data;
    data.*datum.member = 0;
    try {
      require_valid(data);
      zero += std::string(datum.key) + " ";
    } catch (const InputError&) {
      continue;
    }
  }
  // Side frames and bolsters may be light, springs and friction absent.
  CHECK(zero ==
        "bolster-mass sideframe-mass bolster-yaw-inertia bolster-roll-inertia lateral-stiffness "
        "vertical-stiffness warp-stiffness lateral-friction vertical-friction warp-friction "
        "centre-plate-friction f12 f22 bolster-depth ");
  // As the paper prints them, in its units.
  for (const CarDatum& datum : car_data()) {
    const double printed = CarParameters{}.*datum.member / datum.unit_si;
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", printed);
    CAPTURE(datum.key, printed);
    CHECK(printed == Approx(std::strtod(text, nullptr)).epsilon(1e-12));
  }
}

TEST_CASE("Wheels beyond the end of the table have the angle of its end", "[measured]") {
  const FreightCar car = assemble({}, Suspension::dampers);
  auto table = wheelset::cn_table();
  const CreepLimit limit{0.3, {}};
  Cycle cycle;
  cycle.omega = 1, cycle.inverse_speed = 1e-12, cycle.orders = {0, 1};
  cycle.motion = Eigen::MatrixXcd::Zero(9, 2);
  const auto used = [&](double x) {
    cycle.motion(X_TF, 0) = cycle.motion(X_TR, 0) = x;
    return cycle_forces(car, table, limit, cycle, 8);
  };
  // A standing wheelset creeps by spin alone, which the table's own functions say; angles are the
  // columns'.
  for (const double sign : {1.0, -1.0}) {
    const CycleForces at = used(sign * table.end()), beyond = used(sign * 1.5 * table.end());
    const auto c = table.at(sign * table.end()), out = table.at(sign * 1.5 * table.end());
    CHECK(at.lateral_over_vertical[0] > 0.5);
    for (const auto& [forces, roll] : {std::pair{at, c.Phi}, std::pair{beyond, out.Phi}}) {
      const double angle =
                       (sign > 0 ? table.delta_left
                                 : table.delta_right)[sign > 0 ? table.delta_left.size() - 1 : 0] +
                       sign * roll,
                   t = std::tan(angle);
      // Between what friction pushes up and what it holds down.
      CHECK(forces.lateral_over_vertical[0] <= (t + 0.3) / (1 - 0.3 * t) + 1e-9);
      CHECK(forces.lateral_over_vertical[0] >= (t - 0.3) / (1 + 0.3 * t) - 1e-9);
    }
  }
  for (const int samples : {7, (1 << 20) + 1})
    CHECK_THROWS_AS(cycle_forces(car, table, limit, cycle, samples), InputError);
  CHECK_NOTHROW(cycle_forces(car, table, limit, cycle, 8));
  CHECK_THROWS_AS(cycle_forces(car, table, {0, {}}, cycle, 8), InputError);
}

TEST_CASE("Samples of a period: a power of two, as many as the harmonics need or as are wanted",
          "[measured]") {
  for (const auto& [highest, wanted, samples] : {std::tuple{1, 0, 512},
                                                 {32, 0, 512},
                                                 {33, 0, 1024},
                                                 {95, 0, 2048},
                                                 {3, 8, 16},
                                                 {2, 8, 8},
                                                 {1, 1, 8},
                                                 {10, 100, 128},
                                                 {10, 128, 128},
                                                 {10, 129, 256},
                                                 {40, 100, 256},
                                                 {3, 1, 16}})
    CHECK(samples_for(highest, wanted) == samples);
}

TEST_CASE("Multipliers of a smooth law: of higher order than two, in any number of steps",
          "[measured]") {
  // Circles of radius 1 that a third coordinate rides on: exact exponents of the half period.
  const Oscillator o = seen_by(3, [](const Complex* s, Complex* f) {
    const Complex rho = s[0] * s[0] + s[1] * s[1], radial = s[0] * s[3] + s[1] * s[4];
    for (int i = 0; i < 2; ++i) f[i] = (1.0 - rho) * s[3 + i] - 2.0 * radial * s[i];
    f[2] = -0.4 * rho * s[5] - 2.0 * s[2];
  });
  Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(3);
  shape[0] = 1, shape[1] = Complex{0, -1};
  Cycle cycle = first_harmonic(o, shape, 1, 3);
  const auto error = [&](int steps) {
    const Multipliers m = multipliers(o, cycle, steps);
    CHECK(m.symmetric == is_odd(cycle));
    REQUIRE(m.map.size() == 5);
    for (std::size_t k = 1; k < 5; ++k)
      CHECK(std::abs(m.map[k]) <= std::abs(m.map[k - 1]) * (1 + 1e-12));
    double nearest = 1;
    const double part = m.symmetric ? units::pi : 2 * units::pi;
    for (const Complex x : m.map)
      nearest = std::min(nearest, std::abs(std::abs(x) - std::exp(-0.2 * part)));
    CHECK(m.trivial_error < 600 / std::pow(std::max(steps, 16), 3));
    return nearest;
  };
  for (int pass = 0; pass < 2; ++pass) {
    const double coarse = error(64), fine = error(128), finer = error(256);
    CAPTURE(coarse, fine, finer);
    CHECK(coarse > 6 * fine);
    CHECK(fine > 6 * finer);
    // An odd number is made even, and one too small for the harmonics doubled.
    CHECK(error(63) == error(64));
    cycle = with_orders(cycle, 4, true);
    CHECK(error(8) == error(16));
  }
  CHECK_THROWS_AS(multipliers(o, cycle, 3), InputError);
  CHECK_THROWS_AS(hill_exponent(o, cycle, -0.1, 5), InputError);
}

TEST_CASE("Shooting says why it does not close", "[measured]") {
  const MatrixXd one = MatrixXd::Identity(1, 1);
  // A repeller: whatever begins beside it leaves the table.
  Oscillator o{one, -one, 0 * one, one, 1.0, {}, {}};
  o.channels.push_back({VectorXd::Ones(1), false, 0 * one, saturation(1, 1), 2});
  const auto reason = [&](const Eigen::Vector2d& y, double period, const ShootingOptions& options) {
    const Orbit orbit = shoot(o, y, period, options);
    CHECK_FALSE(orbit.converged);
    return orbit.reason;
  };
  CHECK(reason({1, 1}, 30, {}) == "the motion leaves the tables");
  CHECK_THAT(reason({1, 1}, 3, {.most_steps = 1}), Catch::Contains("too stiff"));
  CHECK_THROWS_AS(shoot(o, Eigen::Vector3d{1, 1, 1}, 1), InputError);
  CHECK_THROWS_AS(shoot(o, Eigen::Vector2d{1, NAN}, 1), InputError);
  CHECK_THROWS_AS(shoot(o, Eigen::Vector2d{1, 1}, 0), InputError);
  CHECK(stability(Orbit{}).largest == 0);
}
