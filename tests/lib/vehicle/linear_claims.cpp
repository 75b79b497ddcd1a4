// Modes, critical speeds and limit cycles of the quasi-linear car against the eigenvalues, in 80
// bits, of the car put together body by body: cars at random, at any speed, of any amplitude.
#include <Eigen/Eigenvalues>
#include <cmath>

#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/cycle_solver.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/claim.hpp"
#include "support/random_quasi_linear.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using namespace railbook::tests;
using units::foot, units::inch;

TEST_CASE("claim: modes and critical speeds of the linear car", "[thorough]") {
  Claim matrices("vehicle::QuasiLinearCar"), shapes("vehicle::modes"),
      rounding("vehicle::growth_rounding"), all("vehicle::hopf_points", 700),
      one("vehicle::find_hopf"), linear("vehicle::solve_linear", 700);
  RandomStream draw(1);
  for (int k = 0; k < 500; ++k) {
    const QuasiLinearCar car = random_quasi(draw, k % 4 == 3);
    const double speed = draw.decades(0.1, 1000);
    const Gains gains = car.small();
    const auto m = car.matrices(gains, speed);
    const Matrix9 stiffness = probed(car, gains, speed, false),
                  damping = probed(car, gains, speed, true);
    matrices.error((m.stiffness - stiffness).norm() / stiffness.norm());
    matrices.error((m.damping - damping).norm() / damping.norm());
    const auto exact = eigenvalues_of(car, gains, speed);
    int count = 0;
    for (const Motion& mode : modes(car, gains, speed)) {
      count += mode.lambda.imag() > 0 ? 2 : 1;
      rounding.error(nearest(exact, mode.lambda) / growth_rounding(car, mode));
      const double size = std::abs(mode.lambda);
      const Eigen::VectorXd terms = (m.stiffness.cwiseAbs() + size * m.damping.cwiseAbs() +
                                     size * size * car.car().mass.cwiseAbs()) *
                                    mode.shape.cwiseAbs();
      shapes.error((car.dynamic_stiffness(gains, mode.lambda, speed) * mode.shape).norm() /
                   terms.norm());
    }
    CHECK(count == 18);
    // Each on the axis, and as many as make up for the change in the modes that grow.
    constexpr double low = 6, high = 90;
    auto crossed = growing(car, high) - growing(car, low);
    for (const HopfPoint& h : hopf_points(car, low, high)) {
      crossed -= h.rate_by_speed.real() > 0 ? 2 : -2;
      all.error(off_axis(car, gains, h.motion));
      // From modes 1 % away in speed, and of the car with the gains of some amplitude.
      for (const double v :
           {h.motion.speed * (1 + draw(-0.01, 0)), h.motion.speed * (1 + draw(0, 0.01))}) {
        auto there = modes(car, gains, v);
        const auto off = [&](const Motion& a) { return std::abs(a.lambda - h.motion.lambda); };
        const HopfSearch found = find_hopf(
            car,
            *std::min_element(there.begin(), there.end(),
                              [&](const Motion& a, const Motion& b) { return off(a) < off(b); }));
        REQUIRE(found.converged);
        one.error(off_axis(car, gains, found.point.motion));
      }
      const double amplitude = draw.decades(1e-4, 0.5) * inch;
      const Gains larger =
          car.at(scaled_to(car.car(), h.motion.shape, amplitude), h.motion.lambda.imag());
      const Solved solved = solve_linear(car, larger, h.motion);
      if (solved.converged) linear.error(off_axis(car, larger, solved.motion));
    }
    CHECK(crossed == 0);
  }
}

TEST_CASE("claim: cycles of the quasi-linear car", "[thorough]") {
  Claim found("vehicle::find_cycle", 300), solved("vehicle::solve_cycle", 390),
      along("vehicle::tangent", 300), slope("vehicle::speed_by_amplitude", 300);
  RandomStream draw(2);
  for (int k = 0; k < 100; ++k) {
    const QuasiLinearCar car = random_quasi(draw, k % 4 == 3);
    const auto hopf = hopf_points(car, 6, 90);
    for (int n = 0; n < 4 && !hopf.empty(); ++n) {
      const double a = draw.decades(1e-3, 0.7) * inch;
      const CycleSearch search = find_cycle(car, hopf[0].motion, a);
      if (!search.converged) continue;
      const Motion& m = search.cycle.motion;
      const auto wheelset = [&](const Motion& of, int i) {
        return wheelset_amplitudes(car.car(), of.shape)[static_cast<std::size_t>(i)];
      };
      const int largest = largest_wheelset(car.car(), m.shape);
      found.error(off_axis(car, m));
      found.error(std::abs(wheelset(m, largest_wheelset(car.car(), hopf[0].motion.shape)) / a - 1));
      // Cycles on either side of it.
      const Unknowns u = scaled(m), direction = tangent(car, u, u);
      const double h = 1e-5 * u.norm();
      const auto at = [&](double way) {
        const Unknowns guess = u + way * direction;
        return solve_cycle(car, guess, u,
                           {.kind = BranchCondition::hyperplane,
                            .normal = direction,
                            .value = direction.dot(guess)});
      };
      const Solved up = at(h), down = at(-h);
      REQUIRE((up.converged && down.converged));
      solved.error(off_axis(car, up.motion));
      along.error(((scaled(up.motion) - scaled(down.motion)).normalized() - direction).norm());
      const double rise = (up.motion.speed - down.motion.speed) /
                          (wheelset(up.motion, largest) - wheelset(down.motion, largest));
      slope.error(std::abs(speed_by_amplitude(car, m) - rise) / (std::abs(rise) + m.speed / a));
      // At another speed there may be none near; what is found is one.
      const double speed = m.speed * (1 + draw(-1e-3, 1e-3));
      const Solved there = solve_cycle(car, u, u, {.kind = BranchCondition::speed, .value = speed});
      if (there.converged)
        solved.error(off_axis(car, there.motion) + std::abs(there.motion.speed / speed - 1));
    }
  }
}

TEST_CASE("claim: branches of the quasi-linear car", "[thorough]") {
  Claim walk("vehicle::trace_from", 300), by_speed("vehicle::cycles_at_speed", 300),
      by_amplitude("vehicle::cycles_at_amplitude", 200);
  RandomStream draw(3);
  for (int k = 0; k < 24; ++k) {
    const QuasiLinearCar car = random_quasi(draw, k % 4 == 3);
    const auto hopf = hopf_points(car, 6, 90);
    if (hopf.empty()) continue;
    const CycleBranch branch = trace_from(car, hopf[0], {});
    if (branch.points.empty()) continue;
    for (std::size_t i = 0; i < branch.points.size(); i += 5)
      walk.error(off_axis(car, branch.points[i].motion));
    for (const CycleFold& f : branch.folds) walk.error(off_axis(car, f.motion));
    for (int n = 0; n < 20; ++n) {
      double v = branch.points.front().motion.speed * draw(0.7, 1.4);
      bool by_fold = n % 2 == 0 && !branch.folds.empty();
      if (by_fold) {
        // Next to a fold there are two.
        const CycleFold& f = branch.folds[static_cast<std::size_t>(n) / 2 % branch.folds.size()];
        v = f.motion.speed +
            (branch.points[f.after].motion.speed - f.motion.speed) * draw.decades(1e-6, 0.9);
        by_fold = std::abs(v / f.motion.speed - 1) > 1e-11;  // nearer, rounding decides
      }
      const auto at_speed = cycles_at_speed(car, branch, v);
      CHECK(at_speed.size() >= (by_fold ? 2 : 0));
      for (const CyclePoint& p : at_speed)
        by_speed.error(off_axis(car, p.motion) + std::abs(p.motion.speed / v - 1));
      const double a = draw.decades(2e-3, 0.6) * inch;
      for (const CyclePoint& p : cycles_at_amplitude(car, branch, a))
        by_amplitude.error(off_axis(car, p.motion) + std::abs(p.largest / a - 1));
    }
  }
}
