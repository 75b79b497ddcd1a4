/*** # Which forces act where a measured wheel meets a measured rail?

A program that simulates a vehicle asks for these forces thousands of times a second, at each wheel
and for each position. The textbook's answer is one elliptical contact, but a real wheel on a real
rail touches on its running surface (the tread), on the rim inside the rail (the flange) or at the
corner between them, and often at two places at once. Wear, noise and derailment are decided by what
happens in these patches of half a square centimetre.

::: {#live-wheel-on-rail .live figure=wheel-on-rail}

{{pair}}

:::

::: findings
1. **How good are the forces that this program finds?** CONTACT, the program of Kalker's school, is
   the field's reference. On {{wheels}} of the 22 wheels of a published benchmark our largest
   pressure is within {{worst-pressure}} of its value. The creep force, the friction force of
   rolling with a little slip, differs from CONTACT's by at most {{worst-force}} of the friction
   limit $\mu N$, with the friction coefficient $\mu$ and the normal force $N$. This holds for
   patches small enough to be taken as flat.
2. **What does a fast method cost in accuracy?** One that cuts the patch into strips along the rolling
   direction, each loaded as by Hertz's formulas (semi-Hertzian), and takes friction from Kalker's
   simplified theory (FASTSIM) can fill tables of thousands of positions. On the same wheels it is off
   by up to {{strips-pressure}} in the largest pressure and {{strips-force}} of the friction limit in the
   force.
3. **Where do methods part?** Where a second place is about to touch. At a shift of 5 mm CONTACT finds
   one patch that joins both places, and this program finds two. Neither is proved right, so this wheel
   is shown and not compared.
:::

This chapter is an **addition beyond the papers**: no paper of the book takes profiles to patches to
forces. It joins the wheel and rail profiles of [chapter 02](02-hunting.html), the pressures of
[chapter 01](01-contact.html) and the rolling theory of [chapter 03](03-creep.html).

## The benchmark

We compare with case A of the Manchester contact benchmark (Shackleton and Iwnicki 2008), in its
part A2.2 with yaw. The reference values are those of the open-source version of CONTACT. A wheelset
with the European wheel profile S1002 stands on rails UIC 60 (today 60E1) that lean inwards by 1:40.
It carries 20 kN, the friction coefficient $\mu$ is 0.3, and it rolls at 2 m/s. It is shifted
sideways by 0 to 10 mm and turned about the vertical, *yawed*, by 2.4 mrad for each millimetre of
shift. That makes eleven positions and 22 wheels.

{{fig-patches}}

## From profiles to patches

Directions are $x$ forward along the track, $y$ to the right and $z$ down. On the wheel, $s$ is the
place across, from the circle on which it nominally rolls, and $\theta$ the angle round the axle; its
radius there is $r(s)$. The wheelset is yawed by $\psi$.

**Where can it touch?** A straight rail has the same profile all along the track. So a point of the
wheel can touch it only where the normal of its surface has no component along the track,

$$ \cos\psi\,\sin\theta+\sin\psi\,r'(s)=0. $$

This gives one angle for each $s$: one line on the wheel. The search for contact is thereby a search
along a line. The function `point` of `PlacedWheel` finds the place for one $s$ and the gap down to the
rail:

{{code: wheel_contact/find_contact.cpp point}}

Where the gap is least, the rigid wheel touches first. `find_contact` walks along the line, keeps each local
minimum, and refines it:

{{code: wheel_contact/find_contact.cpp find_contact}}

**Which patches form?** A loaded wheel sinks deeper than first touch and, if it stayed rigid, would
overlap the rail around each minimum. Each area of overlap becomes a patch with a plane of its own.
The origin and the slope of the plane are means over the overlap, weighted by its depth to the power 5/2
(`mean_of`). The distance between the exact surfaces, measured along the normal of that plane, is the
gap of the contact problem. Areas less than 4 mm apart whose normals nearly agree share one plane.

{{code: wheel_contact/patch.cpp mean_of}}

Why the power 5/2? A circular contact of half-width $b$ lies, by Hertz, in an overlap of half-width
$\sqrt2\,b$ whose depth is a parabola. Weighted with the depth to the power $m$, a place $t$ across has
the mean square

$$ \overline{t^2}=\frac{2b^2}{2m+3}, $$

and over the area in contact itself it is $b^2/4$. The two mean squares agree for $m=5/2$. With this
power the plane stands in the middle of the true area, as far as the overlap lets one know it. On
the wheels compared, the middle of the pressures found is within {{frame-off}} of the patch's width
from it. The power was first chosen because the planes then met CONTACT's; this reason came later.

## Load, creepage and force

**How do the patches share the load?** The wheel sinks until the vertical parts of all patches'
forces, friction's included, add up to its load. `solve_full` has three steps: `place_planes` finds
the depth on a coarse grid and places the planes there, `fit_grid` finds it again on a fine one, and
`settle_friction` solves pressure and friction in turn until the load is met:

{{code: wheel_contact/wheel.cpp place_planes}}

{{code: wheel_contact/wheel.cpp settle_friction}}

The pressures are those of elastic half-spaces, by the conjugate gradients of
[chapter 01](01-contact.html).

**How does the wheel slide?** The creepages are the velocity of the rigid wheel over the rail at the
patch, along and across, divided by the speed of rolling; spin is its rate of turning about the normal
of the patch, divided by the same speed. A yawed wheel creeps across, and a wheel on a steep part of the
flange spins. `motion_of` is plain kinematics:

{{code: wheel_contact/wheel.cpp motion_of}}

**Which friction follows?** On the cells that carry pressure, Kalker's full theory finds where they stick
and slide, as in [chapter 03](03-creep.html). Here it works on the patch as it is, not on an ellipse.

## How close it comes

{{fig-pressure}}

At this load the largest pressures of the three methods nearly agree: strips are within
{{strips-pressure}} of CONTACT, Hertz's ellipse within {{hertz-pressure}}. What the approximate
methods lack is the patch's own outline and the full theory's tractions. The force along the track,
a small part of the friction limit, shows it.

{{fig-force}}

{{case-a}}

{{include: bank.cpp}}

{{include: below.cpp}}

{{include: patches.cpp}}

## Deviations

* **CONTACT's pressures on the flange** are 1 to 2 % above those here. Its table was made with cells of
  0.2 mm, four across a patch of the flange; on finer cells its pressures are lower.
* **At 5 mm** its right wheel has one patch of two areas 10 mm apart, with one plane between; here they
  are two half-spaces. That wheel is shown and not compared.
* **Roll and turning.** The *roll* of the wheelset is its tilt about the direction of the track.
  That a wheelset whose roll is free balances with friction's part of the forces is plain statics,
  but it was put so after CONTACT's numbers were seen and confirms nothing. In the table above, the
  roll of the wheelset and the rate at which it turns are the benchmark's.

## Limits

* *Half-spaces*, also on the gauge corner, where a patch whose normal turns by more than 0.35 rad is
  reported as conformal, that is too curved for half-spaces. Patches are plane, and the rolling is
  steady.
* *Falling friction.* Friction falls with the mean slip that a patch of rigid bodies would have, not
  with the slip of each particle; with that a rolling contact has several solutions.
* *Unlike materials.* Pressures drive the surfaces of unlike bodies apart along themselves, so that a
  roller of aluminium on one of steel creeps even when it rolls freely. The full theory takes that into
  the slip and meets Bentall and Johnson's rollers within 1 % of the creepage that CONTACT prints (a
  test: *rollers of aluminium and steel*). What the tractions do to the pressure in return is left out.
  That is half a per cent there, but a third where friction stiffens an aluminium ball pressed on steel
  (Spence 1975). Wheel and rail are both of steel.
* *Starting from rest.* The library can do it: under a constant force Cattaneo's shift goes over into
  Carter's rolling step by step, in Kalker's case within 0.2 % of the creepages that CONTACT prints on
  the way (a test: *from Cattaneo to Carter*). A wheel's patch is passed in some milliseconds, so this
  page stays with the steady end.

## Use it

`railbook wheelrail contact` does this for a wheelset of your own. Give the profiles as tables with
`--wheel` and `--rail`; without them it takes S1002 on 60E1. The wheelset's roll and its rate of turning
are found so that it is in balance:

```console
$ railbook wheelrail contact --shift 4mm --yaw 5mrad --load 50kN --speed 30m/s
...
  right rail: force along                       -3610 +- 60 N
    to the right                                -8930 +- 60 N
...
    normal force                                48780 N
    largest pressure                            1155 +- 3 MPa
    area                                        64.06 mm^2
...
    creepage along                              -0.001364
    across                                      -0.005032
    spin                                        -0.2291 1/m
...
```

{{picture: wheelrail-contact}}

`railbook wheelrail table` makes the table that a vehicle program looks up.

## Try next

* Push the wheelset to where a second place touches. The right wheel then has two patches, and the
  command warns how much each would press on the other:

```console
$ railbook wheelrail contact --shift 5mm --yaw 12mrad --load 10kN --speed 2m/s --head 60E1-benchmark
...
  right patch 1: place along                    -6.94712 +- 1e-05 mm
...
    largest pressure                            1572 +- 3 MPa
...
  right patch 2: place along                    -8.04312 +- 3e-05 mm
...
    largest pressure                            297.2 +- 0.4 MPa
...
```

* Use the fast method on the first example. How far is its force along the track from the full
  theory's?

```console
$ railbook wheelrail contact --shift 4mm --yaw 5mrad --load 50kN --speed 30m/s --method strips
...
  right rail: force along                       -3766 N   (error not known)
...
```

## Symbols

{{symbols}}

## Coverage

{{coverage}}
*/
#include <fmt/format.h>

#include <cmath>
#include <map>

#include <railbook/report/chapter.hpp>
#include <railbook/units/constants.hpp>

#include "case_a.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::wheel_on_rail_chapter;

namespace {

const std::string work = "CONTACT, example mbench_a22";

// Just beyond a jump of the contact, where programs part.
bool verge(const std::string& key) {
  return key == "right-5";
}

// Across, from the frame's origin, over the width of the contact.
double middle_of_pressure(const PatchResult& p) {
  double moment = 0, low = units::infinity, high = -units::infinity;
  for (Eigen::Index k = 0; k < p.pressure.size(); ++k) {
    if (!(p.pressure[k] > 0)) continue;
    const double t = p.grid.y(k / p.grid.nx);
    moment += t * p.pressure[k];
    low = std::min(low, t), high = std::max(high, t);
  }
  return moment / p.pressure.sum() / (high - low + p.grid.dy);
}

void case_a(report::Item& item) {
  item.added("the benchmark is no paper of the book");
  static const table::CsvTable published = item.printed("case-a.csv");
  item.expect_checks(4 * 21);
  item.columns({"wheel",
                {"normal force, N", "{:.0f}"},
                {"largest pressure, MPa", "{:.1f}"},
                "CONTACT",
                {"along, N", "{:.0f}"},
                "CONTACT",
                {"across, N", "{:.0f}"},
                "CONTACT",
                "patches"});
  double pressure = 0, force = 0, strips_pressure = 0, strips_force = 0, frame = 0;
  double hertz_pressure = 0, hertz_force = 0;
  int compared = 0;
  for (const Wheel& wheel : wheels(published)) {
    const WheelResult found = solved(wheel, Method::full);
    const PatchResult& p = found.patches.front();
    item.add_row(wheel.key, p.load, p.p_max / units::megapascal, published.at(wheel.key, "p-max"),
                 p.forces.fx, published.at(wheel.key, "fx"), wheel.side * p.forces.fy,
                 published.at(wheel.key, "fy"), double(found.patches.size()));
    if (verge(wheel.key)) continue;
    ++compared;
    const report::Row row = item.row(published, wheel.key);
    const double bound = 0.3 * wheel.normal;
    row.publication("p-max", p.p_max / units::megapascal,
                    report::relative(0.02, "its cells are a quarter of a flange patch"), work);
    row.publication("approach", p.approach / units::micrometre,
                    report::relative(0.02, "its cells are a quarter of a flange patch"), work);
    row.publication("fx", p.forces.fx,
                    report::absolute(0.01 * bound, "a hundredth of the friction limit"), work);
    row.publication("fy", wheel.side * p.forces.fy,
                    report::absolute(0.01 * bound, "a hundredth of the friction limit"), work);
    const PatchResult quick = solved(wheel, Method::strips).patches.front();
    const auto off = [&](const PatchResult& a, double& worst_pressure, double& worst_force) {
      worst_pressure =
          std::max(worst_pressure, std::abs(a.p_max / units::megapascal / wheel.p_max - 1));
      worst_force =
          std::max(worst_force,
                   std::hypot(a.forces.fx - wheel.fx, wheel.side * a.forces.fy - wheel.fy) / bound);
    };
    off(p, pressure, force);
    frame = std::max(frame, std::abs(middle_of_pressure(p)));
    off(quick, strips_pressure, strips_force);
    off(solved(wheel, Method::hertz).patches.front(), hertz_pressure, hertz_force);
  }
  item.value("wheels", compared, "", "{:.0f}");
  item.value("worst-pressure", 100 * pressure, "%", "{:.1f}");
  item.value("worst-force", 100 * force, "%", "{:.1f}");
  item.value("frame-off", 100 * frame, "%", "{:.0f}");
  item.value("strips-pressure", 100 * strips_pressure, "%", "{:.0f}");
  item.value("hertz-pressure", 100 * hertz_pressure, "%", "{:.0f}");
  item.value("strips-force", 100 * strips_force, "%", "{:.0f}");
}

// A quantity of all methods over the shift, with CONTACT's points.
void over_shift(report::Item& item, const char* name, double (*of)(const WheelResult&),
                double (*published)(const Wheel&)) {
  item.added("the benchmark is no paper of the book");
  report::Data& data = item.data({"y_mm", "full", "strips", "hertz"});
  report::Data& points = item.data("contact", {"y_mm", std::string(name)});
  static const table::CsvTable table = item.printed("case-a.csv");
  int side = 0;
  for (const Wheel& wheel : wheels(table)) {
    if (side != 0 && side != int(wheel.side)) data.gap(), points.gap();
    side = int(wheel.side);
    const auto value = [&](Method method) {
      try {
        const WheelResult found = solved(wheel, method);
        return found.converged ? of(found) : units::nan;
      } catch (const InputError&) {
        return units::nan;
      }
    };
    const double y = side * wheel.y / units::millimetre;
    data.add(y, value(Method::full), value(Method::strips), value(Method::hertz));
    points.add(y, published(wheel));
  }
}

void fig_pressure(report::Item& item) {
  over_shift(
      item, "p_MPa",
      [](const WheelResult& r) { return r.patches.front().p_max / units::megapascal; },
      [](const Wheel& w) { return w.p_max; });
}

void fig_force(report::Item& item) {
  over_shift(
      item, "fx_N", [](const WheelResult& r) { return r.force.x(); },
      [](const Wheel& w) { return w.fx; });
}

const report::Section benchmark{
    report::table("case-a",
                  "Forces and pressures of the full theory lie within two per cent of CONTACT's. "
                  "Case A2.2 of the Manchester benchmark, a row for each wheel, named by side and "
                  "shift in millimetres; of two patches the one that carries most",
                  case_a),
    report::figure("fig-pressure",
                   "The largest pressure grows several times when the flange takes over. Largest "
                   "pressure against the shift, the left wheel at negative shifts and the right at "
                   "positive ones: points by CONTACT, solid the full theory of this program, "
                   "broken its two fast methods, by strips and by Hertz's ellipse.",
                   fig_pressure),
    report::figure(
        "fig-force",
        "The full theory meets CONTACT's force along the track, and the fast methods miss it at no "
        "shift and on the flange. Force along the track against the shift, left wheel at negative "
        "shifts; points by CONTACT, solid the full theory, broken the two fast methods.",
        fig_force)};

}  // namespace

int main(int argc, char** argv) {
  return report::run(argc, argv,
                     {.id = RAILBOOK_CHAPTER,
                      .name = "wheel-on-rail",
                      .title = "Which forces act where a measured wheel meets a measured rail?",
                      .paper = "Addition beyond the papers: the Manchester contact benchmark, case "
                               "A, with CONTACT's answers.",
                      .sources = RAILBOOK_CHAPTER_DIR},
                     {opening, benchmark, against_bank, below, drawn}, {study});
}
