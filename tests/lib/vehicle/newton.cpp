// Newton's iterations inside: derivatives are those of what they derive, and each step is as the
// square of the one before it. A
// wrong derivative still arrives, and takes longer.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/detail/branch_solver.hpp>
#include <railbook/num/random_stream.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/cycle_solver.hpp>
#include <railbook/vehicle/refine_cycle.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/seen_by.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using Eigen::MatrixXd, Eigen::VectorXd, Eigen::Index;
using tests::seen_by;

namespace {

VectorXd random_vector(num::RandomStream& draw, Index n) {
  return VectorXd::NullaryExpr(n, [&](Index) { return draw(-1, 1); });
}
MatrixXd random_matrix(num::RandomStream& draw, Index rows, Index columns) {
  return MatrixXd::NullaryExpr(rows, columns, [&](Index, Index) { return draw(-1, 1); });
}

// The largest error of a derivative by central differences, column by column, over its largest
// entry.
template <class F>
double off(F&& f, const VectorXd& x, const MatrixXd& derivative, double h) {
  double worst = 0;
  for (Index i = 0; i < x.size(); ++i) {
    const VectorXd move = h * VectorXd::Unit(x.size(), i);
    const VectorXd slope = (f(x + move) - f(x - move)) / (2 * h);
    worst = std::max(worst, (slope - derivative.col(i)).lpNorm<Eigen::Infinity>());
  }
  return worst / derivative.cwiseAbs().maxCoeff();
}

// Of every kind of force: laws of a motion with two outputs, of a rate, and a smooth one of three
// scalars that sees its speed; the last
// coordinate is seen by none.
Oscillator of_all_kinds(num::RandomStream& draw) {
  constexpr Index n = 4;
  const MatrixXd a = random_matrix(draw, n, n), one = MatrixXd::Identity(n, n);
  Oscillator o{one + 0.2 * a * a.transpose(),
               0.3 * one + 0.1 * a,
               0.2 * one,
               2 * one + 0.3 * a,
               0.3,
               {},
               {}};
  o.channels.push_back({VectorXd::Unit(n, 0),
                        false,
                        random_matrix(draw, n, 2),
                        {Eigen::Vector4d{-0.7, -0.2, 0.3, 0.9}, random_matrix(draw, 2, 4)}});
  o.channels.push_back({VectorXd::Unit(n, 1), true, random_matrix(draw, n, 1), saturation(1, 0.4)});
  Coupling c;
  c.of_motion = c.of_rate = c.of_rate_by_speed = MatrixXd::Zero(3, n);
  c.of_motion.leftCols(3) = random_matrix(draw, 3, 3);
  c.of_rate.leftCols(3) = random_matrix(draw, 3, 3);
  c.of_rate_by_speed.leftCols(3) = random_matrix(draw, 3, 3);
  c.force = random_matrix(draw, n, 2);
  c.law = [](const double* s, double* f, double* slope) {
    f[0] = s[0] * s[1] + std::sin(s[2]), f[1] = s[0] * s[0] * s[2] - s[1];
    if (!slope) return;
    const double all[6] = {s[1], s[0], std::cos(s[2]), 2 * s[0] * s[2], -1, s[0] * s[0]};
    std::copy(all, all + 6, slope);
  };
  o.couplings.push_back(std::move(c));
  return o;
}

}  // namespace

TEST_CASE(
    "Derivatives are those of differences: balance, motion in time, creep that friction limits",
    "[newton]") {
  num::RandomStream draw(1);
  for (int k = 0; k < 6; ++k) {
    const Oscillator o = of_all_kinds(draw);
    // Rows are in units of their diagonal terms, which here do not depend on the frequency.
    Oscillator even = o;
    for (MatrixXd* m : {&even.mass, &even.damping, &even.damping_by_speed})
      m->diagonal().head(3).setZero();
    CycleEquations equations(even, orders_up_to(k % 2 == 0 ? 4 : 5, k % 2 == 0));
    const Index n = equations.size();
    REQUIRE(n == 3 * (k % 2 == 0 ? 9 : 6));
    VectorXd x(n + 1);
    x << 0.6 * random_vector(draw, n), draw(0.5, 2);
    MatrixXd jacobian;
    const VectorXd left = equations.residual(x.head(n), x[n], jacobian);
    CHECK((left - equations.residual(x.head(n), x[n])).norm() == 0);
    CHECK(off([&](const VectorXd& at) { return equations.residual(at.head(n), at[n]); }, x,
              jacobian, 1e-6) < 1e-5);
    // Turned by a small angle, the unknowns are those of the same motion a little later.
    CHECK(equations.turned(equations.turned(x.head(n)))(equations.places(1)) ==
          -x.head(n)(equations.places(1)));
    CHECK(equations.unknowns(equations.motion()) == x.head(n));

    const Compiled system = compile(o);
    const State y = padded(random_vector(draw, 8));
    StateMatrix J;
    system.jacobian(y, J);
    CHECK(off(
              [&](const VectorXd& at) {
                State rate;
                system.rate(at, rate);
                return VectorXd(rate);
              },
              y, J, 1e-6) < 1e-7);
  }
  const auto& table = wheelset::cn_table();
  // Any smooth curve of the three demands.
  const CreepCurve own = [](const double* t, double* share, double* slope) {
    share[0] = std::tanh(t[0]) * std::cos(t[2]), share[1] = std::tanh(t[1] + 0.5 * t[2]);
    if (!slope) return;
    const double s = 1 - share[1] * share[1], c = std::cosh(t[0]);
    const double all[6] = {
        std::cos(t[2]) / (c * c), 0, -std::tanh(t[0]) * std::sin(t[2]), 0, s, 0.5 * s};
    std::copy(all, all + 6, slope);
  };
  for (int k = 0; k < 60; ++k) {
    CarParameters data;
    if (k % 3 == 0) data.f12 = 0;
    const FreightCar car = assemble(data, Suspension::dampers);
    Oscillator o = car_on_track(car, table, 30);
    limit_creep(o, car, table, {.friction = 0.3, .curve = k % 2 == 0 ? CreepCurve{} : own});
    const auto& law = o.couplings[std::size_t(k) % wheelsets].law;
    const double size = draw.decades(1e-4, 1e-2);
    const VectorXd s = Eigen::Vector3d{size, size, 8e-3}.cwiseProduct(random_vector(draw, 3));
    Eigen::Matrix<double, 2, 3, Eigen::RowMajor> slope;
    double f[2];
    law(s.data(), f, slope.data());
    // Within a step of the table its functions are straight.
    CHECK(off(
              [&](const VectorXd& at) {
                VectorXd force(2);
                law(at.data(), force.data(), nullptr);
                return force;
              },
              s, slope, 1e-8) < 1e-5);
    const double nothing[3] = {0, 0, 0};
    law(nothing, f, slope.data());
    CHECK((f[0] == 0 && f[1] == 0));
    if (k % 2 == 0) CHECK(slope.norm() == 0);
  }
}

namespace {

// Lengths of steps, one after the other, of which each is at most `bound` times the square of the
// one before, down to rounding.
void check_squares(const std::vector<double>& steps, double bound, double floor) {
  CAPTURE(steps);
  REQUIRE(steps.size() > 2);
  CHECK(steps.front() > 1e-4);
  CHECK(steps.back() <= floor);
  for (std::size_t k = 1; k < steps.size(); ++k)
    CHECK(steps[k] <= bound * steps[k - 1] * steps[k - 1] + floor);
}

// Circles of radius^2 = p, omega^2 = 1 + p/2.
Family on_circles() {
  Family family;
  family.oscillator = seen_by(2, [](const Complex* s, Complex* f) {
    const Complex rho = s[0] * s[0] + s[1] * s[1], radial = s[0] * s[2] + s[1] * s[3];
    for (int i = 0; i < 2; ++i) f[i] = -rho * s[2 + i] - (0.5 * rho + 2.0 * radial) * s[i];
  });
  family.set = [](Oscillator& o, double p) {
    if (!(p > -1)) throw InputError("parameter");
    o.damping(0, 0) = o.damping(1, 1) = -p;
  };
  family.watch = {VectorXd::Unit(2, 0)};
  family.scale = 2;
  return family;
}
BranchPoint circle(BranchSolver& solver, double radius, double omega, double p) {
  Eigen::MatrixXcd motion = Eigen::MatrixXcd::Zero(2, Index(solver.orders().size()));
  motion.col(0) << radius, Complex{0, -radius};
  return {solver.equations().unknowns(motion), omega, p};
}

}  // namespace

TEST_CASE("Newton's steps are as the squares of those before: on a branch, from near and from far",
          "[newton]") {
  const Family family = on_circles();
  BranchSolver solver{family, {1, 3, 5}};
  const double p = 0.5, omega = std::sqrt(1 + 0.5 * p), radius = std::sqrt(p);
  num::RandomStream draw(2);
  const BranchPoint exact = circle(solver, radius, omega, p);
  solver.measure(exact);
  const VectorXd at = solver.scaled(exact), hold = VectorXd::Unit(at.size(), at.size() - 1);
  CHECK(at[at.size() - 2] == Approx(std::log(omega)));
  CHECK(at[at.size() - 1] == Approx(p / 2));
  const BranchPoint again = solver.place(at);
  CHECK((again.z - exact.z).norm() + std::abs(again.omega - omega) + std::abs(again.parameter - p) <
        1e-14);
  for (int k = 0; k < 10; ++k) {
    VectorXd x = at + 0.03 * random_vector(draw, at.size());
    std::vector<double> steps;
    bool done = false;
    for (int n = 0; n < 12 && !done; ++n) {
      const VectorXd before = x;
      done = solver.correct(x, hold, hold.dot(at), 1);
      steps.push_back((x - before).norm());
    }
    CHECK(done);
    check_squares(steps, 10, 1e-9);
    CHECK((x - at).norm() < 1e-9);
  }
  // The tangent, by solutions to either side: d(ln omega) = dp / (4 omega^2), d(radius)/radius = dp
  // / (2 p).
  VectorXd x = at;
  REQUIRE(solver.correct(x, hold, hold.dot(at)));
  for (const double sign : {1.0, -1.0}) {
    const VectorXd t = solver.tangent(sign * hold), d = solver.direction(t);
    CHECK(t.norm() == Approx(1).epsilon(1e-12));
    const double dp = d[d.size() - 1];
    CHECK(sign * dp > 0);
    CHECK(d[d.size() - 2] / dp == Approx(1 / (4 * omega * omega)).epsilon(1e-5));
    CHECK(exact.z.dot(d.head(exact.z.size())) / exact.z.squaredNorm() / dp ==
          Approx(1 / (2 * p)).epsilon(1e-5));
    CHECK((solver.scaled_direction(d) - t).norm() < 1e-12);
  }
  // A step of more than 2 is none of a start that is near; from far it is shortened.
  for (const double factor : {0.7, 3.0}) {
    const BranchPoint poor = circle(solver, factor * radius, omega * (factor > 1 ? 1.6 : 0.8), p);
    solver.measure(poor);
    const VectorXd start = solver.scaled(poor);
    x = start;
    CHECK(solver.approach(x, hold, hold.dot(start)));
    CHECK(solver.place(x).omega == Approx(omega).epsilon(1e-9));
    CHECK(solver.place(x).z.norm() == Approx(exact.z.norm()).epsilon(1e-9));
  }
  solver.measure(exact);
  x = at;
  CHECK_FALSE(solver.correct(x, hold, 5));  // 4.75 away
  CHECK(solver.iterations() == 1);
  // Where the family refuses, and where there is no frequency, there is no solution.
  x = at;
  CHECK_FALSE(solver.correct(x, hold, -1));
  x = at;
  CHECK_FALSE(solver.approach(x, hold, -1));
  x = at, x[x.size() - 2] = 30;
  CHECK_FALSE(solver.correct(x, hold, hold.dot(at)));
  // More harmonics and fewer: what is there is carried over.
  BranchPoint carried = circle(solver, radius, omega, p);
  VectorXd direction = solver.direction(solver.tangent(hold));
  const VectorXd before = direction;
  solver.use(orders_up_to(8, true), {&carried.z, &direction});
  CHECK(carried.z.size() == 2 * 17);
  CHECK(direction.size() == 2 * 17 + 2);
  CHECK(direction.norm() == Approx(before.norm()));
  CHECK(direction.tail(2) == before.tail(2));
  solver.use({1, 3, 5}, {&carried.z, &direction});
  CHECK(carried.z == exact.z);
  CHECK(direction == before);
}

TEST_CASE(
    "Newton's steps are as the squares of those before: the quasi-linear car and closed orbits",
    "[newton]") {
  for (const auto suspension : {Suspension::dampers, Suspension::friction}) {
    const QuasiLinearCar car{assemble({}, suspension), wheelset::heumann_table()};
    const Motion hopf = hopf_points(car, 5, 100).back().motion;
    const double amplitude = (suspension == Suspension::friction ? 0.01 : 0.1) * units::inch;
    const CycleSearch search = find_cycle(car, hopf, amplitude);
    REQUIRE(search.converged);
    const Unknowns u = scaled(search.cycle.motion);
    num::RandomStream draw(3);
    const Unknowns start = u + 0.01 * u.cwiseProduct(random_vector(draw, 20));
    const int largest = largest_wheelset(car.car(), search.cycle.motion.shape);
    const BranchCondition picks[]{
        {.kind = BranchCondition::hyperplane, .normal = u, .value = u.dot(u)},
        {.kind = BranchCondition::amplitude, .wheelset = largest, .value = amplitude},
        {.kind = BranchCondition::speed, .value = search.cycle.motion.speed}};
    const auto steps_of = [](auto&& solved) {
      std::vector<double> steps;
      for (int most = 1; most <= 12; ++most) {
        const Solved s = solved(most);
        steps.push_back(s.update);
        if (!s.converged) continue;
        CHECK(s.iterations == most);
        break;
      }
      return steps;
    };
    for (const BranchCondition& pick : picks)
      check_squares(steps_of([&](int most) { return solve_cycle(car, start, u, pick, most); }), 100,
                    1e-10);
    Motion near = hopf;
    near.speed *= 1.01, near.lambda *= 1.01;
    check_squares(steps_of([&](int most) { return solve_linear(car, car.small(), near, most); }),
                  10, 1e-9);
    const auto point = find_hopf(car, near);
    REQUIRE(point.converged);
    CHECK(point.point.iterations <= 6);
  }
  // Rayleigh's cycle, from 2 % off.
  const MatrixXd one = MatrixXd::Identity(1, 1);
  Oscillator o{one, -one, 0 * one, one, 1.0, {}};
  o.channels.push_back(
      {VectorXd::Ones(1), true, -one, sampled([](double v) { return v * v * v / 3; }, -4, 4, 800)});
  const Cycle cycle = balance(o, first_harmonic(o, 2 * Eigen::VectorXcd::Ones(1), 1.0, 31));
  REQUIRE(cycle.converged);
  const VectorXd y = 1.02 * state_at(cycle, 0.3);
  for (const bool symmetric : {true, false}) {
    std::vector<double> closings;
    for (int most = 1; most <= 8; ++most) {
      const Orbit orbit = shoot(o, y, 2 * units::pi / cycle.omega,
                                {.symmetric = symmetric, .most_iterations = most});
      closings.push_back(orbit.closing);
      if (!orbit.converged)
        CHECK(orbit.reason == "does not close after " + std::to_string(most) + " iterations");
      if (orbit.converged) break;
    }
    check_squares(closings, 10, 1e-9);
  }
}

TEST_CASE("Rest is found by as few evaluations as Newton needs", "[newton]") {
  int asked = 0;
  Oscillator o = seen_by(3, [&asked](const Complex* s, Complex* f) {
    for (int i = 0; i < 3; ++i)
      f[i] = 0.4 * (i + 1) - s[i] * s[i] * s[i] - 0.3 * s[(i + 1) % 3] * s[i];
    ++asked;
  });
  const VectorXd q = rest(o);
  for (int i = 0; i < 3; ++i)
    CHECK(q[i] + q[i] * q[i] * q[i] + 0.3 * q[(i + 1) % 3] * q[i] == Approx(0.4 * (i + 1)));
  // Seven calls of the function an evaluation, for its six derivatives; two evaluations a step.
  CHECK(asked <= 7 * 2 * 7);
}
