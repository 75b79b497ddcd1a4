/*** ## The same by integration in time

Each formula above is now met by what it stands for: a wheel on a sine, (1) integrated step by step (Runge-Kutta of order 5 with a local error of
10⁻¹³) until the start is forgotten.

{{table-time}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "items.hpp"
#include "num/dopri5.hpp"

namespace railbook::quality_chapter {

using namespace railbook;

namespace {

struct Amplitudes {
  double stroke = 0;  // per metre of track
  double force = 0;   // N/m
};

/*** On a unit sine, after the transient has decayed, the amplitude of a quantity follows from two values a quarter of a period apart.
*/
Amplitudes integrated(const quality::Car& car, double frequency) {
  using State = Eigen::Vector2d;
  const double rate = 2 * units::pi * frequency;
  const auto f = [&](double t, const State& s, State& d) {
    d[0] = s[1];
    d[1] =
        rate * rate * std::sin(rate * t) - (car.damping * s[1] + car.stiffness * s[0]) / car.body;
  };
  const auto force = [&](double t, const State& s) {
    return -car.wheel * rate * rate * std::sin(rate * t) - car.damping * s[1] -
           car.stiffness * s[0];
  };
  const double decay = car.damping / (2 * car.body);
  num::Dopri5<2> ode{State{1e-13, 1e-13 * rate}, 0.01 / rate};
  ode.restart(f, 0, State::Zero());
  const double end = 32 / decay;
  while (ode.t() < end)
    if (!ode.step(f, end)) return {};
  const double x = ode.y()[0], g = force(end, ode.y());
  const double later = end + 0.25 / frequency;
  while (ode.t() < later)
    if (!ode.step(f, later)) return {};
  return {std::hypot(x, ode.y()[0]), std::hypot(g, force(later, ode.y()))};
}

/*** The squared magnitude (6) as the paper means it, term by term, and (5) as a ratio of polynomials. */
double printed_6(const quality::Car& car, double frequency) {
  const quality::Suspension s = suspension(car);
  const double r = car.body / car.wheel, q2 = (1 + r) * s.damping * s.damping;
  const double f2 = frequency * frequency, own = s.frequency * s.frequency, upper = own * (1 + r);
  const double pi4 = std::pow(2 * units::pi, 4);
  return std::sqrt(pi4 * car.wheel * car.wheel * f2 * f2 *
                   (f2 * f2 + 2 * (2 * q2 - 1) * f2 * upper + upper * upper) /
                   (f2 * f2 + 2 * (2 * s.damping * s.damping - 1) * f2 * own + own * own));
}

double printed_5(const quality::Car& car, double frequency) {
  const std::complex<double> s{0, 2 * units::pi * frequency};
  const auto [m, M, k, b] = car;
  return std::abs(s * s * (M * m * s * s + (M + m) * b * s + (M + m) * k) /
                  (M * s * s + b * s + k));
}

void table_time(report::Item& item) {
  const quality::Car A = car(item, "A").car, stroke_car = quality::make_car(1, 1, roll);
  item.columns({"quantity", "closed form", "integrated", "relative difference"});
  const std::vector<double> lengths{20, 55, 100, 300};
  const std::vector<double> frequencies{0.5, 2, 10};
  item.expect_checks(static_cast<int>(lengths.size() + 3 * frequencies.size()) + 2);
  const auto compare = [&](const std::string& id, const std::string& what, const char* unit,
                           double closed, double numeric) {
    item.agree(id, what, unit, closed, numeric, 1e-8, "integration of (1) and (2) in time");
    item.add_row({what, fmt::format("{:.8g}", closed), fmt::format("{:.8g}", numeric),
                  fmt::format("{:.1e}", std::abs(closed / numeric - 1))});
  };
  for (const double w : lengths)
    compare(fmt::format("stroke-{:g}", w), fmt::format("|X/Z| (4) at {:g} m, 100 km/h", w), "",
            quality::stroke_gain(roll, track_speed / w),
            integrated(stroke_car, track_speed / w).stroke);
  for (const double f : frequencies) {
    const double closed = std::abs(quality::force_gain(A, f));
    compare(fmt::format("force-{:g}", f), fmt::format("|G/Z| at {:g} Hz, car A", f), "N/m", closed,
            integrated(A, f).force);
    item.agree(fmt::format("six-{:g}", f), fmt::format("|G/Z| at {:g} Hz, car A", f), "N/m", closed,
               printed_6(A, f), 1e-12, "equation (6), its first factor (2π)⁴m²v⁴φ⁴");
    item.agree(fmt::format("five-{:g}", f), fmt::format("|G/Z| at {:g} Hz, car A", f), "N/m",
               closed, printed_5(A, f), 1e-12, "equation (5), a sine put in");
  }
  // On the envelope: the worst of all speeds just uses up the limit.
  const auto worst_stroke = [&](double wavelength, double from, double to) {
    double worst = 0;
    for (int i = 0; i <= 24; ++i) {
      const double v = from + (to - from) * i / 24;
      worst = std::max(worst, integrated(stroke_car, v / wavelength).stroke);
    }
    return worst;
  };
  const double flat = quality::allowed_amplitude(severity(inch_limit, track_speed, 1.0 / 30));
  const double resonant = 30 * quality::stroke_peak(roll.damping).ratio * roll.frequency;
  compare("envelope-30", "worst stroke on the envelope over its limit, 30 m", "", 1.0,
          flat * worst_stroke(30, resonant - 6 * kmh, resonant + 6 * kmh) / inch_limit.stroke);
  const double tail = quality::allowed_amplitude(severity(inch_limit, track_speed, 1.0 / 80));
  compare("envelope-80", "worst stroke on the envelope over its limit, 80 m", "", 1.0,
          tail * worst_stroke(80, 20 * kmh, track_speed) / inch_limit.stroke);
  item.reconstructed("the paper prints no responses; car A is ours");
}

}  // namespace

void add_time_domain(report::Chapter& chapter) {
  chapter.table("table-time", "Closed forms against integration in time", table_time);
}

}  // namespace railbook::quality_chapter
