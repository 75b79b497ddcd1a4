// Limit cycles of the paper's four cases against an independent program (numeric Jacobian, other language, its own
// contact geometry), to 0.3 percent in speed, and 2 percent within 0.01 in of the new wheel's flange.
#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/cycle_branch.hpp"
#include "wheelrail/paper_pairs.hpp"

using namespace railbook;
using namespace railbook::dynamics;
using units::foot, units::inch;

namespace {

struct Reference {
  double amplitude, speed, omega, tolerance;  // in, ft/s, rad/s
};

void compare(const wheelrail::ConstraintFunctions& table, Suspension suspension, std::size_t family,
             const std::vector<Reference>& references) {
  const QuasiLinearCar car{assemble({}, suspension), table};
  BranchOptions options;
  if (suspension == Suspension::friction) options.first_amplitude = 0.001 * inch;
  const auto hopf = hopf_points(car, 1, 120);
  REQUIRE(hopf.size() > family);
  const auto branch = trace_from(car, hopf[family], options);
  CHECK(branch.end == BranchEnd::amplitude);
  CHECK(branch.points.size() >= 100);
  for (const auto& r : references) {
    CAPTURE(r.amplitude);
    const auto found = cycles_at_amplitude(car, branch, r.amplitude * inch);
    double nearest = 1e9, omega = 0;
    for (const auto& p : found)
      if (std::abs(p.motion.speed / foot - r.speed) < std::abs(nearest - r.speed)) {
        nearest = p.motion.speed / foot;
        omega = p.motion.lambda.imag();
      }
    CHECK(nearest == Approx(r.speed).epsilon(r.tolerance));
    CHECK(omega == Approx(r.omega).epsilon(r.tolerance));
  }
}

}  // namespace

TEST_CASE("the paper's car: new wheels, both families") {
  const auto& table = wheelrail::new_wheel_table();
  compare(table, Suspension::dampers, 0,
          {{0.41, 171.4, 15.79, 0.02},
           {0.43, 193.9, 23.60, 0.003},
           {0.45, 166.4, 26.42, 0.003},
           {0.50, 125.6, 32.80, 0.003},
           {0.60, 107.1, 33.85, 0.003}});
  compare(table, Suspension::dampers, 1,
          {{0.43, 202.3, 25.74, 0.003}, {0.48, 143.3, 33.29, 0.003}});
}

TEST_CASE("the paper's car: CN A and Heumann wheels") {
  compare(wheelrail::cn_table(), Suspension::dampers, 0,
          {{0.30, 130.22, 21.10, 0.003},
           {0.41, 131.44, 21.60, 0.003},
           {0.48, 131.1, 25.22, 0.003},
           {0.60, 103.1, 32.04, 0.003}});
  compare(wheelrail::heumann_table(), Suspension::dampers, 0,
          {{0.20, 86.95, 26.09, 0.003}, {0.30, 87.87, 26.26, 0.003}, {0.41, 76.04, 32.10, 0.003}});
}

TEST_CASE("the paper's car: CN A with friction") {
  compare(wheelrail::cn_table(), Suspension::friction, 1,
          {{0.10, 98.62, 16.65, 0.003},
           {0.20, 102.49, 17.76, 0.003},
           {0.30, 103.61, 18.12, 0.003},
           {0.45, 102.2, 19.77, 0.005}});
}
