#include <railbook/filters/double_integral.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
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
    CHECK(std::isnan(z[static_cast<std::size_t>(50 / spacing)]));
    CHECK(std::isfinite(z[static_cast<std::size_t>(52 / spacing)]));
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
    CHECK(std::isnan(z[1000]));
    CHECK(std::isfinite(z[1030]));
    double inner = 0;
    for (std::size_t i = 2500; i < 5500; ++i)
      inner = std::max(inner, std::abs(z[i] - in_band(spacing * static_cast<double>(i))));
    CAPTURE(rate);
    CHECK(inner < (0.25 * change + change * change) * 9e-3);
    CHECK(inner > 1e-8);
  }
}

TEST_CASE("unit: a filter's decay is that of its slowest pole") {
  // The weights of a band: their envelope falls by e in each band_decay().
  for (const filters::Band& band :
       {d1, filters::bands[3], filters::Band{"", 25, 100}, filters::Band{"", 100, 150}}) {
    const double decay = filters::band_decay(band), spacing = band.shortest / 20;
    const auto taps = filters::band_taps(band, 2, spacing);
    const auto largest = [&](double from) {  // within a longest wavelength
      double most = 0;
      for (double x = from; x < from + band.longest; x += spacing)
        most = std::max(most, std::abs(taps.half[static_cast<std::size_t>(x / spacing)]));
      return most;
    };
    CAPTURE(band.shortest, band.longest, decay);
    CHECK(std::log(largest(3 * decay) / largest(5 * decay)) == Approx(2).margin(0.4));
  }
}

TEST_CASE("unit: what ends and gaps hide is up to 2 % of the rms just beyond the margin") {
  struct Case {
    filters::Band band;
    double spacing;
  };
  const std::vector<Case> cases{
      {d1, 0.25},           {filters::bands[2], 0.5}, {filters::bands[3], 0.5},
      {{"", 25, 100}, 0.5}, {{"", 3, 150}, 0.5},      {{"", 100, 150}, 0.5},
      {{"", 20, 25}, 0.5},  {{"", 100, 110}, 0.5}};
  const double speed = 30;
  for (const auto& [band, spacing] : cases)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      // Track with waves of up to 1 km, of which a part is measured, with a bias, a drift of it and
      // a gap.
      num::RealFft fft{1 << 16};
      const num::RandomSource source{seed, 0};
      const auto waves_times = [&](const auto& gain) {
        for (std::size_t k = 0; k < fft.spectrum().size(); ++k) {
          const double phi = static_cast<double>(k) / (65536 * spacing);
          const double size = phi < 1e-3 ? 0 : 1e-4 / (phi * std::hypot(1, phi / 0.13));
          fft.spectrum()[k] =
              size * gain(phi) * std::complex{source.normal(2 * k), source.normal(2 * k + 1)};
        }
        fft.inverse();
        return std::vector<double>{fft.real().begin(), fft.real().begin() + 50000};
      };
      const auto truth = waves_times([&](double phi) { return filters::band_gain(band, 2, phi); });
      auto acceleration =
          waves_times([&](double phi) { return -std::pow(2 * units::pi * phi * speed, 2); });
      for (std::size_t i = 0; i < acceleration.size(); ++i)
        acceleration[i] += 9.8 + 1e-5 * static_cast<double>(i);
      for (std::size_t i = 25000; i < 25010; ++i) acceleration[i] = units::nan;
      const auto z = filters::integrate_twice(
          acceleration, std::vector<double>(acceleration.size(), speed), band, spacing);
      const std::size_t margin = filters::double_integral_margin(band, spacing);
      const auto wave = static_cast<std::size_t>(band.longest / spacing);
      double squares = 0, off = 0, inner = 0;
      std::size_t beside = 0, inside = 0;
      for (std::size_t i = 0; i < z.size(); ++i) {
        squares += truth[i] * truth[i] / static_cast<double>(z.size());
        const std::size_t to_gap = i < 25000 ? 25000 - i : i < 25010 ? 0 : i - 25009;
        const std::size_t away = std::min({i + 1, z.size() - i, to_gap});
        if (std::isnan(z[i]) != (away <= margin)) FAIL("sample " << i);
        if (away <= margin) continue;
        const double error = std::pow(z[i] - truth[i], 2);
        if (away <= margin + wave) off += error, ++beside;
        if (away > 2 * margin) inner += error, ++inside;
      }
      CAPTURE(band.shortest, band.longest, seed);
      CHECK(beside == 4 * wave);
      CHECK(std::sqrt(off / static_cast<double>(beside)) < 0.02 * std::sqrt(squares));
      if (inside > 0)
        CHECK(std::sqrt(inner / static_cast<double>(inside)) < 0.002 * std::sqrt(squares));
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
