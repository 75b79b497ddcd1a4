// A number of the bank beside ours, and what a set of them says.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <railbook/units/constants.hpp>

namespace railbook::peer_bank {

inline constexpr double mm = units::millimetre, mpa = units::megapascal;  // the bank's units

// `same` is our answer on the bank's own cells, `fine` on cells of half the size, `limit` what the
// two lead to with cells of no size: of a history, whose cells make a first-order error in both,
// twice the change; of all else `fine`, whose error is of a higher order. A value is `small` when
// it is below 2 % of the largest that the quantity can have in this case: its few digits, and a
// relative difference, say little then.
struct Comparison {
  std::string file;
  int number = 0;  // of the case in its file
  std::string quantity;
  double theirs = 0, same = 0, fine = 0;
  bool small = false, history = false;
  double limit() const { return history ? 2 * fine - same : fine; }
};

inline double log_ratio(double ours, double theirs) {
  return ours / theirs > 0 ? std::log(ours / theirs) : INFINITY;
}

// agrees: fine within 1 %. cells: not, but on the bank's own cells we are, so that its cells make
// the difference. differs: neither.
enum class Outcome { agrees, cells, differs, small };
inline Outcome outcome(const Comparison& c) {
  constexpr double allowed = 0.01;
  if (c.small) return Outcome::small;
  if (std::abs(log_ratio(c.fine, c.theirs)) <= allowed) return Outcome::agrees;
  if (std::abs(log_ratio(c.same, c.theirs)) <= allowed) return Outcome::cells;
  return Outcome::differs;
}

// Of ln(ours/theirs), ours on the finer cells: mean and standard deviation over the comparisons
// that are not small and whose signs agree; and the mean of the limit.
struct Statistics {
  int count = 0, agree = 0, cells = 0, differ = 0, small = 0;
  double bias = 0, scatter = 0, limit = 0;
  double explained() const { return count > 0 ? double(agree + cells) / count : 1; }
};

inline std::map<std::string, Statistics> statistics(const std::vector<Comparison>& all) {
  std::map<std::string, Statistics> found;
  std::map<std::string, std::vector<double>> logs;
  for (const Comparison& c : all) {
    Statistics& s = found[c.quantity];
    const Outcome o = outcome(c);
    if (o == Outcome::small) {
      ++s.small;
      continue;
    }
    ++s.count;
    ++(o == Outcome::agrees ? s.agree : o == Outcome::cells ? s.cells : s.differ);
    const double x = log_ratio(c.fine, c.theirs);
    if (!std::isfinite(x)) continue;
    logs[c.quantity].push_back(x);
    s.limit += log_ratio(c.limit(), c.theirs);
  }
  for (auto& [quantity, x] : logs) {
    Statistics& s = found[quantity];
    double sum = 0, squares = 0;
    for (double v : x) sum += v;
    s.bias = sum / double(x.size());
    s.limit /= double(x.size());
    for (double v : x) squares += (v - s.bias) * (v - s.bias);
    s.scatter = x.size() > 1 ? std::sqrt(squares / double(x.size() - 1)) : 0;
  }
  return found;
}

}  // namespace railbook::peer_bank
