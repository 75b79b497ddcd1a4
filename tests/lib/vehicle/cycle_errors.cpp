// Errors stated for cycles and special points, against shooting and finer branches; and motions
// followed in time.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/cycles/cycle_error.hpp>
#include <railbook/cycles/floquet.hpp>
#include <railbook/cycles/settled_motion.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/linear_stability.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/seen_by.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;

namespace {

ContinuationOptions paper_options() {
  ContinuationOptions options;
  options.lowest = 1;
  options.highest = 120;
  options.largest_amplitude = 0.019;
  return options;
}
LimitCycleBranch first_branch(const QuasiLinearCar& car, const Family& family,
                              const ContinuationOptions& options) {
  const Motion m = hopf_points(car, 1, 120).front().motion;
  return follow_from_hopf(family, m.shape, m.lambda.imag(), m.speed, options);
}

}  // namespace

TEST_CASE("The stated error of a cycle covers its distance from shooting", "[cycle-error]") {
  for (const auto* table : {&wheelset::cn_table(), &wheelset::new_wheel_table()}) {
    const QuasiLinearCar car{assemble({}, Suspension::dampers), *table};
    const Family family = by_speed(car.car(), *table);
    const ContinuationOptions options = paper_options();
    const LimitCycleBranch branch = first_branch(car, family, options);
    int seen = 0;
    for (const double speed : {40.0, 42.0, 44.0, 48.0})
      for (const LimitCycle& c : cycles_at(family, branch, speed, options)) {
        const Oscillator o = car_on_track(car.car(), *table, speed);
        const Orbit orbit = shoot(o, c.cycle);
        if (!orbit.converged) continue;
        CAPTURE(speed, c.largest, c.tail);
        const CycleError error = cycle_error(family, c, options);
        double largest = 0;
        for (const Eigen::VectorXd& row : family.watch)
          largest = std::max(largest, amplitude(o, orbit, row));
        CHECK(std::abs(largest - c.largest) <= error.amplitude + 1e-7 * c.largest);
        CHECK(std::abs(orbit.omega() - c.cycle.omega) <= error.omega + 1e-7 * c.cycle.omega);
        CHECK(error.amplitude < 2e-3 * c.largest);
        ++seen;
      }
    CHECK(seen >= 3);
  }
}

TEST_CASE("The stated error of a special point covers its distance from a finer branch's",
          "[cycle-error][thorough]") {
  for (const auto* table : {&wheelset::cn_table(), &wheelset::new_wheel_table()}) {
    const QuasiLinearCar car{assemble({}, Suspension::dampers), *table};
    const Family family = by_speed(car.car(), *table);
    const ContinuationOptions options = paper_options();
    const LimitCycleBranch branch = first_branch(car, family, options);
    ContinuationOptions fine = options;
    fine.tail = 1e-5;
    fine.multiplier_steps = 2048;
    const LimitCycleBranch finer = first_branch(car, family, fine);
    int seen = 0;
    for (const SpecialCycle& s : branch.special) {
      const SpecialError error = special_error(family, branch, s, options);
      const SpecialCycle* nearest = nullptr;
      for (const SpecialCycle& f : finer.special)
        if (f.kind == s.kind &&
            (nearest == nullptr ||
             std::abs(f.at.largest - s.at.largest) < std::abs(nearest->at.largest - s.at.largest)))
          nearest = &f;
      if (nearest == nullptr) continue;
      CAPTURE(to_string(s.kind), s.at.parameter, s.at.largest, nearest->at.parameter,
              nearest->at.largest, error.parameter, error.largest);
      CHECK(std::abs(nearest->at.parameter - s.at.parameter) <=
            error.parameter + 1e-7 * s.at.parameter);
      CHECK(std::abs(nearest->at.largest - s.at.largest) <= error.largest + 1e-7 * s.at.largest);
      CHECK(error.parameter < 0.01 * s.at.parameter);
      ++seen;
    }
    CHECK(seen >= 2);
  }
}

TEST_CASE("A motion followed in time comes to its cycle, to rest, or leaves the tables",
          "[settled-motion]") {
  // Circles of radius^2 = p: q'' + (rho - p) q' + (1 + rho / 2) q = 0, rho the radius squared.
  Family family;
  family.oscillator = tests::seen_by(2, [](const std::complex<double>* s, std::complex<double>* f) {
    const auto rho = s[0] * s[0] + s[1] * s[1], radial = s[0] * s[2] + s[1] * s[3];
    for (int i = 0; i < 2; ++i) f[i] = -rho * s[2 + i] - (0.5 * rho + 2.0 * radial) * s[i];
  });
  family.set = [](Oscillator& o, double p) { o.damping(0, 0) = o.damping(1, 1) = -p; };
  family.watch = {Eigen::VectorXd::Unit(2, 0)};
  SettleOptions settling;
  settling.omega = 1;
  ContinuationOptions options;
  options.first_amplitude = 0.1;
  const Eigen::Vector4d start(0.3, 0, 0, -0.3);
  const SettledMotion grown = settle(family, 0.4, start, settling, options);
  REQUIRE(grown.kind == SettledMotion::Kind::cycle);
  CHECK(grown.cycle.largest == Approx(std::sqrt(0.4)).epsilon(1e-6));
  CHECK(grown.cycle.cycle.omega == Approx(std::sqrt(1.2)).epsilon(1e-6));
  CHECK(grown.cycle.stable);
  CHECK(settle(family, -0.2, start, settling, options).kind == SettledMotion::Kind::rest);

  // Past the fold of the CN wheels, where creep is linear, nothing holds the wheelsets on the
  // table.
  const QuasiLinearCar car{assemble({}, Suspension::dampers), wheelset::cn_table()};
  const Family cn = by_speed(car.car(), wheelset::cn_table());
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = 0.01;
  const SettledMotion off = settle(cn, 60, y, {}, paper_options());
  CHECK(off.kind == SettledMotion::Kind::left_table);
}
