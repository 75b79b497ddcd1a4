/*** ## Below the surface

Steel yields, and cracks begin, where the stress is largest, and this is usually below the surface.
The stresses below a rectangular cell of constant pressure or traction are known in closed form
(Love and Cerruti). The sum over all cells is made by Fourier transforms, layer by layer. The
stresses of one cell under pressure come from the derivatives of its potential, in `from_pressure`:

{{code: contact/subsurface.cpp from_pressure}}

{{fig-stress}}

The measure of yielding is von Mises's equivalent stress. Without friction that of a round patch is
largest, 0.62 of the largest pressure, at 0.48 of its radius below the surface. Sliding with a
friction of 0.3 makes it larger: {{third-stress}} of the largest pressure, {{third-depth}} below the
right wheel at 3 mm.

At 8 mm the flange's patch is slender and slides across itself. Its largest stress,
{{flange-stress}}, is at the surface, where a line contact has $\sqrt{(1-2\nu)^2+3\mu^2}=0.68$ with
Poisson's ratio $\nu$ of 0.28. A second maximum lies {{flange-second}} below it. The figure shows
fractions of the largest pressure, which is {{pressure-ratio}} as high at 8 mm as at 3 mm. Stresses
are those of the tractions alone, on a half-space that stays elastic.

{{fold}}
*/
#include <railbook/report/values.hpp>
#include <railbook/wheel_contact/stress.hpp>

#include "case_a.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::wheel_on_rail_chapter;

namespace {

// The largest von Mises stress at each depth under the first patch of the right wheel, with and
// without friction.
struct StressProfile {
  double pressure;  // the largest, Pa
  contact::LargestStress sliding, alone;
  // Of the second maximum, below the first six depths, m.
  double second() const {
    Eigen::Index at = 0;
    sliding.von_mises_at.tail(sliding.depths.size() - 6).maxCoeff(&at);
    return sliding.depths[at + 6];
  }
};
StressProfile stress_profile(const Wheel& wheel) {
  const WheelInput input = wish_of(wheel, Method::full);
  PatchResult p = solved(wheel, Method::full).patches.front();
  StressProfile s{p.p_max, stresses(p, input).rail, {}};
  p.friction = 0;  // the same pressure alone
  s.alone = stresses(p, input).rail;
  return s;
}

void fig_stress(report::Item& item) {
  item.added("the benchmark has no stresses");
  const table::CsvTable published = item.printed("case-a.csv");
  report::Data& data = item.data({"depth_mm", "sliding", "frictionless"});
  const StressProfile third = stress_profile(wheel_of(published, "right", 3)),
                      flange = stress_profile(wheel_of(published, "right", 8));
  for (const StressProfile* s : {&third, &flange}) {
    for (Eigen::Index k = 0; k < s->sliding.depths.size(); ++k)
      data.add(s->sliding.depths[k] / units::millimetre, s->sliding.von_mises_at[k] / s->pressure,
               s->alone.von_mises_at[k] / s->pressure);
    data.gap();
  }
  item.value("pressure-ratio", flange.pressure / third.pressure, "times", "{:.1f}");
  report::values(item, "", "{:.2f}", "third-stress", third.sliding.von_mises.value / third.pressure,
                 "flange-stress", flange.sliding.von_mises.value / flange.pressure);
  report::values(item, "mm", "{:.1f}", "third-depth",
                 third.sliding.von_mises.depth / units::millimetre, "flange-second",
                 flange.second() / units::millimetre);
}

}  // namespace

const report::Section below{report::figure("fig-stress", fig_stress)};
