#include <railbook/filters/double_integral.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <railbook/num/fft.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using filters::Curvature;

namespace {

const filters::Band& d1 = filters::bands[1];

struct Wave {
  double length, amplitude, phase;
  double k() const { return 2 * units::pi / length; }
};
const std::vector<Wave> waves{{4, 1e-3, 0.3}, {9, 2e-3, 1.1}, {17, 3e-3, 2.9}, {24, 3e-3, 0.2}};

// The acceleration at a place where the speed is v and changes by dv/dx.
double acceleration(double x, double v, double change) {
  double a = 0;
  for (const Wave& w : waves)
    a += w.amplitude * w.k() *
         (v * change * std::cos(w.k() * x + w.phase) -
          v * v * w.k() * std::sin(w.k() * x + w.phase));
  return a;
}

double in_band(double x) {
  double z = 0;
  for (const Wave& w : waves)
    z += filters::band_gain(d1, 2, 1 / w.length) * w.amplitude * std::sin(w.k() * x + w.phase);
  return z;
}

struct Run {
  std::vector<double> acceleration, speed;
};
Run drive(double spacing, std::size_t samples, const std::function<double(double)>& speed) {
  Run run;
  for (std::size_t i = 0; i < samples; ++i) {
    const double x = spacing * static_cast<double>(i), v = speed(x);
    const double change = (speed(x + 1e-4) - speed(x - 1e-4)) / 2e-4;
    run.speed.push_back(v);
    run.acceleration.push_back(acceleration(x, v, change));
  }
  return run;
}

double worst(const std::vector<double>& z, double spacing) {
  double off = 0;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (std::isfinite(z[i]))
      off = std::max(off, std::abs(z[i] - in_band(spacing * static_cast<double>(i))));
  return off;
}

}  // namespace

TEST_CASE("unit: the gain of the double integral is that of its band over (2 pi phi)^2") {
  for (const filters::Band& band : filters::bands)
    for (const double per_wave : {4.0, 8.0, 30.0})
      for (const Curvature curvature : {Curvature::samples, Curvature::means}) {
        const double spacing = band.shortest / per_wave;
        const auto taps = filters::double_integral_taps(band, spacing, curvature);
        num::RealFft fft{1 << 16};
        const auto gains = filters::symmetric_gains(taps.half, fft);
        double off = 0;
        for (std::size_t k = 1; k < gains.size(); ++k) {
          const double phi = static_cast<double>(k) / (65536 * spacing);
          if (phi < 1 / band.longest || phi > 1 / band.shortest) continue;
          const double twice = curvature == Curvature::samples
                                   ? std::pow(2 * units::pi * phi, 2)
                                   : std::pow(2 * std::sin(units::pi * phi * spacing) / spacing, 2);
          const double wanted = -filters::band_gain(band, 2, phi) / twice;
          off = std::max(off, std::abs(gains[k] / wanted - 1));
        }
        CHECK(off < 1e-3);
        CHECK(std::abs(gains[0]) < 1e-9 * band.longest * band.longest);
      }
  CHECK_THROWS_AS(filters::double_integral_taps(d1, 1), InputError);
  CHECK_THROWS_AS(filters::double_integral_taps(d1, 0), InputError);
}

TEST_CASE("unit: waves at a steady speed come out as they are, without bias and drift") {
  for (const double spacing : {0.05, 0.3}) {
    Run run = drive(spacing, static_cast<std::size_t>(800 / spacing), [](double) { return 20.0; });
    for (std::size_t i = 0; i < run.acceleration.size(); ++i)
      run.acceleration[i] += 0.3 + 1e-3 * spacing * static_cast<double>(i);
    const auto z = filters::integrate_twice(run.acceleration, run.speed, d1, spacing);
    REQUIRE(z.size() == run.speed.size());
    CHECK(std::isnan(z[static_cast<std::size_t>(99 / spacing)]));
    CHECK(std::isfinite(z[static_cast<std::size_t>(101 / spacing)]));
    double inner = 0;
    for (std::size_t i = static_cast<std::size_t>(250 / spacing);
         i < static_cast<std::size_t>(550 / spacing); ++i)
      inner = std::max(inner, std::abs(z[i] - in_band(spacing * static_cast<double>(i))));
    CHECK(inner < 1e-8);
    CHECK(worst(z, spacing) < 0.01 * 9e-3);  // beside the margin, of the sum of the amplitudes
  }
}

TEST_CASE("unit: a changing speed costs its square in the band, a quarter of it at the edges") {
  for (const double rate : {0.01, 0.025}) {  // 1/s: 0.01 is 0.2 m/s^2 at 20 m/s
    const double spacing = 0.1;
    Run run = drive(spacing, 8000, [&](double x) { return 20 + rate * (x - 400); });
    const double slowest = 20 - 150 * rate, change = 25 / (2 * units::pi) * rate / slowest;
    const auto z = filters::integrate_twice(run.acceleration, run.speed, d1, spacing);
    CHECK(std::isnan(z[1980]));
    double inner = 0;
    for (std::size_t i = 2500; i < 5500; ++i)
      inner = std::max(inner, std::abs(z[i] - in_band(spacing * static_cast<double>(i))));
    CAPTURE(rate);
    CHECK(inner < (0.25 * change + change * change) * 9e-3);
    CHECK(inner > 1e-8);
  }
}

TEST_CASE("unit: noise comes out as the weights say, and what is missing stays so") {
  const double spacing = 0.25, speed = 15, sigma = 1e-3;
  const std::vector<double> speeds(100000, speed);
  std::vector<double> noise(speeds.size());
  const num::RandomSource source{1, 0};
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = sigma * source.normal(i);
  noise[50000] = units::nan;
  const auto z = filters::integrate_twice(noise, speeds, d1, spacing);
  const auto taps = filters::double_integral_taps(d1, spacing);
  double weights = -taps.half[0] * taps.half[0], squares = 0, n = 0;
  for (const double weight : taps.half) weights += 2 * weight * weight;
  for (const double value : z) {
    if (std::isnan(value)) continue;
    squares += value * value;
    ++n;
  }
  CHECK(n ==
        static_cast<double>(speeds.size() - 1 - 4 * filters::double_integral_margin(d1, spacing)));
  CHECK(std::sqrt(squares / n) ==
        Approx(sigma / (speed * speed) * std::sqrt(weights)).epsilon(0.05));
  CHECK_THROWS_AS(filters::integrate_twice(noise, std::vector<double>{1}, d1, spacing), InputError);
  CHECK_THROWS_AS(
      filters::integrate_twice(noise, std::vector<double>(noise.size(), 0.0), d1, spacing),
      InputError);
}
