// Simpack's files of wheels (.prw) and rails (.prr).
//
// Sections header and spline, each from NAME.begin to NAME.end; in spline the points (y, z, maybe a
// weight) stand between point.begin and point.end. The settings of spline act in this order:
// shift.y, shift.z, rotate (in units of which units.ang.f make a radian), bound.y.min to
// bound.y.max, bound.z.min to bound.z.max, mirror.y, mirror.z, and units.len.f, the number of
// units in a metre. Signs: for the right side, y outward and z downward, so that both change their
// signs. Source: the public reader and files of the program CONTACT (Vollebregt).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <railbook/profiles/detail/field_lines.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::profiles::detail {
namespace {

struct Settings : std::map<std::string, double> {
  double get(const char* key, double otherwise) const {
    const auto found = find(key);
    return found == end() ? otherwise : found->second;
  }
};

// Nothing where the point is out of bounds.
std::optional<Point> placed(double y, double z, const Settings& s) {
  y += s.get("shift.y", 0), z += s.get("shift.z", 0);
  const double turn = s.get("rotate", 0) / s.get("units.ang.f", 1);
  const double c = std::cos(turn), t = std::sin(turn);
  const double across = c * y - t * z;
  double down = t * y + c * z;
  const double least = s.get("bound.y.min", 0), most = s.get("bound.y.max", 0);
  if (least < most && (across < least || across > most)) return std::nullopt;
  const double low = s.get("bound.z.min", 0), high = s.get("bound.z.max", 0);
  if (low < high) down = std::clamp(down, low, high);
  const double units = s.get("units.len.f", 1);
  return Point{(s.get("mirror.y", 0) == 1 ? across : -across) / units,
               (s.get("mirror.z", 0) == 1 ? down : -down) / units};
}

}  // namespace

FieldProfile read_simpack(const std::vector<Line>& lines, Body body) {
  FieldProfile read;
  read.format = "Simpack";
  Settings settings;
  std::vector<Point> raw;
  bool in_points = false, in_header = false;
  std::optional<double> type;  // 0 a rail, 1 a wheel
  for (const Line& line : lines) {
    const auto comment = line.text.find('!');
    const std::string_view text = trimmed(line.text.substr(0, comment));
    if (text.empty()) continue;
    if (text.find(".begin") != std::string_view::npos) {
      in_points = text.starts_with("point"), in_header = text.starts_with("header");
    } else if (text.find(".end") != std::string_view::npos) {
      in_points = false;
    } else if (in_points) {
      const auto numbers = numbers_of(text);
      if (!numbers || numbers->size() < 2) refuse_line(line, "Simpack");
      raw.push_back({(*numbers)[0], (*numbers)[1]});
    } else if (const auto setting = setting_of(text)) {
      for (const char* key :
           {"shift.y", "shift.z", "rotate", "units.ang.f", "bound.y.min", "bound.y.max",
            "bound.z.min", "bound.z.max", "mirror.y", "mirror.z", "units.len.f"})
        if (setting->key == key) settings[key] = number_of(*setting, line);
      if (setting->key == "type" && in_header) type = number_of(*setting, line);
    }
  }
  if (type && (*type == 1) != (body == Body::wheel))
    throw InputError(fmt::format("this is a Simpack file of a {}; allowed: one of a {}",
                                 *type == 1 ? "wheel" : "rail",
                                 body == Body::wheel ? "wheel" : "rail"));
  if (!(settings.get("units.len.f", 1) > 0) || settings.get("units.ang.f", 1) == 0)
    throw InputError("units.len.f and units.ang.f of a Simpack file: allowed: above 0");
  if (raw.empty()) throw InputError("a Simpack file without points");
  const auto [left, right] = std::ranges::minmax_element(raw, {}, &Point::u);
  if (settings.count("units.len.f") == 0)  // metres without it; other widths say another unit
    if (const auto unit = unit_of(right->u - left->u); unit && unit->metre != 1) {
      settings["units.len.f"] = 1 / unit->metre;
      read.format += fmt::format(", {} by their width", unit->name);
    }
  std::size_t out = 0;
  for (const Point& p : raw)
    if (const auto at = placed(p.u, p.z, settings))
      read.points.push_back(*at);
    else
      ++out;
  if (out > 0)
    read.left_out.push_back(
        {"bounds", std::to_string(out) + " points beyond the file's own bound.y", 0, 0});
  turn_upright(read, body);
  if (body == Body::wheel) place_wheel(read);
  return read;
}

}  // namespace railbook::profiles::detail
