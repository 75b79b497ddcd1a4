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

Jumps and stretches without a change are kept and not trusted; `--screen codes,jumps,still` masks them. A kink, as the joints of rails make, is no jump.

Then the sensors are tried against themselves and against each other. A channel that stands still, jumps or loses its zero, a gage that no track has, a clock or
a distance that stops or leaps; a gain, a unit or a sign that the other sensors contradict: each is a warning printed above the answer and kept under `warnings` in
the JSON, what is certainly wrong is masked, and no row that rests on a suspected value is *good*. A record of more than 32768 rows (10 km) is judged in stretches of that
length, each with 4096 rows of its neighbours or twice its windows: so the memory does not grow with the record. A sensor that is a factor off is then not trusted in
the stretches where that shows; a zero that has moved, and a speed that leapt, are remembered.
*/
#include <fmt/format.h>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <railbook/geometry_car/stretches.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/progress.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>

#include "filters/car_options.hpp"
#include "filters/sensor_file.hpp"
#include "tools.hpp"

namespace railbook::filters_tool {

using namespace geometry_car;
using units::foot;
using units::mph;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Options {
  std::filesystem::path file;
  Processing processing;
  Plausible plausible;
  double chord = 62 * foot, yaw_bias = 0, roll_bias = 0;
  std::vector<std::string> screen{"codes"};
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

// What is known of a parameter where it is good, and how often it is.
struct Tally {
  std::array<double, 4> rows{};  // by Quality
  double sum = 0, squares = 0;

  double of(Quality q) const { return rows[static_cast<std::size_t>(q)]; }
};

// The record as it goes by.
struct Answer {
  std::array<Tally, parameters> tally;
  double slow = units::infinity, fast = 0;  // m/s

  void add(const Stretch& s) {
    for (std::size_t i = s.from; i < s.to; ++i) {
      const double v = std::abs(s.m.speed[i]);
      if (!std::isnan(v)) slow = std::min(slow, v), fast = std::max(fast, v);
      for (const ParameterInfo& info : parameter_list()) {
        const auto p = static_cast<std::size_t>(info.parameter);
        Tally& t = tally[p];
        const Quality q = s.quality[p][i];
        ++t.rows[static_cast<std::size_t>(q)];
        if (q != Quality::good) continue;
        const double value = s.m[info.parameter][i] / info.si;
        t.sum += value;
        t.squares += value * value;
      }
    }
  }
};

std::string headers() {
  std::string text = "distance_m,speed_mph";
  for (const ParameterInfo& info : parameter_list())
    text += fmt::format(",{}_{}", info.name, info.unit);
  for (const ParameterInfo& info : parameter_list()) text += fmt::format(",{}_is", info.name);
  return text + "\n";
}

void append_line(std::string& text, const Stretch& s, std::size_t i, double first, double sample) {
  table::append_number(text, first + static_cast<double>(s.m.mark[i]) * sample, 9);
  text += ',';
  table::append_number(text, s.m.speed[i] / mph, 12);
  for (const ParameterInfo& info : parameter_list()) {
    text += ',';
    table::append_number(text, s.m[info.parameter][i] / info.si, 6);
  }
  for (std::size_t q = 0; q < parameters; ++q) (text += ',') += word(s.quality[q][i]);
  text += '\n';
}

// Rows for a figure: every one, or every second, fourth ... of a long record.
class Thin {
 public:
  void add(std::string_view text) {
    if (rows_++ % every_ != 0) return;
    lines_.emplace_back(text);
    if (lines_.size() < most) return;
    for (std::size_t i = 0; 2 * i < lines_.size(); ++i) lines_[i] = std::move(lines_[2 * i]);
    lines_.resize(most / 2);
    every_ *= 2;
  }
  std::string table() const { return headers() + fmt::format("{}", fmt::join(lines_, "")); }

 private:
  static constexpr std::size_t most = 20000;
  std::vector<std::string> lines_;
  std::size_t rows_ = 0, every_ = 1;
};

void add_parameters(tool::Summary& s, const Answer& a) {
  for (const ParameterInfo& info : parameter_list()) {
    if (info.parameter == Parameter::surface_left) break;  // space curves are in the table only
    const Tally& t = a.tally[static_cast<std::size_t>(info.parameter)];
    const double all = std::accumulate(t.rows.begin(), t.rows.end(), 0.0);
    const auto share = [&](Quality which) { return 100.0 * t.of(which) / all; };
    const double n = t.of(Quality::good);
    const double mean = n > 0 ? t.sum / n : nan;
    const double rms = n > 0 ? std::sqrt(std::max(0.0, t.squares / n - mean * mean)) : nan;
    const std::string name{info.name},
        note = fmt::format("good {:.1f} %, degraded {:.1f}, unreliable {:.1f}, missing {:.1f}",
                           share(Quality::good), share(Quality::degraded),
                           share(Quality::unreliable), share(Quality::missing));
    std::string unit{info.unit};
    if (const auto per = unit.find("_per_"); per != std::string::npos) unit.replace(per, 5, "/");
    if (unit.ends_with("km2")) unit.replace(unit.size() - 1, 1, "^2");
    if (n > 0) {
      s.add_rounded(name + "_mean", name + ", mean where good", mean, rms / 100, unit, note);
      s.add(name + "_deviation", "  standard deviation", rms, unit);
    } else {
      s.absent(name + "_mean", name + ", mean where good", "nowhere good");
      s.add(name + "_note", "  note", note);
    }
    s.add_to_json(name + "_good_percent", share(Quality::good), "%");
  }
}

// The findings of each kind and place in one line.
void add_warnings(tool::Summary& s, const std::vector<Finding>& findings, const Faults& faults) {
  std::vector<std::string> contradicted;
  for (const Finding& f : findings) {
    if (f.fault == Fault::inconsistent && f.size == 0)
      contradicted.push_back(f.what);
    else if (f.fault != Fault::dead ||
             std::find(faults.absent.begin(), faults.absent.end(), f.what) == faults.absent.end())
      s.warn(fmt::format("{}-{}", f.what, name_of(f.fault)), fmt::format("{}: {}", f.what, f.text));
  }
  if (!contradicted.empty())
    s.warn("sensors-inconsistent",
           fmt::format("these sensors contradict each other: {}", fmt::join(contradicted, ", ")));
  if (faults.beyond > 0)
    s.warn("beyond", fmt::format("{} values beyond what a sensor can give, masked", faults.beyond));
  if (faults.spikes > 0)
    s.warn("spikes", fmt::format("{} spikes of displacements, masked", faults.spikes));
  for (const std::string& name : faults.beyond_in)
    s.warn(name + "-range",
           fmt::format("{}: more than 1 % of its values are beyond what the sensor can give; "
                       "is its unit that of its header?",
                       name));
}

tool::Summary summary(const Options& options, const Answer& a, const Stretches& record,
                      const Faults& faults) {
  tool::Summary s{"geometry of " + options.file.string()};
  add_warnings(s, record.findings(), faults);
  s.add("rows", "rows", static_cast<double>(record.rows()), "");
  s.add("rejected", "  of them rejected", static_cast<double>(record.rejected()), "",
        "time zero, negative, missing or too short");
  s.add("runs", "runs without a gap or a turn", static_cast<double>(record.runs()), "");
  s.add("slowest_mph", "slowest foot", a.slow / mph, "mph");
  s.add("fastest_mph", "fastest foot", a.fast / mph, "mph");
  add_parameters(s, a);
  if (!faults.absent.empty())
    s.add("absent", "note", fmt::format("not in the file: {}", fmt::join(faults.absent, ", ")));
  if (!faults.unused.empty())
    s.add("unused", "note", fmt::format("columns not used: {}", fmt::join(faults.unused, ", ")));
  if (a.slow < 0.1 * mph)
    s.add("stop", "note", "the car stopped; what has the stop in its window is not reliable");
  return s;
}

void refuse_nothing(const Options& options, const Answer& a, const Stretches& record) {
  for (const Tally& t : a.tally)
    for (const Quality q : {Quality::good, Quality::degraded, Quality::unreliable})
      if (t.of(q) > 0) return;
  std::vector<std::string> why;
  for (const Finding& f : record.findings())
    if (why.size() < 5) why.push_back(fmt::format("{} {}", f.what, f.text));
  throw InputError{
      fmt::format("file \"{}\": nothing can be measured ({}); allowed: working sensors of at least "
                  "one parameter",
                  options.file.string(), fmt::join(why, "; "))};
}

// The columns of each stretch are of the same sizes: what was freed is kept for the next.
void keep_freed_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
  ::mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

void process_record(Options options) {
  keep_freed_memory();
  tool::OutFolder out(options.out,
                      {"geometry.csv", "geometry.json", "warnings.csv", "geometry.png"});
  Processing& p = options.processing;
  p.mask_jumps = p.mask_still = false;
  for (const std::string& name : options.screen) {
    if (name != "codes" && name != "jumps" && name != "still")
      throw InputError{fmt::format("screen is \"{}\"; allowed: codes, jumps, still", name)};
    p.mask_jumps = p.mask_jumps || name == "jumps";
    p.mask_still = p.mask_still || name == "still";
  }
  const double half = 0.5 * options.chord / p.layout.sample;
  if (std::abs(half - std::round(half)) > 1e-6 || half < 0.5)
    throw InputError{fmt::format(
        "chord is {:.6g} m, {:.6g} samples of {:.6g} m; allowed: an even number of them",
        options.chord, 2 * half, p.layout.sample)};
  p.chain.half_chord = static_cast<int>(std::lround(half));
  p.chain.high_pass = {static_cast<int>(options.high_pass), static_cast<int>(options.passes),
                       static_cast<int>(options.stages)};
  p.roll_poles = static_cast<int>(options.poles);
  p.curvature_mean = static_cast<int>(options.curvature_mean);
  SensorFile file{options.file, p.layout.sample, options.plausible};
  files::OutFile* rows = out ? &out.stream("geometry.csv") : nullptr;
  if (rows != nullptr) rows->write(headers());
  Answer a;
  Thin thin;
  Stretches record{p, [&](const Stretch& s) {
                     a.add(s);
                     if (rows == nullptr) return;
                     std::string text;
                     for (std::size_t i = s.from; i < s.to; ++i) {
                       const std::size_t begin = text.size();
                       append_line(text, s, i, file.first(), p.layout.sample);
                       thin.add(std::string_view(text).substr(begin));
                     }
                     rows->write(text);
                   }};
  {
    tool::Progress progress{"per cent of the record", 100};
    int shown = 0;
    for (Row row; file.next(row); record.push(row)) {
      row.values[static_cast<std::size_t>(Channel::yaw_rate)] -= options.yaw_bias;
      row.values[static_cast<std::size_t>(Channel::roll_rate)] -= options.roll_bias;
      for (; shown < static_cast<int>(100 * file.share()); ++shown) progress.step();
    }
  }
  record.finish();
  refuse_nothing(options, a, record);
  const tool::Summary s = summary(options, a, record, file.faults());
  s.print();
  if (out) {
    out.add("geometry.json", s.json());
    std::string warnings = "sensor,warning,first_row,rows,text\n";
    for (const Finding& f : record.findings())
      warnings += fmt::format("{},{},{},{},{}\n", f.what, name_of(f.fault), f.first + 1, f.rows,
                              table::csv_cell(f.text));
    out.add("warnings.csv", warnings);
    out.scratch("thin.csv", thin.table());
    out.figure(tools::scripts("filters") / "process.gp", {"thin.csv"}, "geometry.png");
  }
  out.commit();
}

}  // namespace

void add_layout(tool::OptionParser& o, Layout& l) {
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
      "process", "track geometry from a record of the car's sensors", [](tool::OptionParser& o) {
        auto options = std::make_shared<Options>();
        o.file("record", options->file, "CSV file, one row a foot");
        o.required();
        add_layout(o, options->processing.layout);
        o.quantity("--chord", options->chord, units::length, "of profile, alignment and warp",
                   tool::positive);
        o.texts("--screen", options->screen,
                "what is masked: codes (values beyond a sensor's range, and spikes), and as well "
                "jumps and still, stretches without a change; else these are kept and not trusted");
        o.count("--high-pass", options->high_pass, "samples of the high-pass's mean, odd", 3,
                10001);
        o.count("--passes", options->passes, "of that mean", 1, 8);
        o.count("--stages", options->stages, "of the high-pass; 2 frees space curves from bias", 1,
                2);
        o.quantity("--roll-corner", options->processing.roll_corner, units::frequency,
                   "between inclinometer and roll gyro", tool::Range{1e-4, 100});
        o.count("--roll-poles", options->poles, "of the inclinometer's path", 1, 8);
        o.count("--curvature-mean", options->curvature_mean, "samples, odd", 3, 1001);
        o.quantity("--yaw-bias", options->yaw_bias, units::angle / units::time,
                   "of the gyro, found at rest");
        o.quantity("--roll-bias", options->roll_bias, units::angle / units::time,
                   "of the gyro, found at rest");
        o.quantity("--fastest", options->processing.fastest, units::speed,
                   "a row that means more is rejected", tool::positive);
        o.quantity("--acceleration-range", options->plausible.acceleration, units::acceleration,
                   "a sensor that says more is masked", tool::positive);
        o.quantity("--rate-range", options->plausible.rate, units::angle / units::time, "likewise",
                   tool::positive);
        o.quantity("--displacement-range", options->plausible.displacement, units::length,
                   "likewise", tool::positive);
        o.quantity("--spike", options->plausible.spike, units::length,
                   "a displacement this far off both its neighbours is masked", tool::positive);
        o.quantity("--steepest-grade", options->processing.steepest, units::number,
                   "of the line, for what braking may cost the profile", tool::Range{0, 0.1});
        o.out(options->out);
        o.help(
            "geometry.csv has a row a mark: distance_m, speed_mph (negative where marks count "
            "down), "
            "and for each parameter its\n"
            "value and, in NAME_is, how far it can be trusted: good, degraded, unreliable or "
            "missing. Along the track towards\n"
            "growing marks, left is positive: curvature (rad/km) in a left-hand curve, crosslevel "
            "(mm) with the left rail\n"
            "higher, alignment and line (mm) to the left; profile and surface (mm) are positive "
            "upwards. profile and alignment\n"
            "are the rail at the middle of the chord less the mean of its ends, so that a dip is "
            "negative; surface and line are\n"
            "space curves without their long waves. curvature_rate (rad/km2) and warp (mm) are the "
            "change of curvature and of\n"
            "crosslevel ahead less behind, warp over the length of the chord. gage (mm) is whole. "
            "warnings.csv lists what\n"
            "is suspected: sensor, warning, first_row, rows, text. Constant errors that are not "
            "seen: "
            "0.14 deg/s of yaw (10 mm of\n"
            "crosslevel at 60 mph), 0.033 m/s2 of the inclinometer (5 mm of it), 0.15 rad of roll "
            "over "
            "the record, 0.047 m/s2\n"
            "of one vertical accelerometer (20 mm of a surface).\n"
            "\nExample: railbook filters process sensors.csv --config car.toml --out mine");
        return [options] { process_record(*options); };
      }};
}

}  // namespace railbook::filters_tool
