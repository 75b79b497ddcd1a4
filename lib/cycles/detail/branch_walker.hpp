// Steps along a branch of limit cycles, with the harmonics that each point needs; for
// continuation.cpp.
#pragma once

#include <vector>

#include <railbook/cycles/detail/branch_solver.hpp>

namespace railbook::cycles {

class BranchWalker {
 public:
  BranchWalker(const Family& family, std::vector<int> orders, const ContinuationOptions& options)
      : solver(family, std::move(orders)), options_(options), step_(0.25 * options.largest_step) {}

  BranchSolver solver;
  LimitCycleBranch branch;

  // Solves for the point where normal . (x - p) = 0 (SI direction) and begins the branch there,
  // along `towards`. `far`: p may be a poor start.
  bool begin(const BranchPoint& p, const VectorXd& normal, const VectorXd& towards,
             bool far = false);

  void walk();

  // `slope`: how much of the branch's direction is the parameter's.
  LimitCycle describe(const BranchPoint& p, double slope);
  double slope(const VectorXd& direction) const {
    const VectorXd t = solver.scaled_direction(direction);
    return t[t.size() - 1];
  }

 private:
  bool advance();
  bool close(Eigen::VectorXd x, const Eigen::VectorXd& t, double slope, LimitCycle point);

  // Adapts the harmonics at the present place. True when they changed.
  bool settle();

  // What happens on the step from `from` along t to the point at step_, with the direction `next`
  // there; `crossed` when another branch was passed.
  void find_special(const VectorXd& from, const VectorXd& t, const VectorXd& next,
                    const LimitCycle& point, bool crossed);

  // Of the step to `next` until it is at the branch's first cycle again; 0: it is not.
  double part_to_first(const LimitCycle& next) const;
  void stop_if_done();
  void erase_false_folds();

  const ContinuationOptions& options_;
  BranchPoint at_;
  VectorXd along_;  // SI, as BranchSolver::direction
  double step_;
  int orientation_ = 0;  // at the last point; 0: not known
};

}  // namespace railbook::cycles
