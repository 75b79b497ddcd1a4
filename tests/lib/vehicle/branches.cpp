// Branches of limit cycles where the car is stiff, slow or straight: an end that is told, never
// NaN, never endless work.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/continuation.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/linear_stability.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using units::foot, units::inch;

namespace {

ContinuationOptions bounded() {
  ContinuationOptions o;
  o.lowest = 1e-3;
  o.highest = 100;
  o.largest_amplitude = 0.3 * inch;
  o.first_amplitude = 0.01 * inch;
  o.most_order = 31;
  o.most_points = 40;
  return o;
}

// From every Hopf point of the car, or, where its arithmetic has no digits left for them, from
// those of the paper's car.
void follow(const CarParameters& data, Suspension suspension,
            const wheelset::ConstraintFunctions& table) {
  const FreightCar car = assemble(data, suspension);
  std::vector<HopfPoint> hopf;
  try {
    hopf = hopf_points({car, table}, 1e-3, 100);
  } catch (const InputError&) {
    hopf = hopf_points({assemble({}, Suspension::dampers), wheelset::cn_table()}, 5, 100);
  }
  const Family family = by_speed(car, table);
  for (const HopfPoint& h : hopf) {
    const Motion& m = h.motion;
    const auto branch = follow_from_hopf(family, m.shape, m.lambda.imag(), m.speed, bounded());
    CHECK(branch.points.size() <= 40);
    CHECK(branch.newton_steps < 5000);
    for (const LimitCycle& p : branch.points) {
      CHECK(std::isfinite(p.parameter));
      CHECK(std::isfinite(p.largest));
      CHECK(std::isfinite(p.leading));
      CHECK(p.cycle.motion.allFinite());
    }
  }
}

}  // namespace

TEST_CASE("branches: springs a million times as stiff") {
  const NoFpFault guard;
  for (double CarParameters::*datum :
       {&CarParameters::lateral_stiffness, &CarParameters::vertical_stiffness,
        &CarParameters::warp_stiffness}) {
    CarParameters data;
    data.*datum *= 1e6;
    follow(data, Suspension::dampers, wheelset::cn_table());
  }
}

TEST_CASE("branches: friction that sticks down to a millionth of the rate") {
  const NoFpFault guard;
  for (const double factor : {1e-2, 1e-4, 1e-6}) {
    CarParameters data;
    data.stick_speed *= factor;
    data.stick_rate *= factor;
    follow(data, Suspension::friction, wheelset::cn_table());
  }
}

TEST_CASE("branches: wheels without conicity have no cycle, and nothing is found") {
  const NoFpFault guard;
  auto flat = wheelset::cn_table();
  const std::vector<double> zero(flat.R.values().size(), 0.0);
  flat.R = flat.D = flat.Phi = wheelset::OddTable{flat.R.step(), zero};
  const FreightCar car = assemble({}, Suspension::dampers);
  const auto hopf = hopf_points({car, wheelset::cn_table()}, 5, 100).front().motion;
  const auto branch =
      follow_from_hopf(by_speed(car, flat), hopf.shape, hopf.lambda.imag(), hopf.speed, bounded());
  for (const LimitCycle& p : branch.points) CHECK(p.cycle.motion.allFinite());
  CHECK(branch.newton_steps < 5000);
}

TEST_CASE("branches: a cycle followed to a crawl") {
  const NoFpFault guard;
  const FreightCar car = assemble({}, Suspension::dampers);
  const auto& table = wheelset::cn_table();
  const auto hopf = hopf_points({car, table}, 5, 100).front().motion;
  auto o = bounded();
  o.most_points = 1;
  const Family family = by_speed(car, table);
  const auto first = follow_from_hopf(family, hopf.shape, hopf.lambda.imag(), hopf.speed, o);
  REQUIRE(first.points.size() == 1);
  // At a thousandth of the speed there is no such cycle: said, not invented.
  o.most_points = 40;
  const auto slow = cycle_near(family, first.points[0].cycle, 1e-3 * hopf.speed, o);
  for (const LimitCycle& p : slow) CHECK(p.cycle.motion.allFinite());
  Oscillator o_at = family.oscillator;
  CHECK_THROWS_AS(family.set(o_at, 0), InputError);
}
