/*
### `track joint`

The wheel/rail force over a joint or a profile of your own. The surface is a rectified sine, by its `--dip` or by the
total `--angle` at the joint, or a measured profile: a CSV file with columns such as `distance_m,profile_mm`, dips positive, the joint at
distance zero; a raised joint is a profile too. Data that are not given are those of the typical track and marked as assumed.

    track joint --speed 60mph --dip 0.5in
    track joint --speed 100mph --angle 12mrad --wheel-load 150kN --out mine
    track joint --speed 30m/s --profile crossing.csv --duration 80ms --out mine
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/track/impact_check.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "tools.hpp"

namespace railbook::track_tool {

using namespace track;

namespace {

// One datum of the lumped model as an option: absent means the typical value.
struct Part {
  const char* option;
  const char* key;
  const char* name;
  units::Dimension dimension;
  const char* unit;
  double si;
  double RailOnBed::*member;
  tool::Range range;
};

constexpr tool::Range masses{1e-4, 1e6}, stiffnesses{1, 1e13}, dampings{0, 1e9};

const std::array<Part, 6> parts{{
    {"--rail-mass", "rail_mass_kg", "effective rail mass, (16)", units::mass, "kg", 1.0,
     &RailOnBed::rail_mass, masses},
    {"--rail-stiffness", "rail_stiffness_MN_per_m", "rail to bed K_1", units::stiffness, "MN/m",
     1e6, &RailOnBed::rail_stiffness, stiffnesses},
    {"--rail-damping", "rail_damping_kN_s_per_m", "rail to bed C_1", units::damping, "kN*s/m", 1e3,
     &RailOnBed::rail_damping, dampings},
    {"--bed-mass", "bed_mass_kg", "tie and ballast mass, (19)", units::mass, "kg", 1.0,
     &RailOnBed::bed_mass, masses},
    {"--bed-stiffness", "bed_stiffness_MN_per_m", "bed to ground K_g", units::stiffness, "MN/m",
     1e6, &RailOnBed::bed_stiffness, stiffnesses},
    {"--bed-damping", "bed_damping_kN_s_per_m", "bed to ground C_g", units::damping, "kN*s/m", 1e3,
     &RailOnBed::bed_damping, dampings},
}};

struct Options {
  double speed = 0;
  std::optional<double> dip, angle;
  std::filesystem::path profile;
  std::optional<double> rail_length;
  std::optional<double> wheel_mass, wheel_load;
  WheelOnRail pair;
  std::array<std::optional<double>, parts.size()> given;
  double duration = 0.06;
  double tolerance = 1e-8;
  tool::Destination out;
};

Surface surface_of(const Options& options) {
  const int ways =
      int(options.dip.has_value()) + int(options.angle.has_value()) + int(!options.profile.empty());
  if (ways != 1) throw InputError("surface: give one of --dip, --angle and --profile");
  if (!options.profile.empty()) {
    if (options.rail_length)
      throw InputError("rail length belongs to --dip and --angle; a profile has its own joint");
    auto columns = table::read_columns(options.profile,
                                       {{"distance", units::length}, {"profile", units::length}});
    SampledProfile profile{std::move(columns[0]), std::move(columns[1])};
    units::require_between("first distance of the profile", profile.first(), -1e4, 0, "m");
    return profile;
  }
  const double length = options.rail_length.value_or(39 * units::foot);
  return RectifiedSine{options.dip ? *options.dip : *options.angle * length / (2 * units::pi),
                       length};
}

ImpactModel model_of(const Options& options, tool::Summary& answer) {
  ImpactModel model = typical_impact();
  const auto mark = [](bool given) { return given ? "" : "assumed"; };
  model.wheel_mass = options.wheel_mass.value_or(model.wheel_mass);
  model.static_load = options.wheel_load.value_or(model.static_load);
  model.hertz_constant = hertz_constant(options.pair);
  answer.add("wheel_mass_kg", "unsprung mass on the rail", model.wheel_mass, "kg",
             mark(options.wheel_mass.has_value()));
  answer.add("wheel_load_kN", "wheel load P_0", model.static_load / units::kilonewton, "kN",
             mark(options.wheel_load.has_value()));
  answer.add("contact_stiffness_MN_per_m", "contact under P_0", contact_stiffness(model) / 1e6,
             "MN/m", "Hertz");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    double& value = model.track.*parts[i].member;
    value = options.given[i].value_or(value);
    answer.add(parts[i].key, parts[i].name, value / parts[i].si, parts[i].unit,
               mark(options.given[i].has_value()));
  }
  return model;
}

constexpr std::size_t least_samples = 10;  // to judge what lies between them

// What the distance of the samples leaves open, and a warning when it is more than 2 % of a peak.
void add_sampling(tool::Summary& answer, const CheckedImpact& checked,
                  const std::optional<SamplingSpread>& judged) {
  const auto& profile = std::get<SampledProfile>(checked.history.surface);
  const auto samples = profile.knots().size();
  answer.add(
      "profile_samples", "samples of the profile", double(samples), "",
      fmt::format("{} mm apart in the mean",
                  tool::to_text(1e3 * (profile.last() - profile.first()) / double(samples - 1))));
  if (!judged) {
    answer.warn("sampling", fmt::format("a profile of {} samples is too coarse to judge what lies "
                                        "between them; give {} or more",
                                        samples, least_samples));
    return;
  }
  const SamplingSpread& spread = *judged;
  const ImpactPeaks& p = checked.peaks;
  double worst = 0;
  const auto add = [&](const char* key, const char* what, double size, double force) {
    worst = std::max(worst, size / std::max(force, checked.history.model.static_load));
    if (!std::isfinite(size)) {
      answer.add(key, what, "not known");
      return;
    }
    answer.add_error(key, what, size / units::kilonewton, "kN",
                     spread.resolved
                         ? "from every second sample"
                         : "from every second sample, and straight lines between samples");
  };
  if (p.has_first) add("p1_sampling_kN", "sampling leaves open: P1", spread.first, p.first.force);
  add("second_sampling_kN", "  largest before 2.5 ms", spread.second, p.second.force);
  add("late_sampling_kN", "  largest after 4 ms", spread.late, p.late.force);
  add("p2_sampling_kN", "  P2", spread.mean, p.mean.force);
  if (worst > 0.02)
    answer.warn("sampling",
                fmt::format("the profile's samples are too far apart: what may lie between them "
                            "changes a peak by {}; sample it more densely, or give a joint by "
                            "--dip or --angle",
                            std::isfinite(worst) ? fmt::format("{:.2g} %", 100 * worst)
                                                 : "an unknown amount"));
}

// The tool's own warnings: tolerance and energy.
void add_checks(tool::Summary& answer, const CheckedImpact& checked) {
  if (std::isnan(checked.change)) {
    answer.warn("tolerance",
                "at a hundredth of the tolerance the run does not end within its "
                "steps: the peaks are unconfirmed");
  } else {
    answer.add_error("tolerance_change", "a hundredth of the tolerance changes peaks by",
                     checked.change, "", "relative, the largest");
    if (checked.change > 1e-3)
      answer.warn("tolerance", fmt::format("at a hundredth of the tolerance a peak changes by "
                                           "{:.2g} %: choose a smaller --tolerance",
                                           100 * checked.change));
  }
  if (checked.moves) {
    const double defect = checked.energy.defect();
    answer.add_error("energy_defect", "energy balance open by", defect, "",
                     "of the largest kinetic energy");
    if (defect > 1e-3)
      answer.warn("energy", fmt::format("the energy balance is open by {:.2g} % of the largest "
                                        "kinetic energy: motions too fast for the steps are lost; "
                                        "choose a smaller --tolerance",
                                        100 * defect));
  }
  answer.add("integrator", "integrator",
             checked.implicit ? "Radau IIA, for stiff data" : "Dormand and Prince");
  answer.add("evaluations", "evaluations of the model", double(checked.history.evaluations), "");
}

// Their error is what the samples of a measured profile leave open.
void add_peaks(tool::Summary& answer, const ImpactHistory& history, const ImpactPeaks& p,
               const std::optional<SamplingSpread>& spread) {
  const auto add = [&](const char* key, const std::string& what, const ForceExtremum& e,
                       std::optional<double> error) {
    const std::string note = fmt::format("at {} ms", tool::to_text(1e3 * e.time));
    if (error)
      answer.add(std::string(key) + "_kN", what,
                 tool::Estimate{e.force / units::kilonewton, *error / units::kilonewton}, "kN",
                 note);
    else
      answer.add(std::string(key) + "_kN", what, e.force / units::kilonewton, "kN", note);
  };
  const auto of = [&](double SamplingSpread::*member) {
    return spread ? std::optional{(*spread).*member} : std::nullopt;
  };
  if (p.has_first)
    add("p1", "P1, first local maximum", p.first, of(&SamplingSpread::first));
  else
    answer.add("p1", "P1, first local maximum", "none");
  add("second", "largest before 2.5 ms", p.second, of(&SamplingSpread::second));
  add("late", "largest after 4 ms", p.late, of(&SamplingSpread::late));
  add("p2", fmt::format("P2, largest mean over {} ms", tool::to_text(1e3 * p.mean_window)), p.mean,
      of(&SamplingSpread::mean));
  add("least", "smallest", p.least, std::nullopt);
  answer.add("contact_lost_ms", "contact lost for", 1e3 * p.lost_for, "ms",
             fmt::format("{} times", history.losses.size()));
}

void write_files(tool::OutFolder& out, const ImpactHistory& history, const tool::Summary& answer) {
  std::string text = "time_ms,force_kN,wheel_mm,rail_mm,bed_mm,surface_mm\n";
  const double begin = std::max(history.begin(), -0.005), end = history.end();
  const int steps = int(std::ceil((end - begin) / 2e-5));
  for (int i = 0; i <= steps; ++i) {
    const double t = std::min(end, begin + (end - begin) * i / steps);
    const ImpactState y = history.state(t);
    text += fmt::format("{:.6g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", 1e3 * t,
                        history.force(t) / units::kilonewton, 1e3 * y[0], 1e3 * y[2], 1e3 * y[4],
                        1e3 * surface_at(history.surface, history.speed * t).z);
  }
  out.add("joint.csv", text);
  out.add("joint.json", answer.json());
  out.figure(tools::scripts("track") / "joint.gp", {"joint.csv"}, "joint.png");
}

void run(const Options& options) {
  tool::OutFolder out(options.out, {"joint.csv", "joint.json", "joint.png"});
  const Surface surface = surface_of(options);
  tool::Summary answer("Wheel/rail force over a joint, one wheel");
  answer.add("speed_m_per_s", "speed", options.speed, "m/s",
             tool::to_text(options.speed / units::mph) + " mph");
  if (const auto* rail = std::get_if<RectifiedSine>(&surface)) {
    answer.add("dip_mm", "dip", rail->depth / units::millimetre, "mm");
    answer.add("angle_mrad", "total angle at the joint", 1e3 * rail->total_angle(), "mrad");
  }
  const ImpactModel model = model_of(options, answer);
  const Eigen::Vector3d f = natural_frequencies(model);
  answer.add(
      "frequencies_Hz", "natural frequencies, Hz",
      fmt::format("{}, {}, {}", tool::to_text(f[0]), tool::to_text(f[1]), tool::to_text(f[2])));
  const ImpactOptions settings{.tolerance = options.tolerance,
                               .start = default_start(surface),
                               .end_time = options.duration};
  const CheckedImpact checked = simulate_checked(model, surface, options.speed, settings);
  const ImpactHistory& history = checked.history;
  if (history.status != ImpactStatus::complete)
    throw InputError(fmt::format(
        "the run stopped at {:.6g} s after {} steps, {}: the run is too long or its data "
        "too stiff for the tolerance",
        history.steps.empty() ? 0.0 : history.end(), history.steps.size(),
        to_string(history.status)));
  const auto* measured = std::get_if<SampledProfile>(&history.surface);
  std::optional<SamplingSpread> spread;
  if (measured != nullptr && measured->knots().size() >= least_samples)
    spread = sampling_spread(checked, settings);
  add_peaks(answer, history, checked.peaks, spread);
  if (measured != nullptr) add_sampling(answer, checked, spread);
  add_checks(answer, checked);
  answer.print();
  if (out) write_files(out, history, answer);
  out.commit();
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  parser.quantity("--speed", options->speed, units::speed, "of the train", tool::Range{0.1, 200});
  parser.required();
  parser.quantity("--dip", options->dip, units::length, "depth of the joint, rectified sine",
                  tool::Range{0, 0.2});
  parser.quantity("--angle", options->angle, units::angle,
                  "total angle of the joint instead of its depth", tool::Range{0, 0.1});
  parser.file("--profile", options->profile,
              "measured surface, CSV with distance_m and profile_mm or other units; dips "
              "positive, joint at 0");
  parser.quantity("--rail-length", options->rail_length, units::length,
                  "between joints; without it 39 ft", tool::Range{1, 1000});
  parser.quantity("--wheel-mass", options->wheel_mass, units::mass, "unsprung, on one rail",
                  tool::Range{1, 1e5});
  parser.quantity("--wheel-load", options->wheel_load, units::force, "static, on one rail",
                  tool::Range{1e3, 1e6});
  parser.quantity("--wheel-radius", options->pair.wheel_radius, units::length, "of the wheel",
                  tool::Range{0.01, 10});
  parser.quantity("--crown-radius", options->pair.crown_radius, units::length,
                  "of the rail's crown", tool::Range{0.01, 10});
  for (std::size_t i = 0; i < parts.size(); ++i)
    parser.quantity(parts[i].option, options->given[i], parts[i].dimension,
                    std::string(parts[i].name) + "; without it the typical track's",
                    parts[i].range);
  parser.quantity("--duration", options->duration, units::time,
                  "after the joint, at least 7 ms or so", tool::Range{0, 2, true});
  parser.quantity("--tolerance", options->tolerance, units::number,
                  "local error over the static approach", tool::Range{1e-13, 1e-3});
  parser.out(options->out);
  parser.help(
      "joint.csv: time from when the wheel is at the joint; force between wheel and rail, positive "
      "as they press; wheel, rail and bed displaced from where they are under the static load, and "
      "the surface under the wheel, all positive downwards: dips are positive.");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool joint_tool() {
  return {"joint", "wheel/rail force over a joint or a profile of your own", declare};
}

}  // namespace railbook::track_tool
