#include <railbook/filters/double_integral.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <railbook/filters/inner_filter.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::filters {

FilterTaps double_integral_taps(const Band& band, double spacing, Curvature curvature) {
  units::require_positive("spacing", spacing, "m");
  units::require_between("shortest wavelength of the band", band.shortest, 4 * spacing,
                         units::infinity, "m");
  return symmetric_taps(band, spacing, [&](double phi) {
    if (!(phi > 0)) return 0.0;
    const double twice = curvature == Curvature::means
                             ? 4 * std::pow(std::sin(units::pi * phi * spacing) / spacing, 2)
                             : std::pow(2 * units::pi * phi, 2);
    return -band_gain(band, 2, phi) / twice;
  });
}

std::size_t double_integral_margin(const Band& band, double spacing) {
  return 4 * band_margin(band, spacing);
}

std::vector<double> integrate_twice(std::span<const double> acceleration,
                                    std::span<const double> speed, const Band& band, double spacing,
                                    Curvature curvature) {
  if (acceleration.size() != speed.size())
    throw InputError{"speeds: " + std::to_string(speed.size()) + " for " +
                     std::to_string(acceleration.size()) + " accelerations; allowed: one each"};
  const FilterTaps taps = double_integral_taps(band, spacing, curvature);
  std::vector<double> rest(acceleration.begin(), acceleration.end());
  double low = units::infinity, high = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (std::isnan(rest[i]) || std::isnan(speed[i])) {
      rest[i] = units::nan;
      continue;
    }
    const double v = units::require_positive("speed", speed[i], "m/s");
    low = std::min(low, v);
    high = std::max(high, v);
    rest[i] /= v * v;
  }
  const auto heights_of = [&](const std::vector<double>& second) {
    std::vector<double> heights;
    heights.reserve(second.size());
    InnerFilter filter(taps, double_integral_margin(band, spacing), [&](std::span<const double> p) {
      heights.insert(heights.end(), p.begin(), p.end());
    });
    filter.push(second);
    filter.finish();
    return heights;
  };
  std::vector<double> heights = heights_of(rest);
  if (!(high > low)) return heights;
  // (z[i+1] - z[i-1]) (v[i+1] - v[i-1])/(4 spacing^2 v); unknown beside what is unknown.
  std::vector<double> corrected(rest.size(), units::nan);
  for (std::size_t i = 1; i + 1 < rest.size(); ++i)
    corrected[i] = rest[i] - (heights[i + 1] - heights[i - 1]) * (speed[i + 1] - speed[i - 1]) /
                                 (4 * spacing * spacing * speed[i]);
  return heights_of(corrected);
}

}  // namespace railbook::filters
