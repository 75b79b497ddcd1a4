#include <railbook/quality/sections.hpp>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/quality/exceptions.hpp>
#include <railbook/spectra/reference_spectra.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

// Simpson's rule over the logarithm of the wavenumber.
double rms_mm(const spectra::Reference& r, double shortest, double longest) {
  const int n = 20000;
  const double from = std::log(1 / longest), step = (std::log(1 / shortest) - from) / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double phi = std::exp(from + step * i);
    sum += (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * r.density(phi) * phi;
  }
  return 1e3 * std::sqrt(sum * step / 3);
}

}  // namespace

TEST_CASE("unit: reference spectra have the rms that two other methods found") {
  struct Known {
    const char *name, *channel;
    double d1, d2;  // mm, 3-25 m and 25-70 m; 0: not known
  };
  for (const Known& k :
       {Known{"german-low", "vertical", 0.98427, 1.65072},
        Known{"german-high", "vertical", 1.61090, 2.70163},
        Known{"german-low", "lateral", 0.71354, 0}, Known{"german-high", "lateral", 1.21313, 0},
        Known{"fra-1", "vertical", 8.54073, 14.4877}, Known{"fra-3", "vertical", 6.40828, 10.8704},
        Known{"fra-4", "vertical", 5.69123, 9.65409}, Known{"fra-5", "vertical", 3.55278, 6.02662},
        Known{"fra-6", "vertical", 1.42915, 2.42427},
        Known{"hamid-yang-1", "vertical", 5.40739, 13.0240},
        Known{"hamid-yang-4", "vertical", 2.27633, 5.48267},
        Known{"hamid-yang-6", "vertical", 1.29057, 3.10840},
        Known{"china-hsr", "vertical", 0.28642, 0.36233},
        Known{"china-hsr", "lateral", 0.26093, 0.32719}}) {
    const auto& r = spectra::reference(k.name, k.channel);
    CAPTURE(k.name, k.channel);
    CHECK(rms_mm(r, 3, 25) == Approx(k.d1).epsilon(1e-4));
    if (k.d2 > 0) CHECK(rms_mm(r, 25, 70) == Approx(k.d2).epsilon(1e-4));
  }
  CHECK_THROWS_WITH(spectra::reference("german-lo"), Contains("did you mean \"german-low\""));
}

TEST_CASE("unit: sections begin at multiples of their length, whichever way the record runs") {
  for (const double direction : {1.0, -1.0}) {
    quality::Sections sections{
        100, [&](std::size_t i) { return 1050 + direction * 0.25 * static_cast<double>(i); }};
    std::vector<double> z(1000);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = 5 + std::sin(0.1 * static_cast<double>(i));
    z[3] = std::numeric_limits<double>::quiet_NaN();
    sections.push(std::span{z}.first(333));
    sections.push(std::span{z}.subspan(333));
    REQUIRE(sections.all().size() == 3);
    CHECK(sections.all()[0].from == 1000);
    CHECK(sections.all()[1].from == 1000 + 100 * direction);
    CHECK(sections.all()[0].missing == 1);
    const quality::Section& s = sections.all()[1];
    // The plain sums of the same samples.
    const std::size_t first = sections.all()[0].samples;
    double sum = 0, square = 0;
    for (std::size_t i = first; i < first + s.samples; ++i) sum += z[i], square += z[i] * z[i];
    const auto n = static_cast<double>(s.samples);
    CHECK(s.samples == 400);
    CHECK(*s.deviation() == Approx(std::sqrt(square / n - sum * sum / n / n)).epsilon(1e-9));
    CHECK(s.highest == Approx(6).margin(1e-2));
  }
}

TEST_CASE("unit: twist, combined deviation and China's index, by hand") {
  quality::Twist twist{3, 0.25};
  CHECK(twist.base() == 3);
  for (int i = 0; i < 12; ++i) CHECK(std::isnan(twist.push(1e-3 * i)));
  CHECK(twist.push(1e-3 * 12) == Approx(4e-3));  // 1 mm a quarter metre
  const std::array four{3e-3, 4e-3};
  CHECK(quality::combined_deviation(four) == Approx(5e-3));
  const std::array weights{1.0, 0.0};
  CHECK(quality::combined_deviation(four, weights) == Approx(3e-3));
  CHECK_THROWS_AS(quality::combined_deviation(four, std::array{1.0}), InputError);
  const std::array<double, 7> seven{2.07, 2.07, 1.99, 1.99, 1.17, 1.60, 1.23};
  CHECK(quality::track_quality_index(seven) == Approx(12.12));
}

TEST_CASE("unit: exceptions are runs beyond the limit, on one side, ended by a gap") {
  quality::Exceptions exceptions{1, [](std::size_t i) { return 10.0 * static_cast<double>(i); }};
  const double gap = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> all{0, 1, 1.5, 3, 2, 1, -2, -1.5, 2, gap, 2, 0};
  exceptions.push(std::span{all}.first(4));
  exceptions.push(std::span{all}.subspan(4));
  REQUIRE(exceptions.all().size() == 4);
  const auto& first = exceptions.all()[0];
  CHECK(first.from == 20);
  CHECK(first.to == 40);
  CHECK(first.largest == 3);
  CHECK(first.at == 30);
  CHECK(exceptions.all()[1].largest == -2);
  CHECK(exceptions.all()[1].to == 70);
  CHECK(exceptions.all()[3].from == 100);
  CHECK_THROWS_AS(quality::Exceptions(0, [](std::size_t) { return 0.0; }), InputError);
}
