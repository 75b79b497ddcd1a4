/***
## What spoils the measurement

### How well must the analog corner be known?

The digital filter removes the memory of an analog filter whose corner it is given. Resistors and
capacitors drift, so that the true corner is another. In the table the corners of the analog filters
$B$ (of the yaw gyro) and $F$ (of the accelerometers) are both off by a fraction $\delta$, and the
processing does not know it. The second column is what this does to the gain of $B$ and of $C$, the
digital filter that undoes it; the others are the errors of the car at 60 mph over the standard
track with perfect sensors.

{{corner-off}}

{{corner-answer}}

The reason is the motion of the body. For waves faster than the corner, the analog filter of the
accelerometers passes $(1+\delta)^2$ times as much as the digital one assumes, so that their gain is
wrong by this factor. The height sensors have no such factor, and the motion of the body no longer
cancels between the two.

### How fine and how steady must the clock be?

The time $T$ between two samples enters the profile squared. A clock that counts in steps rounds
each time of passing to the next step. It loses no count: what it takes from one foot it gives to
the next, so that for waves of many feet most of the error cancels.

{{clock-step}}

{{clock-answer}}

A reading of the clock may also be off by chance. Here each has an independent error of mean 0 that
the processing does not know:

{{clock-jitter}}

{{jitter-answer}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/num/random_source.hpp>

#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

// The largest difference of |BC| between 9 and 80 mph when the corner of B is off by a fraction.
double spread(double off) {
  double largest = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double theta = units::pi * i / 1000;
    const auto gain = [&](double speed) {
      const double kappa = kappa_at(speed);
      return std::abs(filters::first_order_analog((1 + off) * kappa, theta) *
                      filters::first_order_digital(kappa, theta));
    };
    largest = std::max(largest, std::abs(gain(9 * mph) - gain(80 * mph)));
  }
  return largest;
}

struct Errors {
  double profile, alignment, crosslevel;  // RMS, m
};
Errors errors_of(const Record& record) {
  const Measurement m = reconstruct(record, chosen_processing());
  const auto of = [&](Parameter p) { return rms_error(m, main_line().truth, p, 700); };
  return {of(Parameter::profile_left), of(Parameter::alignment_left), of(Parameter::crosslevel)};
}

// A run at 60 mph with analog filters whose corners are off by a fraction.
Record with_corners_off(double off) {
  Line line{main_line().track, chosen_car(), {}};
  line.car.layout.first_corner *= 1 + off;
  line.car.layout.second_corner *= 1 + off;
  return cruise(line, 60 * mph);
}

// The clock rounds each time of passing to the next of its steps, s.
Record with_clock_steps(Record r, double step) {
  double time = 0, counted = 0;
  for (double& T : r.elapsed) {
    const double before = counted;
    time += T;
    counted = step * std::round(time / step);
    T = counted - before;
  }
  return r;
}

// Each clock reading is off by an independent normal error, which the processing takes for the
// time.
Record with_jitter(Record r, double deviation) {
  const num::RandomSource errors{1, 1};
  for (std::size_t k = 1; k < r.elapsed.size(); ++k)
    r.elapsed[k] += deviation * (errors.normal(k) - errors.normal(k - 1));
  return r;
}

void corner_off(report::Item& item) {
  item.added("not in the paper");
  item.columns({{"corner off by, %", "{:g}"},
                {"|BC| at 9 and 80 mph differ by", "{:.4f}"},
                {"profile, mm", "{:.3f}"},
                {"alignment, mm", "{:.3f}"},
                {"crosslevel, mm", "{:.3f}"}});
  double nominal = 0, one_percent = 0;
  for (const double percent : {-5.0, -1.0, -0.5, 0.0, 0.2, 0.5, 1.0, 5.0}) {
    const double off = percent / 100;
    const Errors e = errors_of(with_corners_off(off));
    item.add_row(percent, spread(off), e.profile / mm, e.alignment / mm, e.crosslevel / mm);
    if (percent == 0) nominal = e.profile;
    if (std::abs(percent) == 1) one_percent = std::max(one_percent, e.profile);
  }
  const double tolerable = std::floor(10 * 0.1 * mm / one_percent) / 10;  // per cent
  item.value("off-1-percent", one_percent / mm, "mm", "{:.2f}");
  item.value(
      "corner-answer",
      fmt::format(
          "A corner that is 1 % off makes the error of the profile {:.2f} mm RMS instead "
          "of {:.2f}. Since the error is nearly in proportion, a corner that is measured to "
          "{:.1f} % keeps it below 0.1 mm. The digital filter works with any corner; it only "
          "has to be told.",
          one_percent / mm, nominal / mm, tolerable));
  item.value("corner-tolerable", tolerable, "%", "{:.1f}");
}

void clock_step(report::Item& item) {
  item.added("not in the paper");
  item.columns({{"step, µs", "{:g}"},
                {"step, % of the time of a foot", "{:.3g}"},
                {"error of a reading, µs RMS", "{:.3g}"},
                {"profile, mm", "{:.3f}"},
                {"alignment, mm", "{:.3f}"},
                {"crosslevel, mm", "{:.3f}"}});
  const Record clean = cruise(main_line(), 60 * mph);
  double coarsest = 0;  // that leaves the profile below 0.1 mm
  for (const double step : {1e-6, 1e-5, 1e-4, 2e-4, 5e-4, 1e-3}) {
    const Errors e = errors_of(with_clock_steps(clean, step));
    item.add_row(1e6 * step, 100 * step / (foot / (60 * mph)), 1e6 * step / std::sqrt(12),
                 e.profile / mm, e.alignment / mm, e.crosslevel / mm);
    if (e.profile < 0.1 * mm) coarsest = step;
  }
  item.value(
      "clock-answer",
      fmt::format("Of the steps tried, the largest fine enough for 0.1 mm at 60 mph is {:g} µs.",
                  1e6 * coarsest));
  item.value("step-tolerable", 1e6 * coarsest, "µs", "{:g}");
}

void clock_jitter(report::Item& item) {
  item.added("not in the paper");
  item.columns({{"error of a reading, µs RMS", "{:g}"},
                {"error, % of the time of a foot", "{:.3g}"},
                {"profile, mm", "{:.3f}"},
                {"alignment, mm", "{:.3f}"},
                {"crosslevel, mm", "{:.3f}"}});
  const Record clean = cruise(main_line(), 60 * mph);
  double largest = 0;  // that leaves the profile below 0.1 mm
  for (const double deviation : {1e-5, 1e-4, 2e-4, 3e-4, 1e-3}) {
    const Errors e = errors_of(with_jitter(clean, deviation));
    item.add_row(1e6 * deviation, 100 * deviation / (foot / (60 * mph)), e.profile / mm,
                 e.alignment / mm, e.crosslevel / mm);
    if (e.profile < 0.1 * mm) largest = deviation;
  }
  item.value(
      "jitter-answer",
      fmt::format("Of those tried, the largest independent error of a reading that keeps the "
                  "profile within 0.1 mm at 60 mph is {:g} µs RMS.",
                  1e6 * largest));
  item.value("jitter-tolerable", 1e6 * largest, "µs RMS", "{:g}");
}

}  // namespace

const report::Section mismatch{report::table("corner-off", corner_off),
                               report::table("clock-step", clock_step),
                               report::table("clock-jitter", clock_jitter)};

}  // namespace railbook::filters_chapter
