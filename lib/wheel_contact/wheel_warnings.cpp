// What a user should know of a wheel's contact beside its numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <railbook/units/constants.hpp>
#include <railbook/wheel_contact/detail/full_wheel.hpp>

namespace railbook::wheel_contact {
namespace {

// How much less the smaller of two patches would carry if both pressed on one half-space, over its
// load: each sinks in by the other's load over pi E* distance, and the wheel comes down until both
// bear what they did together. Loads grow as approach^(3/2).
double neighbour_effect(const Work& w, const PatchResult& large, const PatchResult& small) {
  const double distance = (large.patch.frame.origin - small.patch.frame.origin).norm();
  const double sinking = (large.load - small.load) /
                         (units::pi * w.material.effective_modulus * distance) *
                         std::cos(large.patch.frame.angle - small.patch.frame.angle);
  const double a = 1.5 * large.load / large.approach, b = 1.5 * small.load / small.approach;
  return std::max(0.0, a * b / (a + b) * sinking / small.load);
}

// A wheel that climbs on its flange, or has climbed: beyond the flange's steepest place, where the
// angle is less by more than what a profile's points leave open.
void warn_of_climbing(const Work& w, WheelResult& out) {
  constexpr double least_flange = 45 * units::degree, sure = 3 * units::degree;
  const profiles::Profile& profile = w.wheel.pair->wheel;
  const double flange = flange_angle(profile);
  if (out.patches.empty() || flange < least_flange) return;
  const double mu = w.input.friction.flange.value_or(w.input.friction.coefficient);
  const double limit = nadal_limit(flange, mu), ratio = out.force.y() / out.force.z();
  const Frame& frame = out.patches.front().patch.frame;
  const double s = w.touch.least.front().s;
  if (s < flange_place(profile) && -frame.angle < flange - sure)
    out.warnings.push_back(
        {"climbed",
         fmt::format(
             "climbed: the wheel stands at {:.0f} degrees on its flange, beyond the steepest "
             "place, {:.1f} mm above where it stands on its tread",
             std::abs(frame.angle) / units::degree,
             -(out.z + w.wheel.pose.roll * w.wheel.pair->half_spacing) / units::millimetre)});
  if (ratio > limit)
    out.warnings.push_back(
        {"nadal",
         fmt::format("Y/Q of {:.3g} is above Nadal's limit of {:.3g}: the flange may climb", ratio,
                     limit)});
}

}  // namespace

void add_warnings(const Work& w, WheelResult& out) {
  warn_of_climbing(w, out);
  const auto warn = [&](const char* key, std::string text) {
    out.warnings.push_back({key, std::move(text)});
  };
  for (const PlacedWheel::Point& p : w.touch.least) {
    const double clear = p.gap - out.z;
    if (clear > 0 && clear < 0.5 * (out.z - out.z_touch))
      warn("verge",
           fmt::format(
               "verge of a second contact: at {:.2f} mm across the wheel only {:.1f} um clear",
               p.s / units::millimetre, clear / units::micrometre));
  }
  const double unlike = w.material.dissimilarity;
  if (std::abs(unlike) > 0.02)
    warn("unlike", fmt::format("unlike materials (K = {:.3f}): {}", unlike,
                               w.input.method == Method::full
                                   ? "what their tractions do to the pressure is left out"
                                   : "left out by this method; take the full theory"));
  for (const PatchResult& p : out.patches) {
    if (out.patches.size() > 1 && p.load < 0.1 * out.patches.front().load)
      warn("verge",
           fmt::format("verge of a second contact: a patch carries only {:.0f} N", p.load));
    const double effect =
        &p == &out.patches.front() ? 0 : neighbour_effect(w, out.patches.front(), p);
    if (effect > 0.02)
      warn("neighbour",
           fmt::format("patches apart are half-spaces of their own: on one, the patch of {:.0f} N "
                       "would carry about "
                       "{:.0f} % less, and the largest one that much more",
                       p.load, std::min(100.0, 100 * effect)));
    const contact::Box& box = p.patch.overlap;  // sqrt(2) as large as the contact
    const double width = (box.y_max - box.y_min) / std::sqrt(2.0),
                 length = (box.x_max - box.x_min) / std::sqrt(2.0);
    const double head = w.wheel.pair->rail.to() - w.wheel.pair->rail.from();
    if (width > 0.3 * head || length > 0.4 * p.patch.radius)
      warn("half_space",
           fmt::format("half-space: the contact is {:.0f} mm wide and {:.0f} mm long, the rail's "
                       "profile {:.0f} mm "
                       "wide, the wheel's radius {:.0f} mm: too large for half-spaces",
                       width / units::millimetre, length / units::millimetre,
                       head / units::millimetre, p.patch.radius / units::millimetre));
    if (p.strips.two_lobes && w.input.method != Method::full)
      warn("two_areas",
           "two areas of overlap in one patch: rough by this method; take the full theory");
    if (p.patch.merged)
      warn("shared_frame", "two areas of overlap are near one another and share one frame");
    if (p.patch.at_end)
      warn("off_profile",
           "off the profile: the overlap reaches an end of one, beyond which no body is taken");
    if (p.patch.turn > 0.35)
      warn("conformal",
           fmt::format(
               "conformal: the rail turns by {:.2f} rad over the patch, whose frame is plane",
               p.patch.turn));
    if (!p.forces.warning.empty()) warn("theory_range", std::string(p.forces.warning));
    if (p.p_max_error > 0.02 && std::isfinite(p.p_max_error))
      warn("coarse",
           fmt::format("coarse: the peak pressure may be off by {:.1f} %", 100 * p.p_max_error));
  }
}

}  // namespace railbook::wheel_contact
