#include <railbook/bench/work_precision.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <railbook/bench/timing.hpp>
#include <railbook/plot/plot.hpp>

namespace railbook::bench {
namespace {

using Points = std::vector<report::WorkPrecision>;

constexpr double tighter = 100;  // a reference must be so much better than what it judges

Outcome guarded(const Setting& setting, std::size_t quantities) {
  Outcome outcome;
  try {
    outcome = setting.run();
  } catch (const std::exception& error) {
    outcome.converged = false;
    outcome.reason = error.what();
  }
  if (outcome.converged && outcome.values.size() != quantities)
    throw std::logic_error{"work-precision: a method returned another number of values"};
  return outcome;
}

double relative_error(double value, double reference) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
  return std::abs(value - reference) / std::abs(reference);
}

bool known(const report::WorkPrecision& p) {
  return p.converged && p.error >= tighter * p.reference_uncertainty && p.error > 0;
}

}  // namespace

Points measure(const std::string& id, const std::vector<Reference>& references,
               const std::vector<Method>& methods, bool timings, double budget) {
  std::vector<Outcome> outcomes;
  std::vector<std::function<void()>> calls;
  std::vector<double> first;
  for (const Method& method : methods)
    for (const Setting& setting : method.settings) {
      first.push_back(seconds_of([&] { outcomes.push_back(guarded(setting, references.size())); }));
      calls.push_back(outcomes.back().converged ? [run = setting.run] { (void)run(); }
                                                : std::function<void()>{});
    }
  std::vector<Timing> times(calls.size());
  if (timings) times = time_interleaved(calls, first, budget);
  Points points;
  std::size_t i = 0;
  for (const Method& method : methods)
    for (const Setting& setting : method.settings) {
      for (std::size_t q = 0; q < references.size(); ++q) {
        const Outcome& found = outcomes[i];
        report::WorkPrecision& p = points.emplace_back();
        p.id = id;
        p.quantity = references[q].quantity;
        p.method = method.name;
        p.setting = setting.label;
        p.error = found.converged ? relative_error(found.values[q], references[q].value)
                                  : std::numeric_limits<double>::quiet_NaN();
        p.reference_uncertainty = references[q].uncertainty;
        p.seconds_min = times[i].min;
        p.seconds_q1 = times[i].q1;
        p.seconds_median = times[i].median;
        p.seconds_q3 = times[i].q3;
        p.samples = times[i].samples;
        p.work = found.work;
        p.work_unit = method.work_unit;
        p.converged = found.converged;
        p.reason = found.reason;
      }
      ++i;
    }
  return points;
}

namespace {

Points of_quantity(const Points& points, const std::string& quantity) {
  Points chosen;
  for (const report::WorkPrecision& p : points) {
    if (p.quantity != quantity) continue;
    if (p.method.find(',') != std::string::npos)
      throw std::logic_error{"work-precision: gnuplot cuts \"" + p.method + "\" at the comma"};
    chosen.push_back(p);
  }
  if (chosen.empty())
    throw std::logic_error{"work-precision: no points of quantity \"" + quantity + "\""};
  return chosen;
}

// Slope and means of ln(error) over ln(x), where x is the time or the work.
struct Line {
  double slope = std::numeric_limits<double>::quiet_NaN();
  double x = 0, y = 0;           // means of the logarithms
  double x_low = 0, x_high = 0;  // range of ln(x)
};

Line line_through(const Points& points, const std::string& method,
                  double report::WorkPrecision::*across) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  Line line{.x_low = units::infinity, .x_high = -units::infinity};
  for (const report::WorkPrecision& p : points) {
    if (p.method != method || !known(p) || !(p.*across > 0)) continue;
    const double x = std::log(p.*across), y = std::log(p.error);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    line.x_low = std::min(line.x_low, x), line.x_high = std::max(line.x_high, x);
  }
  const double spread = n * sxx - sx * sx;
  if (spread <= 0) return line;  // fewer than two places
  line.slope = (n * sxy - sx * sy) / spread;
  line.x = sx / n, line.y = sy / n;
  return line;
}

void differs_by_machine(report::Data& data, const char* column) {
  data.holds_to(column, 0, units::infinity, "times of this machine");
}

// Two digits, with a real minus sign.
std::string two_digits(double slope) {
  return fmt::format("{}{:.2g}", slope < 0 ? "−" : "", std::abs(slope));
}

// The panel's frame: the axes, and a line of the expected slope a little below each method that has
// one.
void frame(report::Item& item, const Points& points, const std::vector<Method>& methods,
           const Axes& axes, double report::WorkPrecision::*across) {
  report::Data& data = item.data("frame", {"what", "x1", "y1", "x2", "y2", "text"});
  data.add("error", axes.error_low, axes.error_high, 0.0, 0.0, "");
  data.add("seconds", axes.seconds_low, axes.seconds_high, 0.0, 0.0, "");
  data.add("reference", points.front().reference_uncertainty,
           tighter * points.front().reference_uncertainty, 0.0, 0.0, "");
  for (const Method& m : methods) {
    const Line line = line_through(points, m.name, across);
    if (m.slope == 0 || std::isnan(line.slope)) continue;
    const double half = 0.3 * (line.x_high - line.x_low), below = std::log(4.0);
    data.add("slope", std::exp(line.x - half), std::exp(line.y - below - m.slope * half),
             std::exp(line.x + half), std::exp(line.y - below + m.slope * half),
             fmt::format("expected {}; found {}", two_digits(m.slope), two_digits(line.slope)));
  }
  data.holds_to("*", 0.9, 1e-12, "errors near rounding move the lines; work may differ by a step");
  if (across == &report::WorkPrecision::seconds_median)
    for (const char* column : {"x1", "y1", "x2", "y2", "text"}) differs_by_machine(data, column);
}

}  // namespace

report::Data& show(report::Item& item, const Points& points, const std::string& quantity,
                   const std::vector<Method>& methods, const Axes& axes) {
  const Points chosen = of_quantity(points, quantity);
  const bool timed = std::ranges::any_of(chosen, [](auto& p) { return p.seconds_median > 0; });
  const auto across = timed ? &report::WorkPrecision::seconds_median : &report::WorkPrecision::work;
  report::Data& data = item.data({"method", "setting", "error", "seconds_q1_s", "seconds_median_s",
                                  "seconds_q3_s", "work", "state"});
  for (const report::WorkPrecision& p : chosen) {
    const bool failed = !p.converged || !std::isfinite(p.error);
    // An error below what the reference knows, or none at all, is drawn there.
    const double error = failed ? 1 : std::max({p.error, p.reference_uncertainty, 1e-16});
    data.add(p.method, p.setting, error, p.seconds_q1, p.seconds_median, p.seconds_q3, p.work,
             failed     ? "failed"
             : known(p) ? "known"
                        : "vague");
  }
  const char* const why = "error control takes other steps where a last digit differs";
  data.holds_to("error", 0.9, 1e-15, why).holds_to("work", 0.05, 0, why);
  if (timed)
    for (const char* time : {"seconds_q1_s", "seconds_median_s", "seconds_q3_s"})
      differs_by_machine(data, time);
  frame(item, chosen, methods, axes, across);
  item.add(chosen);
  item.script(plot::shared("lib/bench") / "work_precision.gp");
  return data;
}

Method& Method::labelled(std::string_view pattern) & {
  for (Setting& setting : settings) {
    const bool one = setting.label == "1" && pattern.ends_with('s');
    setting.label =
        fmt::format(fmt::runtime(pattern.substr(0, pattern.size() - one)), setting.label);
  }
  return *this;
}

std::string label(int size) {
  return std::to_string(size);
}
std::string label(double setting) {
  return fmt::format("{:g}", setting);
}

Points figure(report::Item& item, const Reference& reference, const std::vector<Method>& methods,
              double budget, const Axes& axes) {
  Points points = measure(item.id(), {reference}, methods, item.timings(), budget);
  show(item, points, reference.quantity, methods, axes);
  return points;
}

double observed_slope(const Points& points, const std::string& quantity,
                      const std::string& method) {
  return line_through(of_quantity(points, quantity), method, &report::WorkPrecision::work).slope;
}

Cheapest cheapest(const Points& points, const std::string& quantity, double error) {
  const Points chosen = of_quantity(points, quantity);
  Cheapest best{"", "", std::numeric_limits<double>::infinity()}, candidate = best;
  double work = 0;  // of the candidate; within a method work tells more than noisy times
  const auto takes_less = [&](const report::WorkPrecision& p) {
    return p.work > 0 && work > 0 ? p.work < work : p.seconds_median < candidate.seconds;
  };
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const report::WorkPrecision& p = chosen[i];
    if (i == 0 || p.method != chosen[i - 1].method) candidate.method.clear();
    const bool good = p.converged && p.error + p.reference_uncertainty <= error;
    if (!good)
      candidate.method.clear();
    else if (candidate.method.empty() || takes_less(p))
      candidate = {p.method, p.setting, p.seconds_median}, work = p.work;
    const bool last = i + 1 == chosen.size() || chosen[i + 1].method != p.method;
    if (last && !candidate.method.empty() && candidate.seconds < best.seconds) best = candidate;
  }
  return best;
}

namespace {

// "0.1 %", "10⁻⁶", "5·10⁻⁴".
std::string size_of(double error) {
  if (error > 0.9995e-3) return fmt::format("{:g} %", 100 * error);
  const std::string text = fmt::format("{:.0e}", error);  // "5e-04"
  const std::size_t e = text.find('e');
  std::string power = "10⁻";
  for (const char digit : std::to_string(-std::stoi(text.substr(e + 1))))
    power += std::array{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"}[std::size_t(digit - '0')];
  return text.substr(0, e) == "1" ? power : text.substr(0, e) + "·" + power;
}

}  // namespace

std::string answer(const Points& points, const std::string& quantity,
                   std::initializer_list<double> errors) {
  std::string text;
  std::size_t sizes_end = 0;  // where another error goes that the same method meets
  std::optional<Cheapest> before;
  for (const double error : errors) {
    const Cheapest best = cheapest(points, quantity, error);
    if (before && before->method == best.method && before->setting == best.setting) {
      const std::string size = " or " + size_of(error);
      text.insert(sizes_end, size);
      sizes_end += size.size();
      continue;
    }
    before = best;
    text += fmt::format("{} {}", text.empty() ? "For an error of" : "; of", size_of(error));
    sizes_end = text.size();
    text += ' ';
    const bool timed = !best.method.empty() && best.seconds > 0;
    if (best.method.empty())
      text += "none of the settings tried";
    else
      text +=
          timed ? fmt::format("use {}{}{} ({})", best.method, best.setting.empty() ? "" : " with ",
                              best.setting, duration(best.seconds))
                : "(not timed)";
  }
  return text + ".";
}

}  // namespace railbook::bench
