// The four cases of the paper's Figure 11, traced once and shared by the tables and figures of the chapter.
#pragma once

#include <string>
#include <vector>

#include "dynamics/cycle_branch.hpp"
#include "dynamics/examine.hpp"

namespace railbook::hunting_chapter {

struct Study {
  std::string key;   // "new", "cn", "heumann", "friction"
  std::string name;  // for tables
  const wheelrail::ConstraintFunctions* table;
  dynamics::Suspension suspension;
  dynamics::QuasiLinearCar car;
  std::vector<dynamics::HopfPoint> hopf;        // of the linear car, up to 400 ft/s
  std::vector<dynamics::CycleBranch> branches;  // one a Hopf point
  std::size_t main = 0;                         // the branch of the paper's figure
  const dynamics::CycleBranch& main_branch() const { return branches[main]; }
};
const std::vector<Study>& studies();
// By key; throws std::logic_error for an unknown one.
const Study& study(const std::string& key);

// Cycles of the main branches with Hill's leading exponent and the true cycle nearby; computed once.
struct Labelled {
  const Study* study;
  dynamics::CyclePoint point;
  dynamics::Complex exponent;
  dynamics::Examined truth;
};
const std::vector<Labelled>& labelled_cycles();

// "new", "cn" and "heumann": the three with dampers.
inline constexpr int linear_studies = 3;

}  // namespace railbook::hunting_chapter
