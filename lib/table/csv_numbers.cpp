// Cells as numbers.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

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

// Powers of ten, and behind them the same below zero. Digits and such a power are exact doubles, so
// that one division rounds as std::from_chars does (Clinger 1990).
constexpr auto tens = [] {
  std::array<double, 32> powers{1, -1};
  for (std::size_t i = 0; i < 30; ++i) powers[i + 2] = 10 * powers[i];
  return powers;
}();

// A decimal of at most 15 digits without an exponent, up to the first character behind it.
// Nothing for any other text.
const char* short_decimal(const char* at, char mark, double& value) {
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
          tens[2 * static_cast<std::size_t>(behind) + (negative ? 1 : 0)];
  return at;
}

// Any finite number; what follows it, or nothing. `mark` is its decimal point or comma.
const char* long_number(const char* at, const char* end, char mark, double& value) {
  if (*at == '+' && at[1] != '-') ++at;
  std::array<char, 64> text{};  // with a point
  const char* from = at;
  if (mark != '.') {
    if (end - at > std::ssize(text)) return nullptr;
    end = std::transform(at, end, text.data(), [mark](char c) {
      return c == mark ? '.' : c == '.' ? mark : c;
    });
    from = text.data();
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

// Which of 16 bytes are this one: a bit each.
std::uint64_t where(const char* at, char wanted) {
#ifdef __SSE2__
  const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
  const __m128i equal = _mm_cmpeq_epi8(bytes, _mm_set1_epi8(wanted));
  return static_cast<unsigned>(_mm_movemask_epi8(equal));
#else
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < 16; ++i) bits |= std::uint64_t{at[i] == wanted} << i;
  return bits;
#endif
}

// A cell that is a decimal of at most 15 digits and nothing else, `behind` of them behind a mark,
// without a branch on what they are. False for what else there is.
[[gnu::always_inline]] inline bool whole_decimal(const char* at, const char* end, bool marked,
                                                 std::ptrdiff_t behind, double& value) {
#ifdef __SSE2__
  alignas(16) static constexpr auto last = [] {  // from byte i on, the last i of 16
    std::array<unsigned char, 32> bytes{};
    std::fill(bytes.begin() + 16, bytes.end(), static_cast<unsigned char>(0xFF));
    return bytes;
  }();
  const auto load = [](const void* from) {
    return _mm_loadu_si128(static_cast<const __m128i*>(from));
  };
  const std::ptrdiff_t negative = *at == '-' ? 1 : 0, mark = marked ? 1 : 0;
  const auto digits = static_cast<std::size_t>(end - at - negative - mark);
  if (digits - 1 > 14) return false;
  // The digits in a row, zeros before them: those before the mark move up to close its place.
  const __m128i back = load(end - 16), up = load(end - 16 - mark);
  __m128i d = _mm_xor_si128(up, _mm_and_si128(_mm_xor_si128(up, back), load(&last[behind])));
  d = _mm_and_si128(_mm_sub_epi8(d, _mm_set1_epi8('0')), load(&last[digits]));
  const __m128i nine = _mm_set1_epi8(9);
  if (_mm_movemask_epi8(_mm_cmpeq_epi8(_mm_max_epu8(d, nine), nine)) != 0xFFFF) return false;
  // Added up to fours, to eights and to all, which is exact.
  d = _mm_add_epi32(
      _mm_madd_epi16(_mm_and_si128(d, _mm_set1_epi16(0xFF)), _mm_set1_epi32(0x000A03E8)),
      _mm_madd_epi16(_mm_srli_epi16(d, 8), _mm_set1_epi32(0x00010064)));
  d = _mm_madd_epi16(_mm_packs_epi32(d, d), _mm_set1_epi32(0x00012710));
  const __m128d eights = _mm_mul_pd(_mm_cvtepi32_pd(d), _mm_set_pd(1, 1e8));
  const double size = _mm_cvtsd_f64(_mm_add_sd(eights, _mm_unpackhi_pd(eights, eights)));
  value = size / tens[static_cast<std::size_t>(2 * behind + negative)];
  return true;
#else
  return false;
#endif
}

// Rows of plain numbers: what is asked for, and how they are written.
struct PlainRows {
  std::span<const std::size_t> columns;
  std::size_t last = 0, apart = 0;  // the last column; between the numbers of a row
  char separator = ',', mark = '.';
  bool undecided = false, point = false;  // whether numbers have a decimal point; one was seen
  const TwoParts* parts = nullptr;

  // A number between blanks or in quotes, or one that is no short decimal.
  [[gnu::noinline]] bool other_cell(const char* at, const char* end, std::size_t column,
                                    double& value) {
    if (column == last && end > at && end[-1] == '\r') --end;
    const bool quoted = *at == '"';
    if (quoted && (end - ++at < 1 || *--end != '"')) return false;
    while (!quoted && *at == ' ') ++at;
    while (!quoted && end > at && end[-1] == ' ') --end;
    const bool two = parts != nullptr && parts->column == column;
    const char own = quoted || mark != separator ? mark : '\n';
    const char* const point_at = std::find(at, end, own);
    const bool marked = point_at != end;
    if (two && in_two_parts(at, own, *parts, value) == end) return true;
    if (two && parts->alone == 0) return false;
    if (!whole_decimal(at, end, marked, marked ? end - point_at - 1 : 0, value) &&
        short_decimal(at, own, value) != end && long_number(at, end, own, value) != end)
      return false;
    if (undecided) point = point || std::find(at, end, '.') != end;
    if (two) value *= parts->alone;
    return true;
  }

  // Rows, up to one that is not plain; how many. `all` columns are wanted.
  template <bool all>
  std::size_t read(const char*& text, const char* end, double* values, std::size_t rows) {
    const char part = separator;
    const std::uint64_t markable = mark != separator ? ~std::uint64_t{0} : 0;
    const std::size_t odd = parts != nullptr && parts->alone != 1 ? parts->column : last + 1;
    // Of the 64 bytes from one on, a bit each: what may end a cell, and marks.
    const char* from = nullptr;
    std::uint64_t stops = 0, marks = 0;
    const auto look = [&](const char* at) {
      from = at;
      stops = marks = 0;
#pragma GCC unroll 4
      for (unsigned i = 0; i < 4; ++i, at += 16) {
        marks |= where(at, mark) << 16 * i;
        stops |= (where(at, part) | where(at, '\n')) << 16 * i;
        if (!all) stops |= (where(at, '"') | where(at, '\0')) << 16 * i;
      }
      marks &= markable;
    };
    const auto next_stop = [&](const char* at) {
      for (; stops == 0; at += 64) look(at);  // NOLINT(bugprone-infinite-loop): look finds stops
      const char* const stop = from + static_cast<unsigned>(std::countr_zero(stops));
      return stop;
    };
    bool open = undecided;
    std::uint64_t points = 0;
    std::size_t row = 0, seen = 0, in_sight = 1;  // rows; from where on 64 bytes hold so many
    for (const char* at = text; row < rows && at != end && *at != '#'; ++row, text = at) {
      if (seen-- == 0) {
        look(at);
        seen = in_sight - 1;
      }
      double* value = values + row;
      auto wanted = columns.begin();
      for (std::size_t column = 0; column <= last; ++column) {
        const char* stop = next_stop(at);
        if (!all && *stop == '"' && stop == at) {
          do stops &= stops - 1, stop = next_stop(stop + 1);
          while (*stop == part);
          const char* const behind = stop + 1;
          if (*stop != '"') return row;
          stops &= stops - 1;
          stop = next_stop(behind);
          if (stop - behind > (column == last && *behind == '\r' ? 1 : 0)) return row;
        }
        const std::uint64_t upto = stops ^ (stops - 1), marked = marks & upto;
        stops &= ~upto;
        marks &= ~upto;
        if (*stop != (column == last ? '\n' : part)) return row;
        if (all || (wanted != columns.end() && *wanted == column)) {
          const char *begin = at, *behind = stop;
          if (column == last && behind[-1] == '\r') --behind;
          if (*begin == '"' && behind[-1] == '"') ++begin, --behind;
          const std::ptrdiff_t digits =
              marked != 0 ? behind - from - 1 - static_cast<unsigned>(std::countr_zero(marked)) : 0;
          if (!whole_decimal(begin, behind, marked != 0, digits, *value) || column == odd) {
            if (!other_cell(at, stop, column, *value)) return row;
          } else {
            points |= marked;
          }
          value += apart;
          ++wanted;
        }
        at = stop + 1;
      }
      if (open && (points != 0 || point)) open = undecided = false, point = true;
      if (row == 0)
        in_sight = std::max<std::size_t>(1, 64 / static_cast<std::size_t>(at - text + 2));
    }
    return row;
  }

  // The same between blanks.
  std::size_t read_words(const char*& text, const char* end, double* values, std::size_t rows) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    std::size_t row = 0;
    for (const char* at = text; row < rows && at != end && *at != '#'; ++row, text = ++at) {
      std::size_t to = row;
      auto wanted = columns.begin();
      for (std::size_t column = 0; column <= last; ++column) {
        while (blank(*at)) ++at;
        const char* const word = at;
        while (!blank(*at) && *at != '\n' && *at != '"' && *at != '\0') ++at;
        if (at == word || !(blank(*at) || column == last)) return row;
        if (wanted == columns.end() || *wanted != column) continue;
        if (!other_cell(word, at, column, values[to])) return row;
        to += apart;
        ++wanted;
      }
      while (blank(*at)) ++at;
      if (*at != '\n') return row;
      if (point) undecided = false;
    }
    return row;
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
  std::size_t row = 0;
  if (separator_ == ' ')
    row = plain.read_words(at, end, values.data(), rows);
  else if (columns.size() == header_.size())
    row = plain.read<true>(at, end, values.data(), rows);
  else
    row = plain.read<false>(at, end, values.data(), rows);
  if (plain.point && !plain.undecided) decimal_ = '.';
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
  const bool both = cells_[column].find('.') != std::string_view::npos;
  const bool comma = cells_[column].find(',') != std::string_view::npos && separator_ == ',';
  refuse(fmt::format("column \"{}\" is \"{}\"; allowed: a finite number{}{}",
                     units::printable(header_[column]), units::printable(cells_[column]),
                     comma && both            ? " without a mark of thousands"
                     : comma && decimal_ == 0 ? " (--decimal comma if its comma is a decimal one)"
                                              : "",
                     decimal_ == 0     ? ""
                     : decimal_ == ',' ? ", with a decimal comma as before"
                                       : ", with a decimal point as before"));
}

}  // namespace railbook::table
