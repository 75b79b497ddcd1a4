// Branches of limit cycles against normal forms whose branches are exact, at random, and the car's
// families against the car put together at once; wheel and rail's limited forces against each wheel
// by itself.
#include <cmath>

#include <railbook/cycles/continuation.hpp>
#include <railbook/vehicle/car_families.hpp>
#include <railbook/vehicle/car_on_track.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "support/claim.hpp"
#include "support/seen_by.hpp"

using namespace railbook;
using namespace railbook::cycles;
using namespace railbook::vehicle;
using namespace railbook::tests;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Circles of radius^2 = rho where p = turn rho^2 - rho or, without a turn, p = rho; omega^2 = 1 +
// stiff rho. `rest` adds forces on other coordinates. A term with q q', zero on circles, keeps the
// motion from turning back on itself.
struct Circles {
  double turn, stiff;
  double parameter(double rho) const { return turn > 0 ? turn * rho * rho - rho : rho; }
  double omega(double rho) const { return std::sqrt(1 + stiff * rho); }
  template <class Rest>
  Family family(int n, Rest rest) const {
    Family family;
    const double a = turn, b = stiff;
    family.oscillator = seen_by(n, [=](const Complex* s, Complex* f) {
      const Complex rho = s[0] * s[0] + s[1] * s[1], radial = s[0] * s[n] + s[1] * s[n + 1],
                    rise = a > 0 ? rho - a * rho * rho : -rho;
      for (int i = 0; i < n; ++i) f[i] = 0;
      for (int i = 0; i < 2; ++i) f[i] = rise * s[n + i] - (b * rho + 4.0 * radial) * s[i];
      rest(rho, s, f);
    });
    family.set = [](Oscillator& o, double p) { o.damping(0, 0) = o.damping(1, 1) = -p; };
    family.watch = {VectorXd::Unit(n, 0)};
    return family;
  }
};
Eigen::VectorXcd circle(int n) {
  Eigen::VectorXcd shape = Eigen::VectorXcd::Zero(n);
  shape[0] = 1, shape[1] = Complex{0, -1};
  return shape;
}
ContinuationOptions up_to(double highest) {
  ContinuationOptions options;
  options.lowest = -10, options.highest = highest, options.first_amplitude = 0.05;
  return options;
}
const SpecialCycle* first_of(const LimitCycleBranch& branch, CycleEvent kind) {
  for (const SpecialCycle& s : branch.special)
    if (s.kind == kind) return &s;
  return nullptr;
}

}  // namespace

TEST_CASE("claim: branches of limit cycles", "[thorough]") {
  Claim hopf("cycles::follow_from_hopf", 300), on("cycles::follow_from", 200),
      at("cycles::cycles_at", 120), near("cycles::cycle_near", 80);
  RandomStream draw(1);
  for (int k = 0; k < 12; ++k) {
    // A branch that turns round at rho = 1/(2 turn).
    const Circles turning{draw.decades(0.5, 2), draw(0, 1)};
    const Family family = turning.family(2, [](Complex, const Complex*, Complex*) {});
    const double turn = turning.turn, lowest = -0.25 / turn;
    const ContinuationOptions options = up_to(0.5 / turn);
    const LimitCycleBranch branch = follow_from_hopf(family, circle(2), 1, 0, options);
    CHECK(branch.stop == BranchStop::parameter);
    const auto off = [&](const LimitCycle& c) {
      const double rho = c.largest * c.largest;
      return std::abs(c.parameter - turning.parameter(rho)) * turn +
             std::abs(c.cycle.omega / turning.omega(rho) - 1);
    };
    for (const LimitCycle& c : branch.points) {
      hopf.error(off(c));
      CHECK(c.stable == (c.largest * c.largest > 0.5 / turn));
    }
    const SpecialCycle* fold = first_of(branch, CycleEvent::fold);
    REQUIRE((fold && fold->located));
    hopf.error(std::abs(fold->at.parameter / lowest - 1));
    // Two cycles above the fold, however near to it, and none below.
    for (int n = 0; n < 6; ++n) {
      const double above = n == 0 ? -1e-3 : draw.decades(1e-8, 0.9), p = lowest * (1 - above);
      const auto found = cycles_at(family, branch, p, options);
      REQUIRE(found.size() == (above < 0 ? 0 : 2));
      for (std::size_t i = 0; i < found.size(); ++i) {
        const double rho = (1 + (i == 0 ? -1 : 1) * std::sqrt(above)) / (2 * turn);
        // Of which the amplitude is known to the root of the parameter's digits.
        at.error(std::abs(found[i].largest / std::sqrt(rho) - 1) * std::sqrt(above) +
                 off(found[i]));
        const double there = p + draw(0, 1e-3) / turn;
        for (const LimitCycle& c : cycle_near(family, found[i].cycle, there, options))
          near.error(off(c) + std::abs(c.parameter - there));
      }
    }
    const LimitCycle& last = branch.points.back();
    const LimitCycleBranch back =
        follow_from(family, last.cycle, last.parameter, Direction::smaller_cycles, up_to(10));
    for (const LimitCycle& c : back.points) on.error(off(c));
    CHECK(back.stop == BranchStop::small_cycle);
  }
}

TEST_CASE("claim: points of branches where another one leaves", "[thorough]") {
  Claim aside("cycles::follow_secondary", 100);
  RandomStream draw(2);
  for (int k = 0; k < 12; ++k) {
    const Circles plain{0, draw(0.2, 0.8)};
    const ContinuationOptions options = up_to(0.6);
    // w'' + c w' + (place - rho) w + w^3 = 0 has w^2 = p - place beside w = 0.
    const double place = draw(0.2, 0.4), c = draw(0.5, 2), bend = draw(0.5, 2);
    const Family lopsided = plain.family(3, [=](Complex rho, const Complex* s, Complex* f) {
      f[2] = -c * s[5] + (1 - place + rho) * s[2] - bend * s[2] * s[2] * s[2];
    });
    const LimitCycleBranch branch = follow_from_hopf(lopsided, circle(3), 1, 0, options);
    const SpecialCycle* breaking = first_of(branch, CycleEvent::symmetry_breaking);
    REQUIRE((breaking && breaking->located));
    aside.error(std::abs(breaking->at.parameter - place));
    const LimitCycleBranch leaving = follow_secondary(lopsided, *breaking, options);
    REQUIRE(leaving.points.size() > 2);
    for (const LimitCycle& p : leaving.points) {
      aside.error(std::abs(std::norm(p.cycle.motion(2, 0)) - (p.parameter - place) / bend));
      CHECK(p.stable);
    }
    // A third coordinate that begins to swing.
    const double swing = draw(0.4, 0.9);
    const Family torus = plain.family(3, [=](Complex rho, const Complex* s, Complex* f) {
      f[2] = -(place - rho) * s[5] - swing * s[2];
    });
    const LimitCycleBranch other = follow_from_hopf(torus, circle(3), 1, 0, options);
    const SpecialCycle* born = first_of(other, CycleEvent::torus);
    REQUIRE((born && born->located));
    aside.error(std::abs(born->at.parameter - place));
  }
}

namespace {

CarParameters random_car(RandomStream& draw) {
  CarParameters car;
  for (const CarDatum& datum : car_data()) car.*datum.member *= draw.decades(0.5, 2);
  car.half_gauge = CarParameters{}.half_gauge;
  return car;
}
State random_state(RandomStream& draw, double size) {
  State y;
  for (double& value : y) value = size * draw(-1, 1);
  return y;
}
double apart(const Oscillator& a, const Oscillator& b, const State& y) {
  State one, other;
  compile(a).rate(y, one), compile(b).rate(y, other);
  return (one - other).norm() / other.norm();
}

// The force of one wheel, sideways and along, as the cubic of Shen, Hedrick and Elkins has it; and
// what of it remains.
struct WheelForce {
  Long along, across, part;
};
WheelForce wheel_force(const CarParameters& p, Long friction, Long along, Long across, Long spin) {
  const Long bound = friction * axle_load(p) / 2, x = -p.f33 * along,
             y = -p.f11 * across - p.f12 * spin, size = std::sqrt(x * x + y * y) / bound,
             part = size < 3 ? 1 - size / 3 + size * size / 27 : 1 / size;
  return {part * x, part * y, part};
}

}  // namespace

TEST_CASE("claim: families of cars, and creep that friction limits", "[thorough]") {
  Claim speeds("vehicle::by_speed"), data_claim("vehicle::by_datum"),
      limit_claim("vehicle::limit_creep"), use("vehicle::cycle_forces");
  RandomStream draw(3);
  const auto& table = wheelset::cn_table();
  for (int k = 0; k < 250; ++k) {
    const CarParameters data = random_car(draw);
    const FreightCar car = assemble(data, k % 2 == 0 ? Suspension::dampers : Suspension::friction);
    const std::optional<CreepLimit> creep =
        k % 3 == 0 ? std::optional<CreepLimit>{{draw(0.1, 0.6), {}}} : std::nullopt;
    const double speed = draw.decades(1, 100);
    const Family by_its_speed = by_speed(car, table, creep);
    const CarDatum& datum = car_data()[static_cast<std::size_t>(k) % car_data().size()];
    const Family by_its_datum = by_datum(car, datum.member, table, speed, creep);
    for (int n = 0; n < 4; ++n) {
      const State y = random_state(draw, 3e-3);
      const double v = draw.decades(1, 100), factor = draw.decades(0.5, 2);
      Oscillator moved = by_its_speed.oscillator, expected = car_on_track(car, table, v);
      by_its_speed.set(moved, v);
      if (creep) limit_creep(expected, car, table, *creep);
      speeds.error(apart(moved, expected, y));
      CarParameters other = data;
      other.*datum.member *= factor;
      const FreightCar changed =
          assemble(other, k % 2 == 0 ? Suspension::dampers : Suspension::friction);
      moved = by_its_datum.oscillator, expected = car_on_track(changed, table, speed);
      by_its_datum.set(moved, other.*datum.member);
      if (creep) limit_creep(expected, changed, table, *creep);
      data_claim.error(apart(moved, expected, y));
    }
    // Wheel by wheel: what friction takes from lateral force and moment. All sizes of creepage,
    // from none to sliding.
    const double friction = draw(0.1, 0.6);
    Oscillator limited = car_on_track(car, table, speed);
    limited.couplings.clear();
    limit_creep(limited, car, table, {friction, {}});
    for (int n = 0; n < 4; ++n) {
      const double size = draw.decades(1e-6, 0.1);
      const double s[3] = {size * draw(-1, 1), size * draw(-1, 1), draw(-1, 1) * 0.012};
      double force[2], slope[6];
      limited.couplings[static_cast<std::size_t>(n)].law(s, force, slope);
      const auto at = table.at(s[2]);
      // As the car has it, both wheels have the spin of their mean.
      const Long r0 = data.wheel_radius, a = data.half_gauge, spin = s[1] - Long{at.D} / r0;
      Long side = 0, moment = 0, most = 0;
      for (const Long wheel : {1, -1}) {
        const Long along = -wheel * a * (s[1] + at.R / r0);
        const WheelForce f = wheel_force(data, friction, along, s[0], spin);
        const Long x = -data.f33 * along, y = -data.f11 * Long{s[0]} - data.f12 * spin,
                   m = data.f12 * Long{s[0]} - data.f22 * spin;
        side += f.across - y;
        moment += -wheel * a * (f.along - x) + (f.part - 1) * m;
        most += std::abs(x) + std::abs(y) + std::abs(m);
      }
      limit_claim.error(static_cast<double>(std::abs(force[0] - side) / most));
      limit_claim.error(static_cast<double>(std::abs(force[1] - moment) / (most * (1 + a))));
    }
    // How hard the wheels are used along a motion, instant by instant and wheel by wheel.
    Cycle cycle;
    cycle.omega = draw(5, 30), cycle.inverse_speed = 1 / speed, cycle.orders = {0, 1, 2};
    cycle.motion = Eigen::MatrixXcd::NullaryExpr(9, 3, [&] {
      return 2e-3 * Complex{draw(-1, 1), draw(-1, 1)};
    });
    const CycleForces found = cycle_forces(car, table, {friction, {}}, cycle, 16);
    Long worst = 0, creeps = 0;
    const std::size_t w = static_cast<std::size_t>(k) % wheelsets;
    for (int n = 0; n < 16; ++n) {
      const VectorXd y = state_at(cycle, 2 * units::pi * n / 16);
      const Long x = car.wheels[w].lateral.dot(y.head<9>()),
                 yaw = car.wheels[w].yaw.dot(y.head<9>()),
                 drift = car.wheels[w].lateral.dot(y.tail<9>()) / Long{speed} - yaw,
                 turn = car.wheels[w].yaw.dot(y.tail<9>()) / Long{speed};
      const auto at = table.at(static_cast<double>(x));
      const Long r0 = data.wheel_radius, a = data.half_gauge, step = table.R.step(),
                 place = x / step + (table.delta_left.size() - 1) / Long{2};
      const auto i = static_cast<std::size_t>(place);
      for (const int wheel : {1, -1}) {
        const WheelForce f = wheel_force(data, friction, -wheel * a * (turn + at.R / r0), drift,
                                         turn - Long{at.D} / r0);
        const auto& angles = wheel > 0 ? table.delta_left : table.delta_right;
        const Long angle = angles[i] +
                           (place - static_cast<Long>(i)) * (angles[i + 1] - angles[i]) +
                           wheel * Long{at.Phi},
                   load = axle_load(data) / 2, outward = wheel * f.across / load,
                   t = std::tan(angle);
        // N sin - T cos over N cos + T sin, T from the rail on the wheel towards the outside.
        worst = std::max(worst, (t - outward) / (1 + outward * t));
        creeps = std::max(creeps, std::hypot(f.along, f.across) / (friction * load));
      }
    }
    for (int n = 0; n < 2; ++n) {
      use.relative(found.lateral_over_vertical[w], worst);
      use.relative(found.creep[w], creeps);
    }
  }
}
