#include "hunting/cycle_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/tool/digits.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::hunting_tool {

using namespace cycles;
using namespace vehicle;

namespace {

constexpr double millimetre = units::millimetre;

}  // namespace

double largest_of(const std::array<double, wheelsets>& values) {
  return *std::max_element(values.begin(), values.end());
}

std::string stability_text(const LimitCycle& c) {
  if (c.neutral) return "neutral: one of many at this speed";
  return c.stable ? "stable" : fmt::format("unstable, {} multipliers outside", c.unstable);
}

void add_cycle(tool::Summary& answer, const std::string& id, const LimitCycle& c,
               const CycleError& error, const CarCase& car,
               const std::optional<CreepLimit>& creep) {
  answer.add(id + "_mm", "  largest amplitude",
             tool::Estimate{c.largest / millimetre, error.amplitude / millimetre}, "mm");
  static constexpr std::array names{"front leading", "front trailing", "rear leading",
                                    "rear trailing"};
  for (std::size_t k = 0; k < wheelsets; ++k)
    answer.add(fmt::format("{}_wheelset_{}_mm", id, k + 1), fmt::format("    {}", names[k]),
               tool::Estimate{c.amplitude[k] / millimetre, error.amplitude / millimetre}, "mm");
  if (!car.table.symmetric())
    answer.add(id + "_middle_mm", "  about", c.middle[0] / millimetre, "mm",
               fmt::format("to the left of the centre; {}, {}, {} mm the others",
                           tool::to_text(c.middle[1] / millimetre),
                           tool::to_text(c.middle[2] / millimetre),
                           tool::to_text(c.middle[3] / millimetre)));
  if (creep) {
    const CycleForces f = cycle_forces(car.car.car(), car.table, *creep, c.cycle);
    answer.add(id + "_L_over_V", "  largest L/V of a wheel", largest_of(f.lateral_over_vertical),
               "",
               fmt::format("{:.3f}, {:.3f}, {:.3f}, {:.3f}; static wheel load",
                           f.lateral_over_vertical[0], f.lateral_over_vertical[1],
                           f.lateral_over_vertical[2], f.lateral_over_vertical[3]));
    answer.add(id + "_creep", "  largest creep force", largest_of(f.creep), "of mu N",
               fmt::format("{:.3f}, {:.3f}, {:.3f}, {:.3f}", f.creep[0], f.creep[1], f.creep[2],
                           f.creep[3]));
  }
  answer.add(id + "_rad_per_s", "  frequency", tool::Estimate{c.cycle.omega, error.omega}, "rad/s");
  answer.add(id + "_multiplier", "  largest Floquet multiplier",
             tool::Estimate{c.leading, error.leading}, "", stability_text(c));
  if (!c.neutral && std::abs(c.leading - 1) < error.leading)
    answer.warn(id + "_stability",
                fmt::format("{}: its largest Floquet multiplier is 1 within its error, and whether "
                            "it is stable is not certain (a smaller --tail may tell)",
                            id));
}

void add_special(tool::Summary& answer, const Family& family, const NamedBranch& named,
                 const ContinuationOptions& walk) {
  for (std::size_t k = 0; k < named.branch.special.size(); ++k) {
    const SpecialCycle& s = named.branch.special[k];
    const std::string id = fmt::format("{}_special_{}", named.key, k + 1);
    const SpecialError error =
        s.located ? special_error(family, named.branch, s, walk) : SpecialError{};
    // Only from the first branch are others followed, and only to less symmetry or twice the
    // period.
    const bool leaves = s.kind == CycleEvent::branch_point ||
                        s.kind == CycleEvent::symmetry_breaking ||
                        s.kind == CycleEvent::period_doubling;
    const bool followed = named.key == "branch" && s.kind != CycleEvent::branch_point;
    answer.add(
        id + "_m_per_s", fmt::format("{}: {}", named.name, to_string(s.kind)),
        tool::Estimate{s.at.parameter, error.parameter}, "m/s",
        fmt::format("{} ft/s{}{}",
                    tool::to_digits_of(s.at.parameter / units::foot, error.parameter / units::foot),
                    s.located ? "" : ", not located closely",
                    leaves && !followed ? "; the branch that leaves here is not followed" : ""));
    answer.add(id + "_mm", "  largest amplitude",
               tool::Estimate{s.at.largest / millimetre, error.largest / millimetre}, "mm");
    answer.add(id + "_rad_per_s", "  frequency", tool::Estimate{s.at.cycle.omega, error.omega},
               "rad/s");
  }
}

void add_extent(tool::Summary& answer, const NamedBranch& named) {
  const auto& points = named.branch.points;
  double slow = 1e300, fast = 0, small = 1e300, large = 0;
  for (const LimitCycle& p : points) {
    slow = std::min(slow, p.parameter);
    fast = std::max(fast, p.parameter);
    small = std::min(small, p.largest);
    large = std::max(large, p.largest);
  }
  answer.add(named.key + "_points", named.name + ": points", static_cast<double>(points.size()), "",
             to_string(named.branch.stop));
  answer.add(named.key + "_extent", "  searched",
             fmt::format("{} to {} m/s, {} to {} mm", tool::to_text(slow), tool::to_text(fast),
                         tool::to_text(small / millimetre), tool::to_text(large / millimetre)));
  if (std::ranges::all_of(points, &LimitCycle::neutral))
    answer.add(named.key + "_stability", "  stability", stability_text(points.front()));
}

}  // namespace railbook::hunting_tool
