/*** ## Does existing track look like that?

The paper squares the allowed amplitude at 64 km/h, lays it over a power spectral density of a 40-mph track and finds them alike. The caption of
its Figure 8 breaks off at "vertical scale", so the height of the curve was free, and amplitude squared is not a density. There are three ways to read
it: $A^2$ as it is; $A^2/2B$, the density of sines a fixed bandwidth $B$ apart, the same shape; and $A^2/2\beta\varphi$, sines a fixed
*ratio* apart. Against the analytic spectrum of a class-3 track (40 mph, 64 km/h),

$$S=\frac{A\varphi_2^2(\varphi^2+\varphi_1^2)}{\varphi^4(\varphi^2+\varphi_2^2)},$$

{{fig-08}}

Spectrum and $A^2$ fall with $\varphi^{-4}$ at both ends, the descriptor by its own two asymptotes (the third reading with $\varphi^{-5}$). In between the spectrum falls with $\varphi^{-2}$, where the
descriptor is flat or, in the third reading, falls with $\varphi^{-1}$. From 2 to 100 m the shapes miss each other by {{mismatch-squared}} decades
(rms, the height fitted) in the first two readings and by {{mismatch-relative}} in the third: against this spectrum "resembles" holds to about a decade, not better. The level says more: in third octaves the
spectrum at 20 m is {{margin-20}} times (in amplitude) below what the vehicle allows, at 5 m {{margin-5}}, at 100 m {{margin-100}} times.
*/
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "num/log_spaced.hpp"
#include "num/quadrature.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

constexpr double phi_1 = 0.0233, phi_2 = 0.131;  // cycle/m

double class_psd(double A, double phi) {
  const double p2 = phi * phi;
  return A * phi_2 * phi_2 * (p2 + phi_1 * phi_1) / (p2 * p2 * (p2 + phi_2 * phi_2));
}

// Its integral from `low` to `high`, by partial fractions.
double class_power(double A, double low, double high) {
  const double a = phi_1 * phi_1, b = phi_2 * phi_2;
  const auto primitive = [&](double p) {
    const double q = (1 - a / b) / b;
    return -q / p - a / b / (3 * p * p * p) - q / phi_2 * std::atan(p / phi_2);
  };
  return A * b * (primitive(high) - primitive(low));
}

// Mean and rms about it of log10(curve/S) over logarithmically even wavelengths from 2 to 100 m.
template <class Curve>
std::pair<double, double> misfit(double A, const Curve& curve) {
  double sum = 0, squares = 0;
  const auto grid = num::log_spaced(2, 100, 200);
  for (const double w : grid) {
    const double d = std::log10(curve(1 / w) / class_psd(A, 1 / w));
    sum += d;
    squares += d * d;
  }
  const double n = static_cast<double>(grid.size()), mean = sum / n;
  return {mean, std::sqrt(squares / n - mean * mean)};
}

void fig_08(report::Item& item) {
  const double A = 1e-8 * report::printed_number(item.printed("spectra.csv").at("3", "A_1e8_m"));
  const quality::Envelope envelope{{level_limit(), car(item, "A"), 64 * kmh}};
  const auto squared = [&](double phi) {
    const double amplitude = quality::allowed_amplitude(envelope(phi));
    return amplitude * amplitude;
  };
  const auto relative = [&](double phi) { return squared(phi) / phi; };
  const auto [offset_2, rms_2] = misfit(A, squared);
  const auto [offset_3, rms_3] = misfit(A, relative);
  auto& data = item.data({"phi_cycle_per_m", "psd", "squared", "relative"});
  for (const double w : num::log_spaced(1, 1000, 60))
    data.add(1 / w, class_psd(A, 1 / w), squared(1 / w) * std::pow(10, -offset_2),
             relative(1 / w) * std::pow(10, -offset_3));
  item.expect_checks(2);
  const double power = class_power(A, 1.0 / 30, 1.0 / 3);
  item.agree("rms", "rms of class-3 track, 3 to 30 m", "mm", 1e3 * std::sqrt(power),
             1e3 * std::sqrt(num::integrate([&](double phi) { return class_psd(A, phi); }, 1.0 / 30,
                                            1.0 / 3)
                                 .value),
             1e-9, "adaptive quadrature");
  item.refute("resembles",
              "the power content of the allowed deviations resembles that of existing track",
              rms_2 > 0.5 && rms_3 > 0.5,
              fmt::format("the shapes differ by {:.2f} or {:.2f} decades (rms, 2 to 100 m), by the "
                          "reading of the squared amplitude",
                          rms_2, rms_3));
  item.value("mismatch-squared", rms_2, "", "{:.2f}");
  item.value("mismatch-relative", rms_3, "", "{:.2f}");
  for (const double w : {5.0, 20.0, 100.0}) {  // a sine with the power of a third octave
    const double low = std::pow(2, -1.0 / 6) / w, high = std::pow(2, 1.0 / 6) / w;
    item.value(fmt::format("margin-{:g}", w),
               std::sqrt(squared(1 / w) / (2 * class_power(A, low, high))), "", "{:.0f}");
  }
  item.rebuilt(
      "the spectrum is a published analytic one for 40-mph track, not the measured one of "
      "the paper, and the car is car A");
}

}  // namespace

const report::Section spectrum{report::figure(
    "fig-08", "Allowed amplitude, squared, over the spectrum of a 64-km/h track (Fig. 8)", fig_08)};

}  // namespace railbook::quality_chapter
