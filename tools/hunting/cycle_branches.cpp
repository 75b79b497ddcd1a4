#include "hunting/cycle_branches.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <railbook/units/constants.hpp>

namespace railbook::hunting_tool {

using namespace cycles;

namespace {

// Of points that branches leave at, the one where this branch has come back: it is the same branch
// from its other end.
void erase_end(std::vector<SpecialCycle>& left, const LimitCycleBranch& branch) {
  if (branch.stop != BranchStop::joined || left.empty()) return;
  const auto apart = [&end = branch.points.back()](const SpecialCycle& s) {
    return std::hypot(s.at.parameter / end.parameter - 1, s.at.largest / end.largest - 1);
  };
  const auto nearest = std::ranges::min_element(left, {}, apart);
  if (apart(*nearest) < 0.05) left.erase(nearest);
}

}  // namespace

bool PointLimit::add(const LimitCycle& p) {
  ++points_;
  if (isatty(STDERR_FILENO) != 0)
    fmt::print(stderr, "\r{:70}\rpoint {}: {:.5g}, {:.4g} mm, {} harmonics ", "", points_,
               p.parameter, p.largest / units::millimetre, p.cycle.orders.back());
  return !reached();
}

void PointLimit::clear() const {
  if (points_ > 0 && isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r{:70}\r", "");
}

std::vector<NamedBranch> follow_all(const Family& family, const vehicle::HopfPoint& hopf,
                                    long number, const ContinuationOptions& walk,
                                    const PointLimit& limit) {
  std::vector<NamedBranch> all;
  const vehicle::Motion& m = hopf.motion;
  all.push_back({"branch", fmt::format("branch of critical speed {}", number),
                 follow_from_hopf(family, m.shape, m.lambda.imag(), m.speed, walk)});
  std::vector<SpecialCycle> left = all.front().branch.special;
  std::erase_if(left, [](const SpecialCycle& s) {
    return s.kind != CycleEvent::symmetry_breaking && s.kind != CycleEvent::period_doubling;
  });
  while (!left.empty() && !limit.reached()) {
    const SpecialCycle s = left.front();
    left.erase(left.begin());
    LimitCycleBranch next = follow_secondary(family, s, walk);
    if (next.points.empty()) continue;
    erase_end(left, next);
    const auto count = all.size();
    all.push_back({fmt::format("secondary_{}", count),
                   fmt::format("branch {} of {}", count, to_string(s.kind)), std::move(next)});
  }
  return all;
}

}  // namespace railbook::hunting_tool
