/***
What the text says of the three pairs, and what ours do. The profiles were chosen for it, so none of this is a
reproduction; that one set of profiles has all the properties at once is still worth a check. "Nearly linear" is read
as within 15 percent of the tangent at the centre, in $R$ and $\Phi$; the contact angle of a worn wheel is further
off. "Several" is read as more than two.

{{geometry-claims}}

At the centre everything has a closed form. With $\delta_0$ the contact angle, $y_0$ the distance of the contact from
the middle and $k=\tan\delta_0/(y_0-r_0\tan\delta_0)$,

$$\phi_w'=k,\qquad\delta'=\frac{1+(r_0+\rho_r\cos\delta_0)\,k}{(\rho_w-\rho_r)\cos\delta_0},\qquad r'=\rho_w\sin\delta_0\;\delta',$$

per unit of displacement; $r'=\tan\delta_0\,[1+(r_0+\rho_r\cos\delta_0)k]$ for a cone, where $\delta'=0$. These are
exact. The smaller the difference of the radii, the faster the contact runs across the head: that, and not the cone,
makes worn wheels steep.

{{slopes}}

The equations of motion take the functions as tables, piecewise linear with {{step}} between knots. A table with a
cliff in it stalls Newton's method and time integration alike, so the tables of this chapter are running means over
{{average}}: the jump becomes a ramp of that width. Contact itself does not need the mean, and the tools leave it to
you (`--average`).

{{constraint-table}}

{{jumps}}

The new wheel's contact angle is largest, {{D-max-new}} in $D$, where the flange's straight face touches,
{{D-max-at-new}} off centre ({{D-max-at-cn}} for CN, {{D-max-at-heumann}} for the Heumann wheel).
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "items.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::wheelrail;
using units::inch;

namespace {

const double a = paper_track.half_spacing;

struct Slopes {
  double R, D, Phi;  // per x/a
};

Slopes computed_slopes(const WheelsetOnTrack& pair) {
  const double h = 1e-6;
  const auto at = pair.contact(h);
  return {0.5 * (at.left.radius - at.right.radius) / h,
          0.5 * (at.left.delta - at.right.delta) / h * a, at.roll / h * a};
}

Slopes closed_slopes(const WheelsetOnTrack& pair) {
  const auto at = pair.contact(0).left;
  const double y0 = -at.on_rail.u, r0 = at.radius, delta = at.delta;
  const double k = std::tan(delta) / (y0 - r0 * std::tan(delta));
  const double rail = 1 / pair.rail().curvature(at.on_rail.u);
  const double swing = 1 + (r0 + rail * std::cos(delta)) * k;
  const double hollow = pair.wheel().curvature(at.on_wheel.u);
  if (hollow == 0) return {std::tan(delta) * swing, 0, a * k};
  const double turn = swing / ((1 / hollow - rail) * std::cos(delta));
  return {std::sin(delta) / hollow * turn, a * turn, a * k};
}

void slopes(report::Item& item) {
  item.expect_checks(8);
  item.columns({"pair", "contact at", "R' exact", "R'", "D' exact", "D'", "Φ' exact", "Φ'"});
  for (const NamedPair& named : paper_pairs) {
    const Slopes c = computed_slopes(named.pair()), e = closed_slopes(named.pair());
    const auto agree = [&](const char* what, double computed, double exact) {
      item.agree(fmt::format("{}-{}", named.key, what),
                 fmt::format("{}: slope of {} at the centre", named.name, what), "", computed,
                 exact, 1e-6, "closed form");
    };
    agree("R", c.R, e.R);
    if (e.D != 0) agree("D", c.D, e.D);
    agree("Phi", c.Phi, e.Phi);
    const double y0 = -named.pair().contact(0).left.on_rail.u;
    item.add_row({named.name, fmt::format("{:.4f} in", y0 / inch), fmt::format("{:.6f}", e.R),
                  fmt::format("{:.6f}", c.R), fmt::format("{:.5f}", e.D),
                  fmt::format("{:.5f}", std::abs(c.D) < 1e-6 ? 0.0 : c.D),
                  fmt::format("{:.6f}", e.Phi), fmt::format("{:.6f}", c.Phi)});
  }
}

// The largest departure of a function from its tangent at 0 for 0 < x < end, as a part of the tangent's value at the
// end.
double bend(const OddTable& f, double end) {
  double worst = 0;
  const double slope = f.slope(0);
  for (double x = 0; x < end; x += f.step()) worst = std::max(worst, std::abs(f(x) - slope * x));
  return slope == 0 ? worst : worst / (slope * end);
}

double largest_jump(const WheelsetOnTrack& pair) {
  double largest = 0;
  for (const auto& jump : contact_jumps(pair, 0, 0.75 * inch, 1e-4))
    largest = std::max(largest, std::abs(jump.after.delta - jump.before.delta));
  return largest;
}

void geometry_claims(report::Item& item) {
  const table::CsvTable printed = item.printed("geometry_claims.csv");
  item.expect_checks(8);
  item.columns({"claim", "paper", "here"});
  const auto claim = [&](const char* key, bool holds, const std::string& here) {
    const std::string& says = printed.at(key, "printed");
    item.check_text(key, printed.at(key, "what"), says, holds ? says : "not " + says);
    item.add_row({printed.at(key, "what"), says, here});
  };
  const Slopes fresh = computed_slopes(new_wheel_pair()), cn = computed_slopes(cn_pair()),
               heumann = computed_slopes(heumann_pair());
  const auto straight = [&](const char* key, const ConstraintFunctions& f, double until) {
    const double worst = std::max(bend(f.R, until), bend(f.Phi, until));
    claim(key, worst < 0.15,
          fmt::format("R and Φ within {:.1f} %, D within {:.1f} %, up to {:.2f} in", 100 * worst,
                      100 * bend(f.D, until), until / inch));
  };
  straight("new-straight", new_wheel_table(), 0.39 * inch);
  straight("cn-straight", cn_table(), 0.36 * inch);
  item.check("cn-slope", printed.at("cn-slope", "what"), "", printed.at("cn-slope", "printed"),
             cn.R / fresh.R, report::relative(0.05, "\"about\"; the profile was chosen for it"));
  item.add_row({printed.at("cn-slope", "what"), printed.at("cn-slope", "printed"),
                fmt::format("{:.4f} in R", cn.R / fresh.R)});
  const auto times = [](double ratio) { return fmt::format("{:.2f} times", ratio); };
  claim("cn-roll", cn.Phi < fresh.Phi, times(cn.Phi / fresh.Phi));
  claim("heumann-R", heumann.R > 2 * fresh.R, times(heumann.R / fresh.R));
  claim("heumann-D", heumann.D > 2 * fresh.D, fmt::format("{:.2f} against 0", heumann.D));
  claim("heumann-Phi", heumann.Phi > 2 * fresh.Phi, times(heumann.Phi / fresh.Phi));
  const double small = largest_jump(heumann_pair()), large = largest_jump(new_wheel_pair());
  claim("heumann-single", small < 0.1 * large,
        fmt::format("jumps {:.3f} rad, the new wheel {:.3f} rad", small, large));
  item.reconstructed("the profiles are chosen to have these properties");
}

void constraint_table(report::Item& item) {
  item.columns(
      {"x, in", "pair", "r_L, in", "r_R, in", "δ_L, rad", "δ_R, rad", "R", "D, rad", "Φ, rad"});
  for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7})
    for (const NamedPair& named : paper_pairs) {
      const ConstraintFunctions& f = named.table();
      const auto value = f.at(x * inch);
      const std::size_t middle = f.r_left.size() / 2;
      const auto k = std::size_t(std::llround(x * inch / f.R.step()));
      item.add_row({fmt::format("{:.1f}", x), named.name,
                    fmt::format("{:.4f}", f.r_left[middle + k] / inch),
                    fmt::format("{:.4f}", f.r_left[middle - k] / inch),
                    fmt::format("{:.5f}", f.delta_left[middle + k]),
                    fmt::format("{:.5f}", f.delta_left[middle - k]), fmt::format("{:.6f}", value.R),
                    fmt::format("{:.6f}", value.D), fmt::format("{:.6f}", value.Phi)});
    }
  item.value("step", new_wheel_table().R.step() / inch, "in", "{:.4f}");
  item.value("average", 0.02, "in", "{:.2f}");
  item.reconstructed("from reconstructed profiles");
  for (const NamedPair& named : paper_pairs) {
    double most = 0, at = 0;
    for (int i = 0; i <= 3000; ++i) {
      const double x = 0.75 * inch * i / 3000;
      const auto c = named.pair().contact(x);
      const double D = 0.5 * (c.left.delta - c.right.delta);
      if (D > most) most = D, at = x;
    }
    item.value(fmt::format("D-max-{}", named.key), most, "rad", "{:.4f}");
    item.value(fmt::format("D-max-at-{}", named.key), at / inch, "in", "{:.3f}");
  }
}

void jumps(report::Item& item) {
  item.columns({"pair", "x, in", "δ_L, rad", "r_L, in", "contact on the wheel moves by, in"});
  for (const NamedPair& named : paper_pairs)
    for (const auto& jump : contact_jumps(named.pair(), -0.75 * inch, 0.75 * inch, 1e-4))
      item.add_row(
          {named.name, fmt::format("{:.6f}", jump.x / inch),
           fmt::format("{:.4f} → {:.4f}", jump.before.delta, jump.after.delta),
           fmt::format("{:.4f} → {:.4f}", jump.before.radius / inch, jump.after.radius / inch),
           fmt::format("{:.4f}", std::hypot(jump.after.on_wheel.u - jump.before.on_wheel.u,
                                            jump.after.on_wheel.z - jump.before.on_wheel.z) /
                                     inch)});
  item.reconstructed("from reconstructed profiles; the paper gives no place");
}

}  // namespace

void hunting_chapter::add_constraint_table(report::Chapter& chapter) {
  chapter.table("geometry-claims", "What the text says of the three pairs", geometry_claims);
  chapter.table("slopes", "Slopes of the constraint functions at the centre, per x/a", slopes);
  chapter.table("constraint-table", "Constraint functions, running mean over 0.02 in",
                constraint_table);
  chapter.table("jumps", "Two-point contact of the left wheel", jumps);
}
