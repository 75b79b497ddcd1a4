#include <railbook/report/answer.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace railbook::report {
namespace {

double four_digits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3);
  return unit * std::round(value / unit);
}

}  // namespace

Answer::Answer(Item& item, std::vector<std::string> sliders, const std::vector<Panel>& panels)
    : sliders_(std::move(sliders)) {
  if (sliders_.empty() || sliders_.size() > 2)
    throw std::logic_error("an answer has one or two sliders");
  Data& list = item.data("panels", {"panel", "kind", "x_label", "y_label", "x_from", "x_to",
                                    "y_from", "y_to", "scale"});
  for (const Panel& p : panels)
    list.add(p.name, p.kind, p.x_label, p.y_label, p.x_from, p.x_to, p.y_from, p.y_to, p.scale);
  std::vector<std::string> columns = sliders_;
  columns.insert(columns.end(), {"panel", "curve", "x", "y"});
  data_ = &item.data("answer", columns);
  data_->holds_to("x", 2e-3, 1e-9, "kept to four digits");
  data_->holds_to("y", 2e-3, 1e-9, "kept to four digits");
}

void Answer::at(std::vector<double> values) {
  if (values.size() != sliders_.size())
    throw std::logic_error("an answer wants a value for each of its sliders");
  values_ = std::move(values);
}

template <class X, class Y>
void Answer::add(std::string_view panel, std::string_view curve, const X& x, const Y& y) {
  if (values_.empty()) throw std::logic_error("an answer wants at() before its points");
  if (values_.size() == 1) {
    data_->add(values_[0], std::string{panel}, std::string{curve}, x, y);
  } else {
    data_->add(values_[0], values_[1], std::string{panel}, std::string{curve}, x, y);
  }
}

void Answer::point(std::string_view panel, std::string_view curve, double x, double y) {
  add(panel, curve, four_digits(x), four_digits(y));
}

void Answer::says(std::string_view panel, std::string_view what, double value) {
  add(panel, what, four_digits(value), 0.0);
}

void Answer::says(std::string_view panel, std::string_view what, std::string_view value) {
  add(panel, what, std::string{value}, 0.0);
}

}  // namespace railbook::report
