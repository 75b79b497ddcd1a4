/*
### `filters process`: your own record

    filters process sensors.csv --config car.toml --out mine

takes one row a foot, in the order of time: `elapsed_s` since the row before, `distance_m` (or `_ft`; left out, each row is a foot further), and the
sensors, each with its unit (`vertical_left_m_per_s2`, `yaw_rate_deg_per_s`, `gage_left_mm`). A sensor that is not there is missing throughout, and so is what
depends on it. The car is described by `car.toml`; an example stands in the chapter's folder `examples`. It answers with gage, curvature, crosslevel, warp, profile and
alignment of both rails at each mark, as long chords and as space curves, and says for each how far it can be trusted: *good*, *degraded* or
*unreliable* by the slowest speed in its window and the paper's limits, profile also where the car brakes or gathers speed so hard that a grade may spoil it, *missing* where the window is not complete or the roll filter has not settled.

A row whose time is zero, negative, missing or shorter than any train allows is an encoder's glitch and is rejected. A jump of the distance begins a new run, and so does a
reversal: marks then count down, and what was measured twice appears twice. A stop is a long time between two rows, nothing else. Empty cells, `nan`, and
values beyond a sensor's range (`--acceleration-range` and so on) and single spikes of a displacement (`--spike`) are masked, together with everything whose
window they fall in; columns it has no use for are named. Without a single run long enough for the composite
filter, or without a parameter that can be measured at all, there is nothing to answer, and the record is refused.

Then the sensors are tried against themselves and against each other. A channel that stands still, jumps or loses its zero, a gage that no track has, a clock or
a distance that stops or leaps; a gain, a unit or a sign that the other sensors contradict: each is a doubt printed above the answer and kept under `flags` in
the JSON, what is certainly wrong is masked, and no row that rests on a doubt is *good*.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/car_options.hpp"
#include "filters/sensor_file.hpp"
#include "geometry_car/health.hpp"
#include "geometry_car/reconstruct.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tool/summary.hpp"
#include "tools.hpp"
#include "units/constants.hpp"

namespace railbook::filters_tool {

using namespace geometry_car;
using units::foot;
using units::mph;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Wish {
  std::filesystem::path file;
  Processing processing;
  Plausible plausible;
  double chord = 62 * foot, yaw_bias = 0, roll_bias = 0;
  long high_pass = 151, passes = 4, stages = 1, poles = 2, curvature_mean = 51;
  tool::Destination out;
};

const char* word(Quality q) {
  switch (q) {
    case Quality::good:
      return "good";
    case Quality::degraded:
      return "degraded";
    case Quality::unreliable:
      return "unreliable";
    case Quality::missing:
      return "missing";
  }
  return "";
}

struct Answer {
  Measurement m;
  std::vector<std::vector<Quality>> quality;  // [parameter][row]
  double first = 0;                           // m, of mark 0
};

std::string table(const Answer& a, const Processing& p, std::size_t every) {
  std::string text = "distance_m,speed_mph";
  for (const ParameterInfo& info : parameter_list())
    text += fmt::format(",{}_{}", info.name, info.unit);
  for (const ParameterInfo& info : parameter_list()) text += fmt::format(",{}_is", info.name);
  text += "\n";
  for (std::size_t i = 0; i < a.m.size(); i += every) {
    text += fmt::format("{:.9g},{}", a.first + static_cast<double>(a.m.mark[i]) * p.layout.sample,
                        table::csv_number(a.m.speed[i] / mph));
    for (const ParameterInfo& info : parameter_list()) {
      const double value = a.m[info.parameter][i] / info.si;
      text += std::isnan(value) ? std::string(",nan") : fmt::format(",{:.6g}", value);
    }
    for (std::size_t q = 0; q < parameters; ++q) text += fmt::format(",{}", word(a.quality[q][i]));
    text += "\n";
  }
  return text;
}

void add_parameters(tool::Summary& s, const Answer& a) {
  for (const ParameterInfo& info : parameter_list()) {
    if (info.parameter == Parameter::surface_left) break;  // space curves are in the table only
    const auto& q = a.quality[static_cast<std::size_t>(info.parameter)];
    const auto share = [&](Quality which) {
      return 100.0 * static_cast<double>(std::count(q.begin(), q.end(), which)) /
             static_cast<double>(q.size());
    };
    double sum = 0, square = 0;
    int n = 0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (q[i] != Quality::good) continue;
      const double v = a.m[info.parameter][i] / info.si;
      sum += v;
      square += v * v;
      ++n;
    }
    const double mean = n > 0 ? sum / n : nan;
    const double rms = n > 0 ? std::sqrt(std::max(0.0, square / n - mean * mean)) : nan;
    const std::string name{info.name},
        note = fmt::format("good {:.1f} %, degraded {:.1f}, unreliable {:.1f}, missing {:.1f}",
                           share(Quality::good), share(Quality::degraded),
                           share(Quality::unreliable), share(Quality::missing));
    std::string unit{info.unit};
    std::replace(unit.begin(), unit.end(), '_', ' ');
    if (n > 0) {
      s.add(name + "_mean", name + ", mean where good", mean, unit, note);
      s.add(name + "_deviation", "  standard deviation", rms, unit);
    } else {
      s.absent(name + "_mean", name + ", mean where good", "nowhere good");
      s.add(name + "_note", "  note", note);
    }
    s.add(name + "_good_percent", "  share that is good", share(Quality::good), "%");
  }
}

// The findings of each kind and place in one line.
void add_flags(tool::Summary& s, const Health& health, const Faults& faults) {
  std::vector<std::string> contradicted;
  for (const Finding& f : health.findings) {
    if (f.fault == Fault::inconsistent && f.size == 0)
      contradicted.push_back(f.what);
    else if (f.fault != Fault::dead ||
             std::find(faults.absent.begin(), faults.absent.end(), f.what) == faults.absent.end())
      s.flag(fmt::format("{}-{}", f.what, name_of(f.fault)), fmt::format("{}: {}", f.what, f.text));
  }
  if (!contradicted.empty())
    s.flag("sensors-inconsistent",
           fmt::format("these sensors contradict each other: {}", fmt::join(contradicted, ", ")));
  if (faults.beyond > 0)
    s.flag("beyond", fmt::format("{} values beyond what a sensor can give, masked", faults.beyond));
  if (faults.spikes > 0)
    s.flag("spikes", fmt::format("{} spikes of displacements, masked", faults.spikes));
  for (const std::string& name : faults.beyond_in)
    s.flag(name + "-range",
           fmt::format("{}: more than 1 % of its values are beyond what the sensor can give; "
                       "is its unit that of its header?",
                       name));
}

tool::Summary summary(const Wish& wish, const Answer& a, const Health& health,
                      const Faults& faults) {
  tool::Summary s{"geometry of " + wish.file.string()};
  add_flags(s, health, faults);
  double slow = units::no_limit, fast = 0;
  for (const double v : a.m.speed) {
    if (std::isnan(v)) continue;
    slow = std::min(slow, std::abs(v));
    fast = std::max(fast, std::abs(v));
  }
  s.add("rows", "rows", static_cast<double>(a.m.size()), "");
  s.add("rejected", "  of them rejected", static_cast<double>(a.m.rejected), "",
        "time zero, negative, missing or too short");
  s.add("runs", "runs without a gap or a turn", static_cast<double>(a.m.runs), "");
  s.add("slowest_mph", "slowest foot", slow / mph, "mph");
  s.add("fastest_mph", "fastest foot", fast / mph, "mph");
  add_parameters(s, a);
  if (!faults.absent.empty())
    s.add("absent", "note", fmt::format("not in the file: {}", fmt::join(faults.absent, ", ")));
  if (!faults.unused.empty())
    s.add("unused", "note", fmt::format("columns not used: {}", fmt::join(faults.unused, ", ")));
  if (slow < 0.1 * mph)
    s.add("stop", "note", "the car stopped; what has the stop in its window is not reliable");
  return s;
}

void write_files(tool::OutFolder& out, const Wish& wish, const Answer& a, const tool::Summary& s) {
  out.add("geometry.csv", table(a, wish.processing, 1));
  out.add("geometry.json", s.json());
  const std::size_t every = a.m.size() / 20000 + 1;
  out.scratch("thin.csv", table(a, wish.processing, every));
  out.figure(tools::scripts("filters") / "process.gp", {"thin.csv"}, "geometry.png");
}

void refuse_nothing(const Wish& wish, const Answer& a, const Health& health) {
  for (const auto& rows : a.quality)
    for (const Quality q : rows)
      if (q != Quality::missing) return;
  std::vector<std::string> why;
  for (const Finding& f : health.findings)
    if (why.size() < 5) why.push_back(fmt::format("{} {}", f.what, f.text));
  throw InputError{
      fmt::format("file \"{}\": nothing can be measured ({}); allowed: working sensors of at least "
                  "one parameter",
                  wish.file.string(), fmt::join(why, "; "))};
}

void process_record(Wish wish) {
  tool::OutFolder out(wish.out, {"geometry.csv", "geometry.json", "geometry.png"});
  Processing& p = wish.processing;
  const double half = 0.5 * wish.chord / p.layout.sample;
  if (std::abs(half - std::round(half)) > 1e-6 || half < 0.5)
    throw InputError{fmt::format(
        "chord is {:.6g} m, {:.6g} samples of {:.6g} m; allowed: an even number of them",
        wish.chord, 2 * half, p.layout.sample)};
  p.chain.half_chord = static_cast<int>(std::lround(half));
  p.chain.high_pass = {static_cast<int>(wish.high_pass), static_cast<int>(wish.passes),
                       static_cast<int>(wish.stages)};
  p.roll_poles = static_cast<int>(wish.poles);
  p.curvature_mean = static_cast<int>(wish.curvature_mean);
  Faults faults;
  Answer a;
  Record record = read_sensors(wish.file, p.layout.sample, wish.plausible, faults, a.first);
  for (double& v : record[Channel::yaw_rate]) v -= wish.yaw_bias;
  for (double& v : record[Channel::roll_rate]) v -= wish.roll_bias;
  const Health health = examine(record, p);
  a.m = reconstruct(record, p);
  for (const ParameterInfo& info : parameter_list())
    a.quality.push_back(quality(a.m, info.parameter, p, health));
  refuse_nothing(wish, a, health);
  const tool::Summary s = summary(wish, a, health, faults);
  s.print();
  if (out) write_files(out, wish, a, s);
  out.commit();
}

}  // namespace

void add_layout(tool::Options& o, Layout& l) {
  const tool::Range lengths{0, 100, true}, corners{1e-3, 1e3};
  o.quantity("--sample", l.sample, units::length, "distance between two samples",
             tool::Range{0.01, 10});
  o.quantity("--base", l.base, units::length, "between the rails' running lines", lengths);
  o.quantity("--transducers", l.transducers, units::length,
             "between the left and right vertical transducers", lengths);
  o.quantity("--truck-spacing", l.truck_spacing, units::length, "between the trucks' centres",
             lengths);
  o.quantity("--inclinometer-height", l.inclinometer_height, units::length, "above the rails",
             {-5, 5});
  o.quantity("--beam-height", l.beam_height, units::length,
             "of the lateral accelerometer above the rails", {-5, 5});
  o.quantity("--beam", l.beam, units::length, "between the zeros of the gage sensors", {0, 3});
  o.quantity("--first-corner", l.first_corner, units::frequency, "of B, before the gyros", corners);
  o.quantity("--second-corner", l.second_corner, units::frequency,
             "of F, before accelerometers and inclinometer", corners);
}

tool::Tool process_tool() {
  return {
      "process", "track geometry from a record of the car's sensors", [](tool::Options& o) {
        auto wish = std::make_shared<Wish>();
        o.file("record", wish->file, "CSV file, one row a foot");
        o.required();
        add_layout(o, wish->processing.layout);
        o.quantity("--chord", wish->chord, units::length, "of profile, alignment and warp",
                   tool::positive);
        o.count("--high-pass", wish->high_pass, "samples of the high-pass's mean, odd", 3, 10001);
        o.count("--passes", wish->passes, "of that mean", 1, 8);
        o.count("--stages", wish->stages, "of the high-pass; 2 frees space curves from bias", 1, 2);
        o.quantity("--roll-corner", wish->processing.roll_corner, units::frequency,
                   "between inclinometer and roll gyro", tool::Range{1e-4, 100});
        o.count("--roll-poles", wish->poles, "of the inclinometer's path", 1, 8);
        o.count("--curvature-mean", wish->curvature_mean, "samples", 1, 1001);
        o.quantity("--yaw-bias", wish->yaw_bias, units::angle / units::time,
                   "of the gyro, found at rest");
        o.quantity("--roll-bias", wish->roll_bias, units::angle / units::time,
                   "of the gyro, found at rest");
        o.quantity("--fastest", wish->processing.fastest, units::speed,
                   "a row that means more is rejected", tool::positive);
        o.quantity("--acceleration-range", wish->plausible.acceleration, units::acceleration,
                   "a sensor that says more is masked", tool::positive);
        o.quantity("--rate-range", wish->plausible.rate, units::angle / units::time, "likewise",
                   tool::positive);
        o.quantity("--displacement-range", wish->plausible.displacement, units::length, "likewise",
                   tool::positive);
        o.quantity("--spike", wish->plausible.spike, units::length,
                   "a displacement this far off both its neighbours is masked", tool::positive);
        o.quantity("--steepest-grade", wish->processing.steepest, units::number,
                   "of the line, for what braking may cost the profile", tool::Range{0, 0.1});
        o.out(wish->out);
        return [wish] { process_record(*wish); };
      }};
}

}  // namespace railbook::filters_tool
