/***
The last rows are the whole chain: simulated car, sensors, reconstruction. Errors are of the left profile against the true rail, unless they say otherwise; for *fails*, the
program `process` at least says in a note that a sensor seems stuck.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "experiment.hpp"
#include "items.hpp"
#include "units/input_error.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Bench {
  Track track;
  Car car;
  Processing p;
  Measurement truth;
};

const Bench& bench() {
  static const Bench result = [] {
    TrackDescription line = main_line(6);
    line.length = 4000 * foot;
    const Car car;
    const Processing p{.layout = car.layout};
    const Track track = build(line);
    return Bench{track, car, p, geometry_car::truth(track, p)};
  }();
  return result;
}

// The largest error of the left profile over the rows of one quality, and how many they are.
Misfit worst(const Measurement& m, Quality wanted) {
  const Bench& b = bench();
  const auto q = quality(m, Parameter::profile_left, b.p);
  Misfit result;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (q[i] != wanted) continue;
    const double e = m[Parameter::profile_left][i] -
                     b.truth[Parameter::profile_left][static_cast<std::size_t>(m.mark[i])];
    result.largest = std::max(result.largest, std::abs(e));
    ++result.rows;
  }
  return result;
}

void journeys(report::Item& item) {
  const Bench& b = bench();
  const auto add = [&](const char* id, const char* what, const char* stress, const Motion& motion) {
    const auto m = reconstruct(drive(b.track, b.car, motion), b.p);
    const Misfit good = worst(m, Quality::good), bad = worst(m, Quality::unreliable);
    item.stability(
        id, what, stress,
        fmt::format(
            "{} runs; {} good rows, at most {:.2f} mm off; {} unreliable ones, up to {:.3g} mm",
            m.runs, good.rows, good.largest / mm, bad.rows, bad.largest / mm),
        good.largest, good.rows > 0 && good.largest < 0.5 * mm ? "holds" : "degraded");
  };
  const double start = 80 * foot, v = 60 * mph;
  add("car-stop", "car: a stop of 30 s", "T 3000 times longer for one sample",
      Motion{.start = start, .speed = v}
          .cruise(350)
          .change_speed(0, 1.5)
          .stand(30)
          .change_speed(v, 1.5)
          .cruise(200));
  add("car-turn", "car: a stop, and back", "marks count down",
      Motion{.start = start, .speed = v}
          .cruise(350)
          .change_speed(0, 1.5)
          .stand(5)
          .change_speed(-v, 1.5)
          .cruise(100));
  add("car-brake", "car: emergency braking, 60 to 20 mph at 2.5 m/s²", "speed changes 1 % a foot",
      Motion{.start = start, .speed = v}.cruise(350).change_speed(20 * mph, 2.5).cruise(600));
}

void faults(report::Item& item) {
  const Bench& b = bench();
  const Record clean = cruise(b.track, b.car, 60 * mph);
  const auto whole = reconstruct(clean, b.p);
  const std::size_t at = clean.size() / 2;
  const auto add = [&](const char* id, const char* what, const char* stress, const Record& r,
                       std::size_t inserted) {
    const auto m = reconstruct(r, b.p);
    std::size_t masked = 0;
    double off = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const double v = m[Parameter::profile_left][i < at ? i : i + inserted],
                   v0 = whole[Parameter::profile_left][i];
      if (std::isnan(v0)) continue;
      if (std::isnan(v))
        ++masked;
      else
        off = std::max(off, std::abs(v - v0));
    }
    const bool clear = off < 1e-5;
    item.stability(
        id, what, stress,
        fmt::format("{} rows rejected, {} of {} masked, others changed by {:.2g} mm at most",
                    m.rejected, masked, whole.size(), off / mm),
        off,
        !clear       ? "degraded"
        : masked > 0 ? "refused"
                     : "holds");
  };
  Record pulse = clean;
  const auto place = static_cast<std::ptrdiff_t>(at);
  pulse.elapsed.insert(pulse.elapsed.begin() + place, 0.0);
  pulse.mark.insert(pulse.mark.begin() + place, clean.mark[at]);
  for (auto& v : pulse.values) v.insert(v.begin() + place, 99.0);
  add("car-pulse", "car: a pulse too many", "T = 0, wild values", pulse, 1);
  Record clock = clean;
  clock.elapsed[at] = -1e-3;
  add("car-clock", "car: a foot of negative time", "a mark is lost: two runs", clock, 0);
  Record plug = clean;
  plug[Channel::height_left][at] = none;
  add("car-plug", "car: one value missing", "NaN into running sums", plug, 0);
  Record spike = clean;
  spike[Channel::vertical_left][at] += 10 * units::standard_gravity;
  add("car-spike", "car: one spike of 10 g in a vertical accelerometer", "a single wrong value",
      spike, 0);
  Record stuck = clean;
  for (double& v : stuck[Channel::height_left]) v = 0;
  const double rms = misfit(reconstruct(stuck, b.p), b.truth, Parameter::profile_left).rms;
  item.stability("car-stuck", "car: a height sensor stuck", "nothing to tell it from a smooth ride",
                 fmt::format("RMS error {:.1f} mm, not flagged", rms / mm), rms, "fails");
}

void limits(report::Item& item) {
  const Bench& b = bench();
  Record r = cruise(b.track, b.car, 60 * mph);
  for (const std::size_t rows : {663UL, 662UL}) {
    r.elapsed.resize(rows);
    r.mark.resize(rows);
    for (auto& v : r.values) v.resize(rows);
    const auto id = fmt::format("car-{}", rows), what = fmt::format("car: a record of {} ft", rows);
    try {
      const auto m = reconstruct(r, b.p);
      const Misfit e = misfit(m, b.truth, Parameter::profile_left);
      item.stability(id, what, "the window of the composite filter",
                     fmt::format("{} value, {:.3f} mm off", e.rows, e.largest / mm), e.largest,
                     "holds");
    } catch (const InputError& refusal) {
      item.stability(id, what, "one foot less than the window", refusal.what(), none, "refused");
    }
  }
  for (const double corner : {0.01, 10.0, 100.0}) {
    Car car = b.car;
    car.layout.second_corner = corner;
    Processing p = b.p;
    p.layout = car.layout;
    const double rms = misfit(reconstruct(cruise(b.track, car, 60 * mph), p), b.truth,
                              Parameter::profile_left, 400)
                           .rms;
    item.stability(fmt::format("car-corner-{}", corner),
                   fmt::format("car: corner of F at {} Hz, 60 mph", corner),
                   corner < 1
                       ? "1/κ² = 2e6"
                       : fmt::format("κ = {:.1f}", 2 * units::pi * corner * foot / (60 * mph)),
                   fmt::format("RMS error {:.3g} mm with perfect sensors", rms / mm), rms,
                   rms < 0.1 * mm ? "holds" : "degraded");
  }
  TrackDescription line = main_line(8);
  line.length = 40000 * foot;
  const Track track = build(line);
  const auto m = reconstruct(cruise(track, b.car, 80 * mph), b.p),
             t = geometry_car::truth(track, b.p);
  const auto part = [&](std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i)
      sum += std::pow(m[Parameter::profile_left][i] -
                          t[Parameter::profile_left][static_cast<std::size_t>(m.mark[i])],
                      2);
    return std::sqrt(sum / static_cast<double>(to - from));
  };
  const double first = part(1000, 7000), last = part(m.size() - 7000, m.size() - 1000);
  item.stability("car-long", "car: 7.6 miles, its first and last mile", "drift of any sum",
                 fmt::format("RMS error {:.4f} mm at the beginning, {:.4f} mm at the end",
                             first / mm, last / mm),
                 std::abs(last - first), last < 1.5 * first + 0.005 * mm ? "holds" : "fails");
}

}  // namespace

void car_stability(report::Item& item) {
  journeys(item);
  faults(item);
  limits(item);
}

}  // namespace railbook::filters_chapter
