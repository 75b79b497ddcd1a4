/*** ## Does existing track look like that?

The paper squares the allowed amplitude at 64 km/h, lays it over a *power spectral density* of a
64-km/h track, the power of its roughness by spatial frequency, and says that the power content of
the one resembles the other. This cannot be tested. The measured spectrum is lost in our copy; the
caption breaks off at "vertical scale", so that the height of the curve was free; and an amplitude
squared is not a density.

It becomes one when a sine of the allowed amplitude $A$ stands for all waves of a band. The bands
may all have the same width, which gives the shape of $A^2$, or the same ratio of upper to lower
edge, which gives $A^2/\varphi$. To show what would be compared, the random part of a slow line of
the same first author is drawn, zone 12 of chapter 05, a rough branch line for 48 km/h. Its density
is $S=C/\varphi^2$ up to a corner $\varphi_c$ and $C\varphi_c^2/\varphi^4$ beyond, with a constant
$C$.

{{fig-08}}

For waves far shorter than those drawn both fall with $\varphi^{-4}$ ($\varphi^{-5}$ for bands in
equal ratios). On the level the allowed power is constant, or falls with $\varphi^{-1}$, while the
spectrum falls with $\varphi^{-2}$. For waves longer than the resonance the allowed power rises with
the fourth power of the wavelength, and this spectrum with the second. After a fit of the height,
the shapes differ from 2 to 100 m by a root mean square (rms) of {{mismatch-squared}} decades for
equally wide bands, and of {{mismatch-relative}} for bands in equal ratios.

Band by band this line is far smoother than car A needs at 64 km/h. The sine that has the power of a
third of an octave, from $2^{-1/6}$ to $2^{1/6}$ times its frequency, is {{margin-20}} times smaller
than the allowed amplitude at 20 m, {{margin-5}} times at 5 m and {{margin-100}} times at 100 m. All
bands from 1 to 1000 m together give the descriptor a standard deviation of {{descriptor-sd}}, so
that it exceeds 1 now and then.

{{fold}}
*/
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <railbook/num/log_spaced.hpp>
#include <railbook/spectra/track_spectrum.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

// Mean and rms about it of log10(curve/S) over logarithmically even wavelengths from 2 to 100 m.
template <class Curve>
std::pair<double, double> misfit(const spectra::TrackParameters& track, const Curve& curve) {
  double sum = 0, squares = 0;
  const auto grid = num::log_spaced(2, 100, 200);
  for (const double w : grid) {
    const double d = std::log10(curve(1 / w) / spectra::random_psd(track, 1 / w));
    sum += d;
    squares += d * d;
  }
  const double n = static_cast<double>(grid.size()), mean = sum / n;
  return {mean, std::sqrt(squares / n - mean * mean)};
}

void fig_08(report::Item& item) {
  const table::CsvTable table = item.printed("spectrum.csv");
  const auto number = [&](const char* column) {
    return report::printed_number(table.at("12", column));
  };
  const spectra::TrackParameters track{.A = number("A"), .phi_c = number("phi_c")};
  const quality::Envelope envelope{{level_limit(), car(item, "A"), 64 * kmh}};
  const auto squared = [&](double phi) {
    return std::pow(quality::allowed_amplitude(envelope(phi)), 2);
  };
  const auto relative = [&](double phi) { return squared(phi) / phi; };
  const auto [offset_2, rms_2] = misfit(track, squared);
  const auto [offset_3, rms_3] = misfit(track, relative);
  auto& data = item.data({"phi_cycle_per_m", "psd", "squared", "relative"});
  for (const double w : num::log_spaced(1, 1000, 60))
    data.add(1 / w, spectra::random_psd(track, 1 / w), squared(1 / w) * std::pow(10, -offset_2),
             relative(1 / w) * std::pow(10, -offset_3));
  report::values(item, "", "{:.2f}", "mismatch-squared", rms_2, "mismatch-relative", rms_3);
  for (const double w : {5.0, 20.0, 100.0}) {  // a sine with the power of a third octave
    const double low = std::pow(2, -1.0 / 6) / w, high = std::pow(2, 1.0 / 6) / w;
    item.value(fmt::format("margin-{:g}", w),
               std::sqrt(squared(1 / w) / (2 * spectra::random_variance(track, low, high))), "",
               "{:.0f}");
  }
  double variance = 0;  // of the descriptor: its gain is the severity
  const auto bands = num::log_spaced(1, 1000, 400);
  for (std::size_t i = 1; i < bands.size(); ++i) {
    const double middle = std::sqrt(bands[i - 1] * bands[i]);
    variance += std::pow(envelope(1 / middle), 2) *
                spectra::random_variance(track, 1 / bands[i], 1 / bands[i - 1]);
  }
  item.value("descriptor-sd", std::sqrt(variance), "", "{:.2f}");
  item.rebuilt(
      "the paper's measured spectrum and the height of its curve are lost; the spectrum is "
      "that of another line, the car is car A");
}

}  // namespace

const report::Section spectrum{report::figure("fig-08", fig_08)};

}  // namespace railbook::quality_chapter
