/*** ## Roll from an inclinometer and a gyro

Crosslevel needs the roll angle of the car against gravity. The inclinometer knows it in the long run, but takes every lateral acceleration for
a roll; the gyro knows the changes, but its bias integrates to anything. The *complementary filter* adds a low-pass of the one to a
high-pass of the other, with gains that sum to one at every frequency:

$$\vartheta_k=a_k\left(\vartheta_{k-1}+\Delta\vartheta_k\right)+(1-a_k)\,\vartheta^{incl}_k,\qquad a_k=e^{-T_k/\tau}.$$

Here the corner is one of *time*, and printed: about two octaves below the lateral mode of the car body, typically 1.25 Hz, so {{roll-corner}},
$\tau$ = {{roll-tau}}. The exponential is again exact for every $T_k$. When the car stands, $T\to\infty$ and $a\to0$: what is left is the inclinometer,
which is why crosslevel holds "to 0 mph".

The paper has first- and second-order stages in it. With $n$ equal poles, a cascade of the step above with the output of each as the inclinometer of the
next, a sway at the car's own mode is suppressed by {{sway-1}}, {{sway-2}}, {{sway-3}} for $n$ = 1, 2, 3. The price: the gyro's share $1-L^n$ peaks above
one ({{gyro-peak}} at the corner for $n=2$), and a gyro bias $b$ costs $n\tau b$. A bias of 0.01 deg/s makes {{bias-1}}, {{bias-2}} and {{bias-3}} of
roll.

{{roll}}

Driven columns: the filter above at 100 samples a second, a sine on the inclinometer alone or on the gyro alone.
*/
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <string>

#include "configuration.hpp"
#include "filters/complementary.hpp"
#include "items.hpp"

namespace railbook::filters_chapter {
namespace {

using Complex = std::complex<double>;

// The steady gain of one path, at f Hz and T s a sample.
double driven_gain(int poles, double f, double T, bool gyro) {
  const double tau = filters::time_constant(roll_corner), theta = 2 * units::pi * f * T;
  filters::ComplementaryFilter real{tau, poles}, imaginary{tau, poles};
  Complex out, before;
  const int samples = static_cast<int>(std::ceil(40 * tau * poles / T));
  for (int k = 0; k <= samples; ++k) {
    const Complex angle = std::polar(1.0, theta * k), step = angle - before;
    out = gyro ? Complex{real.push(0, step.real(), T), imaginary.push(0, step.imag(), T)}
               : Complex{real.push(angle.real(), 0, T), imaginary.push(angle.imag(), 0, T)};
    before = angle;
  }
  return std::abs(out / before);
}

void roll(report::Item& item) {
  const auto table = item.printed("complementary.csv");
  const auto constants = item.printed("complementary-constants.csv");
  const double tau = filters::time_constant(roll_corner), T = 0.01;
  item.expect_checks(static_cast<int>(4 * table.rows.size() + constants.rows.size()));
  item.columns({"poles", "Hz", "inclinometer", "driven", "gyro", "driven"});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string& key = table.at(i, "key");
    const double f = report::printed_number(table.at(i, "hertz"));
    const int n = static_cast<int>(report::printed_number(table.at(i, "poles")));
    const Complex low = filters::low_pass_gain(tau, n, f);
    const report::Row row = item.row(table, key);
    row.check("inclinometer", std::abs(low), derived(row.printed("inclinometer")));
    row.check("gyro", std::abs(1.0 - low), derived(row.printed("gyro")));
    const double driven_low = driven_gain(n, f, T, false), driven_high = driven_gain(n, f, T, true);
    const Complex sampled = filters::low_pass_gain(tau, n, f, T);
    item.agree("driven-low-" + key, "inclinometer's path, driven", "", driven_low,
               std::abs(sampled), 1e-9, "the formula for samples T apart");
    item.agree("driven-high-" + key, "gyro's path, driven", "", driven_high,
               std::abs(1.0 - sampled), 1e-9, "one minus the formula for samples T apart");
    item.add_row({fmt::format("{}", n), table.at(i, "hertz"), fmt::format("{:.4f}", std::abs(low)),
                  fmt::format("{:.4f}", driven_low), fmt::format("{:.4f}", std::abs(1.0 - low)),
                  fmt::format("{:.4f}", driven_high)});
  }
  item.row(constants, "corner")
      .check("value", roll_corner, derived(constants.at("corner", "value")));
  item.row(constants, "tau").check("value", tau, derived(constants.at("tau", "value")));
  item.row(constants, "decibel")
      .check("value", 20 * std::log10(std::abs(filters::low_pass_gain(tau, 1, 1.25))),
             derived(constants.at("decibel", "value")));
  item.value("roll-corner", roll_corner, "Hz", "{:g}");
  item.value("roll-tau", tau, "s", "{:.4f}");
  item.value("gyro-peak", std::abs(1.0 - filters::low_pass_gain(tau, 2, roll_corner)), "",
             "{:.3f}");
  for (const int n : {1, 2, 3}) {
    item.value(fmt::format("sway-{}", n), std::abs(filters::low_pass_gain(tau, n, 1.25)), "",
               "{:.3f}");
    item.value(fmt::format("bias-{}", n),
               filters::gyro_bias_error(0.01 * units::degree, tau, n, T) / units::millimetre,
               "mrad", "{:.3f}");
  }
}

}  // namespace

void add_roll(report::Chapter& chapter) {
  chapter.table("roll", "Gains of the complementary filter, corner 0.3125 Hz", roll);
}

}  // namespace railbook::filters_chapter
