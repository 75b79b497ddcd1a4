// What a table's first lines say of how it is written.
#include <railbook/table/detail/dialect.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

#include <railbook/table/dates.hpp>
#include <railbook/table/detail/parse_number.hpp>
#include <railbook/table/detail/trim.hpp>

namespace railbook::table {
namespace {

constexpr std::string_view blanks = " \t\r";

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

// Also of a position such as 12+345,6.
bool is_number(std::string_view word) {
  std::string text{word};
  if (const std::size_t plus = text.find('+', 1); plus != text.npos) text.erase(plus, 1);
  std::replace(text.begin(), text.end(), ',', '.');
  double ignored = 0;
  return parse_number(text, ignored);
}

}  // namespace

bool is_skipped(std::string_view line) {
  return line.starts_with('#') || line.find_first_not_of(blanks) == std::string_view::npos;
}

std::vector<std::string_view> words_of(std::string_view line, std::size_t columns) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  for (std::size_t i = 1; columns > 0 && words.size() > columns && i < words.size(); ++i) {
    const std::string_view last = words[i];
    if (!is_date_or_time(words[i - 1]) || !(is_clock(last) || last == "AM" || last == "PM"))
      continue;
    const char* const begin = words[i - 1].data();
    words[i - 1] = {begin, static_cast<std::size_t>(last.data() + last.size() - begin)};
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i--));
  }
  return words;
}

std::vector<std::string_view> headers_of(std::string_view line, std::size_t columns) {
  std::vector<std::string_view> apart;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
    const std::size_t end = std::min(line.find("  ", at), line.size());
    std::string_view one = trim(line.substr(at, end - at));
    if (one.ends_with('\r')) one = trim(one.substr(0, one.size() - 1));
    apart.push_back(one);
    at = line.find_first_not_of(blanks, end);
  }
  return apart.size() == columns ? apart : words_of(line);
}

char separator_of(std::string_view header, const std::vector<std::string>& lines) {
  constexpr std::array candidates{'\t', ';', ',', '|'};
  const std::string_view row = lines.empty() ? std::string_view{} : lines.front();
  for (const char c : candidates)
    if (count(header, c) > 0 && count(header, c) == count(row, c)) return c;
  const auto has = [&](char c) { return count(header, c) > 0; };
  if (std::none_of(candidates.begin(), candidates.end(), has)) {
    for (const std::string& line : lines) {
      const auto words = words_of(line, words_of(header).size());
      if (std::count_if(words.begin(), words.end(), is_number) < 2) continue;
      const bool as_many = words_of(header).size() == words.size() ||
                           headers_of(header, words.size()).size() == words.size();
      return as_many ? ' ' : ',';
    }
  }
  return *std::max_element(candidates.begin(), candidates.end(), [&](char a, char b) {
    return count(header, a) < count(header, b) ||
           (count(header, a) == count(header, b) && b == ',');
  });
}

}  // namespace railbook::table
