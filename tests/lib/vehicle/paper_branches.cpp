// Limit cycles of the paper's four cases by describing functions, against
// tests/reference/limit_cycles.cpp on the same tables.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

using namespace railbook;
using namespace railbook::vehicle;
using units::foot, units::inch;

namespace {

struct Reference {
  double amplitude, speed, omega, tolerance;  // in, ft/s, rad/s
};

void compare(const wheelset::ConstraintFunctions& table, Suspension suspension, std::size_t family,
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
  const auto& table = wheelset::new_wheel_table();
  compare(table, Suspension::dampers, 0,
          {{0.41, 171.08, 15.76, 0.0005},
           {0.43, 193.82, 23.59, 0.0005},
           {0.45, 166.45, 26.42, 0.0005},
           {0.50, 125.44, 32.82, 0.0005},
           {0.60, 106.88, 33.86, 0.0005}});
  compare(table, Suspension::dampers, 1,
          {{0.43, 202.44, 25.77, 0.0005}, {0.48, 142.98, 33.32, 0.0005}});
}

TEST_CASE("the paper's car: CN A and Heumann wheels") {
  compare(wheelset::cn_table(), Suspension::dampers, 0,
          {{0.30, 130.25, 21.12, 0.0005},
           {0.41, 131.41, 21.59, 0.0005},
           {0.48, 131.06, 25.20, 0.0005},
           {0.60, 103.05, 32.05, 0.0005}});
  compare(
      wheelset::heumann_table(), Suspension::dampers, 0,
      {{0.20, 86.94, 26.09, 0.0005}, {0.30, 87.87, 26.26, 0.0005}, {0.41, 76.01, 32.11, 0.0005}});
}

TEST_CASE("the paper's car: CN A with friction") {
  compare(wheelset::cn_table(), Suspension::friction, 1,
          {{0.10, 98.70, 16.68, 0.0005},
           {0.20, 102.50, 17.77, 0.0005},
           {0.30, 103.59, 18.12, 0.0005},
           {0.45, 102.39, 19.70, 0.0005}});
}
