#include <railbook/table/csv.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include <railbook/table/detail/foreign_format.hpp>
#include <railbook/table/detail/trim.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/nearest.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_columns = 65536;

bool is_skipped(std::string_view line) {
  return line.starts_with('#') || line.find_first_not_of(" \t\r") == std::string_view::npos;
}

// How often the separator stands outside quotes.
std::size_t count(std::string_view line, char separator) {
  bool quoted = false;
  std::size_t n = 0;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    n += c == separator && !quoted ? 1U : 0U;
  }
  return n;
}

// The one that a header and the line after it have as often; else the one the header has most of.
char separator_of(std::string_view header, std::string_view row) {
  constexpr std::array candidates{'\t', ';', ','};
  for (const char c : candidates)
    if (count(header, c) > 0 && count(header, c) == count(row, c)) return c;
  return *std::max_element(candidates.begin(), candidates.end(), [&](char a, char b) {
    return count(header, a) < count(header, b) ||
           (count(header, a) == count(header, b) && b == ',');
  });
}

// Letters and digits, in lower case.
std::string folded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || byte > 127) result += static_cast<char>(std::tolower(byte));
  }
  return result;
}

bool parse(std::string_view cell, double& value) {
  const char *first = cell.data(), *last = first + cell.size();
  if (first != last && *first == '+') {
    ++first;
    if (first != last && *first == '-') return false;
  }
  const auto [end, status] = std::from_chars(first, last, value);
  return status == std::errc{} && end == last && first != last && std::isfinite(value);
}

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

CsvReader::CsvReader(const std::filesystem::path& file, std::size_t skip) : source_(file) {
  std::string_view text;
  for (; skip > 0; --skip)
    if (!raw_line(text)) refuse("has no more lines than are to be skipped");
  line_ = 1;
  do {
    if (!raw_line(text)) refuse("empty; allowed: a header line and rows");
  } while (is_skipped(text));
  first_ahead_ = source_.line();
  const auto more = [&] {
    if (ahead_.size() >= 100 || !raw_line(text)) return false;
    ahead_.emplace_back(text);
    return true;
  };
  // With the lines that its quotes go on in.
  const auto whole = [&] {
    std::string record{ahead_.back()};
    while (std::count(record.begin(), record.end(), '"') % 2 == 1 && record.size() <= 1 << 20 &&
           more())
      record += text;
    return record;
  };
  ahead_.emplace_back(text);
  const std::string header = whole();
  bool row = more();
  while (row && is_skipped(text)) row = more();
  separator_ = separator_of(header, row ? whole() : "");
  std::reverse(ahead_.begin(), ahead_.end());
  read_header();
}

void CsvReader::read_header() {
  const std::vector<std::string> lines = ahead_;
  const std::size_t first = first_ahead_;
  record();
  double ignored = 0;
  const auto is_number = [&](std::string_view cell) {
    std::string text{cell};
    if (separator_ != ',') std::replace(text.begin(), text.end(), ',', '.');
    return parse(text, ignored);
  };
  const bool none = std::all_of(cells_.begin(), cells_.end(), is_number);
  for (std::size_t i = 0; i < cells_.size(); ++i)
    header_.emplace_back(none || cells_[i].empty() ? std::to_string(i + 1)
                                                   : std::string{cells_[i]});
  if (!none) return;
  ahead_ = lines;
  first_ahead_ = first;
}

void CsvReader::refuse(const std::string& why) const {
  throw InputError{fmt::format("{}, line {}: {}", quoted_name(file()), line_, why)};
}

void CsvReader::require_column(std::size_t before) const {
  if (before >= most_columns)
    refuse(fmt::format("more than {} columns; allowed: up to as many", most_columns));
}

bool CsvReader::raw_line(std::string_view& text) {
  if (!source_.next(text)) return false;
  if (source_.line() == 1) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (const std::string_view format = foreign_format(text); !format.empty())
      throw InputError{fmt::format("{}: this is {}", quoted_name(file()), format)};
  }
  if (text.find('\0') != std::string_view::npos) {
    line_ = source_.line();
    refuse("holds a zero byte: not a text file");
  }
  return true;
}

// The next line that is not skipped, into its cells.
bool CsvReader::record() {
  std::string_view text;
  do {
    if (ahead_.empty()) {
      if (!raw_line(text)) return false;
      line_ = source_.line();
    } else {
      kept_ = std::move(ahead_.back());
      ahead_.pop_back();
      line_ = first_ahead_++;
      text = kept_;
    }
  } while (is_skipped(text));
  return split(text) || split_quoted(std::string{text});
}

// A line without quotes; false when it has one.
bool CsvReader::split(std::string_view text) {
  cells_.clear();
  if (text.ends_with('\r')) text.remove_suffix(1);
  const char* begin = text.data();
  const char* const end = begin + text.size();
  for (const char* at = begin;; ++at) {
    if (at == end || *at == separator_) {
      require_column(cells_.size());
      cells_.push_back(trim({begin, static_cast<std::size_t>(at - begin)}));
      if (at == end) return true;
      begin = at + 1;
    } else if (*at == '"') {
      return false;
    }
  }
}

// A line with cells in quotes, and the lines after it that such a cell goes on in.
bool CsvReader::split_quoted(std::string text) {
  enum class Found { all, open_quote, after_quote };
  const auto cut = [&]() {
    quoted_.clear();
    std::size_t i = 0;
    while (true) {
      std::string cell;
      if (i < text.size() && text[i] == '"') {
        for (++i;; ++i) {
          if (i >= text.size()) return Found::open_quote;
          if (text[i] != '"') {
            cell += text[i];
          } else if (i + 1 < text.size() && text[i + 1] == '"') {
            cell += text[i++];
          } else {
            break;
          }
        }
        ++i;
        if (i < text.size() && text[i] != separator_) return Found::after_quote;
      } else {
        const std::size_t end = std::min(text.find(separator_, i), text.size());
        cell = trim(std::string_view{text}.substr(i, end - i));
        i = end;
      }
      require_column(quoted_.size());
      quoted_.push_back(std::move(cell));
      if (i >= text.size()) return Found::all;
      ++i;
    }
  };
  for (int breaks = 0;; ++breaks) {
    const bool returned = text.ends_with('\r');
    if (returned) text.pop_back();
    const Found found = cut();
    if (found == Found::all) break;
    if (found == Found::after_quote)
      refuse(fmt::format("text after a closing quote; allowed: a {}", separator_ == ',' ? "comma"
                                                                      : separator_ == ';'
                                                                          ? "semicolon"
                                                                          : "tab"));
    std::string_view more;
    std::string kept;
    bool there = breaks < 100 && text.size() <= (1 << 20);
    if (there && !ahead_.empty()) {
      kept = std::move(ahead_.back());
      ahead_.pop_back();
      ++first_ahead_;
      more = kept;
    } else {
      there = there && raw_line(more);
    }
    if (!there) refuse("a quote is not closed");
    text += (returned ? "\r\n" : "\n") + std::string{more};
  }
  cells_.assign(quoted_.begin(), quoted_.end());
  return true;
}

const std::vector<CsvReader::Name>& CsvReader::names() const {
  for (std::size_t i = names_.size(); i < header_.size(); ++i) {
    const std::string name = parse_column(header_[i]).name;
    names_.push_back({name, folded(name), folded(header_[i])});
  }
  return names_;
}

std::optional<std::size_t> CsvReader::find(std::string_view name) const {
  std::vector<std::size_t> found;
  const auto collect = [&](const auto& fits) {
    for (std::size_t i = 0; i < header_.size() && found.size() < 2; ++i)
      if (fits(i)) found.push_back(i);
    if (found.size() > 1)
      throw InputError{fmt::format(
          "{}: column \"{}\" is there twice, as number {} and {}; allowed: the number of one",
          quoted_name(file()), units::printable(name), found[0] + 1, found[1] + 1)};
    return !found.empty();
  };
  const std::string fold = folded(name);
  if (collect([&](std::size_t i) { return header_[i] == name; }) ||
      collect([&](std::size_t i) { return names()[i].name == name; }) ||
      (!fold.empty() && collect([&](std::size_t i) {
        return names()[i].folded_header == fold || names()[i].folded_name == fold;
      })))
    return found[0];
  std::size_t number = 0;
  const std::string_view digits = name.starts_with('#') ? name.substr(1) : name;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc{} && end == digits.data() + digits.size() && number >= 1 &&
      number <= header_.size())
    return number - 1;
  return std::nullopt;
}

std::size_t CsvReader::column(std::string_view name) const {
  if (const auto found = find(name)) return *found;
  std::string there;
  for (const auto& h : header_) there += (there.empty() ? "" : ", ") + h;
  std::vector<std::string> known;
  for (const auto& n : names()) known.push_back(n.name);
  throw InputError{fmt::format("{}: no column \"{}\"; there are: {}{}", quoted_name(file()),
                               units::printable(name), units::printable(there, 1000),
                               units::did_you_mean(name, known))};
}

bool CsvReader::next() {
  if (!record()) return false;
  if (cells_.size() != header_.size())
    refuse(fmt::format("{} cells; allowed: {}, one a column", cells_.size(), header_.size()));
  return true;
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
  if (columns.empty() || !ahead_.empty() || decimal_ == ',') return 0;
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
  if (!parse(cell, value)) return is_missing(cell) ? nan : with_comma(column);
  if (separator_ != ',' && decimal_ != '.' && cell.find('.') != std::string_view::npos) {
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
  if (separator_ == ',' || at == std::string::npos || text.find('.') != std::string::npos ||
      decimal_ == '.')
    refuse_number(column);
  text[at] = '.';
  if (!parse(text, value)) refuse_number(column);
  decimal_ = ',';
  return value;
}

void CsvReader::refuse_number(std::size_t column) const {
  refuse(fmt::format("column \"{}\" is \"{}\"; allowed: a finite number{}",
                     units::printable(header_[column]), units::printable(cells_[column]),
                     decimal_ == 0     ? ""
                     : decimal_ == ',' ? ", with a decimal comma as before"
                                       : ", with a decimal point as before"));
}

}  // namespace railbook::table
