// The branches of limit cycles that `hunting cycle` follows from a critical speed.
#pragma once

#include <string>
#include <vector>

#include <railbook/cycles/continuation.hpp>
#include <railbook/vehicle/linear_stability.hpp>

namespace railbook::hunting_tool {

// A branch, how it is called in the files and in the answer.
struct NamedBranch {
  std::string key, name;
  cycles::LimitCycleBranch branch;
};

// Ends the search after a number of points of all branches, the same on every machine; shows the
// latest point to somebody who waits.
class PointLimit {
 public:
  explicit PointLimit(long most) : most_(most) {}
  ~PointLimit() { clear(); }
  PointLimit(const PointLimit&) = delete;
  PointLimit& operator=(const PointLimit&) = delete;
  bool add(const cycles::LimitCycle& p);  // false at the last one
  bool reached() const { return points_ >= most_; }
  void clear() const;

 private:
  long most_, points_ = 0;
};

// The branch of a critical speed itself, `number` the lowest being 1, then those that leave it
// where symmetry breaks or the period doubles.
std::vector<NamedBranch> follow_all(const cycles::Family& family, const vehicle::HopfPoint& hopf,
                                    long number, const cycles::ContinuationOptions& walk,
                                    const PointLimit& limit);

}  // namespace railbook::hunting_tool
