// The integrators: a blow-up, a stiff problem, and their work.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/radau5.hpp>

using namespace railbook;
using State = Eigen::Vector2d;

namespace {
constexpr double mu = 100;
const auto van_der_pol = [](double, const State& y, State& dy) {
  dy << y[1], mu * (1 - y[0] * y[0]) * y[1] - y[0];
};
const auto its_jacobian = [](double, const State& y, Eigen::Matrix2d& j) {
  j << 0, 1, -2 * mu * y[0] * y[1] - 1, mu * (1 - y[0] * y[0]);
};

struct Work {
  long steps = 0, rejections = 0, evaluations = 0;
};
// In `pieces` of equal length, as one who wants the answer there.
Work implicit(double tolerance, int pieces) {
  num::Radau5<2> solver{State::Constant(tolerance), 1e-3};
  solver.restart(0, State{1, 0});
  Work work;
  for (int k = 1; k <= pieces; ++k)
    for (; solver.t() < 100.0 * k / pieces; ++work.steps)
      REQUIRE(solver.step(van_der_pol, its_jacobian, 100.0 * k / pieces));
  return {work.steps, solver.rejections(), solver.evaluations()};
}
Work explicit_steps(double tolerance, int pieces) {
  num::Dopri5<2> solver{State::Constant(tolerance), 1e-3};
  solver.restart(van_der_pol, 0, State{1, 0});
  Work work;
  for (int k = 1; k <= pieces; ++k)
    for (; solver.t() < 5.0 * k / pieces; ++work.steps)
      REQUIRE(solver.step(van_der_pol, 5.0 * k / pieces));
  return {work.steps, solver.rejections(), solver.evaluations()};
}
void check(const Work& found, const Work& known) {
  CHECK(found.steps == Approx(known.steps).epsilon(0.01));
  CHECK(found.rejections == Approx(known.rejections).margin(2));
  CHECK(found.evaluations == Approx(known.evaluations).epsilon(0.01));
}
}  // namespace

TEST_CASE("unit: a blow-up ends in a refusal, not in a number") {
  using One = num::Dopri5<1>::State;
  const auto f = [](double, const One& y, One& dy) { dy[0] = y[0] * y[0]; };
  for (const double begin : {0.0, 3.0, -3.0}) {
    num::Dopri5<1> solver{One::Constant(1e-8), 0.01};
    solver.restart(f, begin, One{1.0});  // y = 1 / (begin + 1 - t)
    bool alive = true;
    for (int i = 0; i < 100000 && alive && solver.t() < begin + 2; ++i)
      alive = solver.step(f, begin + 2);
    CHECK_FALSE(alive);
    CHECK(solver.t() == Approx(begin + 1).epsilon(1e-6));
  }
}

TEST_CASE("unit: a stiff problem is stepped on the slow scale") {
  // y = cos t from y' = -1e6 (y - cos t) - sin t; the second component is quiet.
  const auto f = [](double t, const State& y, State& dy) {
    dy << -1e6 * (y[0] - std::cos(t)) - std::sin(t), 0;
  };
  const auto jac = [](double, const State&, Eigen::Matrix2d& j) { j << -1e6, 0, 0, 0; };
  num::Radau5<2> solver{State::Constant(1e-8), 1e-3};
  solver.restart(0, State{1, 0});
  while (solver.t() < 5) REQUIRE(solver.step(f, jac, 5));
  CHECK(std::abs(solver.y()[0] - std::cos(5.0)) < 1e-8);
  CHECK(solver.evaluations() < 3000);
}

TEST_CASE("unit: the collocation polynomial of a Radau step holds between its ends") {
  const auto f = [](double, const State& y, State& dy) { dy << y[1], -y[0]; };
  const auto jac = [](double, const State&, Eigen::Matrix2d& j) { j << 0, 1, -1, 0; };
  num::Radau5<2> solver{State::Constant(1e-11), 1e-3};
  solver.restart(0, State{1, 0});
  while (solver.t() < 5) {
    REQUIRE(solver.step(f, jac, 5));
    const auto& dense = solver.dense();
    CHECK(dense.end == solver.t());
    CHECK((dense.at(dense.end) - solver.y()).norm() < 1e-14);
    for (double u : {0.0, 0.3, 0.7}) {
      const double t = dense.begin + u * dense.length;
      CHECK(std::abs(dense.at(t)[0] - std::cos(t)) < 1e-8);
    }
  }
}

// A controller that is a little wrong still converges, and only takes longer. The counts are
// today's; a change for the better changes them with its reason.
TEST_CASE("unit: the work of Radau IIA on a relaxation oscillation, whole and in pieces") {
  check(implicit(1e-4, 1), {227, 38, 2805});
  check(implicit(1e-6, 1), {674, 17, 6535});
  check(implicit(1e-6, 10), {679, 22, 6647});
  check(implicit(1e-6, 1000), {1630, 14, 12912});
}

TEST_CASE(
    "unit: the work of Dormand and Prince's steps on a relaxation oscillation, whole and in "
    "pieces") {
  check(explicit_steps(1e-4, 1), {450, 15, 2791});
  check(explicit_steps(1e-7, 1), {577, 12, 3535});
  check(explicit_steps(1e-7, 10), {580, 17, 3583});
  check(explicit_steps(1e-7, 1000), {1151, 4, 6931});
}
