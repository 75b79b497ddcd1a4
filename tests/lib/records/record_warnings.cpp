// What a record stream says of a record: each doubt from its limit on, with its count, its worst
// place and its size.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/warning.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

constexpr double lost = std::numeric_limits<double>::quiet_NaN(), spacing = 0.25;

std::vector<double> track(std::size_t n) {
  std::vector<double> z(n);
  spectra::SyntheticTrack input;
  input.seed = 5, input.spacing = spacing, input.A = 5e-7, input.dip = 0;
  spectra::TrackGenerator{input}.fill(z);
  return z;
}

struct Heard {
  std::vector<units::Warning> warnings;
  double roughness = 0;
  std::string of(const std::string& key) const {
    for (const units::Warning& d : warnings)
      if (d.key == key) return d.text;
    return {};
  }
};
Heard hear(const std::vector<double>& z, std::size_t bridge = 0) {
  records::RecordStream stream{{.spacing = spacing, .bridge = bridge},
                               [](std::span<const double>) {}};
  stream.add(z);
  stream.finish();
  return {stream.warnings(), stream.roughness()};
}

}  // namespace

TEST_CASE("unit: more than a twentieth of the samples bridged is doubted") {
  for (const std::size_t gaps : {199U, 200U, 201U, 400U}) {
    auto z = track(4000);
    for (std::size_t k = 0; k < gaps; ++k) z[5 + 9 * k] = lost;
    INFO(gaps << " of 4000");
    CHECK(hear(z, 0).warnings.empty());  // left as gaps
    const std::string text = hear(z, 1).of("bridged");
    CHECK(text.empty() == (gaps <= 200));
    if (gaps == 201) CHECK_THAT(text, Catch::StartsWith("5.025 % of the samples are bridged"));
    if (gaps == 400) CHECK_THAT(text, Catch::StartsWith("10 % of the samples are bridged"));
  }
}

TEST_CASE("unit: roughness is that of offsets over 20 m, of which there must be a hundred") {
  for (const std::size_t n : {179U, 180U, 3000U}) {
    auto z = track(n);
    if (n > 1000) z[1500] = lost;
    double sum = 0, offsets = 0;
    for (std::size_t i = 40; i + 40 < n; ++i) {
      const double offset = z[i] - 0.5 * (z[i - 40] + z[i + 40]);
      if (!std::isnan(offset)) sum += offset * offset, ++offsets;
    }
    INFO(n << " samples");
    const double found = hear(z).roughness;
    CHECK(found == Approx(offsets < 100 ? 0 : sum / offsets / (units::pi * units::pi * 10)));
  }
}

TEST_CASE("unit: heights rougher than 1e-4 m or smoother than 1e-10 m are doubted for their unit") {
  const auto z = track(3000);
  const double own = hear(z).roughness;
  for (const double limit : {1e-4, 1e-10})
    for (const double share : {0.98, 1.02}) {
      auto scaled = z;
      for (double& v : scaled) v *= std::sqrt(share * limit / own);
      const std::string text = hear(scaled).of("unit");
      INFO(share << " of " << limit);
      CHECK(text.empty() == (limit > 1e-5 ? share < 1 : share > 1));
      const double rms = std::sqrt(units::pi * units::pi * 10 * share * limit) / units::millimetre;
      char size[32];
      std::snprintf(size, sizeof size, "%.3g", rms);
      if (!text.empty()) CHECK_THAT(text, Contains("the chord of 20 m by " + std::string(size)));
    }
}

TEST_CASE("unit: each kind of fault is reported once, with all its samples and its worst place") {
  auto z = track(6000);
  const auto put = [&](std::size_t from, std::size_t count, double value) {
    std::fill_n(z.begin() + static_cast<std::ptrdiff_t>(from), count, value);
  };
  put(1000, 3, -9.999), put(3000, 7, -9.999), put(3400, 7, -9.999);  // of equal ones the first
  z[2000] += 0.5, z[4000] -= 0.9, z[4400] += 0.7;
  put(2500, 60, z[2500]), put(4500, 30, z[4500]);
  const Heard all = hear(z);
  CHECK(all.warnings.size() == 3);
  CHECK_THAT(all.of("codes"),
             Catch::StartsWith("17 samples far off with one value, such as -9.999 m at 750 m"));
  CHECK_THAT(all.of("outliers"),
             Catch::StartsWith("3 samples in 3 places far off, the largest by -0.89"));
  CHECK_THAT(all.of("outliers"), Contains(" m at 1000 m: a defect, or"));
  CHECK_THAT(
      all.of("stuck"),
      Catch::StartsWith("88 samples repeat the one before, 59 of them from 625.25 m to 639.75 m"));

  auto one = track(6000);
  one[2000] += 0.5;
  CHECK_THAT(hear(one).of("outliers"), Catch::StartsWith("1 sample in 1 place far off"));
  for (std::size_t i = 3000; i < 6000; ++i) one[i] += 0.3;
  CHECK_THAT(hear(one).of("steps"),
             Catch::StartsWith("the level steps at 1 place, the largest by 0."));
  CHECK_THAT(hear(one).of("steps"), Contains(" m at 750 m: "));
  for (std::size_t i = 5000; i < 6000; ++i) one[i] -= 0.6;
  CHECK_THAT(hear(one).of("steps"),
             Catch::StartsWith("the level steps at 2 places, the largest by -0."));
  CHECK_THAT(hear(one).of("steps"), Contains(" m at 1250 m: "));
}
