#include <railbook/quality/alignment.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/units/input_error.hpp>

using namespace railbook;

namespace {

// Rough track as a sum of many waves, so that it can be read anywhere.
double height(double x) {
  double z = 0;
  for (int k = 1; k < 60; ++k) z += std::cos(0.13 * k * x + k * k * 1.7) / k;
  return 1e-3 * z;
}

}  // namespace

TEST_CASE("unit: a run that slips against another is found again, to a fraction of a sample") {
  const double h = 0.25;
  std::vector<double> a(12000), b(12000);
  const auto slip = [](double x) {
    return 3.3 + 1e-3 * x;
  };  // m, what the second run counts too much
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = h * static_cast<double>(i);
    a[i] = height(x);
    b[i] = height(x - slip(x)) + 2e-5 * std::sin(37.0 * x);
  }
  for (std::size_t i = 5000; i < 5100; ++i) a[i] = std::numeric_limits<double>::quiet_NaN();
  const auto matches = quality::align(a, b, h);
  CHECK(matches.size() == 29);
  for (const auto& m : matches) {
    CHECK(m.found);
    CHECK(m.correlation > 0.95);
    const double x = h * static_cast<double>(m.centre);
    CHECK(m.offset == Approx(slip(x + m.offset)).margin(0.05));
  }
  CHECK(quality::offset_at(matches, 6000) == Approx(slip(1505)).margin(0.05));
}

TEST_CASE("unit: another track is not found") {
  std::vector<double> a(4000), b(4000);
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = height(0.25 * static_cast<double>(i));
    b[i] = height(9000 + 0.31 * static_cast<double>(i));
  }
  for (const auto& m : quality::align(a, b, 0.25, {.least = 0.6})) {
    CHECK_FALSE(m.found);
    CHECK(m.offset / 0.25 == std::round(m.offset / 0.25));  // and not looked for between samples
  }
  const std::vector<double> still(a.size(), 0.0);  // is like nothing, and nothing like it
  for (const auto& matches : {quality::align(a, still, 0.25), quality::align(still, b, 0.25)})
    for (const auto& m : matches) {
      CHECK_FALSE(m.found);
      CHECK(m.correlation == -1);
    }
  CHECK(quality::offset_at({}, 7) == 0);
  CHECK_THROWS_AS(quality::align(a, b, 0), InputError);
  CHECK_THROWS_AS(quality::align(a, b, 0.25, {.window = 1}), InputError);
  CHECK_THROWS_AS(quality::align(a, b, 0.25, {.window = 5000}), InputError);
}

TEST_CASE("unit: a window that is like another place, before or behind, is left out") {
  const double h = 0.25, slip = 3, window = quality::AlignmentOptions{}.window;
  for (const double astray : {-12.0, 12.0}) {
    std::vector<double> a(12000), b(12000);
    const double from = 5 * window, to = 6 * window;  // one of the windows, half of two others
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double x = h * static_cast<double>(i), there = x - slip - astray;
      a[i] = height(x);
      b[i] = height(there >= from && there < to ? there : x - slip);
    }
    CAPTURE(astray);
    std::size_t lost = 0;
    for (const auto& m : quality::align(a, b, h)) {
      if (m.found) CHECK(m.offset == Approx(slip).margin(0.05));
      lost += m.found ? 0 : 1;
    }
    CHECK(lost >= 1);
    CHECK(lost <= 3);
  }
}
