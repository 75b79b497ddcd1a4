// Error against run time: several methods, each at several settings, against one reference.
//
//   void cost(report::Item& item) {
//     const auto points = bench::figure(
//         item, {"F", exact.force, 1e-15},
//         {bench::sweep("cg-fft", {63, 127, 255}, by_grid).counts("points
//         transformed").expects(-1),
//          bench::sweep("countact", {5, 9, 19}, by_columns)
//              .labelled("{} columns")
//              .counts("matrix elements")},
//         0.5, axes_of_the_chapter);
//     item.value("answer", bench::answer(points, "F", {1e-3, 1e-5}));   // the sentence under the
//     panel
//   }
//
// Several quantities of the same runs: measure() once, then show() in an item each.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/report/item.hpp>
#include <railbook/report/record.hpp>

namespace railbook::bench {

// A quantity that every method computes. The reference comes from a closed form or another method,
// at least 100 times tighter than the errors to be shown; `uncertainty` is its own, relative.
// Points below 100 times that are drawn grey.
struct Reference {
  std::string quantity;
  double value = 0;
  double uncertainty = 0;
};

// What one run of a method returns: a value for each reference, in the same order.
struct Outcome {
  std::vector<double> values;
  double work = 0;  // the method's own count: unknowns, evaluations, transformed points
  bool converged = true;
  std::string reason;  // why not
};

struct Setting {
  std::string label;
  std::function<Outcome()> run;
};

struct Method {
  std::string name;
  std::vector<Setting> settings;
  double slope = 0;  // expected d ln(error)/d ln(time), negative; 0: none is expected
  std::string work_unit = {};

  // The order that theory gives the method, drawn as a slope beside what was measured: expects(-2).
  Method& expects(double d_ln_error_by_d_ln_time) & {
    return slope = d_ln_error_by_d_ln_time, *this;
  }
  Method&& expects(double d_ln_error_by_d_ln_time) && {
    return slope = d_ln_error_by_d_ln_time, std::move(*this);
  }
  // What its settings are: labelled("{} cells") makes "12 cells" of the label "12".
  Method& labelled(std::string_view pattern) &;
  Method&& labelled(std::string_view pattern) && { return std::move(labelled(pattern)); }
  // What its work is a count of.
  Method& counts(std::string unit) & { return work_unit = std::move(unit), *this; }
  Method&& counts(std::string unit) && { return work_unit = std::move(unit), std::move(*this); }
};

// The axes of a panel, shared by the panels of a chapter so that they can be laid beside each
// other; 0: from the data.
struct Axes {
  double error_low = 0, error_high = 0;
  double seconds_low = 0, seconds_high = 0;
};

std::string label(int size);
std::string label(double setting);

// Runs every setting of every method once for its error and, when `timings`, again for its time: in
// rounds over all settings, so that a slow minute of the machine strikes every method alike; a
// sample is a batch of at least 1 ms; up to 21 samples a setting, but at most about `budget`
// seconds of each. A run that does not converge or throws stays in the list with its reason and the
// time it took to fail. One record a quantity, method and setting.
std::vector<report::WorkPrecision> measure(const std::string& id,
                                           const std::vector<Reference>& references,
                                           const std::vector<Method>& methods, bool timings,
                                           double budget = 0.5);

// A method at several sizes: the settings are labelled by them.
template <class Size, class Run>
Method sweep(std::string name, const std::vector<Size>& sizes, const Run& run) {
  Method method{std::move(name), {}};
  for (const Size& size : sizes)
    method.settings.push_back({label(size), [run, size] { return run(size); }});
  return method;
}
template <class Run>
Method sweep(std::string name, std::initializer_list<int> sizes, const Run& run) {
  return sweep(std::move(name), std::vector<int>(sizes), run);
}

// Measures one quantity and shows it, in one step; returns the points.
std::vector<report::WorkPrecision> figure(report::Item& item, const Reference& reference,
                                          const std::vector<Method>& methods, double budget = 0.5,
                                          const Axes& axes = {});

// Gives the points of one quantity to a figure item: records, CSV and the common script. The panel
// has the run time (without timings the work) across and the error upwards: medians with bars from
// quartile to quartile, failures as crosses at the top, grey where the reference is less than 100
// times better, the expected order as a line with the measured one. `methods` are those measured,
// for what they expect. A method's name must not hold a comma. Returns the data, so that what is
// said about their accuracy can be added.
report::Data& show(report::Item& item, const std::vector<report::WorkPrecision>& points,
                   const std::string& quantity, const std::vector<Method>& methods = {},
                   const Axes& axes = {});

// The slope d ln(error)/d ln(work) of one method's converged points above 100 times the reference's
// uncertainty, by least squares: minus the order of convergence in work. NaN with fewer than two
// points.
double observed_slope(const std::vector<report::WorkPrecision>& points, const std::string& quantity,
                      const std::string& method);

// The method and setting that takes least time to an error that each later setting of the method
// keeps, too; empty when none does. The reference's uncertainty is added to each error. Settings of
// a method are compared by their work, methods by the medians that the table prints.
struct Cheapest {
  std::string method, setting;
  double seconds = 0;
};
Cheapest cheapest(const std::vector<report::WorkPrecision>& points, const std::string& quantity,
                  double error);

// "For an error of 0.1 % use CG-FFT with 48 cells (1.2 ms); of 10⁻⁸ none of the settings tried."
// Without timings "(not timed)".
std::string answer(const std::vector<report::WorkPrecision>& points, const std::string& quantity,
                   std::initializer_list<double> errors);

}  // namespace railbook::bench
