// A verdict against the paper, tried: what we chose and what the print rounds is varied, and the
// verdict must stand each time.
//
// "Not confirmed" and "corrected" accuse an author. data/trials.csv of the chapter declares what is
// varied, at least two settings of each choice, ours among them:
//
//   check,choice,unit,settings
//   fig-11/stable,width of the running mean,in,0.08; 0.04; 0.02
//   fig-11/stable,dampers that fit 145 ft/s,,first of the curve; last of the curve
//
// The code computes the result for every declared setting:
//
//   report::Trial trial = item.trial("stable", "speed at which stability ends", "{:.0f} ft/s",
//                                    [&](double speed) { return speed < 1.2 * hopf; });
//   trial.vary("width of the running mean",
//              [&](const report::Setting& s) { return torus_speed(s.number * units::inch); });
//   trial.vary("dampers that fit 145 ft/s",
//              [&](const report::Setting& s) { return torus_speed(dampers[s.index]); });
//   item.refute("stable", "the cycle is stable to a high velocity", trial, "it ends at ...");
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace railbook::report {

// One row of trials.csv.
struct TrialRow {
  std::string check;  // "fig-11/stable"
  std::string choice, unit;
  std::vector<std::string> settings;
};

// Throws InputError when the file is not of this form: a choice with fewer than two settings, the
// same choice or the same setting twice, a check whose item (the part before the slash) is none of
// `items`.
std::vector<TrialRow> read_trials(const std::filesystem::path& file,
                                  const std::vector<std::string>& items);

struct Setting {
  std::string text;  // "0.08 in"
  double number;     // 0.08; NaN when the setting is no number
  std::size_t index;
};

// One choice, its settings, and the result for each.
struct Variation {
  std::string choice;
  std::vector<std::string> settings;
  std::vector<double> results;
};

class Trial {
 public:
  using Expected = std::function<bool(double)>;

  // `format` writes a result with its unit: "{:.0f} ft/s". `stands`: whether the verdict stands for
  // a result. `rows` are those of this check; none throws std::logic_error.
  Trial(std::string quantity, std::string format, Expected stands, std::vector<TrialRow> rows);

  // Computes the result for each declared setting of a choice. Throws std::logic_error for a choice
  // that is not declared, or twice.
  void vary(std::string_view choice, const std::function<double(const Setting&)>& result);

  // Whether every declared choice was computed and the verdict stood each time; NaN never stands.
  bool stands() const;
  // Why it does not: the first setting that reverses the verdict, or the choice left out. Else
  // empty.
  std::string objection() const;

  std::string range() const;                       // "145 to 160 ft/s"
  std::string range_of(const Variation& v) const;  // of one choice
  const std::string& quantity() const { return quantity_; }
  const std::vector<Variation>& variations() const { return variations_; }
  std::string show(double result) const;

 private:
  std::string quantity_, format_;
  Expected stands_;
  std::vector<TrialRow> rows_;
  std::vector<Variation> variations_;
};

// The verdict "the print is not what is computed": the result does not round to the printed text.
Trial::Expected misses(std::string_view printed);

}  // namespace railbook::report
