#include <railbook/vehicle/eigenvector_loop.hpp>

#include <catch2/catch.hpp>

#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
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
