#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "method/eigenvector_loop.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::vehicle;
using units::inch;

TEST_CASE("eigenvector loop: it says where it does not converge") {
  const QuasiLinearCar car{assemble({}, Suspension::dampers), wheelset::new_wheel_table()};
  const auto hopf = hopf_points(car, 3, 120);
  const auto lost = paper_cycle(car, hopf[0].motion, 0.44 * inch, ModeChoice::least_damped);
  CHECK(lost.end == LoopEnd::modes_take_turns);
  CHECK(lost.switches > 10);
  // Above, it settles on a cycle, of the other branch.
  const auto settled = paper_cycle(car, hopf[0].motion, 0.5 * inch, ModeChoice::least_damped);
  REQUIRE(settled.end == LoopEnd::converged);
  const auto other = cycles_at_amplitude(car, trace_from(car, hopf[1], {}), 0.5 * inch);
  REQUIRE(other.size() == 1);
  CHECK(settled.cycle.speed == Approx(other[0].motion.speed).epsilon(1e-6));
  CHECK_THROWS_AS(paper_cycle(car, hopf[0].motion, 0, ModeChoice::least_damped), InputError);
}

TEST_CASE("The paper's loop: a thousandth of the speed first, then by secants, a tenth at most") {
  const QuasiLinearCar car{assemble({}, Suspension::dampers), wheelset::heumann_table()};
  const auto hopf = hopf_points(car, 5, 100);
  REQUIRE_FALSE(hopf.empty());
  for (const double off : {0.97, 1.02, 1.6}) {
    Motion guess = hopf[0].motion;
    guess.speed *= off;
    std::vector<double> speed{guess.speed}, growth;
    LoopResult found;
    for (int outer = 1; outer <= 12; ++outer) {
      LoopLimits limits;
      limits.outer = outer;
      found = paper_cycle(car, guess, 0.05 * inch, ModeChoice::least_damped, limits);
      if (found.end != LoopEnd::no_speed) break;
      growth.push_back(found.cycle.lambda.real());
      speed.push_back(found.cycle.speed);
      CHECK(found.inner >= outer);
    }
    REQUIRE(found.end == LoopEnd::converged);
    CHECK(found.outer == int(speed.size()));
    CHECK(found.cycle.lambda.real() == 0);
    CHECK(find_cycle(car, found.cycle, 0.05 * inch).cycle.motion.speed ==
          Approx(found.cycle.speed).epsilon(1e-6));
    CHECK(speed[1] == Approx(speed[0] * (growth[0] > 0 ? 0.999 : 1.001)).epsilon(1e-12));
    for (std::size_t k = 1; k < growth.size(); ++k) {
      const double slope = (growth[k] - growth[k - 1]) / (speed[k] - speed[k - 1]),
                   change = std::clamp(-growth[k] / slope, -0.1 * speed[k], 0.1 * speed[k]);
      CHECK(speed[k + 1] == Approx(speed[k] + change).epsilon(1e-9));
    }
  }
  LoopLimits hasty;
  hasty.inner = 1;
  const auto slow = paper_cycle(car, hopf[0].motion, 0.3 * inch, ModeChoice::least_damped, hasty);
  CHECK(slow.end == LoopEnd::inner_loop_slow);
  CHECK(slow.inner == 1);
  // The next least damped is the other mode: with one family's critical speed the other's growth is
  // found.
  const auto next = paper_cycle(car, hopf[0].motion, 1e-4 * inch, ModeChoice::next_least_damped);
  REQUIRE(next.end == LoopEnd::converged);
  const auto at = modes(car, car.small(), next.cycle.speed);
  std::vector<double> rates;
  for (const Motion& m : at)
    if (m.lambda.imag() > 0) rates.push_back(m.lambda.real());
  REQUIRE(rates.size() > 1);
  CHECK(std::abs(rates[1]) < 1e-6);
}
