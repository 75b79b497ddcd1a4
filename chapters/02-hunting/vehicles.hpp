// The four vehicles of the paper's Figure 11 with their branches, and single cycles of the full equations: computed once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dynamics/continuation.hpp"
#include "dynamics/cycle_branch.hpp"
#include "dynamics/examine.hpp"
#include "dynamics/history.hpp"
#include "report/item.hpp"
#include "wheelrail/paper_pairs.hpp"

namespace railbook::hunting_chapter {

struct Vehicle {
  std::string key;   // "new", "cn", "heumann", "friction"
  std::string name;  // for tables
  const wheelrail::ConstraintFunctions* table;
  double flange;  // displacement up to which the tables are those of the tread [m]
  dynamics::Suspension suspension;
  dynamics::QuasiLinearCar car;
  std::vector<dynamics::HopfPoint> hopf;        // of the linear car, up to 400 ft/s
  std::vector<dynamics::CycleBranch> branches;  // one a Hopf point
  std::size_t main = 0;                         // the branch of the paper's figure
  const dynamics::CycleBranch& main_branch() const { return branches[main]; }
};
const std::vector<Vehicle>& vehicles();
// By key; throws std::logic_error for an unknown one.
const Vehicle& vehicle(std::string_view key);
// The branch of the full equations from the same critical speed; computed once, when it is asked for.
const dynamics::LimitCycleBranch& true_branch(std::string_view key);
// "new", "cn" and "heumann": the three with dampers.
inline constexpr int with_dampers = 3;

// The displacement up to which the left wheel stands on its tread, not on the throat, curved by less than 2 in; less
// half the width of the tables' running mean [m].
double flange_begins(const wheelrail::WheelsetOnTrack& pair);

// Why an item is rebuilt.
inline constexpr const char* rebuilt_reason =
    "the paper's profiles, its equivalent dampers and the sticking of its friction are not in it; "
    "those used are stated";

struct CycleCase {
  std::string name;  // "new wheel, 150 ft/s"
  const Vehicle* vehicle = nullptr;
  dynamics::CyclePoint quasi;  // the describing-function cycle
  dynamics::Oscillator car;
  dynamics::Examined examined;  // balance with 23 harmonics, shooting, multipliers
};
// The cycle of a vehicle's main branch at a speed [m/s], `which` in order along it.
CycleCase cycle_case(const Vehicle& vehicle, double speed, std::size_t which = 0);
// New wheel, 150 ft/s.
const CycleCase& example_cycle();

// Half of peak to peak of the largest wheelset [m].
double largest_amplitude(const dynamics::Oscillator& car, const dynamics::Cycle& cycle);
double largest_amplitude(const dynamics::Oscillator& car, const dynamics::Orbit& orbit);
// Integration that watches the four wheelsets.
dynamics::HistoryOptions watching(const dynamics::Oscillator& car, double tolerance = 1e-9);
// Of the wheelset that swings most, over the last periods.
dynamics::Swing largest_swing(const dynamics::History& history, int periods);
// The state of a describing-function cycle at phase 0.
Eigen::VectorXd state_of(const dynamics::Motion& motion);

}  // namespace railbook::hunting_chapter
