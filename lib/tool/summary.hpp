// What a tool answers: named quantities, printed for people and written as JSON for programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <railbook/units/warning.hpp>

namespace railbook::tool {

// A value and its error, absolute and in the value's unit; infinite: not known.
struct Estimate {
  double value = 0, error = 0;
};

class Summary {
 public:
  explicit Summary(std::string title) : title_(std::move(title)) {}

  // A number in the unit it is shown in. `key` is its JSON name ("force_N" style names carry the
  // unit). Throws InputError naming it when it is not finite: what has no value is said to be
  // absent.
  void add(std::string key, std::string what, double value, std::string unit,
           std::string note = "");
  // A number with its error, "144.54 +- 0.02 ft/s"; in the JSON the error is under "errors", null
  // when not known.
  void add(std::string key, std::string what, const Estimate& estimate, std::string unit,
           std::string note = "");
  // A number whose last digit stands in the place of the first of `last`, as of a mean beside its
  // standard deviation.
  void add_rounded(std::string key, std::string what, double value, double last, std::string unit,
                   std::string note = "");
  // A number that is an error itself: two digits are enough.
  void add_error(std::string key, std::string what, double error, std::string unit,
                 std::string note = "");
  // A number for the JSON only, which the text shows beside another one.
  void add_to_json(std::string key, double value, std::string unit);
  void add(std::string key, std::string what, std::string text);
  // A quantity that has no value here, and why ("none", "beyond the largest force"): null in the
  // JSON, with the reason as its note.
  void absent(std::string key, std::string what, std::string why);

  // A warning that the answer stands under: "not-converged", "after 200 steps the force still
  // changes by 3 %". Printed above all values, and under "warnings" in the JSON. What is only worth
  // knowing is a note of a value.
  void warn(std::string key, std::string text);

  const std::vector<units::Warning>& warnings() const { return warnings_; }

  // The table on standard output: what, value, unit, note; with --json, json(). On standard error
  // where standard output is a file's.
  void print() const;
  // {"title": ..., "values": {key: value, ...}, "errors": ..., "units": {key: unit, ...}, "notes":
  // ..., "warnings": {key: text}, "program": ..., "version": ..., "command": [...], "given":
  // {option: text}, "assumed": {option: text}}; what is absent is null.
  std::string json() const;

 private:
  struct Line {
    enum class Kind { number, text, absent, hidden };
    Kind kind;
    std::string key, what, text, unit, note;
    double value;
    std::optional<double> error{};
  };
  std::string title_;
  std::vector<Line> lines_;
  std::vector<units::Warning> warnings_;
};

}  // namespace railbook::tool
