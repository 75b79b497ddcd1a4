/*** ## Below the surface

Steel yields, and cracks begin, where the stress is largest, which is rarely where the tractions are. A
rectangular cell of constant pressure or traction has stresses in closed form (by Love and Cerruti).
`from_pressure` makes those of a pressure from the derivatives of the cell's potential. Layer by layer they
are then convolved with all cells by Fourier transforms:

{{code: contact/subsurface.cpp from_pressure}}

{{fig-stress}}

The measure of yielding is von Mises's equivalent stress. Without friction that of a round patch is
largest, 0.62 of the largest pressure, at 0.48 of its radius. Sliding with a friction of 0.3 lifts it and
brings it up, to {{third-stress}} of the largest pressure and {{third-depth}} below the right wheel at
3 mm.

At 8 mm the flange's patch is slender and slides across itself. Its largest stress, {{flange-stress}}, is
at the surface, where a line contact has $\sqrt{(1-2\nu)^2+3\mu^2}=0.68$ with Poisson's ratio $\nu$ of
0.28. A second one lies {{flange-second}} below it. Both are fractions of a pressure almost four times as
high. Stresses are those of the tractions alone, on a half-space that stays elastic.

{{fold}}
*/
#include <railbook/wheel_contact/stress.hpp>

#include "case_a.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::wheel_on_rail_chapter;

namespace {

void fig_stress(report::Item& item) {
  item.added("stresses are not in the benchmark");
  static const table::CsvTable published = item.printed("case-a.csv");
  report::Data& data = item.data({"depth_mm", "sliding", "frictionless"});
  for (const auto& [shift, name] : {std::pair{3, "third"}, {8, "flange"}}) {
    const Wheel wheel = wheel_of(published, "right", shift);
    const WheelInput input = wish_of(wheel, Method::full);
    PatchResult p = solved(wheel, Method::full).patches.front();
    const contact::LargestStress sliding = stresses(p, input).rail;
    p.friction = 0;  // the same pressure alone
    const contact::LargestStress alone = stresses(p, input).rail;
    for (Eigen::Index k = 0; k < sliding.depths.size(); ++k)
      data.add(sliding.depths[k] / units::millimetre, sliding.von_mises_at[k] / p.p_max,
               alone.von_mises_at[k] / p.p_max);
    data.gap();
    const std::string key = name;
    item.value(key + "-stress", sliding.von_mises.value / p.p_max, "", "{:.2f}");
    item.value(key + "-depth", sliding.von_mises.depth / units::millimetre, "mm", "{:.1f}");
    Eigen::Index second = 0;
    sliding.von_mises_at.tail(sliding.depths.size() - 6).maxCoeff(&second);
    item.value(key + "-second", sliding.depths[second + 6] / units::millimetre, "mm", "{:.1f}");
  }
}

}  // namespace

const report::Section below{
    report::figure("fig-stress",
                   "Sliding raises the largest stress, on the flange up to the surface. Largest "
                   "von Mises stress in the rail at each depth over the largest pressure, right "
                   "wheel at 3 mm on the tread and at 8 mm on the flange; dashed the same pressure "
                   "without friction. By this program; the benchmark has no stresses.",
                   fig_stress)};
