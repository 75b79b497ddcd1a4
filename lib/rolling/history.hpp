// A contact of Hertz's pressure along a history of loads, creepages, forces and shifts.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <railbook/rolling/case.hpp>

namespace railbook::rolling {

// What is done to the contact at a distance rolled. Between two rows all is linear in the distance;
// a row at the distance of the one before it changes what it has without rolling. The first row
// presses a fresh contact, free of tractions, and shifts it.
struct HistoryRow {
  double distance = 0;       // [m], not below that of the row before
  double load = 0;           // [N], > 0
  Creepage creepage;         // while rolling on
  std::optional<double> fx;  // [N], below mu N, in place of the longitudinal creepage or shift
  double shift_x = 0, shift_y = 0;  // of body 1 over body 2 [m], where nothing rolls
};

struct HistoryOptions {
  Eigen::Index along = 24;   // cells along the contact under its largest load; >= 4, even
  bool extrapolate = true;   // with cells of twice the size, to cells of no size: errors
  double dissimilarity = 0;  // Kalker's K of unlike bodies (material_pair.hpp)
};

// After a step: the contact rolled by one cell, or was shifted at a row.
struct HistoryStep {
  Eigen::Index row = 0;  // of the history, to or at which it went
  bool rolled = false;
  double distance = 0;              // [m]
  double load = 0;                  // [N]
  Creepage creepage;                // given or found; 0 where nothing rolled
  double shift_x = 0, shift_y = 0;  // given or found [m]; 0 where it rolled
  CreepForces forces;  // without tractions; `error` and `mz_error` over mu N of this load
  double motion_error = not_known;  // of a longitudinal creepage or shift [m] that was found
};

// Kalker's full theory in steps (transient.hpp). `c` has the semi-axes at its load, both grow with
// the cube root of the load (Hertz); its creepage is not used. Places of the rows are rounded to
// cells, and cells fill the contact, which is of first order in the cells: a second answer on cells
// of twice the size takes this error away, and half of what it changes is the error that is
// stated (24 cells: some 1 % of a creepage that is found on the way to steady rolling). The part
// that sticks is that of the smaller cells. Throws InputError on a history that is empty or goes
// back, on a row out of range, named by its number from 1, and on more than 100,000 steps. A step
// that is not solved ends the answer; its forces say why.
std::vector<HistoryStep> roll_history(const RollingCase& c, const std::vector<HistoryRow>& rows,
                                      const HistoryOptions& options = {});

}  // namespace railbook::rolling
