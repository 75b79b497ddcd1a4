// Location, pressure, creepages and forces against published results of the Manchester benchmark.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/benchmark_case_a.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::tests;

TEST_CASE("unit: S1002 and the rail have their published measures") {
  const Profile wheel = s1002();
  CHECK(wheel.at(0).depth == 0);
  CHECK(wheel.at(-0.0375).depth == Approx(0.010).margin(5e-6));   // flange 32.5 mm thick
  CHECK(wheel.at(-0.055).depth == Approx(0.028).epsilon(1e-12));  // and 28 mm high
  CHECK(std::atan(-wheel.at(-0.039).slope) == Approx(70 * 3.14159265358979 / 180).epsilon(1e-8));
  for (const double joint :
       {-62.764705882, -49.662510381, -39.764473993, -38.426669071, -35.0, -26.0, 32.15796}) {
    const auto before = wheel.at(1e-3 * joint - 1e-12), after = wheel.at(1e-3 * joint + 1e-12);
    CHECK(before.depth == Approx(after.depth).margin(1e-10));
    CHECK(before.slope == Approx(after.slope).margin(1e-8));
  }
  // Closing the joints moves no depth by more than the step that was there.
  const auto printed = [](double y) {
    constexpr double c[] = {4.320221063e3,  1.038384026e3,  1.065501873e2,  6.051367875,
                            2.054332446e-1, 4.169739389e-3, 4.687195829e-5, 2.252755540e-7};
    double depth = 0;
    for (int k = 7; k >= 0; --k) depth = depth * y - c[k];
    return depth;
  };
  for (double y = -34.9; y < -26; y += 0.1)
    CHECK(1e3 * wheel.at(1e-3 * y).depth == Approx(printed(y)).margin(1.3e-4));
  // The joints of the drawing, and the two heads of 60 kg/m.
  const Profile drawn(rail_60e1(Rail60::drawing)), other(rail_60e1(Rail60::benchmark));
  CHECK(drawn.at(-0.0359998).depth == Approx(14.3e-3).margin(5e-5));
  CHECK(other.at(0.02598804).depth == Approx(2.25316e-3).margin(1e-8));
  double apart = 0;
  for (double y = -0.0355; y < 0.0355; y += 1e-4)
    apart = std::max(apart, std::abs(drawn.at(y).depth - other.at(y).depth));
  CHECK(apart < 0.06e-3);
  CHECK(apart > 0.02e-3);
}

TEST_CASE("unit: the benchmark's rigid contact to a hundredth of a millimetre") {
  // Roll [urad], depth [mm], y_r and s of the right wheel, of the left, difference of radii;
  // without yaw. Derived for this project by another program, which agrees with CONTACT's first
  // touch to 1e-4 mm.
  constexpr double table[11][7] = {{0, 0.1821, -7.28, 3.25, 7.28, 3.25, 0.000},
                                   {-54, 0.1618, -18.86, -9.36, 5.01, 6.55, 0.637},
                                   {-116, 0.1297, -19.62, -11.14, 3.85, 8.73, 0.804},
                                   {-184, 0.0905, -20.55, -13.10, 3.17, 10.45, 0.994},
                                   {-259, 0.0429, -21.78, -15.37, 2.76, 11.89, 1.235},
                                   {-370, -0.0317, -33.98, -28.61, 2.54, 13.16, 3.693},
                                   {-651, -0.2373, -35.47, -31.24, 2.42, 14.41, 4.678},
                                   {-6412, -4.6201, -41.54, -41.06, 1.84, 18.66, 18.817},
                                   {-8663, -6.3310, -40.74, -42.34, 2.21, 20.33, 20.855},
                                   {-10174, -7.4751, -40.07, -43.40, 2.73, 21.52, 22.220},
                                   {-11350, -8.3614, -39.46, -44.36, 3.30, 22.50, 23.281}};
  const ProfilePair& pair = benchmark_pair();
  for (std::size_t i = 0; i < 11; ++i) {
    INFO("y = " << i << " mm");
    const double* row = table[i];
    const double y = 1e-3 * static_cast<double>(i), roll = rigid_roll(pair, y, 0);
    CHECK(1e6 * roll == Approx(row[0]).margin(0.6));
    const Pose pose{y, 0, roll};
    const auto right = find_contact(PlacedWheel(pair, pose)),
               left = find_contact(PlacedWheel(pair, mirrored(pose)));
    CHECK(1e3 * right.z() == Approx(row[1]).margin(1.5e-4));
    const auto &r = right.least.front(), &l = left.least.front();
    CHECK(1e3 * r.at.y() - benchmark_rail_origin == Approx(row[2]).margin(0.009));
    CHECK(1e3 * r.s == Approx(row[3]).margin(0.009));
    CHECK(benchmark_rail_origin - 1e3 * l.at.y() == Approx(row[4]).margin(0.009));
    CHECK(1e3 * l.s == Approx(row[5]).margin(0.009));
    CHECK(1e3 * (r.radius - l.radius) == Approx(row[6]).margin(0.003));
  }
}

namespace {

// A wheel of the benchmark; `side` 1 right, -1 left.
void compare(const WheelResult& found, const BenchmarkWheel& c, double side) {
  REQUIRE(found.converged);
  REQUIRE(found.patches.size() == 1);
  const PatchResult& p = found.patches.front();
  // On the flange CONTACT's own cells, four across the patch, are off by some 1 % of the approach.
  CHECK(1e3 * found.z == Approx(c.z).margin(1e-4 + 0.01 * 1e-3 * c.approach / std::cos(c.delta)));
  CHECK(found.force.z() == Approx(10e3).epsilon(1e-3));
  CHECK(p.load == Approx(c.normal).epsilon(1e-3));
  CHECK(1e6 * p.approach == Approx(c.approach).epsilon(0.01));
  CHECK(1e-6 * p.p_max == Approx(c.p_max).epsilon(0.02));
  const double bound = 0.3 * c.normal;
  CHECK(std::hypot(p.forces.fx - c.fx, side * p.forces.fy - c.fs) < 0.01 * bound);
  // The place and what hangs on it: spin, moment.
  CHECK(side * (1e3 * p.patch.frame.origin.y() - benchmark_rail_origin) ==
        Approx(c.y_r).margin(0.01));
  CHECK(side * p.patch.frame.angle == Approx(c.delta).margin(2e-4));
  CHECK(-1e3 * p.creepage.longitudinal == Approx(c.xi).margin(0.006 + 2e-3 * std::abs(c.xi)));
  CHECK(-side * 1e3 * p.creepage.lateral == Approx(c.eta).margin(2e-3 * std::abs(c.eta)));
  CHECK(-side * 1e2 * p.creepage.spin == Approx(c.phi).margin(0.1));
}

}  // namespace

TEST_CASE("unit: the benchmark's case A2.2 as CONTACT answers it") {
  for (std::size_t i = 0; i < 11; ++i) {
    INFO("left wheel, y = " << i << " mm");
    compare(solve_wheel(benchmark_pair(), mirrored(benchmark_pose(i)), benchmark_wish(i)),
            benchmark_left[i], -1);
  }
  for (std::size_t i = 0; i < 11; ++i) {
    INFO("right wheel, y = " << i << " mm");
    const WheelResult found = solve_wheel(benchmark_pair(), benchmark_pose(i), benchmark_wish(i));
    if (i != 5) {
      compare(found, benchmark_right[i], 1);
      continue;
    }
    // Just beyond a jump: two areas bear load, 10 mm apart, which CONTACT makes one and this
    // program keeps two.
    REQUIRE(found.patches.size() == 2);
    CHECK(1e-6 * found.patches[0].p_max == Approx(1592).epsilon(0.02));
    CHECK(found.force.z() == Approx(10e3).epsilon(1e-3));
  }
}

TEST_CASE("unit: a free wheelset finds the benchmark's roll and turning") {
  for (const std::size_t i : {2U, 8U}) {
    INFO("y = " << i << " mm");
    WheelInput input = benchmark_wish(i);
    input.angular_velocity = 0;
    input.along = input.across = 24;
    const WheelsetResult found = solve_wheelset(benchmark_pair(), benchmark_pose(i), input);
    REQUIRE(found.converged);
    CHECK(1e6 * found.pose.roll == Approx(benchmark_poses[i].roll_urad).margin(3));
    // Where all slides, the moments hardly depend on the angular velocity.
    CHECK(found.angular_velocity ==
          Approx(benchmark_poses[i].angular_velocity).epsilon(i == 8 ? 1e-4 : 2e-5));
  }
}

TEST_CASE("unit: the strips are near CONTACT on ordinary patches") {
  for (const std::size_t i : {1U, 2U, 3U, 4U, 6U}) {
    INFO("right wheel, y = " << i << " mm");
    WheelInput input = benchmark_wish(i);
    input.method = Method::strips;
    const WheelResult found = solve_wheel(benchmark_pair(), benchmark_pose(i), input);
    REQUIRE(found.converged);
    const BenchmarkWheel& c = benchmark_right[i];
    const PatchResult& p = found.patches.front();
    CHECK(1e-6 * p.p_max == Approx(c.p_max).epsilon(0.08));
    CHECK(1e6 * p.approach == Approx(c.approach).epsilon(0.08));
    CHECK(std::hypot(p.forces.fx - c.fx, p.forces.fy - c.fs) < 0.03 * 0.3 * c.normal);
  }
}
