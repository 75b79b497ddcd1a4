// How close a computed value must come to a printed one, and the verdict on one comparison.
#pragma once

#include <string>
#include <string_view>

namespace railbook::report {

enum class ToleranceKind {
  last_digit,     // |computed - printed| within half a unit of the last printed digit
  relative,       // |computed - printed| / |printed|
  absolute,       // |computed - printed|
  digitised,      // |computed - printed| / axis span, for values read off a figure
  agrees_with,    // |computed - reference| / |reference|, reference from an independent method of
                  // ours
  misprint,       // computed equals another value, and does not round to the printed one
  not_the_print,  // computed does not round to the printed one
  at_most,        // computed <= the bound
  at_least,       // computed >= the bound
  exact,          // the same text: a class, a name, a yes or no
};

// A tolerance; `allowed` is in the unit of its kind. Every kind but last_digit and exact needs a
// reason.
struct Tolerance {
  ToleranceKind kind = ToleranceKind::last_digit;
  double allowed = 0;
  std::string why;
  double span = 1;  // digitised: the axis span; misprint: the corrected value
};

Tolerance last_digit();
Tolerance relative(double allowed, std::string why);
Tolerance absolute(double allowed, std::string why);
Tolerance digitised(double share, double axis_span, std::string why);
// `allowed` relative to `corrected`, which is derived by another route than the computed value.
Tolerance misprint(double corrected, double allowed, std::string why);
Tolerance not_the_print(std::string why);
Tolerance at_most(std::string why);
Tolerance at_least(std::string why);

// The result of one comparison. `error` and `allowed` are in the same unit: an absolute difference
// for last_digit, absolute and the bounds, otherwise a ratio.
struct Verdict {
  bool pass;
  double error, allowed;
};

// Compares; NaN and infinity never pass. Throws std::logic_error when a tolerance is not finite and
// positive, lacks its reason, or when `printed` is not a number.
Verdict compare(std::string_view printed, double computed, const Tolerance& tolerance);

// `computed` moved away from the printed value by twice the tolerance, so that a check which can
// fail does.
double beyond_tolerance(std::string_view printed, double computed, const Tolerance& tolerance);

// The number a printed text stands for, "39240", ".15935", "1.7e-7", "-5 365"; NaN when it is none.
double printed_number(std::string_view text);

// The power of ten of the last digit of a printed number: -8 for "1.7e-7", 0 for "39240".
int last_decade(std::string_view text);

// Half a unit of the last digit of a printed number: 0.05e-7 for "1.7e-7", 0.5 for "39240".
double half_last_digit(std::string_view text);

std::string_view name(ToleranceKind kind);

}  // namespace railbook::report
