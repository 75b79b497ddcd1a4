/*** ## How good is the profile, and what spoils it

Straight track, two equal rails, a bouncing body; each source of error on its own. The table gives the RMS error of the high-passed 62-ft
chord, whose true values have an RMS of {{errors-truth}}.

{{table-errors}}

{{fig-errors}}

{{include: other_tracks.cpp}}

An *ideal* instrument has a hybrid filter and nothing else, and its error is the small-$\kappa$ statement of above made of flesh: the product $F\cdot G$ averages
over two samples with a kernel that is a triangle only while $\kappa=\omega_2T$ is small. At {{errors-15}} the ideal error is {{ideal-15}}, at 5 mph {{ideal-5}}, and below
2 mph, where the body's bounce is slower than a sample, it runs away. A lower corner makes it as much smaller: ten times at 0.1 Hz.

But the lower corner costs resolution, for the digital filter has to amplify what the analog one took away. A converter of step $q$ leaves the floor
$\frac{q}{\sqrt{12}}\sqrt{1.5}/\omega_2^2$ at high speed: {{floor-1}} with 12 bits over ±1 g and a corner of 1 Hz, {{floor-01}} with 0.1 Hz. So the corner
is a compromise, and 1 Hz is about right for the 12-bit converters of the time. At low speed quantisation rises like $V^{-2}$, white noise like $V^{-1.5}$ (measured:
{{noise-slope}}).

This is why the paper calls profile and alignment degraded below 15 mph and not to be relied upon below 5: with 12 bits the error is {{twelve-15}} at 15 mph
and {{twelve-5}} at 5 mph, and grows tenfold once more down to 2 mph. Which error still is one that matters is a judgement, and the paper does
not tell its own; the speeds are consistent with limits of about 0.2 mm and 1.6 mm.

{{table-budget}}

The budget checks each line of the table against mathematics: a constant bias against $-bL^2/8V^2$ (without high-pass; with it, it vanishes), steps against their floors,
gyro biases against $b/V$ in curvature and $(n\tau+2/\omega_2)b$ in roll, of which $2/\omega_2$ belongs to the analog filter ahead of the inclinometer. An
error of one per cent in the yaw gyro's gain tilts the track in a curve by a hundredth of the centrifugal acceleration. An error of speed counts
as much, and no more: the gyro feels $V\kappa$ at the true speed, so the correction $V\dot\psi$ is linear in the measured one.
*/
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiment.hpp"
#include "filters/chord_filter.hpp"
#include "filters/complementary.hpp"
#include "items.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

constexpr double g = units::standard_gravity;
constexpr double bits_12 = 2 * g / 4096, bits_16 = 2 * g / 65536, density = 20e-6 * g,
                 step = 0.1 * mm;

struct Source {
  std::string name, heading;
  double corner;  // of F, Hz
  double converter = 0, noise = 0, displacement = 0;
};
const std::vector<Source>& sources() {
  static const std::vector<Source> list{
      {"ideal-1.0", "ideal, 1 Hz", 1.0},
      {"ideal-0.1", "ideal, 0.1 Hz", 0.1},
      {"noise", "noise 20 µg/√Hz", 1.0, 0, density},
      {"12-bit", "12 bits, ±1 g", 1.0, bits_12},
      {"16-bit", "16 bits, ±1 g", 1.0, bits_16},
      {"displacement", "height steps 0.1 mm", 1.0, 0, 0, step},
      {"12-bit-0.1", "12 bits, 0.1 Hz", 0.1, bits_12},
      {"noise-0.1", "noise, 0.1 Hz", 0.1, 0, density},
  };
  return list;
}

const std::vector<double>& speeds() {
  static const std::vector<double> list{0.5, 0.7, 1, 1.4, 2, 3, 5, 9, 15, 30, 60, 120};
  return list;
}

// RMS errors (m) of the left profile, [speed][source], and of the truth.
struct Errors {
  std::vector<std::vector<double>> rms;
  double truth = 0;
  double at(double speed, const std::string& source) const {
    std::size_t i = 0, j = 0;
    while (speeds()[i] != speed) ++i;
    while (sources()[j].name != source) ++j;
    return rms[i][j];
  }
};

const Errors& errors() {
  static const Errors result = [] {
    Errors e;
    const Track track = build(bounce_line());
    const auto t = truth(track, {});
    for (const double speed : speeds()) {
      std::vector<double> row;
      double corner = 0;
      Record clean;
      for (const Source& s : sources()) {
        const Car car = bounce_car(s.corner);
        if (s.corner != corner) clean = cruise(track, car, speed * mph);
        corner = s.corner;
        Sensors sensors;
        for (const Channel c : {Channel::vertical_left, Channel::vertical_right})
          sensors[c] = {.density = s.noise, .step = s.converter};
        for (const Channel c : {Channel::height_left, Channel::height_right})
          sensors[c].step = s.displacement;
        const Processing p{.layout = car.layout};
        const auto m = reconstruct(measured(clean, car.layout, sensors, 1), p);
        row.push_back(misfit(m, t, Parameter::profile_left, 600).rms);
        if (e.truth == 0) {
          double sum = 0;
          int n = 0;
          for (const double v : t[Parameter::profile_left])
            if (!std::isnan(v)) sum += v * v, ++n;
          e.truth = std::sqrt(sum / n);
        }
      }
      e.rms.push_back(row);
    }
    return e;
  }();
  return result;
}

void table_errors(report::Item& item) {
  item.reconstructed("the paper gives no error, track, ride, corner or sensor");
  const auto earlier = item.printed("profile-errors.csv");
  const Errors& e = errors();
  int cells = 0;
  for (const auto& row : earlier.rows)
    for (std::size_t c = 1; c < row.size(); ++c)
      cells += row[c].empty() || row[0] == "truth" ? 0 : 1;
  item.expect_checks(cells);
  std::vector<std::string> headings{"mph"};
  for (std::size_t j = 0; j < 6; ++j) headings.push_back(sources()[j].heading + ", mm");
  item.columns({headings.begin(), headings.end()});
  const double scale = e.truth / mm / report::printed_number(earlier.at("truth", "ideal-1.0"));
  for (const auto& row : earlier.rows) {
    if (row[0] == "truth") continue;
    const double speed = report::printed_number(row[0]);
    std::vector<std::string> line{row[0]};
    for (std::size_t c = 1; c < row.size(); ++c) {
      const Source& source = sources()[c - 1];
      const double rms = e.at(speed, source.name) / mm;
      line.push_back(fmt::format("{:.3g}", rms));
      if (row[c].empty()) continue;
      item.agree(
          fmt::format("{}-{}", row[0], source.name),
          fmt::format("{} mph, {}", row[0], source.heading), "mm", rms,
          scale * report::printed_number(row[c]), 0.2,
          "an earlier program on another track, scaled by the truths; it names a scatter of 20 %");
    }
    item.add_row(line);
  }
  item.value("errors-truth", e.truth / mm, "mm", "{:.2f}");
  item.value("errors-15", 15, "mph", "{:.0f}");
  item.value("ideal-15", e.at(15, "ideal-1.0") / mm, "mm", "{:.3f}");
  item.value("ideal-5", e.at(5, "ideal-1.0") / mm, "mm", "{:.2f}");
  item.value("twelve-15", e.at(15, "12-bit") / mm, "mm", "{:.2f}");
  item.value("twelve-5", e.at(5, "12-bit") / mm, "mm", "{:.1f}");
}

void fig_errors(report::Item& item) {
  item.reconstructed("track, ride, corners and sensors are ours");
  std::vector<std::string> columns{"speed_mph"};
  for (const Source& s : sources()) columns.push_back(s.name + "_mm");
  auto& data = item.data(columns);
  const Errors& e = errors();
  for (std::size_t i = 0; i < speeds().size(); ++i) {
    const auto& r = e.rms[i];
    data.add(speeds()[i], r[0] / mm, r[1] / mm, r[2] / mm, r[3] / mm, r[4] / mm, r[5] / mm,
             r[6] / mm, r[7] / mm);
  }
}

// The long chord, without high-pass, of a car that stands on a constant acceleration `bias` at speed v.
double chord_of_bias(double bias, double v) {
  const Layout l;
  filters::SecondOrderHybrid filter{{2 * units::pi * l.second_corner}};
  std::vector<double> offsets;
  for (int k = 0; k < 100; ++k) {
    const auto two = filter.push(bias, l.sample / v);
    if (k >= 2) offsets.push_back(filters::short_chord(two));
  }
  return filters::to_chord_running(offsets, 31).offset.front();
}

// What an error of one channel changes in a parameter in the middle of a long curve (or on a tangent), SI.
double change(double speed, double curve, Parameter parameter, Channel channel,
              const SensorError& error, double sample_error = 0) {
  TrackDescription line = bounce_line();
  line.surface.A = line.dip = line.grade = 0;
  line.length = 1600;
  line.curvature = curve;
  line.curve_begin = 0.1;
  line.curve_length = 1000;
  const Track track = build(line);
  const Car car;
  Processing p{.layout = car.layout};
  const Record clean = cruise(track, car, speed);
  Sensors sensors;
  sensors[channel] = error;
  const auto right = reconstruct(clean, p);
  p.layout.sample *= 1 + sample_error;
  const auto wrong = reconstruct(measured(clean, car.layout, sensors, 1), p);
  const std::size_t k = clean.size() / 2;
  return wrong[parameter][k] - right[parameter][k];
}

void add_gyros(report::Item& item) {
  const Layout l;
  const Processing p;
  const double rate = 0.005 * units::degree;
  for (const double v : {0.5, 1.0, 2.0, 5.0, 80.0})
    item.agree(
        fmt::format("yaw-{}", v), fmt::format("yaw bias 0.005 deg/s at {} mph, curvature", v),
        "deg/100 ft",
        change(v * mph, 0, Parameter::curvature, Channel::yaw_rate, {.bias = rate}) / per_100ft,
        rate / (v * mph) / per_100ft, 1e-6, "b/V");
  const double held = 2 / (2 * units::pi * l.second_corner);
  for (const double v : {0.5, 60.0}) {
    const double T = l.sample / (v * mph);
    item.agree(
        fmt::format("roll-{}", v), fmt::format("roll bias 0.01 deg/s at {} mph, crosslevel", v),
        "mm",
        change(v * mph, 0, Parameter::crosslevel, Channel::roll_rate, {.bias = 2 * rate}) / mm,
        (filters::gyro_bias_error(2 * rate, filters::time_constant(p.roll_corner), p.roll_poles,
                                  T) +
         2 * rate * held) *
            l.base / mm,
        0.01, "poles of the inclinometer's path, analog filter included");
  }
  const double curve = -2 * per_100ft, v = 80 * mph, lateral = v * v * -curve / g * l.base;
  item.agree("centrifugal", "2-degree curve at 80 mph, yaw gain 1 % off, crosslevel", "mm",
             change(v, curve, Parameter::crosslevel, Channel::yaw_rate, {.scale = 0.01}) / mm,
             0.01 * lateral / mm, 0.01, "V^2 kappa/g times the base");
  item.agree("speed", "the same, speed 0.1 % off", "mm",
             change(v, curve, Parameter::crosslevel, Channel::yaw_rate, {}, 0.001) / mm,
             0.001 * lateral / mm, 0.01, "once the speed, not twice");
}

void table_budget(report::Item& item) {
  const Errors& e = errors();
  const std::vector<double> biased{120, 80, 30, 15, 5, 2, 0.5};
  item.expect_checks(static_cast<int>(biased.size()) + 4 + 2 + 5 + 2 + 2);
  const double chord = 62 * foot;
  for (const double v : biased)
    item.agree(fmt::format("bias-{}", v), fmt::format("bias of 1 mg at {} mph, no high-pass", v),
               "mm", chord_of_bias(1e-3 * g, v * mph) / mm,
               -1e-3 * g * chord * chord / (8 * v * mph * v * mph) / mm, 1e-9, "-b L^2/(8 V^2)");
  const auto own = [&](double speed, const char* with, const char* ideal) {
    return std::sqrt(std::pow(e.at(speed, with), 2) - std::pow(e.at(speed, ideal), 2)) / mm;
  };
  const auto floor = [&](double q, double corner) {
    return q / std::sqrt(12.0) * std::sqrt(1.5) / std::pow(2 * units::pi * corner, 2) / mm;
  };
  const std::string high = "high-speed floor q/sqrt(12) sqrt(1.5)/omega^2";
  item.agree("12-bit", "12 bits at 120 mph, 1 Hz", "mm", own(120, "12-bit", "ideal-1.0"),
             floor(bits_12, 1), 0.06, high);
  item.agree("12-bit-0.1", "12 bits at 120 mph, 0.1 Hz", "mm", own(120, "12-bit-0.1", "ideal-0.1"),
             floor(bits_12, 0.1), 0.06, high);
  item.agree("16-bit", "16 bits at 120 mph, 1 Hz", "mm", own(120, "16-bit", "ideal-1.0"),
             floor(bits_16, 1), 0.06, high);
  item.agree("height", "height steps of 0.1 mm at 120 mph", "mm",
             own(120, "displacement", "ideal-1.0"), step / std::sqrt(12.0) * std::sqrt(1.5) / mm,
             0.06, "q/sqrt(12) sqrt(1.5)");
  const auto slope = [&](double from, double to) {
    return std::log(own(to, "noise-0.1", "ideal-0.1") / own(from, "noise-0.1", "ideal-0.1")) /
           std::log(to / from);
  };
  item.agree("noise-low", "exponent of the noise, 9 to 30 mph", "", slope(9, 30), -1.5, 0.05,
             "white noise through a double integral");
  item.agree("noise-high", "exponent of the noise, 15 to 60 mph", "", slope(15, 60), -1.5, 0.05,
             "white noise through a double integral");
  add_gyros(item);
  item.value("noise-slope", slope(9, 60), "", "{:.2f}");
  item.value("floor-1", own(120, "12-bit", "ideal-1.0"), "mm", "{:.3f}");
  item.value("floor-01", own(120, "12-bit-0.1", "ideal-0.1"), "mm", "{:.2f}");
}

}  // namespace

void add_errors(report::Chapter& chapter) {
  chapter.table("table-errors", "RMS error of the profile by speed and source", table_errors);
  chapter.figure("fig-errors", "RMS error of the profile by speed and source", fig_errors);
  chapter.table("table-budget", "The error budget against closed forms", table_budget);
}

}  // namespace railbook::filters_chapter
