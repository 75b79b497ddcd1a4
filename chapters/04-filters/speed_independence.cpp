/*** ## What "independent of speed and direction" is worth

The weight of $BC$ over its one sample interval is $e^{\omega_1(t-t_k)}$: flat only for $\kappa=\omega_1T\to0$. So the claim is one of small $\kappa$, and it is
the analog corner that must be *low* compared with $V/d$, not high. In magnitude the error is of second order: the power differs from the limit by

$$\kappa^2\left[\frac1{4\sin^2\theta/2}-\frac1{\theta^2}-\frac1{12}\right]+O(\kappa^4),$$

most at Nyquist, {{nyquist-coefficient}} $\kappa^2$. In phase it is of first order. The centroid of the weight lies

$$T\left(\frac1\kappa-\frac a{1-a}\right)=T\left(\frac12-\frac\kappa{12}+\dots\right)$$

before the sample. Half a sample can be shifted away, the same for both directions. The rest, $\kappa d/12$, changes its sign with the direction of
travel, and forward and reverse runs end up $\kappa d/6$ apart.

{{small-kappa}}

At 1 mph the response is off by up to {{off-1}}, and the two directions lie {{offset-1}} apart. At the 80 mph of the paper's figures it is
{{offset-80}}, which no one sees in samples a foot apart. In terms of what the curvature system needs, the paper's 2 mph is fair: a curve's
curvature changes over tens of feet.

The deviations are the largest over all wavenumbers, by formula; the delay is also measured, on a ramp: a signal that rises
steadily comes out late by the centroid.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "configuration.hpp"
#include "items.hpp"
#include "sine_drive.hpp"

namespace railbook::filters_chapter {
namespace {

struct Deviation {
  double magnitude = 0, complex = 0;
};
Deviation largest_deviation(double kappa) {
  Deviation largest;
  constexpr int points = 2000;
  for (int i = 1; i <= points; ++i) {
    const double theta = units::pi * i / points, limit = filters::sinc_limit(theta);
    const auto bc =
        filters::first_order_analog(kappa, theta) * filters::first_order_digital(kappa, theta);
    largest.magnitude = std::max(largest.magnitude, std::abs(std::abs(bc) - limit));
    largest.complex = std::max(largest.complex, std::abs(bc * std::polar(1.0, theta / 2) - limit));
  }
  return largest;
}

// How late the steady output of the hybrid filter is on a ramp, in T: the analog output from its closed form, with
// another transient than the steady state's, which the digital filter has to take out.
double measured_delay(double kappa) {
  filters::FirstOrderHybrid c{kappa};  // T = 1
  double late = 0;
  for (int k = 0; k < 5; ++k) late = k - c.push(k - 1 / kappa + 3 * std::exp(-kappa * k), 1);
  return late;
}

void small_kappa(report::Item& item) {
  const auto table = item.printed("small-kappa.csv");
  const auto constants = item.printed("small-kappa-constants.csv");
  item.expect_checks(static_cast<int>(6 * table.rows.size()) + 3);
  item.columns({"mph", "κ", "largest deviation of |BC|", "as a complex number", "delay / T",
                "forward and reverse apart, mm"});
  for (const auto& cells : table.rows) {
    const std::string& key = cells.at(0);
    const double speed = report::printed_number(key) * units::mph;
    const double kappa = gyro_corner * sample_distance / speed;
    const Deviation d = largest_deviation(kappa);
    const double delay = filters::centroid_delay(kappa);
    const double apart = 2 * (0.5 - delay) * sample_distance / units::millimetre;
    const report::Row row = item.row(table, key);
    row.check("kappa", kappa);
    row.check("magnitude", d.magnitude);
    row.check("complex", d.complex);
    row.check("delay", delay);
    row.check("offset", apart);
    item.check("ramp-" + key, "the delay, measured on a ramp", "", table.at(key, "delay"),
               measured_delay(kappa));
    item.add_row({key, fmt::format("{:.4f}", kappa), fmt::format("{:.5f}", d.magnitude),
                  fmt::format("{:.4f}", d.complex), fmt::format("{:.5f}", delay),
                  fmt::format("{:.3g}", apart)});
    if (key == "1") item.value("off-1", d.magnitude, "", "{:.2f}");
    if (key == "1" || key == "80") item.value("offset-" + key, apart, "mm", "{:.3g}");
  }
  for (const auto& [key, speed] : {std::pair{"corner-9", 9.0}, {"corner-80", 80.0}})
    item.row(constants, key)
        .check("value", gyro_corner / (2 * units::pi * speed * units::mph) * units::foot);
  // The bracket at Nyquist, against the formula itself at a small kappa.
  const double bracket = 0.25 - 1 / (units::pi * units::pi) - 1.0 / 12;
  const double kappa = 1e-3, limit = filters::sinc_limit(units::pi);
  const double power = std::norm(filters::first_order_analog(kappa, units::pi) *
                                 filters::first_order_digital(kappa, units::pi));
  item.agree("bracket", "coefficient of κ² at Nyquist", "",
             (power / (limit * limit) - 1) / (kappa * kappa), bracket, 1e-5,
             "the expansion; the next term is of the size κ²");
  item.reconstructed(
      "the corner of 1 Hz is ours; the reference values were worked out beforehand, not printed");
  item.value("nyquist-coefficient", bracket, "", "{:.4f}");
}

}  // namespace

void add_speed_independence(report::Chapter& chapter) {
  chapter.table("small-kappa",
                "Independence of speed and direction: the first-order hybrid filter, corner 1 Hz",
                small_kappa);
}

}  // namespace railbook::filters_chapter
