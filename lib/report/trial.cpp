#include <railbook/report/trial.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <railbook/report/tolerance.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::report {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return "";
  return std::string{text.substr(first, text.find_last_not_of(' ') - first + 1)};
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(';', start), list.size());
    parts.push_back(trimmed(list.substr(start, end - start)));
    start = end + 1;
  }
  return parts;
}

template <class List, class Value>
bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

void require_variation(const TrialRow& row, const std::string& where) {
  if (row.choice.empty())
    throw InputError{where + ": choice is empty; allowed: the words for what is varied"};
  for (std::size_t i = 0; i < row.settings.size(); ++i) {
    if (row.settings[i].empty()) throw InputError{where + ": settings has an empty one"};
    if (std::count(row.settings.begin(), row.settings.end(), row.settings[i]) > 1)
      throw InputError{fmt::format("{}: settings has \"{}\" twice", where, row.settings[i])};
  }
  if (row.settings.size() < 2)
    throw InputError{where + ": settings has one only; allowed: two or more, with semicolons"};
}

}  // namespace

std::vector<TrialRow> read_trials(const std::filesystem::path& file,
                                  const std::vector<std::string>& items) {
  const table::CsvTable table = table::read_table(file);
  std::vector<TrialRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    TrialRow row{table.at(i, "check"), table.at(i, "choice"), table.at(i, "unit"),
                 split(table.at(i, "settings"))};
    const std::string where = fmt::format("file \"{}\", row {}", file.string(), i + 1);
    if (!contains(items, row.check.substr(0, row.check.find('/'))))
      throw InputError{fmt::format(
          "{}: check is \"{}\"; allowed: a check of an item of the chapter", where, row.check)};
    require_variation(row, where);
    for (const TrialRow& other : rows)
      if (other.check == row.check && other.choice == row.choice)
        throw InputError{
            fmt::format("{}: choice \"{}\" of {} is there twice", where, row.choice, row.check)};
    rows.push_back(std::move(row));
  }
  return rows;
}

Trial::Trial(std::string quantity, std::string format, Expected stands, std::vector<TrialRow> rows)
    : quantity_(std::move(quantity)),
      format_(std::move(format)),
      stands_(std::move(stands)),
      rows_(std::move(rows)) {
  if (rows_.empty()) throw std::logic_error{"a trial without a row in data/trials.csv"};
}

void Trial::vary(std::string_view choice, const std::function<double(const Setting&)>& result) {
  const auto row = std::find_if(rows_.begin(), rows_.end(),
                                [&](const TrialRow& r) { return r.choice == choice; });
  if (row == rows_.end())
    throw std::logic_error{fmt::format("data/trials.csv does not declare \"{}\"", choice)};
  if (std::any_of(variations_.begin(), variations_.end(),
                  [&](const Variation& v) { return v.choice == choice; }))
    throw std::logic_error{fmt::format("\"{}\" is varied twice", choice)};
  Variation variation{row->choice, {}, {}};
  for (const std::string& text : row->settings) {
    const std::string shown = row->unit.empty() ? text : text + " " + row->unit;
    variation.results.push_back(
        result(Setting{shown, printed_number(text), variation.settings.size()}));
    variation.settings.push_back(shown);
  }
  variations_.push_back(std::move(variation));
}

bool Trial::stands() const {
  return objection().empty();
}

std::string Trial::objection() const {
  for (const TrialRow& row : rows_)
    if (std::none_of(variations_.begin(), variations_.end(),
                     [&](const Variation& v) { return v.choice == row.choice; }))
      return row.choice + " was not varied";
  for (const Variation& v : variations_)
    for (std::size_t i = 0; i < v.results.size(); ++i)
      if (std::isnan(v.results[i]) || !stands_(v.results[i]))
        return fmt::format("{} {}: {}", v.choice, v.settings[i], show(v.results[i]));
  return "";
}

std::string Trial::show(double result) const {
  return std::isnan(result) ? "no result" : fmt::format(fmt::runtime(format_), result);
}

std::string Trial::range() const {
  Variation all;
  for (const Variation& v : variations_)
    all.results.insert(all.results.end(), v.results.begin(), v.results.end());
  return range_of(all);
}

std::string Trial::range_of(const Variation& v) const {
  double least = units::nan, most = units::nan;  // fmin and fmax pass over a NaN
  for (const double r : v.results) least = std::fmin(least, r), most = std::fmax(most, r);
  const std::string low = show(least), high = show(most);
  if (low == high) return low;
  // The unit once: "145 to 160 ft/s".
  const std::size_t at = low.find(' '), high_at = high.find(' ');
  const bool same_unit = at != std::string::npos && high_at != std::string::npos &&
                         low.substr(at) == high.substr(high_at);
  return fmt::format("{} to {}", same_unit ? low.substr(0, at) : low, high);
}

Trial::Expected misses(std::string_view printed) {
  const double value = printed_number(printed), half = half_last_digit(printed);
  return [value, half](double result) { return std::abs(result - value) > half; };
}

}  // namespace railbook::report
