/*** ## Both together

The vehicle needs both limits kept, so at each wavelength the smaller amplitude counts. (The stroke of the roll mode is driven by cross level, the
wheel force by profile; the paper puts both on one chart.)

{{code: quality/descriptor.cpp lower_corner}}

{{fig-07}}

{{include: answer.cpp}}

The shape is the paper's: a rise with the square of the wavelength at both ends and a constant level between. Its two numbers depend on the vehicle, which is not printed.
With car A the level ends below at {{corner-40}}, {{corner-64}}, {{corner-100}}, {{corner-130}} and
{{corner-177}} for the five speeds, where the paper says "below 7 m"; with the loaded car B at {{corner-B}} at 100 km/h. Above, the amplitude has doubled at {{double-64}} for 64 km/h, {{double-100}} for 100 and
{{double-177}} for 177 km/h, where the paper says "above 100 m".
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "num/log_spaced.hpp"
#include "num/roots.hpp"
#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

// The corner found on the finished envelope: the longest wavelength below 60 m, on a fine grid, at which it is below the level.
double searched_corner(const quality::Envelope& envelope) {
  double corner = 0;
  for (double w = 0.5; w < 60; w *= 1.0002)
    if (quality::allowed_amplitude(envelope(1 / w)) < flat_level * (1 - 1e-9)) corner = w;
  return corner;
}

void fig_07(report::Item& item) {
  const quality::ForceLimit A = car(item, "A");
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  double worst_corner = 0, off_power = 0, off_level = 0;
  for (const double v : speeds(item)) {
    const quality::Descriptor d{level_limit(), A, v};
    const quality::Envelope envelope{d};
    const auto amplitude = [&](double w) { return quality::allowed_amplitude(envelope(1 / w)); };
    const double corner = quality::lower_corner(d), upper = quality::flat_until(*d.stroke, v);
    for (const double w : num::log_spaced(0.5, 1000, 80)) {
      data.add(v / kmh, w, amplitude(w) / cm);
      if (w > corner && w < upper)
        off_level = std::max(off_level, std::abs(amplitude(w) / flat_level - 1));
    }
    data.gap();
    worst_corner = std::max(worst_corner, std::abs(searched_corner(envelope) / corner - 1));
    off_power = std::max({off_power, std::abs(power_of_wavelength(amplitude, 0.02) - 2),
                          std::abs(power_of_wavelength(amplitude, 1e4) - 2)});
    const double doubled =
        num::find_root([&](double w) { return amplitude(w) - 2 * flat_level; }, upper, 1000).x;
    item.value(fmt::format("corner-{:.0f}", v / kmh), corner, "m", "{:.2f}");
    item.value(fmt::format("double-{:.0f}", v / kmh), doubled, "m", "{:.0f}");
  }
  limit_answer(item);
  item.expect_checks(4);
  item.claim("long",
             "at long waves the amplitudes ultimately approach the square of the wavelength",
             off_power < 0.02, "within 1 % of the power 2 at 10 km");
  item.claim("short", "the control of short waves approaches the square of the wavelength as well",
             off_power < 0.02, "within 1 % of the power 2 at 2 cm");
  item.claim("level", "at intermediate wavelengths the level of control is constant",
             off_level < 1e-12, "constant to rounding");
  item.at_most("corner-search", "lower corners, closed form against the envelope, relative", "",
               worst_corner, 5e-4, "search on a grid of 0.02 %");
  item.value("corner-B", quality::lower_corner({level_limit(), car(item, "B"), track_speed}), "m",
             "{:.1f}");
  item.rebuilt("car A and the speeds; the paper prints neither");
}

}  // namespace

const report::Section combined{
    report::figure("fig-07", "Both limits kept, by track speed (Fig. 7)", fig_07)};

}  // namespace railbook::quality_chapter
