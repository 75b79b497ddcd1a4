// What a check is about and what came of it: two fields of every check, set where the check is
// made.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <railbook/report/tolerance.hpp>
#include <railbook/report/trial.hpp>

namespace railbook::report {

// What the reference is.
enum class Source {
  print,        // a number or drawn curve of this paper
  claim,        // a statement of this paper in words
  publication,  // another work, named
  route,        // an independent method of ours, named
};

// What came of a check against print or claim, if it passes. Checks against publication or route
// are `verified`.
enum class Outcome {
  confirmed,      // to the printed digit, or the claim holds as stated
  consistent,     // within a stated tolerance whose reason is given
  fitted,         // an input was chosen to meet it
  corrected,      // the print is wrong: the check shows what is right, and carries a trial
  restored,       // our copy is damaged: the reading is derived
  not_confirmed,  // something else holds, whatever was varied of what we chose (report/trial.hpp)
  verified,
};

std::string_view name(Source source);
std::string_view name(Outcome outcome);

// The outcome that a check asserts, and how close it must come. `reason` is empty only for
// confirmed.
struct Expectation {
  // A bare tolerance: confirmed when it is last_digit(), otherwise consistent.
  Expectation(Tolerance tolerance);  // NOLINT(google-explicit-constructor): reads as a tolerance

  Outcome outcome;
  Tolerance tolerance;
  std::optional<Trial> trial;

 private:
  friend Expectation fitted(std::string why, Tolerance tolerance);
  friend Expectation restored(std::string why, Tolerance tolerance);
  friend Expectation corrected(double value, double allowed, std::string why, Trial trial);
  friend Expectation not_confirmed(std::string why, Trial trial);
  Expectation(Outcome o, Tolerance t, std::optional<Trial> tried = {})
      : outcome(o), tolerance(std::move(t)), trial(std::move(tried)) {}
};

// row.print("frequency", f, report::fitted("the damper was chosen for it"));
Expectation fitted(std::string why, Tolerance tolerance = last_digit());
Expectation restored(std::string why, Tolerance tolerance = last_digit());
// The computed value equals `value`, derived by another route than the computed one, within
// `allowed` (relative), and does not round to the print, whatever the trial varies.
Expectation corrected(double value, double allowed, std::string why, Trial trial);
// The computed value does not round to the print, whatever the trial varies.
Expectation not_confirmed(std::string why, Trial trial);

}  // namespace railbook::report
