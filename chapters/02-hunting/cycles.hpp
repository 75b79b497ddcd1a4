// The limit cycles that the sections on balance, time and multipliers share: solved once.
#pragma once

#include <string>
#include <vector>

#include "dynamics/examine.hpp"
#include "dynamics/history.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

struct CycleCase {
  std::string key;   // "new-150"
  std::string name;  // for tables: "new wheel, 150 ft/s"
  const Study* study = nullptr;
  double speed = 0;            // [m/s]
  dynamics::CyclePoint quasi;  // the describing-function cycle
  dynamics::Oscillator car;
  dynamics::Examined examined;  // balance with 23 harmonics, shooting, multipliers
};
const std::vector<CycleCase>& cycle_cases();
// By key; throws std::logic_error for an unknown one.
const CycleCase& cycle_case(const std::string& key);

// Half of peak to peak of the largest wheelset [m].
double largest_amplitude(const dynamics::Oscillator& car, const dynamics::Cycle& cycle);
// Integration that watches the four wheelsets.
dynamics::HistoryOptions watching(const dynamics::Oscillator& car, double tolerance = 1e-9);
// Of the wheelset that swings most, over the last periods.
dynamics::Swing largest_swing(const dynamics::History& history, int periods);
// The state of a describing-function cycle at phase 0.
Eigen::VectorXd state_of(const dynamics::Motion& motion);

}  // namespace railbook::hunting_chapter
