// Chapter 7: a wheel over a dipped joint, and the track under a moving load.
#include <array>
#include <cmath>

#include <railbook/track/impact.hpp>
#include <railbook/track/impact_peaks.hpp>
#include <railbook/track/moving_load.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "live.hpp"

namespace railbook::live {
namespace {

using namespace track;
using units::foot, units::inch;

void joint(const Inputs& in, Answer& out) {
  ImpactModel model = typical_impact();
  model.wheel_mass = in["wheel_mass"];
  model.static_load = in["load"];
  RailOnBed& t = model.track;
  t.rail_stiffness *= in["pad"];
  t.bed_stiffness *= in["bed"];
  t.rail_damping = 2 * in["pad_damping"] * std::sqrt(t.rail_stiffness * t.rail_mass);
  t.bed_damping = 2 * in["bed_damping"] * std::sqrt(t.bed_stiffness * t.bed_mass);
  const RectifiedSine rail{in["dip"], in["rail_length"]};
  const double speed = in["speed"], end = in["end"];
  const ImpactHistory h =
      simulate(model, rail, speed, {.start = default_start(rail), .end_time = end});
  const ImpactPeaks p = impact_peaks(h);
  out.value("complete", h.status == ImpactStatus::complete ? 1 : 0);
  out.value("static", model.static_load);
  out.value("p1", p.has_first ? p.first.force : units::nan);
  out.value("p1_time", p.has_first ? p.first.time : units::nan);
  out.value("p2", p.mean.force);
  out.value("p2_time", p.mean.time);
  out.value("least", p.least.force);
  out.value("lost", p.lost_for);
  const Eigen::Vector3d frequencies = natural_frequencies(model);
  out.value("frequency_1", frequencies[0]);
  out.value("frequency_2", frequencies[1]);
  out.value("frequency_3", frequencies[2]);
  out.table("passage", {"t", "force", "wheel", "rail", "bed", "surface"});
  const int points = in.whole("points");
  const double from = std::max(h.begin(), in["from"]);
  for (int i = 0; i <= points; ++i) {
    const double at = std::min(std::lerp(from, end, static_cast<double>(i) / points), h.end());
    const ImpactState s = h.state(at);
    out.row({at, h.force(at), s[0], s[2], s[4], surface_at(h.surface, speed * at).z});
  }
}

// Lengths in units of 1/beta, deflections in those of the static one at rest, P beta/2K.
void dent(const Inputs& in, Answer& out) {
  const MovingLoadShape shape = moving_load(in["theta"], in["zeta"]);
  out.value("at_load", shape.at_load());
  out.value("deepest", shape.maximum().y);
  out.value("deepest_at", shape.maximum().s);
  out.value("highest", shape.minimum().y);
  out.table("dent", {"s", "y"});
  const int points = in.whole("points");
  for (int i = 0; i <= points; ++i) {
    const double s = in["reach"] * (2.0 * i / points - 1);
    out.row({s, shape.deflection(s)});
  }
}

}  // namespace

std::span<const Function> track_functions() {
  static const std::array<Function, 2> all{
      {{"joint",
        nullptr,
        {{"speed", "m/s", 60 * units::mph, 2, 60},
         {"dip", "m", 0.3 * inch, 0, 0.02},
         {"wheel_mass", "kg", typical_wheel_mass, 50, 3000},
         {"load", "N", typical_wheel_load, 5e3, 300e3},
         {"pad", "", 1, 0.05, 20},  // times the typical stiffness
         {"bed", "", 1, 0.05, 20},
         {"pad_damping", "", 0.05, 0, 2},  // shares of the critical
         {"bed_damping", "", 0.2, 0, 2},
         {"rail_length", "m", 39 * foot, 5, 100},
         {"from", "s", -0.002, -0.1, 0},
         {"end", "s", 0.03, 0.02, 0.2},
         {"points", "", 400, 10, 4000}},
        joint},
       {"dent",
        nullptr,
        {{"theta", "", 0.5, 0, 3},
         {"zeta", "", 0.1, 0, 3},
         {"reach", "", 12, 1, 100},
         {"points", "", 240, 10, 2000}},
        dent}}};
  return all;
}

}  // namespace railbook::live
