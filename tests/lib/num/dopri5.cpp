#include <railbook/num/dopri5.hpp>

#include <catch2/catch.hpp>
#include <cmath>

using namespace railbook;

namespace {
using Solver = num::Dopri5<2>;
using State = Solver::State;
const auto pendulum = [](double t, const State& y, State& dy) {
  dy << y[1], -y[0] + 0.3 * std::cos(2 * t);
};
double exact(double t) {
  return 1.1 * std::cos(t) - 0.1 * std::cos(2 * t);
}

struct Run {
  double end_error = 0, dense_error = 0;
  long evaluations = 0;
};
Run run(double tolerance) {
  Solver solver{State::Constant(tolerance), 0.01};
  solver.restart(pendulum, 0, State{1, 0});
  Run r;
  while (solver.t() < 10) {
    REQUIRE(solver.step(pendulum, 10));
    const auto& d = solver.dense();
    for (double u : {0.25, 0.5, 0.9}) {
      const double t = d.begin + u * d.length;
      r.dense_error = std::max(r.dense_error, std::abs(d.at(t)[0] - exact(t)));
    }
  }
  r.end_error = std::abs(solver.y()[0] - exact(10));
  r.evaluations = solver.evaluations();
  return r;
}
}  // namespace

TEST_CASE("unit: Dormand-Prince steps are of order five and the error follows the tolerance") {
  const Run loose = run(1e-6), tight = run(1e-11);
  CHECK(loose.end_error < 1e-4);
  CHECK(tight.end_error < 1e-9);
  CHECK(tight.dense_error < 1e-8);
  // Error against work: order 5 means at least 4 in the exponent over five decades of tolerance.
  const double order = std::log(loose.end_error / tight.end_error) /
                       std::log(double(tight.evaluations) / double(loose.evaluations));
  CHECK(order > 4);
}

TEST_CASE("unit: polynomials to degree five are integrated to rounding, to degree four between") {
  num::Dopri5<1> solver{num::Dopri5<1>::State::Constant(1.0), 2.0};
  using One = num::Dopri5<1>::State;
  const auto quintic = [](double t, const One&, One& dy) { dy[0] = 5 * t * t * t * t; };
  solver.restart(quintic, 1, One{1.0});
  REQUIRE(solver.step(quintic, 3));
  CHECK(solver.y()[0] == Approx(243).epsilon(1e-14));
  const auto quartic = [](double t, const One&, One& dy) { dy[0] = 4 * t * t * t; };
  solver.restart(quartic, 1, One{1.0});
  REQUIRE(solver.step(quartic, 2));
  CHECK(solver.dense().at(1.5)[0] == Approx(5.0625).epsilon(1e-14));
}

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
