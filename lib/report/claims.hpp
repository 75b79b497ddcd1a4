// Statements of a chapter, as a table: data/claims.csv has the words, the bounds and the reason,
// the program only gives the numbers that it found.
//
//   check,claim,outcome,holds,found,why
//   fig-03/averages,averaging reduces the variance,confirmed,..0.5,"to {1:.2f} of it",
//   fig-11/cluster,all points cluster,consistent,0.5..; ..2,"{:.2f} to {:.2f}","near has no
//   measure"
//
//   item.claims({{"averages", {averaged / single, averaged}}});
//
// `holds` has an interval for each number in turn, its ends included; one end or both may be left
// out. `found` is an fmt format of all numbers. `why` is the reason of a consistent claim, or the
// method of a verified statement on our own program or model.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/report/expectation.hpp>
#include <railbook/report/trial.hpp>

namespace railbook::report {

struct Interval {
  double from, to;  // infinite where there is no end
};

// One row of claims.csv.
struct ClaimRow {
  std::string check, claim;
  Outcome outcome;  // confirmed, consistent or verified
  std::vector<Interval> holds;
  std::string found, why;
};

// What a program found for a claim of its item; a claim with a trial must hold in each variation.
struct FoundClaim {
  std::string_view id;
  std::vector<double> numbers;
  std::optional<Trial> trial = {};
};

// Throws InputError when the file is not of this form: a check twice or of none of `items`, an
// outcome that is none of the three, a reason missing or too much, an interval from more to less.
std::vector<ClaimRow> read_claims(const std::filesystem::path& file,
                                  const std::vector<std::string>& items);

// Whether each number lies in its interval; NaN never does. Throws std::logic_error for fewer
// numbers than intervals.
bool holds(const ClaimRow& row, const std::vector<double>& numbers);
// The row's words with the numbers in them.
std::string found_text(const ClaimRow& row, const std::vector<double>& numbers);

}  // namespace railbook::report
