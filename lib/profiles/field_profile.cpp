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

std::vector<double> leading_numbers(std::string_view text) {
  std::vector<double> numbers;
  const bool decimal_comma = text.find(';') != std::string_view::npos;
  const char* separators = decimal_comma ? " \t;" : " \t,;";
  while (true) {
    const auto begin = text.find_first_not_of(separators);
    if (begin == std::string_view::npos) return numbers;
    text.remove_prefix(begin);
    const auto end = std::min(text.find_first_of(separators), text.size());
    std::string cell(text.substr(0, end));
    if (decimal_comma) cell += ';';
    const auto number = numbers_of(cell);
    if (!number || number->size() != 1) return numbers;
    numbers.push_back(number->front());
    text.remove_prefix(end);
  }
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

namespace {

// A wheel's sides may be measured higher up than its flange is high; they lie at its two ends.
bool wheel_downward(const std::vector<Point>& points) {
  constexpr double side = 0.006;  // m
  const auto [outer, inner] = std::ranges::minmax_element(points, {}, &Point::u);
  std::vector<double> heights;
  for (const Point& p : points)
    if (p.u > outer->u + side && p.u < inner->u - side) heights.push_back(p.z);
  if (heights.empty()) return false;
  std::ranges::sort(heights);
  const double middle = heights[heights.size() / 2];
  return heights.back() - middle > middle - heights.front();
}

// The width of the parts that lie within 5 mm of a height: a rail's head is wide at its top, and a
// groove beside it narrow at its bottom.
double width_near(const std::vector<Point>& points, double z) {
  double width = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (std::abs(points[i - 1].z - z) < 0.005 && std::abs(points[i].z - z) < 0.005)
      width += std::abs(points[i].u - points[i - 1].u);
  return width;
}
bool rail_downward(const std::vector<Point>& points) {
  const auto [low, high] = std::ranges::minmax_element(points, {}, &Point::z);
  return width_near(points, low->z) > width_near(points, high->z);
}

}  // namespace

void turn_upright(FieldProfile& read, Body body) {
  std::vector<Point>& points = read.points;
  if (points.empty()) return;
  if (!(body == Body::wheel ? wheel_downward(points) : rail_downward(points))) return;
  for (Point& p : points) p.z = -p.z;
  read.format += ", heights downward";
}

void place_wheel(FieldProfile& read) {
  constexpr double from_back = 0.030, from_tape = 0.070, tape = 0.070;  // m
  constexpr double flange = 0.010;                                      // m, below the tread
  std::vector<Point>& points = read.points;
  if (points.empty()) return;
  const double tip = std::ranges::min_element(points, {}, &Point::z)->u;
  const auto [outer, inner] = std::ranges::minmax_element(points, {}, &Point::u);
  const bool turned = tip < 0.5 * (outer->u + inner->u);
  if (turned) {
    for (Point& p : points) p.u = -p.u;
    read.format += ", y inward";
  }
  std::vector<double> heights;
  for (const Point& p : points) heights.push_back(p.z);
  std::ranges::sort(heights);
  if (heights[heights.size() / 2] - heights.front() < flange) return;
  const double at = turned ? -tip : tip;
  if (std::abs(at) < from_back) {
    for (Point& p : points) p.u += tape;
    read.moved += tape;
    read.format += ", from the back of the flange";
  } else if (at < 0 || at > from_tape) {
    read.warnings.push_back(
        {"origin",
         fmt::format("the flange's tip is {:.1f} mm from the file's origin, which is neither the "
                     "tape circle nor the back of the flange: see --datum",
                     at * 1e3),
         0, 0});
  }
}

}  // namespace detail

std::optional<FieldProfile> parse_field_profile(std::string_view text, Body body,
                                                const FieldOptions& options) {
  using namespace detail;
  if (options.section.value_or(1) > 1 && !contains(text, "points]"))
    throw InputError(fmt::format(
        "section {} is asked for, and the file has none; allowed: a MiniProf file of sections",
        *options.section));
  const std::vector<Line> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i].text;
    if (line.empty()) continue;
    if (line.starts_with('<')) return std::nullopt;  // XML
    if (contains(line, "MDI_HEADER"))
      throw InputError(fmt::format(
          "line {}: this is a property file of ADAMS, whose form is not published; allowed: its "
          "points in two plain columns, across and height",
          lines[i].number));
    if (contains(line, "wheelprofile") || contains(line, "railprofile"))
      return read_vampire({lines.begin() + std::ptrdiff_t(i), lines.end()}, body);
    if (line.starts_with("header.begin") || line.starts_with("spline.begin"))
      return read_simpack(lines, body);
    if (contains(line, "U_OFFSET") || contains(line, "TH_OFFSET") || contains(line, "NSLC"))
      throw InputError(fmt::format(
          "line {}: this is a list of slices {} (.slcs, .slcw), with the names of its sections; "
          "allowed: one section, such as one of those files",
          lines[i].number, contains(text, "TH_OFFSET") ? "round a wheel" : "along a rail"));
    if (contains(line, "miniprof") || contains(line, "[fileinfo]") ||
        (setting_of(line) && std::isalpha(static_cast<unsigned char>(line.front())) != 0))
      return read_miniprof(lines, body, options);
    if (contains(line, "inward") && !line.starts_with('#')) return std::nullopt;
    if (const auto numbers = numbers_of(without_comment(line)); numbers && numbers->size() > 1)
      break;
  }
  return read_plain(lines, body, options);
}

}  // namespace railbook::profiles
