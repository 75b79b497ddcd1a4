// What the readers of profile files share: lines, comments and numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/profiles/field_profile.hpp>

namespace railbook::profiles::detail {

struct Line {
  std::string_view text;  // without blanks at its ends
  std::size_t number = 0;
};
std::vector<Line> lines_of(std::string_view text);

std::string_view trimmed(std::string_view text);
std::string lower(std::string_view text);
bool contains(std::string_view text, std::string_view part);  // capitals do not matter

// Without what follows a sign of a comment: # % ! " or two slashes.
std::string_view without_comment(std::string_view text);

// The numbers of a line, parted by blanks, tabs, commas or semicolons; beside semicolons a comma is
// a decimal one. Nothing where something is no finite number, and empty for an empty line. Also
// Fortran's 1.0D+01.
std::optional<std::vector<double>> numbers_of(std::string_view text);

// The same of the beginning of a line up to the first word: what follows is a remark.
std::vector<double> leading_numbers(std::string_view text);

// The key in lower case and the value of "key = value", neither in quotes.
struct Setting {
  std::string key;
  std::string_view value;
};
std::optional<Setting> setting_of(std::string_view text);
// The one number that a setting holds. Throws InputError naming key and line.
double number_of(const Setting& setting, const Line& line);

[[noreturn]] void refuse_line(const Line& line, const char* format);

FieldProfile read_miniprof(const std::vector<Line>& lines, Body body, const FieldOptions& options);
FieldProfile read_simpack(const std::vector<Line>& lines, Body body);
FieldProfile read_vampire(const std::vector<Line>& lines, Body body);
std::optional<FieldProfile> read_plain(const std::vector<Line>& lines, Body body,
                                       const FieldOptions& options);
// The unit, of metres, inches and millimetres, in which a profile of this width is 20 to 250 mm
// wide, if there is one.
struct Unit {
  const char* name;
  double metre;
};
std::optional<Unit> unit_of(double width);

// Turns the heights upwards: a wheel has its flange below its tread, a rail its top inside. Adds to
// the format's name that it did.
void turn_upright(FieldProfile& read, Body body);
// Puts an upright wheel with its flange inwards and its origin on the tape circle: the flange's tip
// is 5 to 30 mm from the back of the flange and 40 to 65 mm from the tape circle, so that its place
// says which of the two is the origin. Adds to the format's name what it changed.
void place_wheel(FieldProfile& read);

}  // namespace railbook::profiles::detail
