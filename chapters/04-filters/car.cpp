/*** ## The car

Now the whole measuring chain. A car body rides on two trucks; under the front one runs the measuring axle. Above it, in the body, sit two
vertical accelerometers, an inclinometer, the roll and the yaw gyro, and a height sensor on each side measures the body over the axle. Three
more displacement sensors measure how far the body has swayed over the trucks. On the truck, a beam carries a lateral accelerometer and the two
gage sensors. An encoder on an axle calls for a sample each foot, and a clock says how long the foot took.

{{fig-layout}}

{{include: car_scene.cpp}}

**Motion.** The body bounces at 1 Hz, rolls, leans outwards in curves, and each end sways on its truck at 1.25 Hz, the one frequency the
paper gives. The trucks weave about the centre line. All this is integrated together with the analog filters in continuous time: the
track is straight between sixteen points a foot, over such a piece the equations are linear with constant coefficients, and
the Taylor series of their solution is summed to the last digit. The simulation knows nothing of the digital filters. What is small in an
attitude but not in its effect, gravity on a leaning accelerometer, is not linearised.

**Reconstruction.** This is the paper's, step by step. *Gage* is the sum of two distances. *Curvature* is the yaw rate behind $B\cdot C$, times the
time between samples, less what the body turned over its trucks, smoothed over 51 ft. *Crosslevel* takes the slow part of the body's roll from
the inclinometer, the fast part from the roll gyro, and the track's roll against the body's from the height sensors; before, the inclinometer is
rid of the centrifugal acceleration $V\dot\psi$, of $\ell\ddot\psi$ because it sits a distance $\ell$ before the middle of the car, and of $h\ddot\theta$
because it sits above the rails. *Profile* doubles each vertical acceleration into a short chord by $F\cdot G$, puts upright what the leaning body
measured, and takes off the short chord of the height sensors. *Alignment* does the same with the beam's accelerometer, gravity on the rolling beam taken
off, and adds the short chord of each gage sensor.

Which parameter needs which sensor is the paper's Figure 3, of which only the text around it can be read. We ask the code: each sensor of a recorded journey
is disturbed in turn, and what changes depends on it.

{{table-sensors}}

The text is confirmed, with one exception: it gives profile all sensors of the curvature system, ours needs of these only the yaw gyro (through the
roll of the body) and the encoder.

What is each correction worth? Sixty miles an hour over the whole line, perfect sensors, one correction left out at a time:

{{table-corrections}}

{{include: experiment.cpp}}
*/
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "items.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

struct Group {
  std::string name;
  std::vector<Channel> channels;  // none: the encoder
};

const std::vector<Group>& groups() {
  using enum Channel;
  static const std::vector<Group> list{{"gage sensors", {gage_left, gage_right}},
                                       {"yaw gyro", {yaw_rate}},
                                       {"sway sensors front", {sway_front_a, sway_front_b}},
                                       {"sway sensor rear", {sway_rear}},
                                       {"inclinometer", {inclinometer}},
                                       {"roll gyro", {roll_rate}},
                                       {"height sensors", {height_left, height_right}},
                                       {"vertical accelerometers", {vertical_left, vertical_right}},
                                       {"lateral accelerometer", {lateral}},
                                       {"encoder", {}}};
  return list;
}

// Groups of which each member, disturbed alone, changes one of the parameters.
std::string needed(const Record& record, const Measurement& whole, const Processing& processing,
                   const std::vector<Parameter>& parameters) {
  std::string names;
  const auto changes = [&](const Record& disturbed) {
    const Measurement m = reconstruct(disturbed, processing);
    for (const Parameter p : parameters)
      for (std::size_t i = 0; i < m.size(); ++i)
        if (!std::isnan(m[p][i]) && m[p][i] != whole[p][i]) return true;
    return false;
  };
  for (const Group& group : groups()) {
    bool all = true;
    for (const Channel c : group.channels) {
      Record r = record;
      for (std::size_t i = 0; i < r.size(); ++i)
        r[c][i] += 1e-3 * std::sin(0.1 * static_cast<double>(i));
      all = all && changes(r);
    }
    if (group.channels.empty()) {
      Record r = record;
      for (double& T : r.elapsed) T *= 1.01;
      all = changes(r);
    }
    if (all) names += (names.empty() ? "" : "; ") + group.name;
  }
  return names;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find("; ", from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 2;
  }
  return parts;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The printed names less those not needed, in the order of groups().
std::string expected(const table::CsvTable& table, const std::string& key) {
  const auto printed = split(table.at(key, "printed")), left = split(table.at(key, "not needed"));
  std::string names;
  for (const Group& g : groups())
    if (has(printed, g.name) && !has(left, g.name)) names += (names.empty() ? "" : "; ") + g.name;
  return names;
}

void table_sensors(report::Item& item) {
  item.explained("printed as text; profile needs less than the text names");
  const auto printed = item.printed("dependencies.csv");
  item.expect_checks(static_cast<int>(printed.rows.size()));
  TrackDescription line = main_line();
  line.length = 1500 * foot;
  const Car car;
  const Record record = cruise(build(line), car, 60 * mph);
  const Processing processing{.layout = car.layout};
  const Measurement whole = reconstruct(record, processing);
  using enum Parameter;
  std::vector<std::string> headings{"parameter"};
  for (const Group& g : groups()) headings.push_back(g.name);
  item.columns({headings.begin(), headings.end()});
  for (const auto& [name, made_of] : std::vector<std::pair<std::string, std::vector<Parameter>>>{
           {"gage", {gage}},
           {"curvature", {curvature, curvature_rate}},
           {"crosslevel", {crosslevel, warp}},
           {"profile", {profile_left, profile_right, surface_left, surface_right}},
           {"alignment", {alignment_left, alignment_right, line_left, line_right}}}) {
    const std::string names = needed(record, whole, processing, made_of);
    item.check_text(name,
                    "what " + name + " is made of" +
                        (printed.at(name, "not needed").empty() ? "" : ", less what is not needed"),
                    expected(printed, name), names);
    std::vector<std::string> cells{name};
    for (const Group& g : groups()) cells.emplace_back(has(split(names), g.name) ? "●" : "");
    item.add_row(cells);
  }
}

void table_corrections(report::Item& item) {
  item.reconstructed("track, car and ride are ours");
  item.columns({"left out", "parameter", "RMS error with it", "without"});
  const Track track = build(main_line());
  const Car car;
  const Record record = cruise(track, car, 60 * mph);
  const Processing processing{.layout = car.layout};
  const Measurement t = truth(track, processing), with = reconstruct(record, processing);
  using enum Parameter;
  struct Row {
    const char* what;
    bool Corrections::*which;
    Parameter parameter;
  };
  for (const Row& row :
       {Row{"body turning over its trucks", &Corrections::truck_motion, curvature},
        Row{"centrifugal acceleration", &Corrections::centrifugal, crosslevel},
        Row{"distance to the yaw centre", &Corrections::yaw_centre, crosslevel},
        Row{"roll acceleration", &Corrections::roll_acceleration, crosslevel},
        Row{"roll gyro", &Corrections::gyro, crosslevel},
        Row{"leaning body", &Corrections::vertical_attitude, profile_left},
        Row{"transducers beside the rail", &Corrections::transducer_place, profile_left},
        Row{"gravity on the rolling beam", &Corrections::gravity, alignment_left},
        Row{"beam above the rails", &Corrections::beam_height, alignment_left}}) {
    Processing less = processing;
    less.corrections.*row.which = false;
    const ParameterInfo& info = parameter_list()[static_cast<std::size_t>(row.parameter)];
    const bool bend = row.parameter == curvature;
    const char* unit = bend ? "deg per 100 ft" : "mm";
    const double si = bend ? per_100ft : mm;
    item.add_row({row.what, std::string(info.name),
                  fmt::format("{:.3g} {}", misfit(with, t, row.parameter).rms / si, unit),
                  fmt::format("{:.3g} {}",
                              misfit(reconstruct(record, less), t, row.parameter).rms / si, unit)});
  }
}

}  // namespace

void add_car(report::Chapter& chapter) {
  chapter.table("table-sensors", "Figures 2 and 3: what each parameter is made of", table_sensors);
  chapter.table("table-corrections", "What each correction is worth", table_corrections);
}

}  // namespace railbook::filters_chapter
