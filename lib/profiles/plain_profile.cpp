// Plain columns of numbers, as CONTACT, GENSYS and tables after UIC 519 have them.
//
// Two columns, across and height, parted by blanks, tabs, commas or semicolons; more columns may
// follow, and a first one may count the rows. The file states neither unit nor signs. The unit
// follows from the width: a profile is 20 to 250 mm wide, so metres, inches and millimetres exclude
// one another. Signs follow from the shape: a wheel has its flange below its tread and on its inner
// side, a rail its top inside. Which side of a rail is the gauge side does not follow: y is taken
// as outward, as the program CONTACT does, and a warning says so unless both sides are alike.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/profiles/detail/field_lines.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles::detail {
namespace {

constexpr std::size_t fewest = 8;

struct Unit {
  const char* name;
  double metre;
};
std::optional<Unit> unit_of(double width) {
  for (const Unit& unit :
       {Unit{"metres", 1}, {"inches", units::inch}, {"millimetres", units::millimetre}})
    if (width * unit.metre > 0.02 && width * unit.metre < 0.25) return unit;
  return std::nullopt;
}

// The middle between the two sides of a rail at a height, by straight lines between the points; NaN
// where one of them does not reach it.
double middle_at(const std::vector<Point>& points, double z) {
  double low = units::infinity, high = -units::infinity;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i];
    if ((a.z - z) * (b.z - z) > 0 || a.z == b.z) continue;
    const double u = a.u + (z - a.z) / (b.z - a.z) * (b.u - a.u);
    low = std::min(low, u), high = std::max(high, u);
  }
  return low < high ? 0.5 * (low + high) : units::nan;
}

// Whether that middle moves by more than 0.3 mm from 1 to 12 mm below the top.
bool lopsided(const std::vector<Point>& points) {
  const double top = std::ranges::max_element(points, {}, &Point::z)->z;
  double low = units::infinity, high = -units::infinity;
  for (int k = 1; k <= 12; ++k) {
    const double middle = middle_at(points, top - k * units::millimetre);
    if (std::isnan(middle)) continue;
    low = std::min(low, middle), high = std::max(high, middle);
  }
  return high - low > 0.3 * units::millimetre;
}

}  // namespace

std::optional<FieldProfile> read_plain(const std::vector<Line>& lines, Body body) {
  FieldProfile read{"plain columns", {}, {}, {}};
  std::vector<std::vector<double>> rows;
  for (const Line& line : lines) {
    const auto text = without_comment(line.text);
    if (text.empty()) continue;
    const auto numbers = numbers_of(text);
    if (numbers && numbers->size() > 1) {
      rows.push_back(*numbers);
      continue;
    }
    if (!rows.empty() && rows.size() >= fewest) refuse_line(line, "plain");
    read.left_out.push_back(
        {"header", fmt::format("line {}, \"{}\"", line.number, text.substr(0, 40)), 0, 0});
  }
  if (rows.size() < fewest) return std::nullopt;
  const std::size_t columns = rows.front().size();
  bool counted = columns > 2;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != columns)
      throw InputError(
          fmt::format("row {} of the points has {} columns, the first one {}; "
                      "allowed: as many in each",
                      i + 1, rows[i].size(), columns));
    counted = counted && rows[i][0] == rows[0][0] + double(i);
  }
  const std::size_t first = counted ? 1 : 0;
  for (const auto& row : rows) read.points.push_back({row[first], row[first + 1]});
  const auto [left, right] = std::ranges::minmax_element(read.points, {}, &Point::u);
  const auto [low, high] = std::ranges::minmax_element(read.points, {}, &Point::z);
  const double width = right->u - left->u;
  const auto unit = unit_of(width);
  if (!unit || high->z - low->z > 1.3 * width)
    throw InputError(
        fmt::format("the points span {:.4g} by {:.4g} in their own unit; allowed: across and "
                    "height of one side, 20 to 250 mm wide, in millimetres, metres or inches",
                    width, high->z - low->z));
  read.format += fmt::format(", {} by their width", unit->name);
  for (Point& p : read.points) p = {-p.u * unit->metre, p.z * unit->metre};
  if (turn_upright(read.points, body)) read.format += ", heights downward";
  if (body == Body::wheel) {
    const auto flange = std::ranges::min_element(read.points, {}, &Point::z)->u;
    const auto [inner, outer] = std::ranges::minmax_element(read.points, {}, &Point::u);
    if (flange < 0.5 * (inner->u + outer->u)) {
      for (Point& p : read.points) p.u = -p.u;
      read.format += ", y inward";
    }
  } else if (lopsided(read.points)) {
    read.warnings.push_back(
        {"side", "the file does not say which side is the gauge side: y was taken as outward", 0,
         0});
  }
  return read;
}

}  // namespace railbook::profiles::detail
