// Clean records, of all kinds: fewer than one in a thousand is doubted.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "spectra/line_mask.hpp"
#include "num/random_source.hpp"
#include "spectra/record.hpp"
#include "spectra/spectrum_fit.hpp"
#include "spectra/synthetic_track.hpp"
#include "spectra/welch.hpp"

using namespace railbook;

namespace {

spectra::SyntheticTrack some_track(std::uint64_t k) {
  const num::RandomSource random{k, 77};
  std::uint64_t i = 0;
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform(i++));
  };
  const auto maybe = [&](double value) { return random.uniform(i++) < 0.5 ? value : 0; };
  spectra::SyntheticTrack t{.spacing = between(0.1, 0.6), .seed = k};
  t.A = between(2e-9, 1e-5);
  if (maybe(1) > 0) t.phi_c = between(0.05, 0.5);
  t.rail_length = between(8, 40);
  t.dip = maybe(between(0.001, 0.01));
  t.dip_scatter = maybe(0.3);
  t.memory_dip = maybe(0.003);
  t.grade = maybe(0.02);
  t.wave_amplitude = maybe(10);
  t.sensor_noise = maybe(1e-4);
  t.gap_share = maybe(0.02);
  return t;
}

}  // namespace

TEST_CASE(
    "property: no clean record is found faulty, whatever its spacing, roughness and rounding") {
  std::size_t records = 0;
  for (std::uint64_t k = 0; k < 30; ++k) {
    const auto t = some_track(k);
    constexpr std::size_t length = 2500;
    const auto z = spectra::synthesize(t, 40 * length);
    const std::vector<double> quanta{0, 1e-6, 1e-5, 1e-4, 1e-3};
    const double quantum = quanta[k % quanta.size()], place = k % 3 == 0 ? 0.05 * t.spacing : 0.01;
    for (std::size_t r = 0; r < 40; ++r) {
      spectra::RecordStream stream{{}, [](std::span<const double>) {}};
      for (std::size_t i = r * length; i < (r + 1) * length; ++i) {
        const double x = t.spacing * static_cast<double>(i);
        stream.add(place * std::round(x / place),
                   quantum > 0 ? quantum * std::round(z[i] / quantum) : z[i]);
      }
      stream.finish();
      const auto doubts = stream.doubts();
      CAPTURE(k, r, t.spacing, t.A, t.phi_c, quantum);
      for (const auto& doubt : doubts) UNSCOPED_INFO(doubt.text);
      CHECK(doubts.empty());
      ++records;
    }
  }
  CHECK(records == 1200);
}

TEST_CASE("property: no clean spectrum is doubted: residuals, stray lines, another rail") {
  std::size_t records = 0;
  for (std::uint64_t k = 0; k < 6; ++k) {
    const spectra::SyntheticTrack t{.seed = 100 + k,
                                    .A = k % 2 == 0 ? 5e-7 : 3e-6,
                                    .phi_c = k < 3 ? 0.13 : spectra::no_corner,
                                    .dip = k % 3 == 0 ? 0 : 0.004};
    spectra::TrackGenerator generator{t};
    std::vector<double> z(10000);
    for (std::size_t r = 0; r < 200; ++r) {
      generator.fill(z);
      const auto s = spectra::welch(z, t.spacing, {.segment = 2048});
      const spectra::FitOptions options{.noise = spectra::NoiseModel::automatic};
      const auto fit = spectra::fit_track_spectrum(s, options);
      CAPTURE(k, r);
      CHECK(fit.misfit < 1.25);
      const auto stray = spectra::stray_line(s, options, fit);
      if (stray) UNSCOPED_INFO(stray->phi << " " << stray->ratio << " " << stray->chance);
      CHECK_FALSE(stray.has_value());
      CHECK_FALSE(spectra::contradicting_rail(s, options, fit).has_value());
      ++records;
    }
  }
  CHECK(records == 1200);
}
