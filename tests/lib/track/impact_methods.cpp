#include <railbook/track/impact_methods.hpp>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include <railbook/track/impact_system.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::track;

namespace {
const ImpactModel model{
    650, 122.3e3, 8.9093903e10, {63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67}};
const RectifiedSine rail{0.5 * units::inch, 39 * units::foot};
constexpr std::array times{0.00142, 0.01, 0.03};

ForcesAt run(ImpactMethod method, double tolerance, long most = 2000000, bool restart = true) {
  ImpactOptions options;
  options.restart_at_cusps = restart;
  options.start = -0.5;
  options.tolerance = tolerance;
  options.most_steps = most;
  return forces_at(model, rail, 26.8, options, method, times);
}

// z = h cos(k s) in every piece, the odd ones upside down.
struct Waves {
  double h = 2e-5, k = 3;
  long piece(double s) const { return std::lround(std::floor(s)); }
  SurfacePoint at(double s, long of) const {
    const double sign = of % 2 == 0 ? 1 : -1;
    return {sign * h * std::cos(k * s), -sign * h * k * std::sin(k * s)};
  }
};
}  // namespace

TEST_CASE("unit: four integrators agree on the forces over a joint") {
  const ForcesAt reference = run(ImpactMethod::dopri5, 1e-12);
  REQUIRE(reference.complete);
  CHECK(reference.force.size() == times.size());
  CHECK(reference.state.size() == times.size());
  for (ImpactMethod method : {ImpactMethod::rk8pd, ImpactMethod::bsimp, ImpactMethod::radau5}) {
    const ForcesAt forces = run(method, 1e-10);
    INFO(static_cast<int>(method));
    REQUIRE(forces.complete);
    REQUIRE(forces.force.size() == times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      CHECK(forces.force[i] == Approx(reference.force[i]).epsilon(1e-6));
    CHECK(forces.evaluations > 100);
  }
}

TEST_CASE("unit: without a restart the integrators step across the joint, to the same forces") {
  for (const ImpactMethod method :
       {ImpactMethod::rk8pd, ImpactMethod::bsimp, ImpactMethod::radau5}) {
    INFO(static_cast<int>(method));
    const ForcesAt anew = run(method, 1e-10), across = run(method, 1e-10, 2000000, false);
    REQUIRE(across.complete);
    CHECK(across.evaluations != anew.evaluations);
    for (std::size_t i = 0; i < times.size(); ++i)
      CHECK(across.force[i] == Approx(anew.force[i]).epsilon(1e-6));
  }
}

TEST_CASE("unit: the default method's forces are those of the passage itself") {
  ImpactOptions options{.tolerance = 1e-9, .start = -0.5, .end_time = times.back()};
  const ImpactHistory passage = simulate(model, rail, 26.8, options);
  const ForcesAt forces = run(ImpactMethod::dopri5, 1e-9);
  CHECK(forces.evaluations == passage.evaluations);
  for (std::size_t i = 0; i < times.size(); ++i)
    CHECK(forces.force.at(i) == passage.force(times[i]));
}

TEST_CASE("unit: a run that stops early says so and why") {
  for (ImpactMethod method : {ImpactMethod::dopri5, ImpactMethod::rk8pd, ImpactMethod::radau5}) {
    const ForcesAt forces = run(method, 1e-9, 5);
    CHECK_FALSE(forces.complete);
    CHECK_FALSE(forces.reason.empty());
  }
  CHECK_THROWS_AS(forces_at(model, rail, 26.8, {}, ImpactMethod::rk8pd, {}), InputError);
}

TEST_CASE("unit: the model's Jacobian is the difference of its rates, on contact and in flight") {
  const Waves waves;
  const double rest = static_approach(model);
  ImpactSystem<Waves> system{model, waves, 20, rest};
  ImpactState y;
  y << 3e-5, 0.02, 1e-5, -0.01, 4e-6, 0.03;
  const double t = 0.021;
  // On contact, in flight, and apart.
  for (const auto& [flying, lift] : {std::pair{false, 0.0}, {true, 0.0}, {false, -4 * rest}}) {
    INFO("flying " << flying << ", lifted by " << lift);
    system.flying = flying;
    ImpactState at = y;
    at[0] += lift;
    const double s = 20 * t, x = rest + at[0] - at[2] - waves.at(s, 0).z;
    CHECK(system.contact(t, at).approach == Approx(x));
    CHECK(system.contact(t, at).rate == Approx(at[1] - at[3] - 20 * waves.at(s, 0).slope));
    const double force = flying || lift != 0 ? 0 : 8.9093903e10 * std::pow(x, 1.5);
    CHECK(system.force(t, at) == Approx(force));
    ImpactJacobian jac;
    ImpactState drift, low, high;
    system.jacobian(t, at, jac, &drift);
    for (int column = 0; column < 6; ++column) {
      const double h = column % 2 == 0 ? 1e-9 : 1e-6;
      ImpactState ahead = at, behind = at;
      ahead[column] += h, behind[column] -= h;
      system(t, ahead, high), system(t, behind, low);
      const ImpactState slope = (high - low) / (2 * h);
      for (int row = 0; row < 6; ++row)
        CHECK(jac(row, column) ==
              Approx(slope[row]).epsilon(1e-6).margin(1e-5 * (1 + slope.norm())));
    }
    system(t + 1e-8, at, high), system(t - 1e-8, at, low);
    for (int row = 0; row < 6; ++row)
      CHECK(drift[row] == Approx((high[row] - low[row]) / 2e-8).epsilon(1e-5).margin(1e-3));
    system.jacobian(t, at, jac, nullptr);
    CHECK(jac(0, 1) == 1);
  }
}

TEST_CASE("unit: a right-hand side follows the surface's pieces only where it is asked to") {
  const Waves waves;
  ImpactSystem<Waves> system{model, waves, 20, static_approach(model)};
  const ImpactState still = ImpactState::Zero();
  const double t = 0.06, up = waves.at(1.2, 1).z;  // s = 1.2: the second piece
  CHECK(system.contact(t, still).approach == Approx(system.rest + up));
  system.follow = true;
  CHECK(system.contact(t, still).approach == Approx(system.rest - up));
}
