// Figures that answer: below the figure a reader moves a slider, and the page draws what the
// program found for that value.
//
//   report::Answer answer{item, {"speed_mph"}, {{"force", "time, ms", "force, kN", 0, 20, 0,
//   400}}}; for (const double mph : {20., 40., 60.}) {
//     answer.at({mph});
//     for (...) answer.point("force", "computed", time, force);
//   }
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <railbook/report/item.hpp>

namespace railbook::report {

// One panel of it, with its axes; "cells" draws dots, "plane" dots and the unit circle, "says"
// lists what says() gave it.
struct Panel {
  std::string name, x_label = {}, y_label = {};
  double x_from = 0, x_to = 1, y_from = 0, y_to = 1;
  std::string scale = "lin";   // lin, log (both), logx or logy
  std::string kind = "lines";  // lines, cells, plane or says
};

// The data files <item>-panels.csv and <item>-answer.csv, which book/answer.js draws. A page should
// load quickly: keep them below 300 kB.
class Answer {
 public:
  // One or two sliders, named as columns are: "speed_mph". Throws std::logic_error for another
  // count.
  Answer(Item& item, std::vector<std::string> sliders, const std::vector<Panel>& panels);

  // What follows belongs to these values of the sliders; the page offers them in the order in which
  // they come.
  void at(std::vector<double> values);
  // A point of a curve, in the units of the axes, kept to four digits.
  void point(std::string_view panel, std::string_view curve, double x, double y);
  // A line of a "says" panel: "peak, kN" and its value, or a word.
  void says(std::string_view panel, std::string_view what, double value);
  void says(std::string_view panel, std::string_view what, std::string_view value);

 private:
  template <class X, class Y>
  void add(std::string_view panel, std::string_view curve, const X& x, const Y& y);

  std::vector<std::string> sliders_;
  std::vector<double> values_;
  Data* data_ = nullptr;
};

}  // namespace railbook::report
