/***
Is the geometry right for profiles that are not ours? EN 15302 gives two reference profiles, a wheel and a rail A, and
the equivalent conicity that a program should find for them. The points go the way of any measured profile, spline,
biarcs and exact search:

{{conicity-benchmark}}

The standard's numbers come out when the axle is kept level, so that is how they must have been made: each wheel
touches where its own gap is least, and the roll that would close both is left out. Let the wheelset roll, as it does,
and the conicity is {{roll-low}} to {{roll-high}} larger, the more the steeper the contact. `hunting geometry --level`
gives the standard's kind.
*/

#include <fmt/format.h>

#include <algorithm>

#include "items.hpp"
#include "units/constants.hpp"
#include "wheelrail/conicity.hpp"
#include "wheelrail/measured_curve.hpp"
#include "wheelrail/tabulate.hpp"

using namespace railbook;
using namespace railbook::wheelrail;
using units::millimetre;

namespace {

// The standard's two profiles have their origins 750 mm from the middle, the wheelset a radius of 460 mm.
constexpr double half_spacing = 0.75, radius = 0.46;
constexpr double smoothing = 1e-6;  // the digits of the thinned points

Curve reference_profile(const report::Item& item, const char* file) {
  const auto columns = table::read_columns(item.sources() / "data" / file,
                                           {{"outward", units::length}, {"height", units::length}});
  std::vector<Point> points;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    points.push_back({-half_spacing - columns[0][i], columns[1][i]});
  return measured_curve(std::move(points), smoothing).curve;
}

void benchmark(report::Item& item) {
  const table::CsvTable reference = item.printed("en15302_conicity.csv");
  const WheelsetOnTrack pair = with_radius(reference_profile(item, "en15302_wheel_a.csv"),
                                           reference_profile(item, "en15302_rail_a.csv"), radius);
  TableOptions options{
      .half_spacing = half_spacing, .end = 6.5 * millimetre, .step = 0.05 * millimetre};
  const ConstraintFunctions rolling = tabulate(pair, options);
  options.level = true;
  const ConstraintFunctions level = tabulate(pair, options);
  item.expect_checks(int(reference.rows.size()));
  item.columns({"amplitude, mm", "EN 15302", "axle level", "wheelset rolls"});
  double low = 1, high = 0;
  for (const auto& row : reference.rows) {
    const double amplitude = std::stod(row[0]) * millimetre;
    const double still = conicity(level, amplitude).kinematic,
                 free = conicity(rolling, amplitude).kinematic;
    item.row(reference, row[0])
        .check("reference", still,
               report::relative(
                   0.05,
                   "points thinned and smoothed by 1 µm; the standard allows 0.05, not relative"));
    item.add_row({row[0], reference.at(row[0], "reference"), fmt::format("{:.4f}", still),
                  fmt::format("{:.4f}", free)});
    low = std::min(low, free / still - 1);
    high = std::max(high, free / still - 1);
  }
  item.value("roll-low", 100 * low, "%", "{:.0f}");
  item.value("roll-high", 100 * high, "%", "{:.0f}");
}

}  // namespace

void hunting_chapter::add_conicity_benchmark(report::Chapter& chapter) {
  chapter.table("conicity-benchmark", "Equivalent conicity of EN 15302's profiles A", benchmark);
}
