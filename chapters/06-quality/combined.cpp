/*** ## Both together

The vehicle needs both limits kept, so that at each wavelength the smaller amplitude counts. The
stroke is that of the roll mode, driven by crosslevel, the height of one rail over the other; the
wheel force is driven by profile, the height of each rail. The paper puts both on one chart.

{{fig-07}}

The shape is the paper's: a rise with the square of the wavelength at both ends, and a constant
level between. Its two numbers depend on the vehicle, which is not printed; the figure at the head of the
page draws it for any posted speed and body. With car A the level
ends below at {{corner-40}}, {{corner-64}}, {{corner-100}}, {{corner-130}} and {{corner-177}} for
the five speeds, where the paper says "<7 m"; with the loaded car B at {{corner-B}} at 100 km/h.
Beyond the upper end of the level, the amplitude has doubled at {{double-64}} for 64 km/h,
{{double-100}} for 100 and {{double-177}} for 177 km/h, where the paper says ">100 m".

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/log_spaced.hpp>
#include <railbook/num/roots.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

namespace {

void fig_07(report::Item& item) {
  const quality::ForceLimit A = car(item, "A");
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  double off_power = 0, off_level = 0;
  for (const double v : speeds(item)) {
    const quality::Descriptor d{level_limit(), A, v};
    const quality::Envelope envelope{d};
    const auto amplitude = [&](double w) { return quality::allowed_amplitude(envelope(1 / w)); };
    const double corner = quality::lower_corner(d), upper = quality::flat_until(*d.stroke, v);
    for (const double w : num::log_spaced(0.5, 1000, 80)) {
      data.add(v / kmh, w, amplitude(w) / cm);
      if (w > corner && w < upper)
        off_level = std::max(off_level, std::abs(allowed_by_search(d, w) / flat_level - 1));
    }
    data.gap();
    off_power = std::max({off_power, std::abs(power_of_wavelength(amplitude, 0.02) - 2),
                          std::abs(power_of_wavelength(amplitude, 1e4) - 2)});
    const double doubled =
        num::find_root([&](double w) { return amplitude(w) - 2 * flat_level; }, upper, 1000).x;
    item.value(fmt::format("corner-{:.0f}", v / kmh), corner, "m", "{:.2f}");
    item.value(fmt::format("double-{:.0f}", v / kmh), doubled, "m", "{:.0f}");
  }
  item.expect_checks(3);
  item.claim("long",
             "at long waves the amplitudes ultimately approach the square of the wavelength",
             off_power < 0.02, "within 1 % of the power 2 at 10 km");
  item.claim("short", "the control of short waves approaches the square of the wavelength as well",
             off_power < 0.02, "within 1 % of the power 2 at 2 cm");
  item.claim(
      "level", "at intermediate wavelengths the level of control is constant", off_level < 1e-4,
      fmt::format("a search over speeds finds it constant within {:.1g} %", 100 * off_level));
  item.value("corner-B", quality::lower_corner({level_limit(), car(item, "B"), track_speed}), "m",
             "{:.1f}");
  item.rebuilt("car A and the speeds; the paper prints neither");
}

}  // namespace

const report::Section combined{
    report::figure("fig-07",
                   "Figure 7. The allowance is level between two rises with the square of the "
                   "wavelength. Allowed amplitude by track speed in km/h, the smaller of both "
                   "limits; car A and the speeds are ours.",
                   fig_07)};

}  // namespace railbook::quality_chapter
