// The accuracy that the library states of bands, chords and of how two runs are laid on each
// other, on seeded draws.
#include <cmath>
#include <vector>

#include <railbook/filters/chord_stream.hpp>
#include <railbook/filters/fir_filter.hpp>
#include <railbook/filters/inner_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/alignment.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::filters;
using namespace railbook::quality;
using namespace railbook::tests;

namespace {

// The gain of a filter without phase at phi (cycle/m): the sum itself.
Long gain(const filters::FilterTaps& taps, Long phi) {
  Long sum = taps.half[0];
  for (std::size_t j = 1; j < taps.half.size(); ++j)
    sum += 2 * taps.half[j] * std::cos(2 * long_pi * phi * taps.spacing * Long(j));
  return sum;
}

Long chord_gain(Long chord, Long phi) {
  return 1 - std::cos(long_pi * chord * phi);
}

}  // namespace

TEST_CASE("claim: filters of bands") {
  Claim claim("filters::band_taps");
  RandomStream draw(81);
  for (int k = 0; k < 200; ++k) {
    const double shortest = draw.decades(1, 70), spacing = shortest * draw.decades(0.05, 0.5);
    const Band band{"drawn", shortest, shortest * draw.decades(1.1, 100)};
    const int passes = 1 + k % 2;
    const filters::FilterTaps taps = band_taps(band, passes, spacing);
    for (int i = 0; i < 5; ++i) {
      const double phi = draw.decades(1 / band.longest, 1 / band.shortest);
      claim.relative(gain(taps, phi), band_gain(band, passes, phi));
    }
    claim.error(static_cast<double>(std::abs(gain(taps, 0))));
  }
}

TEST_CASE("claim: filters of chords") {
  Claim offset("filters::chord_taps"), uniformity("filters::uniformity_taps");
  RandomStream draw(82);
  for (int k = 0; k < 1000; ++k) {
    const double chord = draw.decades(2, 40), spacing = chord * draw.decades(2e-3, 0.25);
    const double phi = draw.decades(1e-2, 0.5) / spacing;
    const Long turn = 2 * long_pi * phi * spacing, cubic = 3 * std::pow(turn, Long{4}) / 128;
    const Long one = chord_gain(chord, phi);
    const auto room = [&](Long found, Long exact) {
      return static_cast<double>(std::abs(found - exact) / (cubic + 1e-12L));
    };
    offset.error(room(gain(chord_taps(chord, spacing), phi), one));
    Long mean = 1;
    for (int m = 1; m <= 4; ++m) mean += 2 * std::cos(long_pi * m * Long{chord} * phi / 2);
    uniformity.error(room(gain(uniformity_taps(chord, spacing), phi), one * (1 - mean / 9)));
  }
}

TEST_CASE("claim: offsets of chords, also divided elsewhere than in the middle") {
  Claim claim("filters::ChordStream");
  RandomStream draw(85);
  for (int k = 0; k < 200; ++k) {
    const double spacing = draw.decades(0.1, 1), before = spacing * draw.decades(2, 50),
                 after = k % 4 ? spacing * draw.decades(2, 50) : before;
    const Long phi = draw.decades(1e-2, 0.5) / spacing, start = draw(0, 1);
    const auto height = [&](Long x) { return std::sin(2 * long_pi * (phi * x + start)); };
    std::vector<double> record(300);
    for (std::size_t i = 0; i < record.size(); ++i)
      record[i] = static_cast<double>(height(Long(spacing) * Long(i)));
    record[200] = std::nan("");
    std::vector<double> found;
    filters::ChordStream stream{{before, after}, spacing, [&](std::span<const double> values) {
                                  found.insert(found.end(), values.begin(), values.end());
                                }};
    stream.push(std::span{record}.first(77));
    stream.push(std::span{record}.subspan(77));
    stream.finish();
    REQUIRE(found.size() == record.size());
    const auto back = static_cast<std::ptrdiff_t>(before / spacing) + 2,
               ahead = static_cast<std::ptrdiff_t>(after / spacing) + 2;
    const Long turn = 2 * long_pi * phi * Long(spacing),
               cubic = 3 * std::pow(turn, Long{4}) / 128 + 1e-12L;
    for (std::ptrdiff_t i = 0; i < 300; ++i) {
      const double is = found[static_cast<std::size_t>(i)];
      const bool whole = i >= back && i + ahead < 300 && (i + ahead < 200 || i - back > 200);
      CHECK(std::isnan(is) != whole);
      const Long x = Long(spacing) * Long(i), b = before, a = after;
      if (whole)
        claim.error(static_cast<double>(
            std::abs(is - (height(x) - (a * height(x - b) + b * height(x + a)) / (a + b))) /
            cubic));
    }
  }
}

TEST_CASE("claim: filters where they have their track") {
  Claim margin("filters::band_margin"), inner("filters::InnerFilter");
  RandomStream draw(84);
  for (int k = 0; k < 1000; ++k) {
    const Band band{"drawn", 1, draw.decades(1.1, 100)};
    const double spacing = draw.decades(0.01, 0.5);
    const auto samples = static_cast<double>(band_margin(band, spacing));
    margin.error(samples * spacing >= band.longest && (samples - 1) * spacing < band.longest ? 0
                                                                                             : 1);
    const filters::FilterTaps taps = chord_taps(draw.decades(2, 20), 0.5);
    const auto reach = static_cast<std::ptrdiff_t>(taps.half.size()) - 1;
    const auto keep = static_cast<std::ptrdiff_t>(draw(0, 1.01) * static_cast<double>(reach));
    const auto n = static_cast<std::ptrdiff_t>(draw(1, 400));
    std::vector<double> record(static_cast<std::size_t>(n));
    double chance = 0;  // of a gap to go on, or to begin
    for (double& z : record) {
      z = draw(0, 1) < chance ? std::nan("") : draw(-1, 1);
      chance = std::isnan(z) ? 0.7 : 0.01;
    }
    std::vector<double> found;
    InnerFilter filter(taps, static_cast<std::size_t>(keep), [&](std::span<const double> p) {
      found.insert(found.end(), p.begin(), p.end());
    });
    const auto half = static_cast<std::size_t>(n / 2);
    filter.push(std::span{record}.first(half));
    filter.push(std::span{record}.subspan(half));
    filter.finish();
    const auto all = filters::filter(taps, record);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      bool whole = true;
      for (std::ptrdiff_t j = i - keep; j <= i + keep; ++j)
        whole = whole && j >= 0 && j < n && !std::isnan(record[static_cast<std::size_t>(j)]);
      const double is = found.at(static_cast<std::size_t>(i));
      if (whole)
        inner.error(std::abs(is - all[static_cast<std::size_t>(i)]));
      else
        inner.error(std::isnan(is) ? 0 : 1);
    }
  }
}

TEST_CASE("claim: two runs laid on each other") {
  Claim aligned("quality::align"), between("quality::offset_at");
  RandomStream draw(83);
  for (int k = 0; k < 250; ++k) {
    // Rough track with waves from eight spacings on, read by the second run with a slip that is no
    // whole number of spacings.
    const double spacing = draw.decades(0.1, 0.5), slip = spacing * draw(-15, 15);
    std::vector<double> waves, phases;
    for (int i = 0; i < 40; ++i) {
      waves.push_back(2 * units::pi * draw.decades(0.004, 0.125) / spacing);
      phases.push_back(draw(0, 2 * units::pi));
    }
    const auto height = [&](double x) {
      double z = 0;
      for (std::size_t i = 0; i < waves.size(); ++i)
        z += std::cos(waves[i] * x + phases[i]) / waves[i];
      return z;
    };
    std::vector<double> first, second;
    for (int i = 0; i < 500; ++i) {
      const double x = spacing * i;
      first.push_back(height(x)), second.push_back(height(x - slip));
    }
    const auto matches =
        align(first, second, spacing, {.window = 160 * spacing, .reach = 20 * spacing});
    for (const Match& m : matches) {
      if (m.centre < 100 || m.centre > 400) continue;  // what it looks for lies in the record
      aligned.error(m.found ? std::abs(m.offset - slip) / spacing : 1);
    }
    for (int i = 0; i < 4; ++i) {
      const double at = draw(double(matches.front().centre), double(matches.back().centre));
      std::size_t j = 0;
      while (double(matches[j + 1].centre) < at) ++j;
      const Match &a = matches[j], &b = matches[j + 1];
      const Long part = (Long(at) - Long(a.centre)) / Long(b.centre - a.centre);
      between.error(static_cast<double>(
          std::abs(offset_at(matches, at) - (a.offset + part * (Long(b.offset) - a.offset))) /
          (std::abs(a.offset) + std::abs(b.offset))));
    }
  }
}
