#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_branch.hpp>

using namespace railbook;
using namespace railbook::vehicle;
using units::foot, units::inch;

namespace {

// Straight functions with the paper's slopes a dR/dx, a dD/dx, a dPhi/dx, and a steep rise from 0.4
// in on.
wheelset::ConstraintFunctions geometry(double r, double d, double phi, double wall = 0) {
  wheelset::ConstraintFunctions g;
  g.half_spacing = CarParameters{}.half_gauge;
  g.radius = CarParameters{}.wheel_radius;
  const double step = 0.05 * inch;
  const auto table = [&](double slope, double rise) {
    std::vector<double> values;
    for (int k = 0; k <= 15; ++k)
      values.push_back(k * step * slope / g.half_spacing + std::max(0, k - 8) * step * rise);
    return wheelset::OddTable{step, values};
  };
  g.R = table(r, wall);
  g.D = table(d, 20 * wall);
  g.Phi = table(phi, 0.5 * wall);
  return g;
}
wheelset::ConstraintFunctions cone() {
  return geometry(0.05201, 0, 0.05200);
}
wheelset::ConstraintFunctions hollow() {
  return geometry(0.15596, 7.215, 0.04654, 5);
}

// The first harmonic of what the true nonlinear forces leave over, by summing over the cycle.
double harmonic_residual(const QuasiLinearCar& quasi, const wheelset::ConstraintFunctions& table,
                         const Motion& cycle) {
  const auto rates = at_speed(quasi.car(), cycle.speed);
  const double omega = cycle.lambda.imag();
  constexpr int n = 20000;
  Vector9c sum = Vector9c::Zero();
  double size = 0;
  for (int k = 0; k < n; ++k) {
    const Complex turn = std::exp(Complex{0, 2 * units::pi * k / n});
    const Vector9 q = (turn * cycle.shape).real();
    const Vector9 v = (Complex{0, omega} * turn * cycle.shape).real();
    const Vector9 acceleration = rates.acceleration(q, v, [&](double x_over_a) {
      const auto c = table.at(x_over_a * rates.half_gauge);
      return Constraint{c.R, c.D, c.Phi};
    });
    const Vector9 inertia = (-omega * omega * turn * cycle.shape).real();
    sum += (inertia - acceleration).cast<Complex>() * std::conj(turn) * (2.0 / n);
    size = std::max(size, inertia.norm());
  }
  return sum.norm() / size;
}

}  // namespace

TEST_CASE("quasi-linear car: derivatives are those of the residual") {
  std::mt19937 engine{3};
  std::uniform_real_distribution<double> uniform{-1, 1};
  for (const auto suspension : {Suspension::dampers, Suspension::friction}) {
    const QuasiLinearCar car{assemble({}, suspension), hollow()};
    Motion m{Vector9c::NullaryExpr([&] {
               return 0.012 * Complex{uniform(engine), uniform(engine)};
             }),
             {0, 17},
             35};
    const auto at = [&](const Motion& motion) {
      return car.evaluate(motion, car.at(motion.shape, motion.lambda.imag()));
    };
    const auto e = at(m);
    const double h = 1e-6;
    for (int k = 0; k < 18; ++k) {
      Motion low = m, high = m;
      const Complex step = k < 9 ? Complex{1e-2 * h, 0} : Complex{0, 1e-2 * h};
      low.shape[k % 9] -= step;
      high.shape[k % 9] += step;
      const Vector9c slope = (at(high).residual - at(low).residual) / (2e-2 * h);
      Eigen::Matrix<double, 18, 1> both;
      both << slope.real(), slope.imag();
      CHECK((both - e.by_shape.col(k)).norm() < 1e-5 * e.by_shape.col(k).norm());
    }
    Motion low = m, high = m;
    low.lambda -= Complex{0, 17 * h};
    high.lambda += Complex{0, 17 * h};
    const Vector9c by_frequency = (at(high).residual - at(low).residual) / (34 * h);
    CHECK((by_frequency - e.by_frequency).norm() < 1e-6 * by_frequency.norm());
    low = high = m;
    low.speed -= 35 * h;
    high.speed += 35 * h;
    const Vector9c by_speed = (at(high).residual - at(low).residual) / (70 * h);
    CHECK((by_speed - e.by_speed).norm() < 1e-6 * by_speed.norm());
  }
}

TEST_CASE("Hopf points: rate of growth against solving again") {
  const auto table = hollow();
  const QuasiLinearCar car{assemble({}, Suspension::dampers), table};
  const auto hopf = hopf_points(car, 3, 120).front();
  const double h = 1e-3;
  const auto growth = [&](double speed) {
    return modes(car, car.small(), speed).front().lambda.real();
  };
  const double v = hopf.motion.speed;
  CHECK(hopf.rate_by_speed.real() ==
        Approx((growth(v + h) - growth(v - h)) / (2 * h)).epsilon(1e-5));
}

// 145 ft/s with new wheels; 12, 21 and 26 rad/s are in the paper's text. The slopes are those of
// the reconstructed profiles; the further digits were computed by an independent program from the
// same slopes.
TEST_CASE("Hopf points: the paper's car") {
  struct Case {
    wheelset::ConstraintFunctions table;
    double v[2], omega[2];
  };
  const Case cases[]{{cone(), {144.54, 152.42}, {12.05, 13.09}},
                     {hollow(), {130.36, 175.59}, {21.12, 26.63}},
                     {geometry(0.42601, 11.426, 0.13878), {86.79, 102.31}, {26.14, 30.68}}};
  for (const auto& c : cases) {
    const QuasiLinearCar car{assemble({}, Suspension::dampers), c.table};
    const auto found = hopf_points(car, 3, 120);
    REQUIRE(found.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(found[k].motion.speed / foot == Approx(c.v[k]).margin(0.006));
      CHECK(found[k].motion.lambda.imag() == Approx(c.omega[k]).margin(0.006));
    }
  }
}

TEST_CASE("limit cycles: the true forces have no first harmonic left") {
  const auto table = hollow();
  for (const auto suspension : {Suspension::dampers, Suspension::friction}) {
    const QuasiLinearCar car{assemble({}, suspension), table};
    BranchOptions options;
    if (suspension == Suspension::friction) options.first_amplitude = 0.001 * inch;
    const auto hopf = hopf_points(car, 3, 120);
    const auto branch = trace_from(car, hopf.back(), options);
    REQUIRE(branch.points.size() > 40);
    for (std::size_t k = 0; k < branch.points.size(); k += branch.points.size() / 5)
      CHECK(harmonic_residual(car, table, branch.points[k].motion) < 1e-6);
  }
}

TEST_CASE("limit cycles: folds, cycles at an amplitude and at a speed") {
  const QuasiLinearCar car{assemble({}, Suspension::dampers), hollow()};
  const auto hopf = hopf_points(car, 3, 120);
  const auto branch = trace_from(car, hopf[0], {});
  CHECK(branch.end == BranchEnd::amplitude);
  // What it costs today: a walk that is a little wrong still arrives, and takes longer.
  CHECK(branch.folds.size() == 2);
  CHECK(static_cast<int>(branch.points.size()) == Approx(226).margin(2));
  CHECK(branch.newton_steps == Approx(815).epsilon(0.03));
  CHECK(branch.rejected_steps == Approx(24).margin(2));
  for (const auto& fold : branch.folds) {
    CAPTURE(fold.largest / inch, fold.motion.speed / foot, fold.speed_by_amplitude);
    // At a fold the amplitude's criterion changes sign, and V is extreme: neighbours are on one
    // side.
    const auto near = find_cycle(car, fold.motion, fold.largest * (1 + 1e-4));
    const auto other = find_cycle(car, fold.motion, fold.largest * (1 - 1e-4));
    REQUIRE((near.converged && other.converged));
    CHECK((near.cycle.motion.speed - fold.motion.speed) *
              (other.cycle.motion.speed - fold.motion.speed) >
          0);
    CHECK(near.cycle.speed_by_amplitude * other.cycle.speed_by_amplitude < 0);
  }
  const auto at = cycles_at_amplitude(car, branch, 0.45 * inch);
  REQUIRE(at.size() == 1);
  CHECK(at[0].largest == Approx(0.45 * inch).epsilon(1e-10));
  for (const auto& cycle : cycles_at_speed(car, branch, at[0].motion.speed))
    CHECK(cycle.motion.speed == Approx(at[0].motion.speed).epsilon(1e-10));
  // On the straight part every amplitude is a cycle at the linear car's speed.
  CHECK(branch.points.front().neutral);
  CHECK(branch.points.front().motion.speed == Approx(hopf[0].motion.speed).epsilon(1e-9));
}

TEST_CASE("linear stability: what cannot be asked is refused") {
  const QuasiLinearCar car{assemble({}, Suspension::dampers), cone()};
  CHECK_THROWS_AS(hopf_points(car, 0, 10), InputError);
  CHECK_THROWS_AS(hopf_points(car, 20, 10), InputError);
  CHECK_THROWS_AS(modes(car, car.small(), 0), InputError);
  auto other = cone();
  other.half_spacing *= 1.01;
  CHECK_THROWS_WITH((QuasiLinearCar{assemble({}, Suspension::dampers), other}),
                    Catch::Contains("half spacing"));
}
