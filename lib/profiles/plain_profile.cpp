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
#include <array>
#include <cmath>
#include <utility>

#include <railbook/profiles/detail/field_lines.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles::detail {
namespace {

constexpr std::size_t fewest = 8;

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

// The two columns that hold across and height: the first two that do not count the rows and are not
// the same in all of them.
std::array<std::size_t, 2> columns_of(const std::vector<std::vector<double>>& rows) {
  std::size_t shortest = rows.front().size();
  for (const auto& row : rows) shortest = std::min(shortest, row.size());
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < shortest && shortest > 2; ++k) {
    bool counts = k == 0, same = true;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      counts = counts && rows[i][k] == rows[0][k] + double(i);
      same = same && rows[i][k] == rows[0][k];
    }
    if (!counts && !same) found.push_back(k);
  }
  return found.size() < 2 ? std::array<std::size_t, 2>{0, 1}
                          : std::array<std::size_t, 2>{found[0], found[1]};
}

}  // namespace

std::optional<Unit> unit_of(double width) {
  for (const Unit& unit :
       {Unit{"metres", 1}, {"inches", units::inch}, {"millimetres", units::millimetre}})
    if (width * unit.metre > 0.02 && width * unit.metre < 0.25) return unit;
  return std::nullopt;
}

std::optional<FieldProfile> read_plain(const std::vector<Line>& lines, Body body,
                                       const FieldOptions& options) {
  FieldProfile read;
  read.format = "plain columns";
  std::vector<std::vector<double>> rows;
  for (const Line& line : lines) {
    const auto text = without_comment(line.text);
    if (text.empty()) continue;
    auto numbers = leading_numbers(text);
    if (numbers.size() > 1) {
      rows.push_back(std::move(numbers));
      continue;
    }
    if (!rows.empty() && rows.size() >= fewest) refuse_line(line, "plain");
    read.left_out.push_back(
        {"header", fmt::format("line {}, \"{}\"", line.number, text.substr(0, 40)), 0, 0});
  }
  if (rows.size() < fewest) return std::nullopt;
  const auto [across, height] = options.columns.value_or(columns_of(rows));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() <= std::max(across, height))
      throw InputError(
          fmt::format("row {} of the points has {} columns; allowed: {} or more, see "
                      "--columns",
                      i + 1, rows[i].size(), std::max(across, height) + 1));
    read.points.push_back({rows[i][across], rows[i][height]});
  }
  const auto [left, right] = std::ranges::minmax_element(read.points, {}, &Point::u);
  const auto [low, high] = std::ranges::minmax_element(read.points, {}, &Point::z);
  const double width = right->u - left->u;
  const auto unit =
      options.unit ? std::optional<Unit>{{"the unit given", *options.unit}} : unit_of(width);
  if (!unit || high->z - low->z > 1.3 * width)
    throw InputError(
        fmt::format("the points span {:.4g} by {:.4g} in their own unit; allowed: across and "
                    "height of one side, 20 to 250 mm wide, in millimetres, metres or inches",
                    width, high->z - low->z));
  read.format +=
      options.unit ? ", in the unit given" : fmt::format(", {} by their width", unit->name);
  for (Point& p : read.points) p = {-p.u * unit->metre, p.z * unit->metre};
  turn_upright(read, body);
  if (body == Body::wheel) {
    place_wheel(read);
  } else if (lopsided(read.points)) {
    read.warnings.push_back(
        {"side", "the file does not say which side is the gauge side: y was taken as outward", 0,
         0});
  }
  return read;
}

}  // namespace railbook::profiles::detail
