/***
## The car

Two trucks of three pieces each under a rigid body: nine degrees of freedom,
$q=(X_{TF},X_{TR},\theta_{TF},\theta_{TR},\theta_{WF}, \theta_{WR},X_C,\theta_C,\phi_C)$: each
truck's lateral position, the yaw $\theta_T$ of its side frames and its *warp* $\theta_W$, the angle
by which the parallelogram of side frames and axles is out of square; then the body's lateral
position, yaw and roll. A wheelset stands at $x_w=X_T\pm L_T\theta_T$ with the yaw
$\psi=\theta_T+\theta_W$; the bolster stays parallel to the axles and moves with the body. The
creepages of its wheels are, in the paper's (1) to (5),

$$\xi_x=\frac{\dot x_w}V-\psi, \tag{1}$$

where $V$ is the speed, and

$$\xi_{zR,L}=1\pm\frac aV\dot\psi-\frac{r_{R,L}}{r_0},\qquad \xi_{\theta R,L}=\pm\frac{\delta_{R,L}}{r_0}+\frac{\dot\psi}V, \tag{2}$$

with half the distance $a$ of the two contact points and the rolling radius $r_0$ of the centred
wheels. Gravity pushes sideways with

$$N_{xR}+N_{xL}=-W\Big(\frac{\delta_L-\delta_R}2+\phi_w\Big). \tag{6}$$

where $W$ is the axle load. Table 1 of the paper, the equations of motion, is lost. They follow from
these words and linear creep forces with the coefficients $f_{11}$ (lateral), $f_{33}$
(longitudinal), $f_{12}$ and $f_{22}$ (spin): one wheelset feels the force and the moment

$$F=-2f_{11}\Big(\frac{\dot x_w}V-\psi\Big)-\frac{2f_{12}}V\dot\psi+\Big(\frac{2f_{12}}{r_0}-W\Big)D-W\Phi,$$
$$M=-\frac{2(a^2f_{33}+f_{22})}V\dot\psi-\frac{2a^2f_{33}}{r_0}R+2f_{12}\Big(\frac{\dot x_w}V-\psi\Big)
  +\frac{2f_{22}}{r_0}D.$$

Spin creep cancels {{spin-share}} of the force that gravity exerts through the contact angle:
$2f_{12}/r_0$ = {{spin-force}} against an axle load of {{axle-load}}.

{{code: vehicle/freight_car.cpp add_creep}}

The suspension is springs in parallel with dry friction, whose describing function is (12) below;
for the joints, with the amplitudes $A_1\ldots A_7$ of their rates,

$$F_{xs}=K_xu+\frac{4F_{0x}}{\pi A}\dot u, \tag{13}$$

and (14) to (19) likewise for the rear, the vertical springs, warp and the centre plates:

{{code: vehicle/freight_car.cpp joint_list}}

{{parameters}}

**The creep coefficients can be recomputed**, because the paper names the theory, Kalker's, and
calls them full values: Hertz's ellipse of a 33-in wheel on a rail head of 10 in under half the axle
load, steel of 29·10⁶ psi and Poisson's ratio 0.3 (radius and steel are assumptions), times Kalker's
table.

{{creep-coefficients}}

Three agree with the print, which settles two exponents and that the values are full ones. The text
that we have of the paper prints $f_{22}$ as 2.1, twenty times less than Kalker's theory gives, and
we read 42.1. The ellipse gives {{f22}}; and the printed $f_{11}$ and $f_{12}$ give {{f22-print}}
without crown, load and modulus, because $f_{22}f_{11}/f_{12}^2=C_{33}C_{22}/C_{23}^2$ depends on
the ellipse's shape alone. All computations use 42.1. The literal 2.1 would change the critical
speed with new wheels by {{f22-effect}}.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/contact/hertz.hpp>
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

constexpr double poisson = 0.3;

struct Creep {
  double f11, f12, f22, f33;
};

// Hertz's ellipse of wheel on rail, and Kalker's coefficients of it.
Creep by_hertz_and_kalker(const CarParameters& car, double crown = 10 * inch,
                          double young = 29e6 * units::psi) {
  const auto curvature =
      contact::relative_curvature({1 / car.wheel_radius, 0}, {0, 1 / crown});  // x along the rail
  const double modulus = contact::effective_modulus({young, poisson, young, poisson});
  const auto ellipse = contact::hertz_from_force(curvature, modulus, axle_load(car) / 2);
  const auto c = rolling::kalker_table(ellipse.a / ellipse.b, poisson);
  const double shear = young / (2 * (1 + poisson)), ab = ellipse.a * ellipse.b;
  return {shear * ab * c.c22, shear * std::pow(ab, 1.5) * c.c23, shear * ab * ab * c.c33,
          shear * ab * c.c11};
}

void parameters(report::Item& item) {
  item.rebuilt("data of Table 2 that are illegible or not given are marked");
  item.columns({"", "what", {"value", "{:.7g}"}, "unit", "SI", "origin"});
  const CarParameters car;
  for (const CarDatum& datum : car_data()) {
    const double si = car.*datum.member;
    item.add_row(fmt::format("${}$", datum.symbol), datum.name, si / datum.unit_si, datum.unit,
                 fmt::format("{:.5g} {}", si, units::si_name(datum.dimension)), origin_text(datum));
  }
  const Dampers c = equivalent_dampers(car);
  const auto damper = [&](const char* symbol, const char* what, double value, bool turns) {
    item.add_row(symbol, what, value / (turns ? foot_pound : lbf / foot),
                 turns ? "ft lb s/rad" : "lb s/ft",
                 fmt::format("{:.5g} {}", value, turns ? "N m s/rad" : "N s/m"),
                 "fitted: $4F_0/\\pi\\omega A$");
  };
  damper("$c_x$", "lateral damper, a side frame", c.lateral, false);
  damper("$c_y$", "vertical damper, a side frame", c.vertical, false);
  damper("$c_w$", "warp damper, a truck", c.warp, true);
  damper("$c_\\theta$", "centre-plate damper, a truck", c.centre_plate, true);
  const double spin = 2 * car.f12 / car.wheel_radius, load = axle_load(car);
  item.value("spin-force", spin / lbf, "lb", "{:.0f}");
  item.value("axle-load", load / lbf, "lb", "{:.0f}");
  item.value("spin-share", 100 * spin / load, "%", "{:.0f}");
}

void creep_coefficients(report::Item& item) {
  item.rebuilt(
      "the paper names Kalker's theory; rail crown, modulus and Poisson's ratio are assumed");
  item.expect_checks(6);
  const CarParameters print;
  const Creep f = by_hertz_and_kalker(print);
  const double f22 = foot * foot_pound;
  // Free of load, size and modulus: f11 goes with the ellipse's area, f12 with its power 3/2, f22 with its square.
  const double by_print = f.f22 * f.f11 / (f.f12 * f.f12) * print.f12 * print.f12 / print.f11;
  const auto assumed =
      report::relative(words::nearly, "crown, modulus and Poisson's ratio are assumed");
  const auto exponent =
      report::restored("the exponent is illegible; any other is off by a factor of ten", assumed);
  item.print("f11", "f11, lateral creep: our text has \"1.151!05 10\"", "lb", "1.15e6", f.f11 / lbf,
             exponent);
  item.print("f33", "f33, longitudinal creep: our text has \"1.262x10° 18\"", "lb", "1.262e6",
             f.f33 / lbf, exponent);
  item.print("f12", "f12, lateral/spin creep: our text has \"6750\"", "ft lb", "6750",
             f.f12 / foot_pound, assumed);
  item.print("f22", "f22, spin creep, from the printed f11 and f12: our text has \"2.1\"", "ft² lb",
             "42.1", by_print / f22,
             report::restored("2.1 is twenty times too small: we read a first digit that is lost",
                              report::absolute(5, "half of the way to the next readings")));
  // The printed value that is farthest from ours, times ours.
  const auto worst = [&](const Creep& c) {
    double least = 1;
    for (const double t : {print.f11 / c.f11, print.f33 / c.f33, print.f12 / c.f12})
      if (std::abs(std::log(t)) > std::abs(std::log(least))) least = t;
    return least;
  };
  report::Trial full = item.trial("full-kalker", "print over computation, the worst of three",
                                  "{:.2f}", [](double t) { return t > 0.75 && t < 1.5; });
  full.vary("crown of the rail head", [&](const report::Setting& s) {
    return worst(by_hertz_and_kalker(print, s.number * inch));
  });
  full.vary("Young's modulus", [&](const report::Setting& s) {
    return worst(by_hertz_and_kalker(print, 10 * inch, s.number * 1e6 * units::psi));
  });
  claim(item, "full-kalker", full,
        fmt::format("{} times those of Hertz and Kalker; half of the full values would be 0.5",
                    full.range()));
  item.value("creep-range", full.range() + " times");
  CarParameters other;
  other.f22 = 2.1 * f22;
  const Vehicle& fresh = vehicle("new");
  const double change =
      std::abs(first_critical(other, fresh).speed - first_critical({}, fresh).speed);
  item.at_most("f22-effect", "critical speed, new wheels, f22 of 2.1 instead of 42.1", "ft/s",
               change, 0.5, "half of the printed speed's last digit");
  item.value("f22", f.f22 / f22, "ft² lb", "{:.1f}");
  item.value("f22-print", by_print / f22, "ft² lb", "{:.1f}");
  item.value("f22-effect", change, "ft/s", "{:.0e}");
}

}  // namespace

const report::Section car{
    report::table("parameters", "The car's data (Table 2)", parameters),
    report::table("creep-coefficients", "Creep coefficients by Hertz and Kalker",
                  creep_coefficients)};

}  // namespace railbook::hunting_chapter
