/***
## The car

Two trucks of three pieces each under a rigid body. The state is $q=(X_{TF},X_{TR},\theta_{TF},\theta_{TR},\theta_{WF},
\theta_{WR},X_C,\theta_C,\phi_C)$: each truck's lateral position, the yaw $\theta_T$ of its side frames and its *warp* $\theta_W$, the angle by which
the parallelogram of side frames and axles is out of square; then the body's lateral position, yaw and roll. A wheelset stands at
$x_w=X_T\pm L_T\theta_T$ with the yaw $\psi=\theta_T+\theta_W$; the bolster stays parallel to the axles and moves with the
body.

Table 1 of the paper, the equations of motion, is lost. They follow from the words: with the creepages of
(1) to (5) and the linear creep forces, one wheelset feels

$$F=-2f_{11}\Big(\frac{\dot x_w}V-\psi\Big)-\frac{2f_{12}}V\dot\psi+\Big(\frac{2f_{12}}{r_0}-W\Big)D-W\Phi,$$
$$M=-\frac{2(a^2f_{33}+f_{22})}V\dot\psi-\frac{2a^2f_{33}}{r_0}R+2f_{12}\Big(\frac{\dot x_w}V-\psi\Big)
  +\frac{2f_{22}}{r_0}D,$$

and no other property of the contact matters than the three functions $R=(r_L-r_R)/2a$, $D=(\delta_L-\delta_R)/2$ and
$\Phi=\phi_w$ of $x_w$. Spin creep carries {{spin-share}} of what gravity does to the contact angle, with the other sign: $2f_{12}/r_0$ = {{spin-force}} against an axle load of
{{axle-load}}.

Every matrix is a sum of outer products of row vectors, one for each body, spring and wheelset. {{matrices}}
compares the result with the same car computed without them, body by body and wheel by wheel.

{{matrices}}

{{parameters}}

Some entries are not simply printed: exponents and digits are missing in the available copy, and the equivalent linear
dampers are not stated at all. The paper took "constant amplitudes and frequency" for them; 20 rad/s,
0.5 in and 0.003 rad are ours, $c=4F_0/\pi\omega A$ each. This one choice brings the paper's critical speed and its three
frequencies together ({{critical-speeds}}). What it is worth is told by {{fig-sensitivities}}.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/body_by_body.hpp"
#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

std::string origin_text(const CarDatum& datum) {
  switch (datum.origin) {
    case Origin::printed:
      return *datum.remark ? fmt::format("printed; {}", datum.remark) : "printed";
    case Origin::restored:
      return fmt::format("restored: {}", datum.remark);
    case Origin::reconstructed:
      return fmt::format("reconstructed: {}", datum.remark);
  }
  return "";
}

void parameters(report::Item& item) {
  item.columns({"", "what", "value", "unit", "SI", "origin"});
  item.reconstructed("data of Table 2 that are illegible, missing or ours are marked");
  const CarParameters car;
  for (const CarDatum& datum : car_data()) {
    const double si = car.*datum.member;
    item.add_row({fmt::format("${}$", datum.symbol), datum.name,
                  fmt::format("{:.7g}", si / datum.unit_si), datum.unit,
                  fmt::format("{:.5g} {}", si, units::si_name(datum.dimension)),
                  origin_text(datum)});
  }
  const Dampers c = equivalent_dampers(car);
  const double per_foot = units::lbf / units::foot, torque = units::lbf * units::foot;
  const auto damper = [&](const char* symbol, const char* what, double value, double unit,
                          const char* unit_name, const char* si) {
    item.add_row({symbol, what, fmt::format("{:.1f}", value / unit), unit_name,
                  fmt::format("{:.5g} {}", value, si), "reconstructed: $4F_0/\\pi\\omega A$"});
  };
  damper("$c_x$", "lateral damper, a side frame", c.lateral, per_foot, "lb s/ft", "N s/m");
  damper("$c_y$", "vertical damper, a side frame", c.vertical, per_foot, "lb s/ft", "N s/m");
  damper("$c_w$", "warp damper, a truck", c.warp, torque, "ft lb s/rad", "N m s/rad");
  damper("$c_\\theta$", "centre-plate damper, a truck", c.centre_plate, torque, "ft lb s/rad",
         "N m s/rad");
  const double spin = 2 * car.f12 / car.wheel_radius, load = axle_load(car);
  item.value("spin-force", spin / units::lbf, "lb", "{:.0f}");
  item.value("axle-load", load / units::lbf, "lb", "{:.0f}");
  item.value("spin-share", 100 * spin / load, "%", "{:.0f}");
}

// A motion with all parts of it moving, no two alike.
Vector9 sample(double seed, double size) {
  return Vector9::NullaryExpr(
      [&](Eigen::Index k) { return size * std::sin(seed * (1.7 + 2.3 * static_cast<double>(k))); });
}

WheelContacts contacts_at(const wheelrail::ConstraintFunctions& t, double x) {
  const auto c = t.at(x);
  const double r = t.radius + t.half_spacing * c.R, other = t.radius - t.half_spacing * c.R;
  return {r, other, c.D, -c.D, c.Phi};
}

void matrices(report::Item& item) {
  item.columns({"what", "matrices", "by itself"});
  item.reconstructed("Table 1 of the paper, the equations of motion, is lost");
  item.expect_checks(7);
  const double speed = 145 * units::foot;
  for (const auto suspension : {Suspension::dampers, Suspension::friction}) {
    const FreightCar car = assemble({}, suspension);
    const auto& table = *study("cn").table;
    const CarAtSpeed rates = at_speed(car, speed);
    const bool friction = car.has_friction;
    for (int k = 1; k <= 3; ++k) {
      const Vector9 q = sample(k, 0.008), v = sample(k + 0.4, 0.05), w = sample(k + 0.7, 1);
      const Vector9 acceleration = rates.acceleration(q, v, [&](double x_over_a) {
        const auto c = table.at(x_over_a * rates.half_gauge);
        return Constraint{c.R, c.D, c.Phi};
      });
      const double power = w.dot(car.mass * acceleration);
      const double alone = force_power(
          car.data, friction, speed, [&](double x) { return contacts_at(table, x); }, q, v, w);
      const std::string id = fmt::format("power-{}-{}", friction ? "friction" : "dampers", k);
      const std::string what =
          fmt::format("power of all forces, {}, motion {}", friction ? "friction" : "dampers", k);
      item.add_row({what, fmt::format("{:.10g} W", power), fmt::format("{:.10g} W", alone)});
      item.agree(id, what, "W", power, alone, 1e-9, "eqs (1) to (6) at every wheel");
    }
    if (friction) continue;
    const Vector9 v = sample(1.4, 0.05);
    const double energy = 0.5 * v.dot(car.mass * v), alone = kinetic_energy(car.data, v);
    item.add_row(
        {"kinetic energy", fmt::format("{:.10g} J", energy), fmt::format("{:.10g} J", alone)});
    item.agree("kinetic-energy", "kinetic energy of one motion", "J", energy, alone, 1e-13,
               "15 bodies one by one");
  }
}

}  // namespace

void add_car(report::Chapter& chapter) {
  chapter.table("parameters", "The car's data (the paper's Table 2)", parameters);
  chapter.table("matrices", "The matrices against the car body by body", matrices);
}

}  // namespace railbook::hunting_chapter
