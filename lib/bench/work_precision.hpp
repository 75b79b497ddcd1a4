// Error against run time: several methods, each at several settings, against one reference.
//
//   void cost(report::Item& item) {
//     bench::figure(item, {"F", exact.force, 1e-15},
//                   {bench::sweep("cg-fft", {63, 127, 255}, [&](int n) { return by_grid(n); }),
//                    bench::sweep("countact", {5, 9, 19}, [&](int n) { return by_columns(n); })});
//   }
//
// Several quantities of the same runs: measure() once, then show() in an item each.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "report/item.hpp"
#include "report/record.hpp"

namespace railbook::bench {

// A quantity that every method computes. The reference comes from a closed form or another method, at least
// 100 times tighter than the errors to be shown; `uncertainty` is its own, relative.
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
};

struct Timing {
  double min = 0;  // seconds a call
  double median = 0;
  double noise = 0;  // (median - min)/min
};

std::string label(int size);
std::string label(double setting);

// Times a call: one warm-up, batches of at least 1 ms, up to 21 samples but at most about `budget` seconds.
Timing time_call(const std::function<void()>& call, double budget = 0.5);

// Runs every setting of every method once for its error and, when `timings`, again for its time. A run that does
// not converge or throws stays in the list with its reason. One record a quantity, method and setting.
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
                                          const std::vector<Method>& methods, double budget = 0.5);

// Gives the points of one quantity to a figure item: records, CSV and the common two-panel script (error against
// time, error against work). Only converged points are drawn. A method's
// name must not hold a comma. Returns the data, so that what is said about their accuracy can be added.
report::Data& show(report::Item& item, const std::vector<report::WorkPrecision>& points,
                   const std::string& quantity);

// The slope d ln(error)/d ln(work) of one method's converged points, by least squares: minus the order of
// convergence in work. NaN with fewer than two points.
double observed_slope(const std::vector<report::WorkPrecision>& points, const std::string& quantity,
                      const std::string& method);

}  // namespace railbook::bench
