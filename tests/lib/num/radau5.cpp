#include <railbook/num/radau5.hpp>

#include <catch2/catch.hpp>
#include <cmath>

using namespace railbook;

namespace {
using Solver = num::Radau5<2>;
using State = Solver::State;

struct Run {
  double error = 0;
  long evaluations = 0;
};
template <class F, class J>
Run run(F&& f, J&& jac, double tolerance, double end, double exact) {
  Solver solver{State::Constant(tolerance), 1e-3};
  solver.restart(0, State{1, 0});
  while (solver.t() < end) REQUIRE(solver.step(f, jac, end));
  return {std::abs(solver.y()[0] - exact), solver.evaluations()};
}
}  // namespace

TEST_CASE("unit: Radau IIA converges at order five on a smooth problem") {
  const auto f = [](double t, const State& y, State& dy) {
    dy << y[1], -y[0] + 0.3 * std::cos(2 * t);
  };
  const auto jac = [](double, const State&, Solver::Jacobian& j) { j << 0, 1, -1, 0; };
  const double exact = 1.1 * std::cos(10.0) - 0.1 * std::cos(20.0);
  const Run loose = run(f, jac, 1e-5, 10, exact), tight = run(f, jac, 1e-10, 10, exact);
  CHECK(tight.error < 1e-8);
  CHECK(std::log(loose.error / tight.error) /
            std::log(double(tight.evaluations) / double(loose.evaluations)) >
        3.5);
}

TEST_CASE("unit: a stiff problem is stepped on the slow scale") {
  // y = cos t from y' = -1e6 (y - cos t) - sin t; the second component is quiet.
  const auto f = [](double t, const State& y, State& dy) {
    dy << -1e6 * (y[0] - std::cos(t)) - std::sin(t), 0;
  };
  const auto jac = [](double, const State&, Solver::Jacobian& j) { j << -1e6, 0, 0, 0; };
  const Run r = run(f, jac, 1e-8, 5, std::cos(5.0));
  CHECK(r.error < 1e-8);
  CHECK(r.evaluations < 3000);
}

TEST_CASE("unit: the collocation polynomial of a Radau step holds between its ends") {
  const auto f = [](double, const State& y, State& dy) { dy << y[1], -y[0]; };
  const auto jac = [](double, const State&, Solver::Jacobian& j) { j << 0, 1, -1, 0; };
  Solver solver{State::Constant(1e-11), 1e-3};
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
