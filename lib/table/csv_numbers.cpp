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

unsigned digit(char c) {
  return static_cast<unsigned>(c) - '0';
}

// Digits are added to a number; where they end.
const char* add_digits(const char* at, std::uint64_t& number) {
  for (; digit(*at) < 10; ++at) number = 10 * number + digit(*at);
  return at;
}

// A decimal of at most 15 digits without an exponent, up to the first character that is none of it:
// its digits and its power of ten are exact doubles, so that one division rounds as std::from_chars
// does (Clinger 1990). Nothing for what else there is.
[[gnu::always_inline]] inline const char* short_decimal(const char* at, char mark, double& value) {
  static constexpr std::array<double, 16> tens{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = *at == '-';
  at += negative ? 1 : 0;
  const char* const first = at;
  std::uint64_t digits = 0;
  at = add_digits(at, digits);
  std::ptrdiff_t count = at - first, behind = 0;
  if (count == 0 || count > 15) return nullptr;
  if (*at == mark) {
    const char* const point = ++at;
    at = add_digits(at, digits);
    behind = at - point;
    count += behind;
  }
  if (count > 15 || *at == 'e' || *at == 'E') return nullptr;
  value = static_cast<double>(static_cast<std::int64_t>(digits)) /
          tens[static_cast<std::size_t>(behind)];
  if (negative) value = -value;
  return at;
}

// Any finite number; what follows it, or nothing. `mark` is its decimal point or comma, or neither.
const char* long_number(const char* at, const char* end, char mark, double& value) {
  if (*at == '+' && at[1] != '-') ++at;
  std::array<char, 64> text;  // with a point
  const char* from = at;
  if (mark != '.') {
    std::size_t size = 0;
    while (size < text.size() && (digit(at[size]) < 10 || at[size] == mark || at[size] == 'e' ||
                                  at[size] == 'E' || at[size] == '-' || at[size] == '+')) {
      text[size] = at[size] == mark ? '.' : at[size];
      ++size;
    }
    if (size == text.size()) return nullptr;
    from = text.data(), end = from + size;
  }
  const auto [stop, status] = std::from_chars(from, end, value);
  return status == std::errc{} && std::isfinite(value) ? at + (stop - from) : nullptr;
}

// 12+345.6, a whole number and another behind a plus.
const char* in_two_parts(const char* at, char mark, const TwoParts& parts, double& value) {
  const bool negative = *at == '-';
  at += negative ? 1 : 0;
  const char* const first = at;
  std::uint64_t digits = 0;
  at = add_digits(at, digits);
  if (at == first || at - first > 15 || *at != '+' || digit(at[1]) > 9) return nullptr;
  double rest = 0;
  const char* const behind = short_decimal(at + 1, mark, rest);
  const auto whole = static_cast<double>(static_cast<std::int64_t>(digits));
  value = parts.first * (negative ? -whole : whole) + parts.second * rest;
  return behind;
}

// Rows of plain numbers: what is asked for, and how they are written.
struct PlainRows {
  std::span<const std::size_t> columns;
  std::size_t last = 0, apart = 0;  // the last column; between the numbers of a row
  char separator = ',', mark = '.';
  bool undecided = false, point = false;  // whether numbers have a decimal point; one was seen
  const TwoParts* parts = nullptr;
  std::array<bool, 256> ends{};  // the characters that end a bare cell

  const char* skip(const char* at) const {
    while (!ends[static_cast<unsigned char>(*at)]) ++at;
    return at;
  }

  [[gnu::always_inline]] const char* number(const char* at, const char* end, std::size_t column,
                                            char own, double& value) {
    const char* behind = short_decimal(at, own, value);
    const bool two = parts != nullptr && parts->column == column;
    if (two && behind != nullptr && *behind == '+') return in_two_parts(at, own, *parts, value);
    if (two && parts->alone == 0) return nullptr;
    if (behind == nullptr) behind = long_number(at, end, own, value);
    if (behind == nullptr) return nullptr;
    if (undecided) point = point || std::find(at, behind, '.') != behind;
    if (two) value *= parts->alone;
    return behind;
  }

  // One row; nothing when it is not plain. There is a line feed before the end.
  const char* read(const char* at, const char* end, double* values) {
    if (*at == '#') return nullptr;
    const char bare = mark == separator ? '\0' : mark;  // of cells without quotes
    auto wanted = columns.begin();
    for (std::size_t column = 0; column <= last; ++column, ++at) {
      const char* const cell = at;
      while (*at == ' ') ++at;
      if (wanted == columns.end() || *wanted != column) {
        at = skip(at);
        if (*at == '"' && at == cell) {
          do at = skip(at + 1);
          while (*at == separator);
          if (*at++ != '"') return nullptr;
        }
      } else {
        const bool quoted = *at == '"';
        if (quoted && at != cell) return nullptr;
        at = number(quoted ? at + 1 : at, end, column, quoted ? mark : bare, *values);
        if (at == nullptr || (quoted && *at++ != '"')) return nullptr;
        while (!quoted && *at == ' ') ++at;
        values += apart;
        ++wanted;
      }
      if (*at == '\r' && column == last) ++at;
      if (*at != (column == last ? '\n' : separator)) return nullptr;
    }
    return at;
  }

  // The same between blanks.
  const char* read_words(const char* at, const char* end, double* values) {
    if (*at == '#') return nullptr;
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    auto wanted = columns.begin();
    for (std::size_t column = 0; column <= last; ++column) {
      while (blank(*at)) ++at;
      const char* const word = at;
      if (wanted == columns.end() || *wanted != column) {
        at = skip(at);
      } else {
        at = number(at, end, column, mark, *values);
        values += apart;
        ++wanted;
      }
      if (at == nullptr || at == word || !(blank(*at) || column == last)) return nullptr;
    }
    while (blank(*at)) ++at;
    return *at == '\n' ? at + 1 : nullptr;
  }
};

bool is_missing(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.size() > 9) return false;
  std::string lower{cell};
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* word : {"nan", "na", "n/a", "#n/a", "null", "nv", "-", "--", "-nan", "nan(ind)",
                           "-nan(ind)", "1.#qnan", "-1.#ind"})
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

std::size_t CsvReader::numbers(std::span<const std::size_t> columns, std::span<double> values,
                               const TwoParts* parts) {
  if (columns.empty() || !ahead_.empty()) return 0;
  const std::string_view text = source_.lines_ahead();
  const char *at = text.data(), *const end = at + text.size();
  const std::size_t rows = values.size() / columns.size();
  PlainRows plain{.columns = columns,
                  .last = header_.size() - 1,
                  .apart = rows,
                  .separator = separator_,
                  .mark = decimal_ == ',' ? ',' : '.',
                  .undecided = separator_ != ',' && decimal_ == 0,
                  .parts = parts};
  for (const char c : {'\n', '"', '\0', separator_})
    plain.ends[static_cast<unsigned char>(c)] = true;
  if (separator_ == ' ') plain.ends['\t'] = plain.ends['\r'] = true;
  std::size_t row = 0;
  for (; row < rows && at != end; ++row) {
    const char* const next = separator_ == ' ' ? plain.read_words(at, end, values.data() + row)
                                               : plain.read(at, end, values.data() + row);
    if (next == nullptr) break;
    at = next;
    if (plain.point) decimal_ = '.', plain.undecided = false;
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
