/*** ## When the speed changes

For unequal intervals, $r=T_{k+1}/T_k$, the mean over both gives, in the limit of a low corner,

$$D_k=z_{k+1}-(1+r)z_k+rz_{k-1},\qquad m_k=-\tfrac12\left[D_k+(r-1)(z_k-z_{k-1})\right].$$

The second term is geometry, not filtering: on a grade, a car that brakes has a vertical acceleration, and the offset of a chord has not. It is worth
$\frac12\,$grade$\,\dot V d^2/V^2$ a sample, and no vertical accelerometer knows the grade. Either the step $z_k-z_{k-1}$ comes from somewhere, a measured pitch
or a long-wave profile of an earlier pass; or the accelerometer pitches with the track, and reads $V^2z''$ instead of $\ddot z$, which is nearly so in a car on
long waves: then the term is not in the signal and needs no correction.

The table runs an accelerometer that follows the rail (waves of 62, 39 and 20 ft, 5, 3 and 1 mm, on the grade named) through the analog filter, by numerical integration, and gives
the error of the 62-ft chord after the high-pass.

{{varying-speed}}

"Local" is $G$ with the last interval used twice, the filter a programmer writes who thinks of one speed at a time. It is hardly worse than
the exact one without the slope: the missing slope is most of the error. With it, the exact filter is
{{varying-gain}} times better in the braking run. At constant speed all of them agree.
*/
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "configuration.hpp"
#include "filters/geometry_chain.hpp"
#include "filters/hybrid_filter.hpp"
#include "items.hpp"
#include "num/dopri5.hpp"

namespace railbook::filters_chapter {
namespace {

struct Run {
  std::string what;
  double from, to, rate;  // m/s, m/s^2
  double grade;
};

struct Wave {
  double amplitude, wavelength;
};
constexpr Wave waves[] = {
    {5e-3, 62 * units::foot}, {3e-3, 39 * units::foot}, {1e-3, 20 * units::foot}};

double height(double x, double grade) {
  double z = grade * x;
  for (const Wave& w : waves) z += w.amplitude * std::sin(2 * units::pi * x / w.wavelength);
  return z;
}
double slope(double x, double grade) {
  double s = grade;
  for (const Wave& w : waves)
    s += w.amplitude * 2 * units::pi / w.wavelength * std::cos(2 * units::pi * x / w.wavelength);
  return s;
}
double bend(double x) {
  double b = 0;
  for (const Wave& w : waves) {
    const double k = 2 * units::pi / w.wavelength;
    b -= w.amplitude * k * k * std::sin(k * x);
  }
  return b;
}

// Samples a foot apart of the filtered acceleration; `pitching` leaves the part of the grade out of it.
struct Samples {
  std::vector<double> T, y;
};
Samples measure(const Run& run, bool pitching) {
  const filters::SecondOrderLowPass f{acceleration_corner, 1};
  const auto rate = [&](double t, const Eigen::Vector2d& y, Eigen::Vector2d& dy) {
    const double v = run.from + run.rate * t, x = run.from * t + 0.5 * run.rate * t * t;
    const double a = v * v * bend(x) + (pitching ? 0 : run.rate * slope(x, run.grade));
    dy = {y[1], f.omega * f.omega * (a - y[0]) - 2 * f.damping * f.omega * y[1]};
  };
  const double length = run.rate == 0 ? 3000 * sample_distance
                                      : (run.to * run.to - run.from * run.from) / (2 * run.rate);
  num::Dopri5<2> solver{Eigen::Vector2d::Constant(1e-10), 1e-3};
  solver.restart(rate, 0, Eigen::Vector2d::Zero());
  Samples samples;
  double before = 0;
  for (int k = 1; k * sample_distance < length; ++k) {
    const double x = k * sample_distance;
    const double t = 2 * x / (run.from + std::sqrt(run.from * run.from + 2 * run.rate * x));
    while (solver.t() < t)
      if (!solver.step(rate, t)) throw std::runtime_error{"varying speed: no step"};
    samples.T.push_back(t - before);
    samples.y.push_back(solver.y()[0]);
    before = t;
  }
  return samples;
}

// RMS error of the 62-ft chord, mm.
double chord_error(const Run& run, const Samples& samples, bool local, bool with_slope) {
  filters::SecondOrderHybrid g{{acceleration_corner, 1}, {.local = local}};
  std::vector<double> error;
  for (std::size_t k = 0; k < samples.y.size(); ++k) {
    const auto u = g.push(samples.y[k], samples.T[k]);
    if (!std::isfinite(u.mean)) continue;
    const double x = static_cast<double>(k) * sample_distance;  // of the sample before: the middle
    const double z = height(x, run.grade), before = height(x - sample_distance, run.grade);
    const double truth = z - 0.5 * (before + height(x + sample_distance, run.grade));
    const filters::TwoIntervals used{u.mean, local ? u.T_after : u.T_before, u.T_after};
    error.push_back(filters::short_chord(used, with_slope ? z - before : 0) - truth);
  }
  const auto chord = filters::geometry(error).chord;
  double square = 0, count = 0;
  for (const double m : chord)
    if (!std::isnan(m)) square += m * m, count += 1;
  return std::sqrt(square / count) / units::millimetre;
}

void varying_speed(report::Item& item) {
  const std::vector<Run> runs{
      {"30 mph", 30 * units::mph, 0, 0, 0.01},
      {"5 to 80 mph at 0.5 m/s², level", 5 * units::mph, 80 * units::mph, 0.5, 0},
      {"5 to 80 mph at 0.5 m/s², 1 % grade", 5 * units::mph, 80 * units::mph, 0.5, 0.01},
      {"60 to 9 mph at −0.3 m/s², level", 60 * units::mph, 9 * units::mph, -0.3, 0},
      {"60 to 9 mph at −0.3 m/s², 1 % grade", 60 * units::mph, 9 * units::mph, -0.3, 0.01}};
  item.columns({"run", "local, mm", "exact, no slope", "exact, true slope", "exact, pitching"});
  double gain = 0;
  for (const Run& run : runs) {
    const Samples level = measure(run, false), pitching = measure(run, true);
    const double local = chord_error(run, level, true, false),
                 none = chord_error(run, level, false, false);
    const double with = chord_error(run, level, false, true),
                 pitched = chord_error(run, pitching, false, false);
    const auto text = [](double e) { return fmt::format("{:.4f}", e); };
    item.add_row({run.what, text(local), text(none), text(with), text(pitched)});
    gain = none / with;
  }
  item.value("varying-gain", gain, "", "{:.0f}");
  item.reconstructed(
      "track, runs and corner are ours; the paper says only that the time between samples is "
      "measured");
}

}  // namespace

void add_varying_speed(report::Chapter& chapter) {
  chapter.table("varying-speed", "RMS error of the 62-ft chord when the speed changes",
                varying_speed);
}

}  // namespace railbook::filters_chapter
