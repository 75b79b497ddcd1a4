/*
### `wheelrail table`

A table of one wheel's contact over shift, yaw, load, friction and slip, which a vehicle code can interpolate. All
processors share the work; several machines share a large table by yaw: run the command once on each (`--yaw-from`, `--yaw-to`,
`--yaws`).

    wheelrail table --speed 30m/s --shifts 41 --yaws 5 --load 40kN 50kN --mu 0.3 --slip -0.002 0 0.002 --out mine

The rows are the right wheel's; the left wheel's are those at the opposite shift and yaw, with the opposite forces across.
The wheelset rolls as a rigid one and turns with the given slip. A line's first row says how far linear interpolation to
the next shift is from answers between the two, and with an approximate method how far that is from the full theory; of more
than some hundred lines, lines evenly spread do, since the full theory costs more than a line. Answers between are sought half
way and a quarter of the way from either end, and where the error is not largest in the middle, nearer to its largest. Beyond 5 %
of what friction bears, or 10 % of the pressure, the row has a warning.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <thread>

#include <railbook/tool/batch.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>

#include "tools.hpp"
#include "wheelrail/pair.hpp"

namespace railbook::wheelrail_tool {

using namespace profiles;
using namespace wheel_contact;
using units::millimetre;

namespace {

struct Options : PairOptions {
  double from = -8 * millimetre, to = 8 * millimetre, yaw_from = 0, yaw_to = 0;
  long shifts = 33, yaws = 1;
  std::vector<double> loads, frictions{0.3}, slips{0};
  tool::RecordFiles batch;
  tool::Destination out;
};

// The positions of one shift and one yaw.
struct Line {
  double shift, yaw, step;
  bool measured;  // says its errors
};
constexpr long most_measured = 100;  // lines
// What varies along a line.
struct Place {
  double load, friction, slip;
};

WheelResult solve(const Options& options, const ReadPair& read, const Pose& pose,
                  const Place& place, Method method) {
  WheelInput w = wheel_input(options);
  w.load = place.load, w.friction.coefficient = place.friction, w.method = method;
  w.angular_velocity = options.speed / read.radius() * (1 + place.slip);
  WheelResult r = solve_wheel(read.right, pose, w);
  if (!r.converged) throw std::runtime_error(r.reason);
  return r;
}

Pose pose_of(const ReadPair& read, double shift, double yaw) {
  return {shift, yaw, rigid_roll(read.left, read.right, shift, yaw)};
}

// (Fx, Fy) on the rail apart, over the friction times the load.
double apart(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Place& place) {
  const double bound = place.friction * place.load;
  return bound > 0 ? (a - b).head<2>().norm() / bound : 0;
}

// The largest error of linear interpolation between two answers, `error_at` a share of the way: at
// a half and both quarters, and where a quarter's is the largest, at eighths and sixteenths about
// it. A patch that grows into another bends the forces near one end of a step, where the middle
// sees a tenth of the error.
double largest_between(const std::function<double(double)>& error_at) {
  double largest = 0, at = 0.5, step = 0.25;
  const auto look = [&](double share) {
    const double error = error_at(share);
    if (error > largest) largest = error, at = share;
  };
  for (const double share : {0.5, 0.25, 0.75}) look(share);
  if (at == 0.5) return largest;
  for (int k = 0; k < 2; ++k) {
    step /= 2;
    const double middle = at;
    look(middle - step), look(middle + step);
  }
  return largest;
}

constexpr double warned_force = 0.05;     // of mu N
constexpr double warned_pressure = 0.10;  // of the pressure

// Measured at the first place of a line; NaN where there is no answer.
void add_errors(tool::Row& row, const Options& options, const ReadPair& read, const Line& line,
                const Place& place, const WheelResult& here) {
  double between = units::nan, method = units::nan, pressure = units::nan;
  const Method own = method_of(options.method);
  try {
    if (line.step > 0) {
      const auto next =
          solve(options, read, pose_of(read, line.shift + line.step, line.yaw), place, own);
      between = largest_between([&](double share) {
        const auto answer = solve(
            options, read, pose_of(read, line.shift + share * line.step, line.yaw), place, own);
        return apart(answer.force, here.force + share * (next.force - here.force), place);
      });
    }
    if (own != Method::full) {
      const auto full =
          solve(options, read, pose_of(read, line.shift, line.yaw), place, Method::full);
      method = apart(here.force, full.force, place);
      pressure = std::abs(here.patches.front().p_max / full.patches.front().p_max - 1);
    }
  } catch (const std::runtime_error&) {
    row.warn("error-not-measured");
  }
  row.add("interpolation_error_of_mu_N", between);
  row.add("method_error_of_mu_N", method);
  row.add("method_error_p_max", pressure);
  if (between > warned_force) row.warn("interpolation");
  if (method > warned_force || pressure > warned_pressure) row.warn("method");
}

tool::Row row_of(const Line& line, const Place& place) {
  tool::Row row;
  row.add("shift_mm", line.shift / millimetre);
  row.add("yaw_mrad", 1e3 * line.yaw);
  row.add("load_kN", place.load / units::kilonewton);
  row.add("friction", place.friction);
  row.add("slip", place.slip);
  return row;
}

void add_patch(tool::Row& row, std::size_t number, const PatchResult& p) {
  row.add("patch", static_cast<double>(number));
  row.add("along_mm", p.patch.frame.origin.x() / millimetre);
  row.add("across_mm", p.patch.frame.origin.y() / millimetre);
  row.add("angle_mrad", 1e3 * p.patch.frame.angle);
  row.add("normal_N", p.load);
  row.add("p_max_MPa", p.p_max / units::megapascal);
  row.add("area_mm2", p.area / (millimetre * millimetre));
  row.add("creepage_x", p.creepage.longitudinal);
  row.add("creepage_y", p.creepage.lateral);
  row.add("spin_1_per_m", p.creepage.spin);
  row.add("fx_N", p.forces.fx);
  row.add("fy_N", p.forces.fy);
  row.add("mz_N_m", p.forces.mz);
  row.add("stick_share", p.forces.stick_share);
  row.add("patch_wear_N", p.wear_number);
}

void add_answer(tool::Row& row, const Pose& pose, const WheelResult& r) {
  double wear = 0, error = 0, pressure_error = 0;
  for (const PatchResult& patch : r.patches) {
    wear += patch.wear_number;
    error = std::max(error, patch.forces.error),
    pressure_error = std::max(pressure_error, patch.p_max_error);
  }
  row.add("roll_mrad", 1e3 * pose.roll);
  row.add("lowered_mm", r.z / millimetre);
  row.add("x_N", r.force.x());
  row.add("y_N", r.force.y());
  row.add("z_N", r.force.z());
  row.add("axle_moment_N_m", r.axle_moment);
  row.add("wear_N", wear);
  row.add("patches", static_cast<double>(r.patches.size()));
  add_patch(row, 1, r.patches.front());
  row.add("grid_error_of_mu_N", error);
  row.add("grid_error_p_max", pressure_error);
  for (const units::Warning& warning : r.warnings) row.warn(warning.key);
}

// Warnings of the profile's points where this row's wheel stands.
void add_point_warnings(tool::Row& row, const Options& options, const Line& line,
                        const WheelResult& r, const std::vector<profiles::ProfileFit>& fits) {
  for (const profiles::ProfileFit& fit : fits)
    for (const profiles::PointsWarning& warning : fit.warnings)
      if (stands_on(options, tools::Side::right, r, line.shift, fit, warning))
        row.warn(fmt::format("{}-{}", fit.what, warning.key));
}

std::vector<tool::Row> rows_of(const Options& options, const ReadPair& read, const Line& line) {
  const Pose pose = pose_of(read, line.shift, line.yaw);
  std::vector<tool::Row> rows;
  for (const double load : options.loads)
    for (const double friction : options.frictions)
      for (const double slip : options.slips) {
        const Place place{load, friction, slip};
        tool::Row row = row_of(line, place);
        std::vector<tool::Row> others;  // patches
        try {
          const WheelResult r = solve(options, read, pose, place, method_of(options.method));
          add_answer(row, pose, r);
          add_point_warnings(row, options, line, r, read.fits);
          for (std::size_t k = 1; k < r.patches.size(); ++k)
            add_patch(others.emplace_back(row_of(line, place)), k + 1, r.patches[k]);
          if (rows.empty() && line.measured) add_errors(row, options, read, line, place, r);
        } catch (const std::runtime_error& error) {  // not of a lack of memory
          others.clear();
          row.refuse(error.what());
        }
        rows.push_back(std::move(row));
        std::ranges::move(others, std::back_inserter(rows));
      }
  return rows;
}

double step_of(double from, double to, long count) {
  return count > 1 ? (to - from) / static_cast<double>(count - 1) : 0;
}

void run(Options options) {
  units::require_between("last shift", options.to, options.from, 0.05, "m");
  units::require_between("last yaw", options.yaw_to, options.yaw_from, 0.1, "rad");
  const double rows = double(options.shifts) * double(options.yaws) * double(options.loads.size()) *
                      double(options.frictions.size()) * double(options.slips.size());
  units::require_between("rows of the table", rows, 1, 2e7);
  const ReadPair read = read_pair(options);
  const double step = step_of(options.from, options.to, options.shifts),
               turn = step_of(options.yaw_from, options.yaw_to, options.yaws);
  std::map<std::filesystem::path, Line> lines;
  const long every = std::max(1L, options.shifts * options.yaws / most_measured);
  for (long i = 0; i < options.shifts; ++i)
    for (long j = 0; j < options.yaws; ++j) {
      const Line line{options.from + step * double(i), options.yaw_from + turn * double(j),
                      i + 1 < options.shifts ? step : 0, (i * (options.yaws + 1) + j) % every == 0};
      const std::string name =
          fmt::format("shift {:.9g} mm, yaw {:.9g} mrad", line.shift / millimetre, 1e3 * line.yaw);
      if (lines.emplace(name, line).second) options.batch.files.emplace_back(name);
    }
  tool::run_batch(
      options.batch, options.out, "wheelrail",
      [&](const auto& name) { return rows_of(options, read, lines.at(name)); },
      static_cast<int>(std::thread::hardware_concurrency()));
}

std::function<void()> declare(tool::OptionParser& parser) {
  const auto options = std::make_shared<Options>();
  options->method = "strips";
  add_pair_options(parser, *options);
  using tool::Range;
  parser.quantity("--from", options->from, units::length, "first shift to the right",
                  Range{-0.05, 0.05});
  parser.quantity("--to", options->to, units::length, "and last", Range{-0.05, 0.05});
  parser.count("--shifts", options->shifts, "how many", 1, 100000);
  parser.quantity("--yaw-from", options->yaw_from, units::angle, "first yaw, front to the right",
                  Range{-0.1, 0.1});
  parser.quantity("--yaw-to", options->yaw_to, units::angle, "and last", Range{-0.1, 0.1});
  parser.count("--yaws", options->yaws, "how many", 1, 100000);
  parser.quantities("--load", options->loads, units::force, "vertical, on the wheel",
                    Range{1, 1e9});
  parser.required();
  parser.quantities("--mu", options->frictions, units::number, "friction", Range{0, 2});
  parser.quantities("--slip", options->slips, units::number,
                    "the wheelset turns by this share faster than speed over radius",
                    Range{-1, 10});
  parser.out(options->out);
  parser.help(
      "With --out DIR: DIR/wheelrail-table.csv and .jsonl, a row a position. Columns are those of "
      "the right wheel, "
      "forces on the rail; x forward, y right, z down; the first patch carries most, and further "
      "patches follow in rows of their own, with patch 2 and on and without what is the wheel's. "
      "record, status and reason say which position has an answer. Of the wheel: lowered, down "
      "from "
      "where it stood at shift 0, forces x, y and z, axle_moment about its axle, positive as it "
      "drives, wear, the sum of force times creepage. Of a patch: normal force, p_max, area, "
      "creepage_x, creepage_y and spin, fx, fy and mz in its plane, stick_share, the part of it "
      "that sticks, patch_wear. Errors: grid_error of the force over mu N and of p_max, "
      "interpolation_error to the next shift, method_error against the full theory. warnings "
      "lists, "
      "in words: "
      "interpolation: between this shift and the next linear interpolation is off by more than 5 % "
      "of mu N; method: the method is off the full theory by more than that, or by 10 % of the "
      "pressure; climbed: the wheel stands beyond its flange's steepest place; nadal: Y/Q is above "
      "Nadal's limit; verge, unlike, neighbour, half_space, two_areas, shared_frame, off_profile, "
      "conformal, theory_range and coarse: what wheelrail contact warns of there.\n\n"
      "Example: railbook wheelrail table --speed 30m/s --load 40kN 50kN --slip -0.002 0 0.002 "
      "--out mine");
  return [options] { run(*options); };
}

}  // namespace

tool::Tool table_tool() {
  return {"table", "contact over shift, yaw, load, friction and slip", declare};
}

}  // namespace railbook::wheelrail_tool
