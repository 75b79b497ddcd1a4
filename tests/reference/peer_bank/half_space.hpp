// The bank's cases of two half-spaces whose gap is a paraboloid (half_space.csv), and our answers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <railbook/contact/grid.hpp>
#include <railbook/rolling/transient.hpp>

#include "comparison.hpp"

namespace railbook::peer_bank {

// One row of the table, in its units (mm, N, MPa); NaN where a cell is empty. README.md explains
// the columns.
struct HalfSpaceCase {
  std::string file, kind, reason;
  int number = 0, fresh = 0;
  double nu1, nu2, g1, g2, mu, curvature_x, curvature_y, nx, ny, x0, y0, dx, dy;
  double load, pen, cksi, fx_share, ceta, fy_share, cphi, chi, dq;
  double fn, approach, p_max, contact_cells, stick_cells, fx, fy, mz, motion_x;
};

std::vector<HalfSpaceCase> read_half_space(const std::string& file);

// The steady cases of creep_table.csv on the bank's 11 x 11 cells: their creepages and forces are
// made of its reduced ones.
std::vector<HalfSpaceCase> read_creep_table(const std::string& file);

// The normal contact on the case's own cells, each parted into `finer` by `finer`; seen along the
// direction of rolling. SI.
struct Normal {
  contact::Grid grid;
  Eigen::VectorXd p;
  double approach = 0, force = 0, p_max = 0, area = 0;
};
Normal solve_normal(const HalfSpaceCase& c, int finer);

// A contact of this pressure to be shifted and rolled.
std::unique_ptr<rolling::Transient> start_history(const HalfSpaceCase& c, const Normal& n);

// The answers to the cases of one file of the bank, in its order: a transient goes on from the case
// before. A normal contact that a file repeats is compared once. Throws std::runtime_error when a
// solver does not converge.
struct HalfSpaceAnswers {
  std::vector<Comparison> comparisons;
  int answered = 0;     // cases with an answer to every kind of force asked for
  int normal_only = 0;  // cases of which only the normal contact is answered
  int refused = 0;      // cases without any answer; their rows have the reason
};
HalfSpaceAnswers answer(const std::vector<HalfSpaceCase>& cases);

}  // namespace railbook::peer_bank
