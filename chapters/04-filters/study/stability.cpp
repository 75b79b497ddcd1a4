/*** A filter that keeps no memory beyond two samples, as $C$, or three, as $G$, has little to go
wrong: after a stop of an hour $C$ is right at the second sample. With a small $\kappa$ rounding
remains: it is amplified by $1/\kappa$ in $C$, and by $1/\kappa^2$ in $G$. The row that degrades is
one of $C$: its error is given as a fraction of the interval $T$, which is itself short there.

In the car's rows the sensors are perfect but for the fault. The error is the largest at any place
of the record that the program calls *good*, and the number of these places is given. The bound is
what *good* allows for perfect sensors: 0.5 mm of profile and 2 mm of alignment; for crosslevel it
is 7 mm, some three times the RMS error that the library states, for it errs most at speed. A place
of the profile is not good if a foot within the 661 samples that it depends on was slower than 15
mph or lost in a reversal, or if the change of speed on an unknown grade may cost too much. So a
stop in the middle of 3400 ft, with its braking and its start, leaves few good places, and no
warning, since nothing is wrong with the sensors.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include <railbook/bench/evidence.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/geometry_car/health.hpp>

#include "configuration.hpp"
#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

constexpr double corner = acceleration_corner, unit_roundoff = 0x1p-53;

// The error of C over the last of two intervals, on the ramp x = t with a transient that C has to
// take out, as a share of the interval.
double ramp_error(double before, double after) {
  filters::FirstOrderHybrid c{corner};
  const auto analog = [&](double t) {
    return t - 1 / corner + 0.5 * std::exp(-corner * (t + before + after));
  };
  c.push(analog(-before - after), before);
  c.push(analog(-after), before);
  const double u = c.push(analog(0), after);
  return std::abs(u + after * filters::centroid_delay(corner * after)) / after;
}

// F's two modes and a constant, at random intervals: what G makes of it less the constant, over the
// rounding that its weights of 1/kappa^2 allow.
report::Found random_intervals(bench::RandomStream& draw) {
  const double omega = draw.decades(0.1, 100), damping = draw.decades(0.2, 5);
  const double longest = draw.decades(1e-3, 3) / (omega * (1 + damping));
  const std::complex<double> w = std::sqrt(std::complex<double>{damping * damping - 1});
  const std::complex<double> p_1 = omega * (-damping + w), p_2 = omega * (-damping - w);
  filters::SecondOrderHybrid g{{omega, damping}};
  double t = 0, kappa = units::infinity, mean = units::nan;
  for (int k = 0; k < 3; ++k) {
    const double T = longest * draw(0.1, 1);
    t += T;
    if (k > 0) kappa = std::min(kappa, omega * T);
    mean = g.push(1 + (std::exp(p_1 * t) + std::exp(p_2 * t)).real(), T).mean;
  }
  return {fmt::format("ω = {:.3g} rad/s, ζ = {:.2g}, κ = {:.2g}", omega, damping, kappa),
          std::abs(mean - 1) * kappa * kappa};
}

struct IntervalCase {
  const char *id, *what, *stress;
  double before, after;  // s
  report::Expected expect;
  // Four roundings of each of two samples, over the weight 1 - a that C divides by.
  double allowed() const {
    return 8 * unit_roundoff * (before + after + 1 / corner + 0.5) /
           (-std::expm1(-corner * after) * after);
  }
};
const IntervalCase interval_cases[] = {
    {"stop", "C: an hour between two samples", "T → ∞", 0.1, 3600, report::accurate},
    {"start", "C: an hour, then 0.1 s", "T → ∞", 3600, 0.1, report::accurate},
    {"fast", "C: a sample each millimetre at 120 mph", "T → 0", 1e-3 / (120 * mph),
     1e-3 / (120 * mph), report::degraded}};

void intervals(report::Item& item) {
  const int cases = item.full() ? 20'000 : 1'000;
  bench::worst_row(
      item,
      {.id = "random-intervals",
       .what = fmt::format("G: the worst of {} random pairs of poles and intervals", cases),
       .stress = "κ from 1e-4 to 3, intervals 1:10",
       .allowed = 1e-13,
       .reference = "a constant, after F's own modes; times κ²"},
      cases, 41, random_intervals);
  for (const IntervalCase& c : interval_cases)
    item.stability(
        {.id = c.id,
         .what = c.what,
         .stress = c.stress,
         .expect = c.expect,
         .allowed = c.allowed(),
         .reference = "the weighted mean of a ramp; allowed: eight roundings over 1 − a"},
        [&] {
          const double e = ramp_error(c.before, c.after);
          return report::Found{
              e > 0 ? fmt::format("off by {:.0e} of the interval", e) : "right to the last digit",
              e};
        });
}

const Line& line() {
  static const Line result = line_of({.length = 4000 * foot, .seed = 6});
  return result;
}

// What becomes of a record: its good rows, the worst of them, and how many findings the sensors'
// examination made.
report::Found judged(Record record, Parameter parameter = Parameter::profile_left) {
  const Processing processing = chosen_processing();
  const Health health = examine(record, processing);
  const auto m = reconstruct(record, processing);
  const auto q = quality(m, parameter, processing, health);
  std::size_t good = 0;
  double largest = 0;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (q[i] != Quality::good) continue;
    ++good;
    largest = std::max(
        largest,
        std::abs(m[parameter][i] - line().truth[parameter][static_cast<std::size_t>(m.mark[i])]));
  }
  if (good == 0)
    throw report::NoAnswer{
        fmt::format("{} warnings; no place of {} is good", health.findings.size(), m.size())};
  return {fmt::format("{} warning{}; {} of {} places good, off by {:.2g} mm at most",
                      health.findings.size(), health.findings.size() == 1 ? "" : "s", good,
                      m.size(), largest / mm),
          largest};
}

// A journey or a fault, and what may be lost.
struct CarCase {
  const char *id, *what, *stress;
  double allowed;  // m
  std::function<report::Found()> run;
};

// Twice what braking may cost a row of profile and leave it good, and a tenth of a millimetre for
// the rest.
const double usual = 2 * braking_degrades + 0.1 * mm;
constexpr double cruising = 60 * mph;

report::Found driven(double speed, const std::function<void(Motion&)>& travel,
                     Parameter parameter = Parameter::profile_left) {
  Motion m{.start = 80 * foot, .speed = speed};
  travel(m);
  return judged(drive(line().track, chosen_car(), m), parameter);
}

report::Found spoilt(const std::function<void(Record&, std::vector<double>&)>& spoil) {
  static const Record clean = cruise(line(), cruising);
  Record r = clean;
  spoil(r, r[Channel::vertical_left]);
  return judged(r);
}

void from_a_crawl(Motion& m) {
  m.cruise(5).change_speed(28, 2).cruise(600);
}

void clip(std::vector<double>& a) {
  double largest = 0;
  for (const double value : a) largest = std::max(largest, std::abs(value));
  for (double& value : a) value = std::clamp(value, -largest / 2, largest / 2);
}

void add_pulse(Record& r) {
  r.elapsed.insert(r.elapsed.begin() + 1800, 0.0);
  r.mark.insert(r.mark.begin() + 1800, r.mark[1800]);
  for (auto& values : r.values) values.insert(values.begin() + 1800, 99.0);
}

const CarCase car_cases[] = {
    {"car-stop", "car: a stop of 30 s", "one foot takes 2600 times as long", usual,
     [] {
       return driven(cruising, [](Motion& m) {
         m.cruise(350).change_speed(0, 1.5).stand(30).change_speed(cruising, 1.5).cruise(200);
       });
     }},
    {"car-turn", "car: a stop, and back", "the count of feet runs down", usual,
     [] {
       return driven(cruising, [](Motion& m) {
         m.cruise(350).change_speed(0, 1.5).stand(5).change_speed(-cruising, 1.5).cruise(100);
       });
     }},
    {"car-brake", "car: emergency braking, 60 to 20 mph at 2.5 m/s²",
     "the car does not know the grade", usual,
     [] {
       return driven(cruising,
                     [](Motion& m) { m.cruise(350).change_speed(20 * mph, 2.5).cruise(600); });
     }},
    {"car-crawl", "car: alignment from a crawl of 0.3 m/s up",
     "the roll of the beam is not known, and gravity enters", levelling_degrades,
     [] { return driven(0.3, from_a_crawl, Parameter::alignment_left); }},
    {"car-level", "car: crosslevel from a crawl of 0.3 m/s up",
     "at a crawl the inclinometer alone knows it", 7 * mm,
     [] { return driven(0.3, from_a_crawl, Parameter::crosslevel); }},
    {"car-stuck", "car: a height sensor that stands still for 300 ft",
     "could be taken for a smooth ride", usual,
     [] {
       return spoilt([](Record& r, auto&) {
         auto& height = r[Channel::height_left];
         std::fill(height.begin() + 1800, height.begin() + 2100, height[1800]);
       });
     }},
    {"car-spike", "car: one value of an accelerometer off by 1 m/s²", "20 mm of profile", usual,
     [] { return spoilt([](Record&, auto& a) { a[1800] += 1; }); }},
    {"car-clipped", "car: an accelerometer that clips at half its largest value",
     "faults at many places", usual, [] { return spoilt([](Record&, auto& a) { clip(a); }); }},
    {"car-step", "car: an accelerometer's zero steps by 0.15 m/s²", "could be taken for braking",
     usual,
     [] {
       return spoilt([](Record&, auto& a) {
         for (std::size_t i = 1800; i < a.size(); ++i) a[i] += 0.15;
       });
     }},
    {"car-pulse", "car: a pulse too many", "T = 0, wild values", usual,
     [] { return spoilt([](Record& r, auto&) { add_pulse(r); }); }}};

void car(report::Item& item) {
  for (const CarCase& c : car_cases)
    item.stability({.id = c.id,
                    .what = c.what,
                    .stress = c.stress,
                    .allowed = c.allowed,
                    .reference = "the true rail, in m, where called good"},
                   c.run);
}

void stability_table(report::Item& item) {
  item.added("not in the paper");
  intervals(item);
  car(item);
}

}  // namespace

const report::Section stability{report::table("stability", stability_table)};

}  // namespace railbook::filters_chapter
