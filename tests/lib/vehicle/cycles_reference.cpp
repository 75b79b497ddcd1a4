// Limit cycles of the full equations against tests/reference/limit_cycles.cpp (the car body by
// body, fixed steps, orbits closed by Newton, multipliers by differences of orbits), and two routes
// to one exponent.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/refine_cycle.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using units::foot, units::inch;

namespace {

struct Case {
  QuasiLinearCar car;
  const wheelset::ConstraintFunctions& table;
  CycleBranch branch;
};

Case traced(const wheelset::ConstraintFunctions& table, Suspension suspension) {
  QuasiLinearCar car{assemble({}, suspension), table};
  BranchOptions options;
  const bool friction = suspension == Suspension::friction;
  if (friction) options.first_amplitude = 0.001 * inch;
  const auto hopf = hopf_points(car, 1 * foot, 400 * foot);
  auto branch = trace_from(car, hopf.at(friction ? 1 : 0), options);
  return {std::move(car), table, std::move(branch)};
}

RefinedCycle cycle(const Case& c, double feet_a_second, std::size_t which = 0) {
  const auto found = cycles_at_speed(c.car, c.branch, feet_a_second * foot);
  REQUIRE(found.size() > which);
  return refine_cycle(c.car.car(), c.table, found[which].motion);
}

struct Reference {
  double speed, amplitude, omega, allowed;  // ft/s, in, rad/s; of the amplitude, relative
};

void compare(const Case& c, const std::vector<Reference>& references) {
  for (const auto& r : references) {
    CAPTURE(r.speed);
    const RefinedCycle e = cycle(c, r.speed);
    REQUIRE(e.converged);
    CHECK(e.amplitude / inch == Approx(r.amplitude).epsilon(r.allowed));
    CHECK(e.omega == Approx(r.omega).epsilon(2e-4));
  }
}

}  // namespace

TEST_CASE("true cycles: new wheels, Heumann, CN A, with an independent program") {
  compare(traced(wheelset::new_wheel_table(), Suspension::dampers),
          {{146, 0.40085, 12.308, 5e-5}, {150, 0.404936, 13.0943, 5e-6}});
  compare(traced(wheelset::heumann_table(), Suspension::dampers),
          {{87, 0.2033, 26.073, 4e-4}, {87.4, 0.2212, 25.972, 4e-4}});
  compare(traced(wheelset::cn_table(), Suspension::dampers),
          {{130.8, 0.4059, 21.452, 2e-4}, {131.5, 0.4135, 21.654, 2e-4}});
  compare(traced(wheelset::cn_table(), Suspension::friction),
          {{90, 0.0454, 14.241, 2e-3}, {100, 0.1284, 17.120, 6e-4}});
}

TEST_CASE("true cycles: multipliers past the torus point of new wheels") {
  const Case c = traced(wheelset::new_wheel_table(), Suspension::dampers);
  for (const auto& [speed, modulus] : {std::pair{153.0, 0.97}, {153.5, 1.06}, {154.0, 1.14}}) {
    const RefinedCycle e = cycle(c, speed);
    REQUIRE(e.converged);
    CHECK(e.stability.loss == "torus");
    CHECK(e.stability.largest == Approx(modulus).margin(0.007));
  }
}

TEST_CASE("true cycles: Hill's determinant has the exponents of the multipliers") {
  const auto compare_exponents = [](const Case& c, double speed, std::size_t which) {
    const RefinedCycle e = cycle(c, speed, which);
    REQUIRE(e.converged);
    const Oscillator car = car_on_track(c.car.car(), c.table, speed * foot);
    const Cycle balanced = balance(car, harmonics(car, e.orbit, 63));
    const auto& map = e.orbit.map_multipliers;
    const Complex expected = exponent(map[std::abs(map[0] - 1.0) < 1e-6 ? 1 : 0], e.orbit.period);
    const HillExponent hill = hill_exponent(car, balanced, expected * 1.03, 63);
    REQUIRE(hill.converged);
    CHECK(std::exp(hill.value.real() * e.orbit.period) ==
          Approx(e.stability.largest).epsilon(0.02));
  };
  compare_exponents(traced(wheelset::new_wheel_table(), Suspension::dampers), 154, 0);
  const Case cn = traced(wheelset::cn_table(), Suspension::dampers);
  compare_exponents(cn, 131.5, 0);
  compare_exponents(cn, 131.5, 1);
}

TEST_CASE("harmonic balance: errors fall as harmonics are added, and 23 suffice for 1e-4") {
  const Case c = traced(wheelset::new_wheel_table(), Suspension::dampers);
  const RefinedCycle e = cycle(c, 150);
  const Oscillator car = car_on_track(c.car.car(), c.table, 150 * foot);
  double before = 1;
  for (const int highest : {1, 9, 23, 63}) {
    const Cycle balanced = balance(car, harmonics(car, e.orbit, highest));
    CAPTURE(highest, balanced.reason);
    REQUIRE(balanced.converged);
    const double error = std::abs(balanced.omega / e.omega - 1);
    CHECK(error < before / 2);
    before = error;
    if (highest == 23) CHECK(error < 1e-4);
  }
}
