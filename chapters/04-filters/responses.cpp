/*** ## The hybrid filter

**First order.** The analog filter ahead of the converter is $B(s)=\omega_1/(s+\omega_1)$. Its output at sample $k$, $T_k$ seconds after the last one, is

$$y_k=e^{-\omega_1T_k}y_{k-1}+\int_{t_{k-1}}^{t_k}\omega_1e^{-\omega_1(t_k-t)}x(t)\,dt,$$

whatever the speed did before. So

$$u_k=\frac{y_k-a_ky_{k-1}}{1-a_k},\qquad a_k=e^{-\omega_1T_k},$$

is a weighted mean of the input over one sample interval *and nothing else*. This is the digital filter $C$: two samples, one measured time, no
state, no transient when the speed changes. The slower the analog filter, $\kappa=\omega_1T\to0$, the flatter the weight; in the limit $u_kT_k$ is the plain
integral over a foot, which for a yaw rate is the change of heading per foot that the paper wants.

At constant speed, with $\theta=2\pi\varphi d$ radians a sample,

$$|B|=\frac1{\sqrt{1+\theta^2/\kappa^2}},\quad|C|^2=1+\frac{\sin^2\theta/2}{\sinh^2\kappa/2},\quad|BC|\to\left|\frac{\sin\theta/2}{\theta/2}\right|.$$

{{fig-07}}

{{fig-08}}

{{fig-09}}

The corner is ours: {{corner}}, a configuration value, since the paper's figures cannot be read. At 9 mph it lies at {{corner-9}}, at 80 mph at {{corner-80}}:
fixed in time, moving along the track, by the factor {{corner-ratio}} of the speeds for *any* corner. The curves of
Figure 7 are then those of every first-order filter, moved sideways; those of 8 rise where those of 7 fall; and Figure 9 shows what the
paper says of it. At Nyquist, the worst place, both speeds differ by {{spread}}, and the faster one from the limit $\sin(\theta/2)/(\theta/2)$ by {{from-sinc}}.

"A variable bandpass", the paper says of $C$. The filter above is a rising shelf. A fixed low-pass $D=(1-p)/(1-pz^{-1})$ added to it would
make a bandpass of it, and the product would still not depend on the speed; the pale curves in Figures 8 and 9 show that reading, with $D$'s corner at {{smoothing}}.

**Second order.** For accelerations the paper has $F(s)$ and $G(z)$ of second order. Of the samples $y_{k+1},y_k,y_{k-1}$ there is one combination that takes
both modes of $F$ out, for any two poles and any two intervals: with $q(t)$ the impulse response of $F$,

$$g=y_{k+1}-\frac{q(T_k+T_{k+1})}{q(T_k)}y_k+e^{-2\sigma T_k}\frac{q(T_{k+1})}{q(T_k)}y_{k-1}.$$

Divided by the weight of a constant in it, it is a mean over two intervals, whose weight tends to a triangle as the corner falls: the weight
that turns an acceleration into a second difference. For a double real pole at constant speed, $|FG|=|BC|^2$.

{{responses}}

Each number in the table is computed twice: by the formulas, and by driving the filters with sines as described below. They agree to
{{responses-agree}} (largest difference of any complex gain relative to its size). The same holds for complex poles: with a Butterworth pair instead of the
double pole the largest difference is {{butterworth-agree}}.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "configuration.hpp"
#include "items.hpp"
#include "sine_drive.hpp"
#include "units/constants.hpp"

namespace railbook::filters_chapter {
namespace {

using Complex = std::complex<double>;
constexpr double slow = 9 * units::mph, fast = 80 * units::mph;

double theta_of(double cycles_per_foot) {
  return 2 * units::pi * cycles_per_foot * sample_distance / units::foot;
}

// A fixed low-pass of the digital side, for the reading "bandpass".
double smoothing_gain(double theta) {
  const double p = std::exp(-theta_of(smoothing_corner * units::foot));
  return std::abs((1 - p) / (1.0 - p * std::polar(1.0, -theta)));
}

// phi from 1e-3 to 0.5 cycle/ft, even in the logarithm.
template <class Row>
void sweep(const Row& row) {
  constexpr int points = 240;
  for (int i = 0; i <= points; ++i) row(1e-3 * std::pow(500.0, static_cast<double>(i) / points));
}

enum class Part { analog, digital, hybrid };

void figure(report::Item& item, Part part) {
  const auto pick = [&](const Gains& g) {
    return std::abs(part == Part::analog ? g.analog : part == Part::digital ? g.digital : g.hybrid);
  };
  auto& data =
      item.data({"phi_cycle_per_ft", "slow", "fast", "limit", "slow_smoothed", "fast_smoothed"});
  sweep([&](double phi) {
    const double theta = theta_of(phi), d = smoothing_gain(theta);
    const double a = pick(first_order_gains(gyro_corner, sample_distance / slow, theta));
    const double b = pick(first_order_gains(gyro_corner, sample_distance / fast, theta));
    data.add(phi, a, b, filters::sinc_limit(theta), a * d, b * d);
  });
  auto& driven = item.data("driven", {"phi_cycle_per_ft", "slow", "fast"});
  for (const double phi : {0.001, 0.003, 0.01, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    const double theta = theta_of(phi);
    driven.add(phi, pick(drive_first_order(gyro_corner, sample_distance / slow, theta)),
               pick(drive_first_order(gyro_corner, sample_distance / fast, theta)));
  }
  item.reconstructed("the paper prints no corner; ours is 1 Hz");
}

/*** The corners against what the paper does print, the two speeds: */
void fig_07(report::Item& item) {
  figure(item, Part::analog);
  const auto corner_at = [](double speed) {
    return gyro_corner / (2 * units::pi * speed) * units::foot;
  };
  item.value("corner", gyro_corner / (2 * units::pi), "Hz", "{:g}");
  item.value("corner-9", corner_at(slow), "cycle/ft", "{:.5f}");
  item.value("corner-80", corner_at(fast), "cycle/ft", "{:.5f}");
  item.value("corner-ratio", corner_at(slow) / corner_at(fast), "", "{:.3f}");
}

void fig_09(report::Item& item) {
  figure(item, Part::hybrid);
  const auto at_nyquist = [](double speed) {
    return std::abs(first_order_gains(gyro_corner, sample_distance / speed, units::pi).hybrid);
  };
  item.value("spread", at_nyquist(slow) - at_nyquist(fast), "", "{:.4f}");
  item.value("spread-limit", filters::sinc_limit(units::pi), "", "{:.2f}");
  item.value("from-sinc", at_nyquist(fast) - filters::sinc_limit(units::pi), "", "{:.5f}");
  item.value("smoothing", smoothing_corner * units::foot, "cycle/ft", "{:g}");
}

// The largest relative difference of the gains of two methods.
double difference(const Gains& a, const Gains& b) {
  return std::max({std::abs(a.analog - b.analog) / std::abs(b.analog),
                   std::abs(a.digital - b.digital) / std::abs(b.digital),
                   std::abs(a.hybrid - b.hybrid) / std::abs(b.hybrid)});
}

/*** The table of reference gains was derived beforehand, in another program; every entry is checked by formula and by sines: */
// One row of it, at one wavenumber.
struct ResponseRow {
  report::Item& item;
  const table::CsvTable& table;
  const std::string& key;
  double theta = theta_of(report::printed_number(key));
  double apart = 0;  // the largest difference of the two methods
  std::map<std::string, double> gain = {};

  void check(const std::string& name, double formula, double driven) {
    item.row(table, key).check(name, formula);
    item.check("driven-" + key + "-" + name, name + " at " + key + " cycle/ft, driven", "",
               table.at(key, name), driven);
    gain[name] = formula;
  }
  void at_speed(double speed, const std::string& name) {
    const double T = sample_distance / speed;
    const filters::SecondOrderLowPass F{acceleration_corner, 1};
    const Gains f1 = first_order_gains(gyro_corner, T, theta);
    const Gains d1 = drive_first_order(gyro_corner, T, theta);
    const Gains f2 = second_order_gains(F, T, theta), d2 = drive_second_order(F, T, theta);
    check("B_" + name, std::abs(f1.analog), std::abs(d1.analog));
    check("C_" + name, std::abs(f1.digital), std::abs(d1.digital));
    check("BC_" + name, std::abs(f1.hybrid), std::abs(d1.hybrid));
    check("FG_" + name, std::abs(f2.hybrid), std::abs(d2.hybrid));
    apart = std::max({apart, difference(d1, f1), difference(d2, f2)});
  }
};

// Complex poles have no table: both methods against each other.
double butterworth_apart(double speed, double theta) {
  const filters::SecondOrderLowPass f{acceleration_corner, std::sqrt(0.5)};
  const double T = sample_distance / speed;
  return difference(drive_second_order(f, T, theta), second_order_gains(f, T, theta));
}

double hybrid_at_nyquist(double speed) {
  return std::abs(first_order_gains(gyro_corner, sample_distance / speed, units::pi).hybrid);
}

void responses(report::Item& item) {
  const auto table = item.printed("responses.csv");
  const auto numbers = item.printed("small-kappa-constants.csv");
  item.expect_checks(static_cast<int>(18 * table.rows.size()) + 2);
  item.columns(
      {"φ, cycle/ft", "B 9 mph", "B 80", "C 9", "C 80", "BC 9", "BC 80", "limit", "FG 9", "FG 80"});
  double apart = 0, complex_apart = 0;
  for (const auto& cells : table.rows) {
    ResponseRow row{item, table, cells.at(0)};
    row.at_speed(slow, "9");
    row.at_speed(fast, "80");
    // The limit by a corner far below every other rate.
    row.check("limit", filters::sinc_limit(row.theta),
              std::abs(first_order_gains(1e-4, sample_distance / fast, row.theta).hybrid));
    std::vector<std::string> shown{row.key};
    for (const char* name :
         {"B_9", "B_80", "C_9", "C_80", "BC_9", "BC_80", "limit", "FG_9", "FG_80"})
      shown.push_back(fmt::format("{:.5f}", row.gain.at(name)));
    item.add_row(shown);
    apart = std::max(apart, row.apart);
    for (const double speed : {slow, fast})
      complex_apart = std::max(complex_apart, butterworth_apart(speed, row.theta));
  }
  item.row(numbers, "spread-nyquist")
      .check("value", hybrid_at_nyquist(slow) - hybrid_at_nyquist(fast));
  item.row(numbers, "corner-ratio").check("value", fast / slow);
  item.reconstructed(
      "corners of 1 Hz are ours; the reference values were worked out beforehand, not printed");
  item.value("responses-agree", apart, "", "{:.0e}");
  item.value("butterworth-agree", complex_apart, "", "{:.0e}");
}

}  // namespace

/***
{{include: sine_drive.cpp}}
*/
void add_responses(report::Chapter& chapter) {
  chapter.figure("fig-07", "Figure 7. The analog filter at 9 and 80 mph", fig_07);
  chapter.figure("fig-08", "Figure 8. The digital filter at 9 and 80 mph",
                 [](report::Item& item) { figure(item, Part::digital); });
  chapter.figure("fig-09", "Figure 9. Both together", fig_09);
  chapter.table("responses", "Gains of the hybrid filters, by formula and driven by sines",
                responses);
}

}  // namespace railbook::filters_chapter
