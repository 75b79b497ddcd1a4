/***
## The car and the forces on it

**Nine coordinates.** The car is a rigid body on two *trucks* (bogies). A truck has three pieces:
two side frames, which carry the two wheelsets at their ends, and a *bolster* across the middle, on
which the body turns at the *centre plate*. The axles are held in the side frames as if by ball
joints, so a truck can be pushed out of square like a parallelogram; the paper calls this angle
*warp*. {{drawing}} shows the coordinates,

$$q=(X_{TF},X_{TR},\theta_{TF},\theta_{TR},\theta_{WF},\theta_{WR},X_C,\theta_C,\phi_C).$$

They are the lateral displacement $X_T$ (positive to the left) of the front (F) and rear (R) truck,
the yaw $\theta_T$ of its side frames and its warp $\theta_W$ (positive to the left, in radians),
and the lateral displacement, yaw and roll of the body. The front wheelset of a truck stands at
$x_w=X_T+L_T\theta_T$ and the rear one at $x_w=X_T-L_T\theta_T$, with half the wheelbase $L_T$. Both
yaw by $\psi=\theta_T+\theta_W$. The bolster stays parallel to the axles and moves sideways with the
body.

**Creep forces.** Where a loaded wheel touches the rail the steel is strained, and the wheel does
not roll exactly as geometry says. The *creepage* is the sliding speed over the speed $V$ of the
car. A wheelset that moves sideways at the rate $\dot x_w$ while it points to $\psi$ has the lateral
creepage (as an index x means lateral, y vertical and z along the track)

$$\xi_x=\frac{\dot x_w}V-\psi. \tag{1}$$

Its right and left wheels roll on different radii but turn together, so each must slide lengthwise.
This sliding over the speed is the longitudinal creepage, with the radius $r_0$ of the wheels in the
middle of the track:

$$\xi_{zR}=1+\frac aV\dot\psi-\frac{r_R}{r_0}, \tag{2}$$

$$\xi_{zL}=1-\frac aV\dot\psi-\frac{r_L}{r_0}. \tag{3}$$

A wheel whose contact plane is inclined also turns on the spot, about the normal of that plane. This
turning over the speed is the spin creepage, in radians a length,

$$\xi_{\theta R}=\frac{\delta_R}{r_0}+\frac{\dot\psi}V, \tag{4}$$

$$\xi_{\theta L}=-\frac{\delta_L}{r_0}+\frac{\dot\psi}V. \tag{5}$$

For small creepages the forces are proportional to them; the paper calls this linear creep. The
factors are the creep coefficients: $f_{11}$ and $f_{33}$ for the lateral and the longitudinal
force, $f_{12}$ for the lateral force from spin and the moment from lateral creepage, and $f_{22}$
for the moment from spin.

**Gravity.** The rails' forces are normal to the contact planes. Their lateral parts $N_{xR}$ and
$N_{xL}$ push the wheelset back with

$$N_{xR}+N_{xL}=-W\Big(\frac{\delta_L-\delta_R}2+\phi_w\Big), \tag{6}$$

where $W$ is the load on the axle.

**Equations of motion.** Table 1 of the paper, which has them, is lost. They follow from what has
been said. With (1) to (6), one wheelset feels the lateral force $F_w$ and the yawing moment $M_w$,

$$F_w=-2f_{11}\Big(\frac{\dot x_w}V-\psi\Big)-\frac{2f_{12}}V\dot\psi+\Big(\frac{2f_{12}}{r_0}-W\Big)D-W\Phi,$$

$$M_w=-\frac{2(a^2f_{33}+f_{22})}V\dot\psi-\frac{2a^2f_{33}}{r_0}R+2f_{12}\Big(\frac{\dot x_w}V-\psi\Big)
  +\frac{2f_{22}}{r_0}D.$$

The function `add_creep` writes these two lines into the matrices of the car. The row `b` takes a
wheelset's displacement out of the nine coordinates, and `t` its yaw. What multiplies a rate goes
into `creep_damping`, which is divided by $V$ later. What multiplies the yaw goes into
`creep_stiffness`. The forces that unit values of $R$, $D$ and $\Phi$ exert become the columns
`g_r`, `g_d` and `g_phi`.

{{code: vehicle/freight_car.cpp add_creep}}

**Suspension.** Each of the seven joints of the suspension is a spring in parallel with dry
friction; the centre plates have friction only. The friction is replaced by its describing function,
(12) below. For the lateral springs of a side frame, with the stroke $s$, the stiffness $K_x$, the
friction $F_{0x}$ and the amplitude $A$ of the rate $\dot s$, the force is

$$F_{xs}=K_xs+\frac{4F_{0x}}{\pi A}\dot s. \tag{13}$$

The paper's (14) to (19) are the same for the rear truck, the vertical springs, the warp and the
centre plates.

{{parameters}}

**The creep coefficients can be recomputed**, because the paper names the theory, Kalker's, and
calls them full values. Hertz's theory gives the ellipse in which a wheel of 33 in diameter touches
a rail head of 10 in radius under half the axle load; steel has a modulus of 29 million psi and
Poisson's ratio is 0.3. The rail's radius and the steel are assumptions. Kalker's table gives the
coefficients for that ellipse.

{{creep-coefficients}}

Three coefficients agree with the print. This restores two exponents, and shows that the values are
full ones. For $f_{22}$ our text has 2.1, twenty times less than Kalker's theory gives, and we read
42.1. The ellipse gives {{f22}}. The printed $f_{11}$ and $f_{12}$ give {{f22-print}} without crown,
load and modulus, because $f_{22}f_{11}/f_{12}^2=C_{33}C_{22}/C_{23}^2$, with Kalker's coefficients
$C_{22}$, $C_{23}$ and $C_{33}$, depends on the shape of the ellipse alone. All computations use
42.1; the literal 2.1 would change the critical speed with new wheels by {{f22-effect}}.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/report/values.hpp>
#include <railbook/rolling/kalker_table.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

constexpr double lbf = units::lbf, foot_pound = units::foot * units::lbf;

std::string origin_text(const CarDatum& datum) {
  const char* origin = datum.origin == Origin::printed    ? "printed"
                       : datum.origin == Origin::restored ? "restored"
                                                          : "reconstructed";
  return *datum.remark ? fmt::format("{}: {}", origin, datum.remark) : origin;
}

struct Creep {
  double f11, f12, f22, f33;
};

// Hertz's ellipse of wheel on rail, and Kalker's coefficients of it.
Creep by_hertz_and_kalker(const CarParameters& car, double crown = 10 * inch,
                          double young = 29e6 * units::psi) {
  const auto curvature =
      contact::relative_curvature({1 / car.wheel_radius, 0}, {0, 1 / crown});  // x along the rail
  const contact::Material steel{young, 0.3};
  const double modulus = contact::effective_modulus(steel, steel);
  const auto ellipse = contact::hertz_from_force(curvature, modulus, axle_load(car) / 2);
  const auto c = rolling::kalker_table(ellipse.a / ellipse.b, steel.poisson);
  const double shear = steel.shear_modulus(), ab = ellipse.a * ellipse.b;
  return {shear * ab * c.c22, shear * std::pow(ab, 1.5) * c.c23, shear * ab * ab * c.c33,
          shear * ab * c.c11};
}

// A unit as a page has it: N·m/rad for N*m/rad, kg·m² for kg*m^2, ft·lb for ft lb.
std::string written(std::string unit) {
  std::ranges::replace(unit, ' ', '*');
  for (std::size_t at; (at = unit.find('*')) != std::string::npos;) unit.replace(at, 1, "·");
  for (std::size_t at; (at = unit.find("^2")) != std::string::npos;) unit.replace(at, 2, "²");
  return unit;
}

void parameters(report::Item& item) {
  item.rebuilt("data of Table 2 that are illegible or not given are marked");
  item.columns({"", "what", {"value", "{:.7g}"}, "unit", "SI", "origin"});
  const CarParameters car;
  for (const CarDatum& datum : car_data()) {
    const double si = car.*datum.member;
    item.add_row(
        fmt::format("${}$", datum.symbol), datum.name, si / datum.unit_si, written(datum.unit),
        fmt::format("{:.5g} {}", si, written(units::si_name(datum.dimension))), origin_text(datum));
  }
  const Dampers c = equivalent_dampers(car);
  const auto damper = [&](const char* symbol, const char* what, double value, bool turns) {
    item.add_row(symbol, what, fmt::format("{:.4g}", value / (turns ? foot_pound : lbf / foot)),
                 turns ? "ft·lb·s/rad" : "lb·s/ft",
                 fmt::format("{:.5g} {}", value, turns ? "N·m·s/rad" : "N·s/m"),
                 "fitted: $4F_0/\\pi\\omega_cA_c$");
  };
  damper("$c_x$", "lateral damper, a side frame", c.lateral, false);
  damper("$c_y$", "vertical damper, a side frame", c.vertical, false);
  damper("$c_w$", "warp damper, a truck", c.warp, true);
  damper("$c_\\theta$", "centre-plate damper, a truck", c.centre_plate, true);
  item.value("axle-load", axle_load(car) / lbf, "lb", "{:.0f}");
}

// The printed coefficient that is farthest from the computed one, over it.
double farthest(const CarParameters& print, const Creep& f) {
  double ratio = 1;
  for (const double t : {print.f11 / f.f11, print.f33 / f.f33, print.f12 / f.f12})
    if (std::abs(std::log(t)) > std::abs(std::log(ratio))) ratio = t;
  return ratio;
}

// f22 from the printed f11 and f12, free of load, size and modulus: f11 goes with the ellipse's
// area, f12 with its power 3/2, f22 with its square.
double f22_by_print(const CarParameters& print, const Creep& f) {
  return f.f22 * f.f11 / (f.f12 * f.f12) * print.f12 * print.f12 / print.f11;
}

// By how much another f22 moves the critical speed with new wheels [ft/s].
double effect_of_f22(double f22) {
  CarParameters other;
  other.f22 = f22;
  return std::abs(first_critical(other, vehicle("new")).speed -
                  first_critical({}, vehicle("new")).speed);
}

void creep_coefficients(report::Item& item) {
  item.rebuilt(
      "the paper names Kalker's theory; rail crown, modulus and Poisson's ratio are assumed");
  item.expect_checks(6);
  const CarParameters print;
  const Creep f = by_hertz_and_kalker(print);
  const double f22 = foot * foot_pound, by_print = f22_by_print(print, f);
  const auto assumed =
      report::relative(words::nearly, "crown, modulus and Poisson's ratio are assumed");
  const auto exponent =
      report::restored("the exponent is illegible; any other is off by a factor of ten", assumed);
  item.print("f11", "f11, lateral creep: our text has \"1.151!05 10\"", "lb", "1.15e6", f.f11 / lbf,
             exponent);
  item.print("f33", "f33, longitudinal creep: our text has \"1.262x10° 18\"", "lb", "1.262e6",
             f.f33 / lbf, exponent);
  item.print("f12", "f12, lateral/spin creep: our text has \"6750\"", "ft·lb", "6750",
             f.f12 / foot_pound, assumed);
  item.print("f22", "f22, spin creep, from the printed f11 and f12: our text has \"2.1\"", "ft²·lb",
             "42.1", by_print / f22,
             report::restored("2.1 is twenty times too small: we read a first digit that is lost",
                              report::absolute(5, "half of the way to the next readings")));
  report::Trial full = item.trial("full-kalker", "print over computation, the worst of three",
                                  "{:.2f}", [](double t) { return t > 0.75 && t < 1.5; });
  full.vary("crown of the rail head", [&](const report::Setting& s) {
    return farthest(print, by_hertz_and_kalker(print, s.number * inch));
  });
  full.vary("Young's modulus", [&](const report::Setting& s) {
    return farthest(print, by_hertz_and_kalker(print, 10 * inch, s.number * 1e6 * units::psi));
  });
  item.claim("full-kalker", "the creep coefficients are full Kalker values", full,
             fmt::format("{} times those of Hertz and Kalker; half of the full values would be 0.5",
                         full.range()));
  item.value("creep-range", full.range() + " times");
  const double change = effect_of_f22(2.1 * f22);
  item.at_most("f22-effect",
               "change of the critical speed, new wheels, with f22 of 2.1 instead of 42.1", "ft/s",
               change, 0.5, "half of the printed speed's last digit");
  report::values(item, "ft²·lb", "{:.1f}", "f22", f.f22 / f22, "f22-print", by_print / f22);
  item.value("f22-effect", change, "ft/s", "{:.0e}");
}

}  // namespace

const report::Section car{report::table("parameters", parameters),
                          report::table("creep-coefficients", creep_coefficients)};

}  // namespace railbook::hunting_chapter
