// MiniProf's files of wheels (.whl), rails (.ban) and sections (.mpt), in millimetres, or in
// another unit where only that makes a profile of the points' width.
//
// A header of key=value lines, or an old one that begins with MINIPROF or #MINI... and ends with an
// empty line (it may hold a line of the gauges Sd, Sh and qR, which is no point), then a row a
// point. ColumnDef names the columns: X and Y, maybe the angle A, the curvature C, and others.
// [FileInfo] begins a file of sections, whose points follow [Profile1Points]. Signs: of a wheel X
// is counted outward from the back of the flange and Y upward with the flange upward, so that
// inward is 70 mm
// - X and the height is -Y; of a rail X grows to the gauge side and Y is the height, as in four
// public rails: one leans by 1:40 to that side, one has a guard rail there, and the inputs of the
// program CONTACT (Vollebregt), whose y is outward, mirror all of them that they use. Source
// otherwise: its public reader. The shape shows heights that are the other way round.
#include <fmt/format.h>

#include <algorithm>

#include <railbook/profiles/detail/field_lines.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles::detail {
namespace {

// The place of a column in "X,Y,A,C", if it is there.
std::optional<std::size_t> column(std::string_view definition, char name) {
  std::size_t k = 0;
  for (const char c : definition)
    if (c == name)
      return k;
    else if (c == ',')
      ++k;
  return std::nullopt;
}

}  // namespace

FieldProfile read_miniprof(const std::vector<Line>& lines, Body body, const FieldOptions& options) {
  FieldProfile read;
  read.format = "MiniProf";
  std::string_view definition = "X,Y";
  bool old = false, sections = false, in_points = false, keys = false;
  long section = 0;
  for (const Line& line : lines) {
    const bool first = contains(line.text.substr(0, 8), "miniprof");
    if (contains(line.text.substr(0, 40), "#mini") || (first && line.number == 1)) old = true;
    if (line.text.starts_with('[')) {
      sections = true;
      in_points = contains(line.text, "points]");
      if (in_points && ++section > 1 && !options.section)
        throw InputError(fmt::format(
            "line {}: a second section of a MiniProf file; allowed: one section, or the number of "
            "that of the {}, see --section, --wheel-section and --rail-section",
            line.number, body == Body::wheel ? "wheel" : "running rail"));
      in_points = in_points && section == options.section.value_or(1);
      continue;
    }
    if (const auto setting = setting_of(line.text)) {
      keys = true;
      if (setting->key == "columndef") definition = setting->value;
      continue;
    }
    if (line.text.empty()) {
      if (!sections && (old || keys)) in_points = true;
      continue;
    }
    const auto text = without_comment(line.text);
    if (text.empty()) continue;
    const auto numbers = leading_numbers(text);
    if (keys && !old && !sections && numbers.size() > 1) in_points = true;
    if (!in_points) {
      if (numbers.size() > 1 && !sections)
        read.left_out.push_back(
            {"header", fmt::format("line {} of the header, \"{}\"", line.number, text), 0, 0});
      continue;
    }
    const auto x = column(definition, 'X'), y = column(definition, 'Y');
    if (!x || !y)
      throw InputError(
          fmt::format("ColumnDef is \"{}\"; allowed: columns among which X and Y are", definition));
    if (numbers.size() <= std::max(*x, *y)) refuse_line(line, "MiniProf");
    const double across = numbers[*x], up = numbers[*y];
    read.points.push_back(body == Body::wheel ? Point{-across, -up} : Point{across, up});
  }
  if (read.points.empty())
    throw InputError(options.section && sections
                         ? fmt::format("section {} of a MiniProf file; allowed: from 1 to {}",
                                       *options.section, section)
                         : "a MiniProf file without points");
  const auto [outer, inner] = std::ranges::minmax_element(read.points, {}, &Point::u);
  const auto unit = unit_of(inner->u - outer->u).value_or(Unit{"millimetres", units::millimetre});
  if (unit.metre != units::millimetre) read.format += fmt::format(", {} by their width", unit.name);
  for (Point& p : read.points) p = {p.u * unit.metre, p.z * unit.metre};
  turn_upright(read, body);
  if (body == Body::wheel) place_wheel(read);
  return read;
}

}  // namespace railbook::profiles::detail
