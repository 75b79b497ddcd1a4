// Cells as numbers.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include <railbook/table/csv.hpp>
#include <railbook/table/detail/parse_number.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A decimal of at most 15 digits without an exponent, up to the first character that is none of it:
// its digits and its power of ten are exact doubles, so that one division rounds as std::from_chars
// does (Clinger 1990). Nothing for what else there is. A character that ends it must follow.
const char* short_decimal(const char* at, double& value) {
  static constexpr std::array<double, 16> tens{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const auto digit = [](char c) { return static_cast<unsigned>(c) - '0'; };
  const bool negative = *at == '-';
  at += negative ? 1 : 0;
  const char* const first = at;
  std::uint64_t digits = 0;
  while (digit(*at) < 10) digits = 10 * digits + digit(*at++);
  std::ptrdiff_t count = at - first, behind = 0;
  if (count == 0 || count > 15) return nullptr;
  if (*at == '.') {
    const char* const point = ++at;
    while (digit(*at) < 10) digits = 10 * digits + digit(*at++);
    behind = at - point;
    count += behind;
  }
  if (count > 15 || *at == 'e' || *at == 'E') return nullptr;
  value = static_cast<double>(static_cast<std::int64_t>(digits)) /
          tens[static_cast<std::size_t>(behind)];
  if (negative) value = -value;
  return at;
}

// A finite number and the blanks around it; what follows it, or nothing.
const char* plain_number(const char* at, const char* end, double& value) {
  while (*at == ' ') ++at;
  const char* behind = short_decimal(at, value);
  if (behind == nullptr) {
    const auto [stop, status] = std::from_chars(at, end, value);
    if (status != std::errc{} || !std::isfinite(value)) return nullptr;
    behind = stop;
  }
  while (*behind == ' ') ++behind;
  return behind;
}

bool is_missing(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.size() > 4) return false;
  std::string lower{cell};
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* word : {"nan", "na", "n/a", "#n/a", "null", "nv", "-", "--"})
    if (lower == word) return true;
  return false;
}

}  // namespace

bool parse_number(std::string_view cell, double& value) {
  const char *first = cell.data(), *last = first + cell.size();
  if (first != last && *first == '+') {
    ++first;
    if (first != last && *first == '-') return false;
  }
  const auto [end, status] = std::from_chars(first, last, value);
  return status == std::errc{} && end == last && first != last && std::isfinite(value);
}

// One of them, its numbers `rows` apart; nothing when it is not plain. There is a line feed before
// the end.
const char* CsvReader::plain_row(const char* at, const char* end,
                                 std::span<const std::size_t> columns, double* values,
                                 std::size_t rows) {
  if (*at == '#') return nullptr;
  const std::size_t last = header_.size() - 1;
  const bool undecided = separator_ != ',' && decimal_ == 0;
  bool point = false;
  auto wanted = columns.begin();
  for (std::size_t column = 0; column <= last; ++column, ++at) {
    const char stop = column == last ? '\n' : separator_;
    if (wanted == columns.end() || *wanted != column) {
      while (*at != separator_ && *at != '\n' && *at != '"' && *at != 0) ++at;
    } else {
      const char* const behind = plain_number(at, end, *values);
      if (behind == nullptr) return nullptr;
      point = point || (undecided && std::find(at, behind, '.') != behind);
      at = behind;
      if (*at == '\r' && column == last) ++at;
      values += rows;
      ++wanted;
    }
    if (*at != stop) return nullptr;
  }
  if (point) decimal_ = '.';
  return at;
}

std::size_t CsvReader::numbers(std::span<const std::size_t> columns, std::span<double> values) {
  if (columns.empty() || !ahead_.empty() || decimal_ == ',' || separator_ == ' ') return 0;
  const std::string_view text = source_.lines_ahead();
  const char *at = text.data(), *const end = at + text.size();
  const std::size_t rows = values.size() / columns.size();
  std::size_t row = 0;
  for (; row < rows && at != end; ++row) {
    const char* const next = plain_row(at, end, columns, values.data() + row, rows);
    if (next == nullptr) break;
    at = next;
  }
  source_.use(static_cast<std::size_t>(at - text.data()), row);
  if (row > 0) line_ = source_.line();
  return row;
}

double CsvReader::number(std::size_t column) const {
  const std::string_view cell = cells_[column];
  double value = 0;
  constexpr std::string_view minus = "\xE2\x88\x92";  // as text programs write it
  if (cell.starts_with(minus) && cell.size() < 40) {
    std::string text{cell};
    std::replace(text.begin(), text.end(), decimal_ == ',' ? ',' : '.', '.');
    if (parse_number(text.replace(0, minus.size(), "-"), value)) return value;
  }
  if (!parse_number(cell, value)) return is_missing(cell) ? nan : with_comma(column);
  if ((separator_ != ',' || decimal_ == ',') && decimal_ != '.' &&
      cell.find('.') != std::string_view::npos) {
    if (decimal_ == ',') refuse_number(column);
    decimal_ = '.';
  }
  return value;
}

// A number with a decimal comma, where the file can have one.
double CsvReader::with_comma(std::size_t column) const {
  std::string text{cells_[column]};
  const std::size_t at = text.find(',');
  double value = 0;
  if ((separator_ == ',' && decimal_ != ',') || at == std::string::npos ||
      text.find('.') != std::string::npos || decimal_ == '.')
    refuse_number(column);
  text[at] = '.';
  if (!parse_number(text, value)) refuse_number(column);
  decimal_ = ',';
  return value;
}

void CsvReader::refuse_number(std::size_t column) const {
  const bool comma = separator_ == ',' && cells_[column].find(',') != std::string_view::npos;
  refuse(
      fmt::format("column \"{}\" is \"{}\"; allowed: a finite number{}{}",
                  units::printable(header_[column]), units::printable(cells_[column]),
                  comma && decimal_ == 0 ? " (--decimal comma if its comma is a decimal one)" : "",
                  decimal_ == 0     ? ""
                  : decimal_ == ',' ? ", with a decimal comma as before"
                                    : ", with a decimal point as before"));
}

}  // namespace railbook::table
