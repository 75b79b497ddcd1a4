/*** ## The car and its sensors

A car body rides on two trucks, frames with two axles each. Under the front truck runs the measuring
axle. Above it, in the body, sit two vertical accelerometers, an inclinometer (a pendulum that shows
where down is), a gyro for the rate of roll and one for the rate of yaw, the turning about a
vertical axis. On each side a height sensor measures how far the body is above the axle.

Three more displacement sensors measure how far the body has swayed sideways over its trucks. From
the front truck a beam reaches down between the rails. It carries a lateral accelerometer and two
gage sensors, which measure the distance to each rail without touching it. The gage is the sum of
their two readings and of the distance between the two sensors.

An analog filter $B$ of first order stands before both gyros, one of second order, $F$, before the
accelerometers and the inclinometer, and none before the displacement sensors. An encoder on an axle
calls for a sample each foot, and a clock says how long the foot took.

{{fig-layout}}

{{include: car_scene.cpp}}

The paper's Figure 3 shows which measurement (*parameter*, says the paper) needs which sensor
(*transducer*). The drawing is lost in our copy, and we rebuilt it from the words around it. Our
processing follows the same words, and the table shows what it really uses: each sensor of a
recorded journey is disturbed in turn, and a measurement that changes depends on it.

{{table-sensors}}

Gage, curvature, crosslevel and alignment use exactly the sensors that the paper names. For profile
the paper names two accelerometers "in addition to the transducers used in the crosslevel and
curvature systems". Ours needs no sensor beyond these {{outcome:table-sensors/profile}}, but it does
without the sway sensors. That is a property of our correction, which reads the lateral force on the
leaning body from the inclinometer. A correction by the speed times the yaw rate of the track would
need the sway sensors, and the paper's may be of this kind.

The car is simulated. Body, trucks and analog filters are integrated together in continuous time.
The track is piecewise linear, with 16 points a foot, so that each step is integrated exactly. The
processing gets what the converters read each foot and nothing else, and the simulation knows
nothing of the digital filters.

::: {.fold summary="Two statements of the paper about the system as a whole, tried on this model"}

{{table-system}}

:::

{{include: experiment.cpp}}

{{fold}}
*/
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <railbook/geometry_car/health.hpp>

#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

// The sensors as the paper groups them; the encoder has no channel.
const std::vector<std::pair<std::string, std::vector<Channel>>>& groups() {
  using enum Channel;
  static const std::vector<std::pair<std::string, std::vector<Channel>>> list{
      {"gage sensors", {gage_left, gage_right}},
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

using Names = std::vector<std::string>;

// Groups of which each member, disturbed alone, changes one of the parameters, in the order of
// groups().
Names needed(const Record& record, const std::vector<Parameter>& made_of) {
  const Measurement whole = reconstruct(record, chosen_processing());
  const auto changes = [&](const Record& disturbed) {
    const Measurement m = reconstruct(disturbed, chosen_processing());
    for (const Parameter p : made_of)
      for (std::size_t i = 0; i < m.size(); ++i)
        if (!std::isnan(m[p][i]) && m[p][i] != whole[p][i]) return true;
    return false;
  };
  Names names;
  for (const auto& [name, members] : groups()) {
    bool all = true;
    for (const Channel c : members) {
      Record r = record;
      for (std::size_t i = 0; i < r.size(); ++i)
        r[c][i] += 1e-3 * std::sin(0.1 * static_cast<double>(i));
      all = all && changes(r);
    }
    if (members.empty()) {
      Record r = record;
      for (double& T : r.elapsed) T *= 1.01;
      all = changes(r);
    }
    if (all) names.push_back(name);
  }
  return names;
}

void table_sensors(report::Item& item) {
  item.rebuilt("from the text; the paper's Figure 3 is lost in our copy");
  item.expect_checks(5);
  const Record record = cruise(line_of({.length = 1500 * foot}), 60 * mph);
  std::vector<report::Heading> headings{"measurement"};
  for (const auto& [name, members] : groups()) headings.emplace_back(name);
  item.columns(headings);
  const auto found = [&](const char* name, const std::vector<Parameter>& made_of) {
    Names names = needed(record, made_of), cells{name};
    for (const auto& [group, members] : groups())
      cells.emplace_back(std::ranges::count(names, group) > 0 ? "●" : "");
    item.add_row(cells);
    return names;
  };
  using enum Parameter;
  const char* const by = "our processing, each sensor disturbed in turn";
  const char* const same = "these and no others";
  item.verify("gage", "gage uses the gage sensors", found("gage", {gage}) == Names{"gage sensors"},
              same, by);
  item.verify("curvature", "curvature uses the yaw gyro, three sway sensors and the encoder",
              found("curvature and its change", {curvature, curvature_rate}) ==
                  Names{"yaw gyro", "sway sensors front", "sway sensor rear", "encoder"},
              same, by);
  item.verify(
      "crosslevel",
      "crosslevel and warp use inclinometer, roll gyro, height sensors, yaw gyro and encoder",
      found("crosslevel and warp", {Parameter::crosslevel, warp}) ==
          Names{"yaw gyro", "inclinometer", "roll gyro", "height sensors", "encoder"},
      same, by);
  item.consistent(
      "profile", "profile needs two accelerometers besides the sensors of crosslevel and curvature",
      found("profile", {profile_left, profile_right, surface_left, surface_right}) ==
          Names{"yaw gyro", "inclinometer", "roll gyro", "height sensors",
                "vertical accelerometers", "encoder"},
      "no others; the sway sensors are not used",
      "our correction reads the lateral force from the inclinometer");
  item.verify("alignment",
              "alignment uses the lateral accelerometer, the gage sensors and the track's roll",
              found("alignment", {alignment_left, alignment_right, line_left, line_right}) ==
                  Names{"gage sensors", "yaw gyro", "inclinometer", "roll gyro", "height sensors",
                        "lateral accelerometer", "encoder"},
              same, by);
}

// The shift in feet at which the measured parameter is most like the true one.
long lag(const Measurement& m, const Measurement& t, Parameter p) {
  long best = 0;
  double least = units::infinity;
  for (long shift = -10; shift <= 10; ++shift) {
    double sum = 0;
    for (std::size_t i = 400; i + 400 < m.size(); ++i) {
      const double e = m[p][i] - t[p][static_cast<std::size_t>(m.mark[i] + shift)];
      if (!std::isnan(e)) sum += e * e;
    }
    if (sum < least) least = sum, best = shift;
  }
  return best;
}

bool is_synchronous(const Record& record, const Measurement& truth) {
  using enum Parameter;
  const Measurement m = reconstruct(record, chosen_processing());
  for (const Parameter p : {gage, Parameter::crosslevel, profile_left, alignment_left})
    if (lag(m, truth, p) != 0) return false;
  return true;
}

// How many sensors are found when each in turn stands still for 300 ft.
std::size_t still_found(const Record& record) {
  std::size_t found = 0;
  for (const ChannelInfo& c : channel_list()) {
    Record r = record;
    for (std::size_t i = 1000; i < 1300; ++i) r[c.channel][i] = r[c.channel][1000];
    for (const Finding& f : examine(r, chosen_processing()).findings)
      if (f.fault == Fault::still && f.what == c.name) ++found;
  }
  return found;
}

void table_system(report::Item& item) {
  item.rebuilt("track, car, corners and sensors are chosen");
  item.expect_checks(1);
  item.columns({"the paper says", "on our model"});
  const Line line = line_of({.length = 3000 * foot});
  const auto recorded = [&](double speed) {
    return with_errors(cruise(line, speed), debiased_sensors(), 2);
  };
  Record record = recorded(-60 * mph);
  const bool synchronous =
      is_synchronous(recorded(60 * mph), line.truth) && is_synchronous(record, line.truth);
  item.claims({{"synchronous", {synchronous ? 1.0 : 0.0}}});
  item.add_row(
      "all parameters are synchronised to one location",
      synchronous ? "gage, crosslevel, profile, alignment: no shift either way" : "shifted");
  const std::size_t seen = still_found(record);
  const bool quiet = examine(record, chosen_processing()).findings.empty();
  item.verify("faults", "each sensor that stands still over 300 ft is named, and no other",
              seen == channels && quiet, "each of them, and no other",
              "our detection, on faults put into a simulated record");
  item.add_row("an algorithm detects lack-of-activity faults (out of range: second page)",
               std::to_string(seen) + " of " + std::to_string(channels) +
                   " sensors that stand still are found (the encoder is not among them); no alarm "
                   "over 3000 ft without a fault");
}

}  // namespace

const report::Section system{report::table("table-sensors", table_sensors),
                             report::table("table-system", table_system)};

}  // namespace railbook::filters_chapter
