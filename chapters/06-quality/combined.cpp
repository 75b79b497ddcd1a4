/*** ## Both together

Both limits have to be kept, so that at each wavelength the smaller amplitude counts. The stroke is
that of the roll mode, driven by crosslevel; the wheel force is driven by *profile*, the height of
each rail. The paper puts both on one chart.

{{fig-07}}

The shape is the paper's: a rise with the square of the wavelength at both ends, and a constant
level between. Where the level begins and ends depends on the vehicle, which is not printed; the
figure at the head of the page, where it has sliders, draws it for any posted speed and body. With
car A the level begins at {{corner-40}}, {{corner-64}}, {{corner-100}}, {{corner-130}} and
{{corner-177}} for the five speeds, where the paper says "<7 m"; with the loaded car B it begins at
{{corner-B}} at 100 km/h. Beyond the upper end of the level, the amplitude has doubled at
{{double-64}} for 64 km/h, {{double-100}} for 100 and {{double-177}} for 177 km/h, where the paper
says ">100 m".

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

// The curve of both limits at a track speed.
struct Combined {
  quality::Descriptor descriptor;
  quality::Envelope envelope{descriptor};
  double corner = quality::lower_corner(descriptor),
         upper = quality::flat_until(*descriptor.stroke, descriptor.speed);

  double amplitude(double w) const { return quality::allowed_amplitude(envelope(1 / w)); }
  // Where the amplitude is twice the level.
  double doubled() const {
    return num::find_root([&](double w) { return amplitude(w) - 2 * flat_level; }, upper, 1000).x;
  }
  // How far the power of the wavelength is from 2 at both ends.
  double off_power() const {
    const auto a = [&](double w) { return amplitude(w); };
    return std::max(std::abs(power_of_wavelength(a, 0.02) - 2),
                    std::abs(power_of_wavelength(a, 1e4) - 2));
  }
  // How far a search over speeds is from the level, relatively.
  double off_level(const std::vector<double>& wavelengths) const {
    double off = 0;
    for (const double w : wavelengths)
      if (w > corner && w < upper)
        off = std::max(off, std::abs(allowed_by_search(descriptor, w) / flat_level - 1));
    return off;
  }
};

void fig_07(report::Item& item) {
  const quality::ForceLimit A = car(item, "A");
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  const auto wavelengths = num::log_spaced(0.5, 1000, 80);
  double off_power = 0, off_level = 0;
  for (const double v : speeds(item)) {
    const Combined both{{level_limit(), A, v}};
    for (const double w : wavelengths) data.add(v / kmh, w, both.amplitude(w) / cm);
    data.gap();
    off_power = std::max(off_power, both.off_power());
    off_level = std::max(off_level, both.off_level(wavelengths));
    item.value(fmt::format("corner-{:.0f}", v / kmh), both.corner, "m", "{:.2f}");
    item.value(fmt::format("double-{:.0f}", v / kmh), both.doubled(), "m", "{:.0f}");
  }
  item.claims({{"long", {off_power}}, {"short", {off_power}}, {"level", {100 * off_level}}});
  item.value("corner-B", quality::lower_corner({level_limit(), car(item, "B"), track_speed}), "m",
             "{:.1f}");
  item.rebuilt("car A and the speeds; the paper prints neither");
}

}  // namespace

const report::Section combined{report::figure("fig-07", fig_07)};

}  // namespace railbook::quality_chapter
