// What a solver says of itself against what is true: its error estimates, its digits, its worst
// case over random ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/report/item.hpp>

namespace railbook::bench {

// One run of a solver that states its error. Both relative, or both in one unit.
struct Estimate {
  std::string label;  // the case
  double stated = 0;
  double truth =
      0;  // against a reference whose own error is at most a hundredth of it, or of what is stated
};

// The share of the runs whose true error is at most the stated one; NaN without runs.
double covered(const std::vector<Estimate>& runs);

// A figure of true over stated errors, and one check, "covered": at least `least` of the runs are.
// Gives the prose
// {{<item>/covered}} ("98 % of 400") and {{<item>/median-margin}}, the median of stated over true.
void estimates_against_truth(report::Item& item, const std::vector<Estimate>& runs,
                             double least = 0.95);

// A function's largest error over its range against extended precision, in units of the last place
// of the result.
struct Digits {
  std::string id;        // of the check
  std::string function;  // "K(m)"
  std::string range;     // "0 <= m < 1"
  std::string against;   // "series in 80-bit arithmetic"
  double allowed = 0;    // relative error, set beforehand
  double worst = 0;      // relative error found
  double at = 0;         // its argument
};

// `exact(x)` in extended precision at each x; an exact zero must be met exactly. NaN is an error
// without bound.
template <class Function, class Exact>
Digits worst_digits(Digits row, const std::vector<double>& arguments, const Function& function,
                    const Exact& exact) {
  for (const double x : arguments) {
    const long double truth = exact(x);
    const long double off = std::abs(static_cast<long double>(function(x)) - truth);
    const double error = off == 0 ? 0 : static_cast<double>(off / std::abs(truth));
    if (std::isnan(error) || error > row.worst) row.worst = error, row.at = x;
    if (std::isnan(error)) break;
  }
  return row;
}

// The table of them, a row and a check each; says how many of the 15.95 digits of a double are
// lost.
void digits_table(report::Item& item, const std::vector<Digits>& rows);

using num::RandomStream;  // case k of a sweep has stream k

// The worst of `cases` random runs: `run` draws its case and returns what came out, with its error.
// A solver that says that it has no answer throws report::NoAnswer and is counted; an error that is
// NaN without a word is the worst there is. The text of the worst says which case it was.
struct Worst {
  report::Found found{"", 0};
  int cases = 0, unanswered = 0;
};
Worst worst_of(int cases, std::uint64_t seed,
               const std::function<report::Found(RandomStream&)>& run);

// The stability row of that worst; more than `may_refuse` cases without an answer are a refusal of
// the row.
void worst_row(report::Item& item, const report::StabilityCase& c, int cases, std::uint64_t seed,
               const std::function<report::Found(RandomStream&)>& run, int may_refuse = 0);

}  // namespace railbook::bench
