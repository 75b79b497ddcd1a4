#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/quality/quality_index.hpp>
#include <railbook/quality/spreading.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::quality;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("Index: gaps, a flat record and an empty one", "[quality]") {
  const NoFpFault no_fault;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  IndexBuilder b{{.spacing = 1}};
  b.push(std::vector<double>{nan, 2, 2, nan, nan, 0, 0, -3});
  b.finish();
  const QualityIndex q = b.index();
  CHECK(q.samples == 8);
  CHECK(q.missing == 3);
  CHECK(q.above == 3);
  REQUIRE(b.exceedances().size() == 2);
  CHECK(b.exceedances()[0].cut);
  CHECK(b.exceedances()[0].at == 1);  // the first of equal ones
  CHECK(b.exceedances()[1].peak == -3);
  IndexBuilder still{{.spacing = 1}};
  still.push(std::vector<double>(10, 0.0));
  still.finish();
  CHECK(std::isinf(still.index().margin));
  CHECK(IndexBuilder({.spacing = 1}).index().samples == 0);
  CHECK_THROWS_AS(IndexBuilder({.spacing = 0}), InputError);
  CHECK_THROWS_AS(IndexBuilder({.spacing = 1, .threshold = -1}), InputError);
}

TEST_CASE("Index of a few samples, all of it by hand", "[quality]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  // Two pieces of 1.5 m and 1 m; zeros half way from 2 to -2 and a quarter from 1 to -3.
  const std::vector<double> p{nan, 0.5, 2, -2, -1, 1, -3, nan, 1.5, 1.01, 1};
  IndexBuilder b{{.spacing = 0.5, .threshold = 1, .margin = 0.6}};
  b.push(p);
  b.finish();
  const QualityIndex q = b.index();
  CHECK(q.samples == 11);
  CHECK(q.missing == 2);
  const double mean = 13.01 / 9, square = (22.5 + 1.01 * 1.01 + 0) / 9;
  CHECK_THAT(q.mean, WithinRel(mean, 1e-14));
  CHECK_THAT(q.rms, WithinRel(std::sqrt(square), 1e-14));
  CHECK_THAT(q.deviation, WithinRel(std::sqrt(square - mean * mean), 1e-13));
  CHECK_THAT(q.margin, WithinRel((1 - mean) / q.deviation, 1e-13));
  CHECK(q.largest == 3);
  CHECK(q.above == 5);
  CHECK_THAT(q.above_per_km, WithinRel(5 / 4.5e-3, 1e-14));
  CHECK_THAT(q.exceedances_per_km, WithinRel(4 / 4.5e-3, 1e-14));
  struct Expected {
    double at, peak, wavelength, length;
    bool cut;
    double clear;
  };
  const std::vector<Expected> expected{{1, 2, 1.5, 0.5, true, 0.5},  // from sample 1 to 2.5
                                       {1.5, -2, 2, 0.5, false, 1},  // to 4.5
                                       {3, -3, 0.75, 0.5, true, 0},  // from 5.25 to 6
                                       {4, 1.5, 2, 1, true, 0}};
  REQUIRE(b.exceedances().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("exceedance " << i);
    const Exceedance& e = b.exceedances()[i];
    CHECK_THAT(e.at, WithinAbs(expected[i].at, 1e-14));
    CHECK(e.peak == expected[i].peak);
    CHECK_THAT(e.wavelength, WithinAbs(expected[i].wavelength, 1e-14));
    CHECK_THAT(e.length, WithinAbs(expected[i].length, 1e-14));
    CHECK(e.cut == expected[i].cut);
    CHECK_THAT(e.clear, WithinAbs(expected[i].clear, 1e-14));
  }
  // Of the nine samples one spacing within either end of a piece; all of the shorter piece but one.
  CHECK_THAT(b.unsure(), WithinRel((2.0 + 2) / 9, 1e-14));
  const auto& bars = b.histogram();
  std::size_t counted = 0;
  for (const std::size_t bar : bars) counted += bar;
  CHECK(counted == 9);
  CHECK(bars[25] == 1);   // 0.5
  CHECK(bars[100] == 2);  // 2
  CHECK(bars[75] == 1);   // 1.5
  IndexBuilder high{{.spacing = 0.5}};
  high.push(std::vector{1e9});
  CHECK(high.histogram().back() == 1);
}

TEST_CASE("Index by segment: aligned with the kilometre posts, exceedances where their peak is",
          "[quality]") {
  // Half-waves of 10 m about 1; from 130 m to 770 m, a gap of 20 m at 400 m.
  const auto place = [](std::size_t i) { return 130 + 0.5 * static_cast<double>(i); };
  IndexBuilder b{{.spacing = 0.5, .threshold = 1, .place = place, .segment = 200, .margin = 30}};
  std::vector<double> p;
  for (double x = 130; x < 770; x += 0.5)
    p.push_back(x >= 400 && x < 420 ? std::numeric_limits<double>::quiet_NaN()
                                    : (x < 600 ? 0.9 : 1.2) * std::sin(units::pi * x / 10));
  b.push(p);
  b.finish();
  REQUIRE(b.segments().size() == 4);
  const std::vector<double> from{0, 200, 400, 600};
  const std::vector<std::size_t> samples{140, 400, 400, 340}, found{0, 0, 0, 17};
  std::size_t total = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const IndexSums& s = b.segments()[i].sums;
    CHECK(b.segments()[i].from == from[i]);
    CHECK(s.samples == samples[i]);
    CHECK(s.exceedances == found[i]);
    CHECK_THAT(s.index(0.5, 1).rms, WithinRel((i < 3 ? 0.9 : 1.2) / std::sqrt(2.0), 1e-9));
    total += s.samples;
  }
  CHECK(b.segments()[2].sums.missing == 40);
  CHECK(total == b.index().samples);
  CHECK_THAT(b.unsure(), WithinRel(2 * 60 / 620.0, 1e-12));
  CHECK_THAT(b.exceedances().front().clear, WithinAbs(769.5 - 605, 1e-9));
  CHECK_THAT(b.exceedances().back().clear, WithinAbs(4.5, 1e-9));
  CHECK_THROWS_AS(IndexBuilder({.spacing = 1, .segment = 0.5}), InputError);
}

TEST_CASE("The blob: constants, area, and finite volumes that keep it", "[quality]") {
  CHECK_THAT(blob_front(1), WithinAbs(0.74741205, 5e-9));
  CHECK_THAT(blob_height(0, 1), WithinAbs(0.79515947, 5e-9));
  CHECK_THAT(blob_height(0.3, 32), WithinRel(0.5 * blob_height(0.15, 1), 1e-12));
  Histogram p{-1.5 + 0.5 * 3.0 / 300, 3.0 / 300, {}};
  for (std::size_t i = 0; i < 300; ++i) p.height.push_back(blob_height(p.x(i), 1));
  const double before = area(p);
  const Spread s = spread({}, p, 1, 10, 300);
  REQUIRE(s.converged);
  CHECK_THAT(area(s.profile), WithinRel(before, 1e-12));
  CHECK_THAT(mean(s.profile), WithinAbs(0, 1e-12));
  CHECK_THAT(deviation(s.profile), WithinRel(std::sqrt(3.0 / 11) * blob_front(10), 5e-3));
  CHECK_THAT(s.profile.height[150], WithinRel(blob_height(s.profile.x(150), 10), 3e-3));
}
