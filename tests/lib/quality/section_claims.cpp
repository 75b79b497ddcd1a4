// The accuracy that lib/quality states of sections, twist and indices, on seeded records, in
// 80-bit arithmetic.
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/exceptions.hpp>
#include <railbook/quality/sections.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::filters;
using namespace railbook::quality;
using namespace railbook::tests;

TEST_CASE("claim: sections, twist, exceptions and indices") {
  Claim sections("quality::Sections"), twist("quality::Twist"), beyond("quality::Exceptions"),
      warped("quality::Warp"), combined("quality::combined_deviation"),
      index("quality::track_quality_index");
  RandomStream draw(71);
  for (int k = 0; k < 1000; ++k) {
    // 40 samples of one section about a mean that may be far larger than they scatter; some
    // missing.
    const double middle = draw.decades(1e-6, 10), scatter = middle * draw.decades(1e-6, 1e3),
                 spacing = draw.decades(0.05, 1);
    std::vector<double> x;
    for (int i = 0; i < 40; ++i)
      x.push_back(draw(0, 1) < 0.1 ? std::numeric_limits<double>::quiet_NaN()
                                   : middle + draw.normal(scatter));
    const auto place = [&](std::size_t i) { return spacing * static_cast<double>(i); };
    Sections cut(100, place);
    cut.push({x.data(), 13});
    cut.push({x.data() + 13, 27});
    REQUIRE(cut.all().size() == 1);
    const Section& s = cut.all()[0];
    Long sum = 0, square = 0, count = 0, low = 1e9L, high = -1e9L;
    for (const double v : x)
      if (!std::isnan(v))
        sum += v, ++count, low = std::min<Long>(low, v), high = std::max<Long>(high, v);
    for (const double v : x)
      if (!std::isnan(v)) square += (v - sum / count) * (v - sum / count);
    const Long deviation = std::sqrt(square / count), size = std::abs(sum / count) + deviation;
    sections.error(static_cast<double>(std::abs(*s.deviation() - deviation) / size));
    sections.error(static_cast<double>(std::abs(s.mean - sum / count) / size));
    sections.error(
        s.lowest == static_cast<double>(low) && s.highest == static_cast<double>(high) ? 0 : 1);
    sections.error(s.samples == 40 && s.samples - s.missing == static_cast<std::size_t>(count) ? 0
                                                                                               : 1);

    const double base = spacing * draw(1, 10);
    Twist over(base, spacing);
    const auto lag = static_cast<std::size_t>(std::round(base / spacing));
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double found = over.push(x[i]);
      if (i < lag || std::isnan(x[i]) || std::isnan(x[i - lag])) {
        twist.error(std::isnan(found) ? 0 : 1);
        continue;
      }
      const Long run = Long(lag) * spacing;
      twist.error(
          static_cast<double>(std::abs(found - (Long{x[i]} - x[i - lag]) / run) * run / size));
    }

    // Nearer than a base that no sample is exactly away.
    const double reach = spacing * (std::floor(draw(1, 10)) + draw(0.1, 0.9));
    Warp warp(reach, spacing);
    for (std::size_t i = 0; i < x.size(); ++i) {
      double most = 0;
      for (std::size_t j = 0; j <= i; ++j)
        if (spacing * static_cast<double>(i - j) < reach && !std::isnan(x[j]) &&
            std::abs(x[i] - x[j]) > std::abs(most))
          most = x[i] - x[j];
      const double found = warp.push(x[i]);
      warped.error(std::isnan(x[i])                    ? (std::isnan(found) ? 0 : 1)
                   : std::abs(found) == std::abs(most) ? 0
                                                       : 1);
    }

    const double limit = middle + draw(-0.5, 1.5) * scatter;
    if (limit > 0) {
      Exceptions found(limit, place);
      found.push({x.data(), 7});
      found.push({x.data() + 7, 33});
      std::size_t runs = 0;
      double worst = 0;
      int side = 0;
      for (const double v : x) {
        const int here = v > limit ? 1 : v < -limit ? -1 : 0;
        if (here != 0 && here != side) ++runs;
        if (here != 0) worst = std::max(worst, std::abs(v));
        side = here;
      }
      double largest = 0;
      for (const Exception& e : found.all()) largest = std::max(largest, std::abs(e.largest));
      beyond.error(found.all().size() == runs && largest == worst ? 0 : 1);
    } else {
      beyond.error(0);
    }

    std::array<double, 7> d{}, w{};
    Long all = 0, weighted = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      d[i] = draw.decades(1e-6, 1e-1), w[i] = draw(0, 2);
      all += d[i], weighted += w[i] * Long{d[i]} * d[i];
    }
    index.relative(track_quality_index(d), all);
    combined.relative(combined_deviation(d, w), std::sqrt(weighted));
  }
}

TEST_CASE("claim: the gain of a band") {
  Claim claim("filters::band_gain");
  RandomStream draw(72);
  for (int k = 0; k < 1000; ++k) {
    const Band band{"", draw.decades(0.1, 10), draw.decades(11, 1000)};
    const double low = 1 / band.longest, high = 1 / band.shortest;
    const double phi =
        k % 2 == 0 ? draw.decades(1e-6, 1e4) : std::sqrt(low * high) * (1 + draw.decades(1e-15, 1));
    const Long a = 1 / Long{band.longest}, b = 1 / Long{band.shortest},
               x = (Long{phi} * phi - a * b) / (phi * (b - a));
    const Long squared = 1 / (1 + std::pow(x * x, Long{4}));
    claim.relative(band_gain(band, 1, phi), std::sqrt(squared));
    claim.relative(band_gain(band, 2, phi), squared);
  }
}
