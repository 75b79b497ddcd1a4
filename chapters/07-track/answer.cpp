/***
Move the speed and the dip below {{fig-joint}}: the same passage, computed for each. What P1 adds to
the static load is nearly in proportion to the product of the two.
*/
#include <railbook/report/answer.hpp>
#include <railbook/track/impact.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/wheel_on_track.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

void joint_answer(report::Item& item) {
  constexpr double kN = units::kilonewton;
  report::Answer answer{item,
                        {"speed_mph", "dip_in"},
                        {{"wheel on rail", "time, ms", "force, kN", -2, 16, 0, 300},
                         {.name = "peaks", .kind = "says"}}};
  const ImpactModel model = typical_impact();
  for (const double mph : {20., 40., 60., 80., 100., 120.}) {
    for (const double inches : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
      const RectifiedSine rail{inches * units::inch, 39 * units::foot};
      const ImpactHistory h =
          simulate(model, rail, mph * units::mph, {.start = default_start(rail), .end_time = 0.03});
      const ImpactPeaks p = impact_peaks(h);
      answer.at({mph, inches});
      for (int i = 0; i <= 400; ++i) {
        const double t = 1e-3 * (-2 + 18 * i / 400.0);
        answer.point("wheel on rail", "", 1e3 * t, h.force(t) / kN);
      }
      answer.point("wheel on rail", "P1", 1e3 * p.first.time, p.first.force / kN);
      answer.point("wheel on rail", "P2", 1e3 * p.mean.time, p.mean.force / kN);
      answer.says("peaks", "static load, kN", model.static_load / kN);
      answer.says("peaks", "P1, kN", p.first.force / kN);
      answer.says("peaks", "P2, kN", p.mean.force / kN);
      answer.says("peaks", "without contact, ms", 1e3 * p.lost_for);
    }
  }
}

}  // namespace railbook::track_chapter
