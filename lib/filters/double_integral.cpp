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
  return static_cast<std::size_t>(
      std::ceil(4 * band_decay(band) / units::require_positive("spacing", spacing, "m")));
}

namespace {

// The stretches of a record without a gap.
std::vector<std::span<double>> pieces_of(std::vector<double>& record) {
  std::vector<std::span<double>> pieces;
  const auto known = [](double value) { return !std::isnan(value); };
  for (auto at = std::find_if(record.begin(), record.end(), known); at != record.end();) {
    const auto end = std::find_if_not(at, record.end(), known);
    pieces.emplace_back(at, end);
    at = std::find_if(end, record.end(), known);
  }
  return pieces;
}

// Takes off the bias and its even drift. The weights (1 - x^2)^2 make this the least-squares cubic
// of the heights: a line through the accelerations themselves would follow the slopes at the ends.
void take_off_bias(std::span<double> piece) {
  const auto n = static_cast<double>(piece.size());
  double weights = 0, seconds = 0, sum = 0, moment = 0;
  const auto place = [&](std::size_t i) { return (2 * static_cast<double>(i) - n + 1) / (n + 1); };
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const double x = place(i), weight = (1 - x * x) * (1 - x * x);
    weights += weight;
    seconds += weight * x * x;
    sum += weight * piece[i];
    moment += weight * x * piece[i];
  }
  const double bias = sum / weights, drift = seconds > 0 ? moment / seconds : 0;
  for (std::size_t i = 0; i < piece.size(); ++i) piece[i] -= bias + drift * place(i);
}

}  // namespace

std::vector<double> integrate_twice(std::span<const double> acceleration,
                                    std::span<const double> speed, const Band& band, double spacing,
                                    Curvature curvature) {
  if (acceleration.size() != speed.size())
    throw InputError{"speeds: " + std::to_string(speed.size()) + " for " +
                     std::to_string(acceleration.size()) + " accelerations; allowed: one each"};
  const FilterTaps taps = double_integral_taps(band, spacing, curvature);
  std::vector<double> rest(acceleration.begin(), acceleration.end());
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (std::isnan(speed[i])) rest[i] = units::nan;
  for (const std::span<double> piece : pieces_of(rest)) take_off_bias(piece);
  double low = units::infinity, high = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (std::isnan(rest[i])) continue;
    const double v = units::require_positive("speed", speed[i], "m/s");
    low = std::min(low, v);
    high = std::max(high, v);
    rest[i] /= v * v;
  }
  // FilterStream continues a piece point-symmetrically about its last sample. Heights continued so
  // have second derivatives that are point-symmetric about zero: a last one of any other value
  // would be a curvature of twice its size for as far as the filter reaches.
  const auto heights_of = [&](std::vector<double>& second) {
    for (const std::span<double> piece : pieces_of(second)) piece.front() = piece.back() = 0;
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
