#include <railbook/report/claims.hpp>

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include <railbook/report/tolerance.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::report {
namespace {

Outcome outcome_of(const std::string& text, const std::string& where) {
  for (const Outcome outcome : {Outcome::confirmed, Outcome::consistent, Outcome::verified})
    if (text == name(outcome)) return outcome;
  throw InputError{
      fmt::format("{}: outcome is \"{}\"; allowed: confirmed, consistent, verified", where, text)};
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

double end_of(std::string_view text, double none, const std::string& where) {
  if (text.empty()) return none;
  const double value = printed_number(std::string{text});
  if (value == value) return value;
  throw InputError{fmt::format("{}: holds has \"{}\"; allowed: a number", where, text)};
}

Interval interval_of(std::string_view text, const std::string& where) {
  constexpr double all = units::infinity;
  if (text.empty()) return {-all, all};
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos)
    throw InputError{fmt::format("{}: holds has \"{}\"; allowed: from..to", where, text)};
  const Interval interval{end_of(text.substr(0, dots), -all, where),
                          end_of(text.substr(dots + 2), all, where)};
  if (interval.from > interval.to)
    throw InputError{fmt::format("{}: holds has \"{}\", from more to less", where, text)};
  return interval;
}

std::vector<Interval> intervals_of(std::string_view list, const std::string& where) {
  std::vector<Interval> intervals;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(';'), list.size());
    intervals.push_back(interval_of(trimmed(list.substr(0, end)), where));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return intervals;
}

}  // namespace

std::vector<ClaimRow> read_claims(const std::filesystem::path& file,
                                  const std::vector<std::string>& items) {
  const table::CsvTable table = table::read_table(file);
  std::vector<ClaimRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string where = fmt::format("file \"{}\", row {}", file.string(), i + 1);
    const ClaimRow row{table.at(i, "check"),
                       table.at(i, "claim"),
                       outcome_of(table.at(i, "outcome"), where),
                       intervals_of(table.at(i, "holds"), where),
                       table.at(i, "found"),
                       table.at(i, "why")};
    const std::string item = row.check.substr(0, row.check.find('/'));
    if (std::find(items.begin(), items.end(), item) == items.end())
      throw InputError{fmt::format(
          "{}: check is \"{}\"; allowed: a check of an item of the chapter", where, row.check)};
    if (row.claim.empty() || row.found.empty())
      throw InputError{where + ": claim or found is empty; allowed: words"};
    if (row.why.empty() != (row.outcome == Outcome::confirmed))
      throw InputError{where + ": why is for what is consistent or verified, and only for that"};
    if (std::any_of(rows.begin(), rows.end(),
                    [&](const ClaimRow& other) { return other.check == row.check; }))
      throw InputError{fmt::format("{}: check {} is there twice", where, row.check)};
    rows.push_back(row);
  }
  return rows;
}

bool holds(const ClaimRow& row, const std::vector<double>& numbers) {
  if (numbers.size() < row.holds.size())
    throw std::logic_error{fmt::format("{}: {} numbers for {} intervals", row.check, numbers.size(),
                                       row.holds.size())};
  for (std::size_t i = 0; i < row.holds.size(); ++i)
    if (!(numbers[i] >= row.holds[i].from && numbers[i] <= row.holds[i].to)) return false;
  return true;
}

std::string found_text(const ClaimRow& row, const std::vector<double>& numbers) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const double number : numbers) arguments.push_back(number);
  return fmt::vformat(row.found, arguments);
}

}  // namespace railbook::report
