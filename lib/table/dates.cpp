#include <railbook/table/dates.hpp>

#include <algorithm>
#include <cstddef>

namespace railbook::table {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Takes up to `most` digits off the front: how many there were.
std::size_t take_digits(std::string_view& text, std::size_t most) {
  std::size_t count = 0;
  while (count < std::min(most, text.size()) && is_digit(text[count])) ++count;
  text.remove_prefix(count);
  return count;
}

bool take(std::string_view& text, std::string_view one_of) {
  if (text.empty() || one_of.find(text.front()) == text.npos) return false;
  text.remove_prefix(1);
  return true;
}

// Off the front of the text, with whether it was there.
bool take_date(std::string_view& text) {
  const std::size_t first = take_digits(text, 4);
  const char mark = text.empty() ? '\0' : text.front();
  if (first == 0 || first == 3 || !take(text, "-./") || take_digits(text, 2) == 0 ||
      !take(text, {&mark, 1}))
    return false;
  const std::size_t last = take_digits(text, first == 4 ? 2 : 4);
  return last != 0 && last != 3 && (text.empty() || !is_digit(text.front()));
}

bool take_clock(std::string_view& text) {
  if (take_digits(text, 2) == 0) return false;
  std::size_t parts = 1;
  for (; parts < 3 && text.size() > 2 && text.front() == ':'; ++parts) {
    text.remove_prefix(1);
    if (take_digits(text, 2) != 2) return false;
  }
  if (parts == 3 && take(text, ".,")) take_digits(text, 12);
  if (!take(text, "Zz") && take(text, "+-")) {
    take_digits(text, 2);
    take(text, ":");
    take_digits(text, 2);
  }
  return parts > 1;
}

}  // namespace

bool is_date(std::string_view text) {
  return take_date(text) && text.empty();
}

bool is_clock(std::string_view text) {
  return take_clock(text) && text.empty();
}

bool is_date_or_time(std::string_view text) {
  std::string_view rest = text;
  if (take_date(rest)) {
    if (rest.empty()) return true;
    if (!take(rest, "Tt ")) return false;
    while (take(rest, " ")) {
    }
    text = rest;
  }
  for (const std::string_view half : {" AM", " PM", " am", " pm"})
    if (text.ends_with(half)) text.remove_suffix(half.size());
  return is_clock(text);
}

}  // namespace railbook::table
