#include <railbook/profiles/field_profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <railbook/profiles/detail/field_lines.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles {
namespace detail {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\f\v";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<Line> lines_of(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::vector<Line> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    lines.push_back({trimmed(text.substr(0, end)), lines.size() + 1});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool contains(std::string_view text, std::string_view part) {
  return lower(text).find(lower(part)) != std::string::npos;
}

std::string_view without_comment(std::string_view text) {
  text = text.substr(0, text.find_first_of("#%!\""));
  return trimmed(text.substr(0, text.find("//")));
}

std::optional<std::vector<double>> numbers_of(std::string_view text) {
  const bool decimal_comma = text.find(';') != std::string_view::npos;
  std::vector<double> numbers;
  std::string cell;
  const auto take = [&] {
    if (cell.empty()) return true;
    if (cell.front() == '+') cell.erase(0, 1);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
      return false;
    numbers.push_back(value);
    cell.clear();
    return true;
  };
  for (const char c : text) {
    const bool parts = c == ' ' || c == '\t' || c == ';' || (c == ',' && !decimal_comma);
    if (!parts)
      cell += c == ',' ? '.' : c == 'D' || c == 'd' ? 'e' : c;
    else if (!take())
      return std::nullopt;
  }
  if (!take()) return std::nullopt;
  return numbers;
}

std::optional<Setting> setting_of(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || text.starts_with('"')) return std::nullopt;
  std::string_view value = trimmed(text.substr(equals + 1));
  if (value.size() >= 2 && value.front() == '\'' && value.back() == '\'')
    value = value.substr(1, value.size() - 2);
  return Setting{lower(trimmed(text.substr(0, equals))), value};
}

double number_of(const Setting& setting, const Line& line) {
  const auto numbers = numbers_of(without_comment(setting.value));
  if (!numbers || numbers->size() != 1)
    throw InputError(fmt::format("line {}: {} is \"{}\"; allowed: one number", line.number,
                                 setting.key, setting.value));
  return numbers->front();
}

void refuse_line(const Line& line, const char* format) {
  throw InputError(
      fmt::format("line {}: \"{}\" is no point of a {} file; allowed: two numbers or "
                  "more",
                  line.number, line.text.substr(0, 40), format));
}

bool turn_upright(std::vector<Point>& points, Body body) {
  const auto [low, high] = std::ranges::minmax_element(points, {}, &Point::z);
  bool down = false;
  if (body == Body::wheel) {
    std::vector<double> heights;
    for (const Point& p : points) heights.push_back(p.z);
    const auto middle = heights.begin() + std::ptrdiff_t(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    down = high->z - *middle > *middle - low->z;
  } else {
    const double ends = 0.5 * (points.front().z + points.back().z);
    down = high->z - ends < ends - low->z;
  }
  if (down)
    for (Point& p : points) p.z = -p.z;
  return down;
}

}  // namespace detail

std::optional<FieldProfile> parse_field_profile(std::string_view text, Body body) {
  using namespace detail;
  const std::vector<Line> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i].text;
    if (line.empty()) continue;
    if (contains(line, "wheelprofile") || contains(line, "railprofile"))
      return read_vampire({lines.begin() + std::ptrdiff_t(i), lines.end()}, body);
    if (line.starts_with("header.begin") || line.starts_with("spline.begin"))
      return read_simpack(lines);
    if (contains(line, "miniprof") || contains(line, "[fileinfo]") ||
        (setting_of(line) && std::isalpha(static_cast<unsigned char>(line.front())) != 0))
      return read_miniprof(lines, body);
    if (contains(line, "inward") && !line.starts_with('#')) return std::nullopt;
    if (const auto numbers = numbers_of(without_comment(line)); numbers && numbers->size() > 1)
      break;
  }
  return read_plain(lines, body);
}

}  // namespace railbook::profiles
