// VAMPIRE's files of wheels (.whe) and rails (.rai), in millimetres.
//
// WHEELPROFILE or RAILPROFILE, a title, TREADDATUM or GAUGEPOINT, FLANGEBACK or GAUGE with the
// distance, then four numbers a row: y and z of the left side, y and z of the right one, y from the
// middle of the axle or of the track. The right side is read. Signs: y outward on the right; a
// rail's z upward; a wheel's is found from its flange. Source: the public reader of the program
// CONTACT (Vollebregt); no file of the program itself was at hand.
#include <fmt/format.h>

#include <cmath>

#include <railbook/profiles/detail/field_lines.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles::detail {

FieldProfile read_vampire(const std::vector<Line>& lines, Body body) {
  constexpr double tape = 70;  // mm from the back of the flange
  FieldProfile read;
  read.format = "VAMPIRE, its right side";
  if (contains(lines[0].text, "wheel") != (body == Body::wheel))
    throw InputError(fmt::format("this is a VAMPIRE file of a {}; allowed: one of a {}",
                                 body == Body::wheel ? "rail" : "wheel",
                                 body == Body::wheel ? "wheel" : "rail"));
  double distance = units::nan;
  bool differs = false;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const auto text = without_comment(lines[i].text);
    if (text.empty() || contains(text, "treaddatum") || contains(text, "gaugepoint")) continue;
    if (contains(text, "flangeback") || contains(text, "gauge")) {
      const auto value = text.find_first_of(" \t=");
      const auto numbers =
          value == std::string_view::npos ? std::nullopt : numbers_of(text.substr(value + 1));
      if (!numbers || numbers->empty()) refuse_line(lines[i], "VAMPIRE");
      distance = numbers->front();
      continue;
    }
    const auto numbers = numbers_of(text);
    if (!numbers || numbers->size() < 4) refuse_line(lines[i], "VAMPIRE");
    const auto& n = *numbers;
    differs = differs || std::abs(std::abs(n[0]) - std::abs(n[2])) > 1e-3 || n[1] != n[3];
    read.points.push_back({-n[2] * units::millimetre, n[3] * units::millimetre});
  }
  if (read.points.empty()) throw InputError("a VAMPIRE file without points");
  if (body == Body::wheel) {
    if (!(distance > 0)) throw InputError("a VAMPIRE file of a wheel without FLANGEBACK");
    read.moved = (0.5 * distance + tape) * units::millimetre;
    for (Point& p : read.points) p.u += read.moved;
    turn_upright(read, body);
  }
  if (differs)
    read.warnings.push_back({"side", "its left side is another; the right one was read", 0, 0});
  return read;
}

}  // namespace railbook::profiles::detail
