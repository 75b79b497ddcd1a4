// Limits of the United States' track safety standards (49 CFR 213) on mid-chord offsets, gauge and
// cross level, classes 1 to 5, and on alinement, classes 6 to 9.
#pragma once

#include <array>
#include <string_view>

#include <railbook/units/constants.hpp>

namespace railbook::quality {

inline constexpr int fra_classes = 5;

// A limit of each class, falling, m. Each row is in two copies of the code of regulations
// (law.cornell.edu and elaws.us for profile, casetext and an open index class for alinement). Left
// out, since no second source was found: gauge and surface of classes 6 to 9 (213.323, 213.331).
// tools/quality/fra-49-cfr-213.csv is the same as a file.
struct FraLimit {
  std::string_view name;
  double chord = 0;  // m; 0: no chord
  std::array<double, fra_classes> limit{};
};

namespace fra {
inline constexpr double inch = units::inch, feet = units::foot;
inline constexpr FraLimit profile{
    "profile, 62-ft chord", 62 * feet, {3 * inch, 2.75 * inch, 2.25 * inch, 2 * inch, 1.25 * inch}};
inline constexpr FraLimit alinement{"alinement on tangent, 62-ft chord",
                                    62 * feet,
                                    {5 * inch, 3 * inch, 1.75 * inch, 1.5 * inch, 0.75 * inch}};
inline constexpr FraLimit crosslevel{"deviation from zero cross level on tangent",
                                     0,
                                     {3 * inch, 2 * inch, 1.75 * inch, 1.25 * inch, 1 * inch}};
inline constexpr FraLimit warp{"difference in cross level within 62 ft",
                               0,
                               {3 * inch, 2.25 * inch, 2 * inch, 1.75 * inch, 1.5 * inch}};

// Gauge (213.53): at least 4 ft 8 in, at most this.
inline constexpr double least_gauge = 56 * inch, nominal_gauge = 56.5 * inch;
inline constexpr FraLimit gauge{
    "gauge", 0, {58 * inch, 57.75 * inch, 57.75 * inch, 57.5 * inch, 57.5 * inch}};

// Alinement on tangent of classes 6 to 9 (213.327, in casetext's copy and another of the same
// year): the mid-chord offset less the mean of nine, a quarter of the chord apart, about it.
struct Uniformity {
  double chord = 0;               // m
  std::array<double, 4> limit{};  // m, classes 6 to 9
};
inline constexpr std::array<Uniformity, 3> uniformity{
    {{31 * feet, {0.5 * inch, 0.5 * inch, 0.5 * inch, 0.5 * inch}},
     {62 * feet, {0.75 * inch, 0.75 * inch, 0.75 * inch, 0.5 * inch}},
     {124 * feet, {1.5 * inch, 1.25 * inch, 1 * inch, 0.75 * inch}}}};
}  // namespace fra

// The highest class whose limit a magnitude (m) keeps; 0 where it keeps none.
constexpr int fra_class(const FraLimit& limit, double magnitude) {
  int kept = 0;
  for (int i = 0; i < fra_classes; ++i)
    if (magnitude <= limit.limit[static_cast<std::size_t>(i)]) kept = i + 1;
  return kept;
}

}  // namespace railbook::quality
