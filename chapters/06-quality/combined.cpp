/*** ## Both together

The vehicle needs both limits kept, so at each wavelength the smaller amplitude counts. (The stroke of the roll mode is driven by cross level, the
wheel force by profile; the paper puts both on one chart, and so do we.)

{{fig-07}}

The flat level ends below at the corner where the wheel force takes over, {{corner-40}}, {{corner-64}}, {{corner-100}}, {{corner-130}} and
{{corner-177}} for the five speeds. The paper's "below 7 m" holds up to 130 km/h; with this car it fails at 177 km/h, and would hold there, too, with a
body of at most {{mass-7}} on the wheel. The loaded car B would leave the flat level at {{corner-B}} at 100 km/h already: the paper's
corner is that of an empty or half-empty car. Above, the amplitude has doubled at {{double-64}} for 64 km/h, {{double-100}} for 100 and
{{double-177}} for 177 km/h; "above 100 m" fits the fastest ones.
*/
#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "num/log_spaced.hpp"
#include "num/roots.hpp"

namespace railbook::quality_chapter {

using namespace railbook;

namespace {

quality::Descriptor both(const quality::ForceLimit& force, double speed) {
  return {level_limit(), force, speed};
}

// The corner found on the finished envelope: the longest wavelength below 60 m, on a fine grid, at which it is below the level.
double searched_corner(const quality::Descriptor& d) {
  const quality::Envelope envelope{d};
  double corner = 0;
  for (double w = 0.5; w < 60; w *= 1.0002) {
    if (quality::allowed_amplitude(envelope(1 / w)) < flat_level * (1 - 1e-9)) corner = w;
  }
  return corner;
}

void fig_07(report::Item& item) {
  const table::CsvTable printed = item.printed("printed.csv");
  const quality::ForceLimit A = car(item, "A");
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  const auto all = speeds(item);
  item.expect_checks(2 * static_cast<int>(all.size()));
  for (const double v : all) {
    const quality::Descriptor d = both(A, v);
    const quality::Envelope envelope{d};
    for (const double w : num::log_spaced(0.5, 1000, 80))
      data.add(v / kmh, w, quality::allowed_amplitude(envelope(1 / w)) / cm);
    data.gap();
    const std::string name = fmt::format("{:.0f}", v / kmh);
    const double corner = quality::lower_corner(d);
    item.agree("corner-search-" + name, "lower corner at " + name + " km/h", "m", corner,
               searched_corner(d), 5e-4, "search on the envelope, grid of 0.02 %");
    if (v < 140 * kmh)
      item.check("corner-short-" + name, "lower corner at " + name + " km/h", "m",
                 printed.at("short", "printed"), corner,
                 report::at_most("\"below 7 m\" in the text; not so at 177 km/h, see Deviations"));
    item.value("corner-" + name, corner, "m", "{:.2f}");
    const double doubled =
        num::find_root(
            [&](double w) { return quality::allowed_amplitude(envelope(1 / w)) - 2 * flat_level; },
            quality::flat_until(*d.stroke, v), 1000)
            .x;
    item.value("double-" + name, doubled, "m", "{:.0f}");
    if (v > 140 * kmh)
      item.check("corner-long-" + name, "wavelength of twice the level at " + name + " km/h", "m",
                 printed.at("long", "printed"), doubled,
                 report::at_least("\"above 100 m\" in the text; only at 177 km/h, see Deviations"));
  }
  const auto excess = [&](double body) {
    const quality::Suspension s = suspension(A.car);
    return quality::lower_corner(
               both({quality::make_car(A.car.wheel, body, s), A.force}, all.back())) -
           7;
  };
  item.value("mass-7", num::find_root(excess, 5000, 8000, 1e-9).x, "kg", "{:.0f}");
  item.value("corner-B", quality::lower_corner(both(car(item, "B"), track_speed)), "m", "{:.1f}");
  item.reconstructed("car A and the speeds are ours");
}

}  // namespace

void add_combined(report::Chapter& chapter) {
  chapter.figure("fig-07", "Figure 7. Both limits kept, by track speed", fig_07);
}

}  // namespace railbook::quality_chapter
