// The four vehicles of the paper's Figure 11 with their branches, and single cycles of the full
// equations: computed once.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/cycles/continuation.hpp>
#include <railbook/cycles/history.hpp>
#include <railbook/report/item.hpp>
#include <railbook/vehicle/creep_limit.hpp>
#include <railbook/vehicle/cycle_branch.hpp>
#include <railbook/vehicle/refine_cycle.hpp>
#include <railbook/wheelset/paper_pairs.hpp>

#include "sections.hpp"

namespace railbook::hunting_chapter {

using namespace cycles;
using namespace vehicle;
using units::foot, units::inch, units::nan;

inline constexpr double table_mean = 0.02 * inch;  // width of the tables' running mean

struct Range {
  double low = 1e9, high = 0;
  double width() const { return high - low; }
  void add(double x) {
    if (x < low) low = x;
    if (x > high) high = x;
  }
  // "126 to 147 ft/s", with a number of digits after the point.
  std::string text(int digits, const char* unit) const;
};

struct Vehicle {
  std::string key;   // "new", "cn", "heumann", "friction"
  std::string name;  // for tables
  const wheelset::ConstraintFunctions* table;
  double flange, jump;  // displacements at which flange contact begins and jumps to the flange [m]
  QuasiLinearCar car;
  std::vector<HopfPoint> hopf;        // of the linear car, up to 400 ft/s
  std::vector<CycleBranch> branches;  // one a Hopf point
  std::size_t main = 0;               // the branch of the paper's figure
  const CycleBranch& main_branch() const { return branches[main]; }
  bool friction() const { return key == "friction"; }
};
const std::vector<Vehicle>& vehicles();
// By key; throws std::logic_error for an unknown one.
const Vehicle& vehicle(std::string_view key);
// The branch of the full equations from the same critical speed; computed once, when it is asked
// for.
const LimitCycleBranch& true_branch(std::string_view key);
// The table of new wheels with another running mean or another distance of knots [m].
wheelset::ConstraintFunctions new_wheel_table(double running_mean, double knot = 0.0025 * inch);
// The branch of the full equations from the first critical speed of any car, as far as `go_on`
// says. Where two-point contact is a jump of the tables, steps of 1e-6, the usual floor, are too
// long.
LimitCycleBranch branch_with(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                             const std::optional<CreepLimit>& creep = {},
                             const std::function<bool(const LimitCycle&)>& go_on = {},
                             double smallest_step = 1e-10);
// A stretch of a branch of the full equations that is stable with flange contact [ft/s], between
// located points, and by what its stability ends ("fold"; empty: the branch ends).
struct StableStretch {
  Range speeds;
  std::string loss;
};
std::vector<StableStretch> stable_stretches(const LimitCycleBranch& branch, double flange);
// From the slowest to the fastest speed of these stretches; on our branches they follow each other
// without a gap.
Range stable_on_flange(const LimitCycleBranch& branch, double flange);
Range stable_on_flange(const Vehicle& v);
// The largest wheelset of the truck that swings less, on stable cycles by the paper's rule [m]; and
// with other dampers that fit.
double both_trucks(const CycleBranch& branch);
double both_trucks_with(double rotation, const Vehicle& v);
// "new", "cn" and "heumann": the three with dampers.
inline constexpr std::size_t damped_cars = 3;

// Where flange contact begins: the last displacement at which the left wheel stands on its tread
// and not on the arc between tread and flange, less half the width of the tables' running mean [m].
double flange_begins(const wheelset::WheelsetOnTrack& pair, double running_mean = table_mean);
// The first displacement at which two points touch, and contact jumps to the flange [m].
double flange_jump(const wheelset::WheelsetOnTrack& pair);
// The first critical speed [ft/s] of other data on a vehicle's wheels, its frequency [rad/s] and
// the phase between front and rear truck [degrees]; NaN if there is none.
struct Critical {
  double speed, omega, phase;
};
Critical first_critical(const CarParameters& data, const Vehicle& v);

// The paper's friction as dampers by two numbers: omega A of the translations [m/s] and omega theta
// of the rotations [rad/s].
CarParameters with_dampers(double translation, double rotation, CarParameters data = {});
// The translation at which the first critical speed with new wheels is 145 ft/s, for a rotation.
double translation_for(double rotation, CarParameters data = {});
// A car with such dampers.
FreightCar car_for(double rotation);

// Why an item is rebuilt.
inline constexpr const char* rebuilt_reason =
    "profiles, dampers and the sticking rates of friction are ours";
// Columns of one format.
inline std::vector<report::Heading> headings(const char* format,
                                             std::initializer_list<const char*> titles) {
  std::vector<report::Heading> all;
  for (const char* title : titles) all.emplace_back(title, format);
  return all;
}

// Front and rear exchanged.
Motion exchanged(Motion motion);

struct CycleCase {
  std::string name;  // "new wheel, 150 ft/s"
  const Vehicle* vehicle = nullptr;
  CyclePoint quasi;  // the describing-function cycle
  Oscillator car;
  RefinedCycle examined;  // balance with 23 harmonics, shooting, multipliers
};
// The cycle of a vehicle's main branch at a speed [ft/s], `which` in order along it.
CycleCase cycle_case(std::string_view key, double speed, std::size_t which = 0);
// New wheel, 150 ft/s.
const CycleCase& example_cycle();

// A vehicle's car at a speed [ft/s], and a state with both trucks aside [in].
Oscillator car_at(std::string_view key, double speed);
Eigen::VectorXd aside(double inches);
// Integration that watches the four wheelsets, and the swing of the one that swings most, over the
// last periods.
History run(const Oscillator& moving, const Eigen::VectorXd& y, double duration,
            Integrator integrator, double tolerance = 1e-9);
Swing largest_swing(const History& history, int periods);
// The state of a describing-function cycle at phase 0.
Eigen::VectorXd state_of(const Motion& motion);

}  // namespace railbook::hunting_chapter
