// One accelerometer of the simulated car, integrated twice in a band.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include <railbook/filters/double_integral.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/filters/inner_filter.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

namespace {

constexpr double speed = 60 * units::mph;

std::vector<double> banded(const std::vector<double>& heights, const filters::Band& band,
                           double spacing) {
  std::vector<double> all;
  filters::InnerFilter filter(
      filters::band_taps(band, 2, spacing), filters::band_margin(band, spacing),
      [&](std::span<const double> p) { all.insert(all.end(), p.begin(), p.end()); });
  filter.push(heights);
  filter.finish();
  return all;
}

}  // namespace

TEST_CASE("unit: an accelerometer of the car and its height over the axle give the rail") {
  const geometry_car::Track track = geometry_car::build({.length = 8000 * units::foot,
                                                         .opposite_share = 0,
                                                         .dip = 0,
                                                         .curvature = 0,
                                                         .superelevation = 0});
  geometry_car::Motion motion{.start = 2000 * units::foot, .speed = speed};
  motion.cruise(3900 * units::foot);
  const geometry_car::Car car;
  const auto record = geometry_car::drive(track, car, motion);
  const double spacing = car.layout.sample;
  // What the analog filter of 1 Hz has taken is put back.
  filters::SecondOrderHybrid hybrid{{.omega = 2 * units::pi * car.layout.second_corner}};
  std::vector<double> acceleration(record.size(), units::nan), rail;
  for (std::size_t i = 0; i < track.size(); i += static_cast<std::size_t>(track.substeps))
    rail.push_back(track.z_left[i]);
  const auto& measured = record[geometry_car::Channel::vertical_left];
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double mean = hybrid.push(measured[i], spacing / speed).mean;
    if (i > 0) acceleration[i - 1] = mean;
  }
  for (const std::size_t which : {std::size_t{1}, std::size_t{2}}) {  // D1 and D2
    const filters::Band& band = filters::bands[which];
    const auto body =
        filters::integrate_twice(acceleration, std::vector<double>(acceleration.size(), speed),
                                 band, spacing, filters::Curvature::means);
    const auto over = banded(record[geometry_car::Channel::height_left], band, spacing);
    const auto whole = banded(rail, band, spacing);
    double worst = 0, inner = 0, squares = 0, n = 0;
    const auto inside = static_cast<std::size_t>(5 * band.longest / spacing);
    for (std::size_t i = 0; i < body.size(); ++i) {
      const double truth = whole[static_cast<std::size_t>(record.mark[i])];
      if (std::isnan(body[i]) || std::isnan(over[i])) continue;
      const double off = std::abs(body[i] - over[i] - truth);
      worst = std::max(worst, off);
      if (i >= inside && i + inside < body.size()) inner = std::max(inner, off);
      squares += truth * truth;
      ++n;
    }
    CAPTURE(band.name, n, std::sqrt(squares / n), worst, inner);
    CHECK(n > 2000);
    CHECK(worst < 0.1 * std::sqrt(squares / n));
    CHECK(inner < 0.05 * std::sqrt(squares / n));
  }
}
