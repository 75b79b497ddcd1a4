#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/records/screen.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/warning.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
using records::Fault;

namespace {

const double lost = std::numeric_limits<double>::quiet_NaN();

struct Screened {
  std::vector<double> out;
  std::vector<records::FaultyStretch> faults;
  std::vector<units::Warning> warnings;
};

Screened screen(const std::vector<double>& in, double spacing = 0.25) {
  const NoFpFault no_fault;
  Screened s;
  records::RecordStream stream{{.spacing = spacing}, [&](std::span<const double> piece) {
                                 s.out.insert(s.out.end(), piece.begin(), piece.end());
                               }};
  for (const double z : in) stream.add(z);
  stream.finish();
  s.faults = stream.faults();
  s.warnings = stream.warnings();
  return s;
}

// A Screen by itself, fed in pieces of that many samples.
struct Direct {
  std::vector<double> out;
  records::Screen screen{
      [this](std::span<const double> piece) { out.insert(out.end(), piece.begin(), piece.end()); }};
  explicit Direct(const std::vector<double>& in, std::size_t piece = 1000) {
    const NoFpFault no_fault;
    for (std::size_t i = 0; i < in.size(); i += piece)
      screen.push(std::span{in}.subspan(i, std::min(piece, in.size() - i)));
    screen.finish();
  }
};

void shift(std::vector<double>& z, std::size_t from, std::size_t to, double by) {
  for (std::size_t i = from; i < std::min(to, z.size()); ++i) z[i] += by;
}

// A track of class 5 with joints and some noise, in metres.
const std::vector<double>& track() {
  static const std::vector<double> z = spectra::synthesize(
      {.spacing = 0.25, .A = 5e-7, .phi_c = 0.13, .dip = 0.0055, .sensor_noise = 2e-5}, 40000);
  return z;
}

const std::vector<std::size_t> places{0, 1, 77, 8191, 8192, 16383, 20000, 39998, 39999};

}  // namespace

TEST_CASE("unit: a gauge that moves by single quanta is not reported as stuck") {
  for (const std::size_t at : {5000U, 8191U, 8192U, 8193U, 16384U}) {
    std::vector<double> z(80000, 0.0);  // longer than all it looks at at once
    z[1] = 1e-3;
    shift(z, at, z.size(), 1e-3);
    CHECK(Direct(z).out == z);
  }
}

TEST_CASE("unit: a clean track passes the screen unchanged") {
  const auto s = screen(track());
  CHECK(s.faults.empty());
  CHECK(s.warnings.empty());
  CHECK(s.out == track());
}

TEST_CASE("unit: a value far off is taken out, wherever it stands and whatever its size") {
  for (const std::size_t at : places)
    for (const double value : {-9999.0, -9.999, 999.0, 0.999, 32.767, 0.05, -0.1, -9999 * 0.0254}) {
      auto z = track();
      z[at] += value;
      CAPTURE(at, value);
      const auto s = screen(z);
      REQUIRE(s.faults.size() == 1);
      CHECK(s.faults[0].first == at);
      CHECK(s.faults[0].count == 1);
      CHECK(std::isnan(s.out[at]));
      CHECK(s.warnings.size() == 1);
    }
}

TEST_CASE("unit: a code is taken out in runs of any length, others are left alone") {
  for (const std::size_t at : places)
    for (const std::size_t length : {2U, 20U, 300U, 9000U, 20000U})
      for (const double code : {-9.999, 999.0}) {
        auto z = track();
        const std::size_t end = std::min(at + length, z.size());
        if (end - at < 2 || at == 1) continue;  // one good sample before a code: which is which?
        std::fill(z.begin() + static_cast<std::ptrdiff_t>(at),
                  z.begin() + static_cast<std::ptrdiff_t>(end), code);
        CAPTURE(at, length, code);
        const auto s = screen(z);
        REQUIRE(!s.warnings.empty());
        if (at < 8192 && length == 20000) continue;  // it fills all that is looked at
        REQUIRE(s.faults.size() == 1);
        CHECK(s.faults[0].fault == Fault::code);
        CHECK(s.faults[0].first == at);
        CHECK(s.faults[0].count == end - at);
      }
}

TEST_CASE("unit: one sample in eight coded, and a burst of garbage, are taken out") {
  auto z = track();
  for (std::size_t i = 3; i < z.size(); i += 8) z[i] = -9.999;
  auto s = screen(z);
  CHECK(s.faults.size() == z.size() / 8);
  z = track();
  for (std::size_t i = 0; i < 30; ++i)
    z[9000 + i] += 2 * std::sin(static_cast<double>(i * i)) + 0.05;
  s = screen(z);
  std::size_t out = 0;
  for (const auto& f : s.faults) out += f.count;
  CHECK(out >= 27);
  CHECK(out <= 30);
}

TEST_CASE("unit: a sensor that stuck is taken out but for its first sample") {
  for (const std::size_t at : places)
    for (const std::size_t length : {25U, 400U, 7000U, 20000U}) {
      auto z = track();
      const std::size_t end = std::min(at + length, z.size());
      if (end - at < 21) continue;
      std::fill(z.begin() + static_cast<std::ptrdiff_t>(at),
                z.begin() + static_cast<std::ptrdiff_t>(end), z[at]);
      CAPTURE(at, length);
      const auto s = screen(z);
      REQUIRE(!s.warnings.empty());
      std::size_t stuck = 0;
      for (const auto& f : s.faults)
        stuck += f.fault == Fault::stuck || f.fault == Fault::code ? f.count : 0;
      if (at < 8192 && length == 20000) continue;  // it fills all that is looked at
      CHECK(stuck + 1 >= end - at);
      CHECK(stuck <= end - at);
    }
}

TEST_CASE("unit: a step of the datum is found to the sample, and the record cut there") {
  for (const std::size_t at : {300U, 8192U, 20000U, 39700U})
    for (const double step : {0.03, -0.1, 0.5, 20.0}) {
      auto z = track();
      for (std::size_t i = at; i < z.size(); ++i) z[i] += step;
      CAPTURE(at, step);
      const auto s = screen(z);
      REQUIRE(s.faults.size() == 1);
      CHECK(s.faults[0].fault == Fault::step);
      CHECK(s.faults[0].first == at);
      CHECK(s.faults[0].value == Approx(step).margin(0.003));
    }
}

TEST_CASE("unit: metres for millimetres, and the other way round, are doubted") {
  for (const double unit : {1e-3, 1e3}) {
    auto z = track();
    for (double& h : z) h *= unit;
    const auto s = screen(z);
    REQUIRE(s.warnings.size() == 1);
    CHECK(s.warnings[0].key == "unit");
  }
}

TEST_CASE("unit: waves are no faults, however high, nor is a silent record between them") {
  std::vector<double> z(20000, 0.0);
  for (std::size_t i = 4000; i < 4400; ++i)
    z[i] = 0.05 * std::sin(0.015 * units::pi * static_cast<double>(i - 4000));  // 33 m, abruptly
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] += 1e-5 * std::sin(static_cast<double>(i * i % 1000));
  CHECK(screen(z).faults.empty());
}

TEST_CASE("unit: a sensor stuck from the beginning is reported and not taken out") {
  std::vector<double> z = track();
  for (double& value : z) value = 1e-4 * std::round(1e4 * value);
  const auto told = [](const Screened& s) {
    return std::any_of(s.warnings.begin(), s.warnings.end(),
                       [](const units::Warning& d) { return d.key == "still"; });
  };
  CHECK_FALSE(told(screen(z)));
  z.insert(z.begin(), 16000, z.front());
  const Screened s = screen(z);
  CHECK(told(s));
  CHECK(s.out.front() == z.front());
}

TEST_CASE("unit: a first sample is judged by most of the nine that follow it") {
  // Steps of about 1 mm; the nine lie 0.2 m off or where the first one is, after a pattern.
  const auto first_is_out = [](const std::string& pattern) {
    std::vector<double> z;
    for (std::size_t i = 0; i < 400; ++i)
      z.push_back((i % 2 == 0 ? 0.5e-3 : -0.5e-3) + 1e-6 * std::sin(double(i)));
    z[0] += 0.2;
    for (std::size_t i = 0; i < pattern.size(); ++i)
      if (pattern[i] == 'n')
        z[i + 1] += 0.2;
      else if (pattern[i] == '-')
        z[i + 1] = lost;
    const auto faults = screen(z).faults;
    return !faults.empty() && faults[0].first == 0;
  };
  CHECK(first_is_out("fffffffff"));
  CHECK(first_is_out("fnfnfnfnfn"));        // five of nine are far
  CHECK_FALSE(first_is_out("fnfnfnfnnf"));  // four of nine
  CHECK(first_is_out("fn-f-nfnfn-fn"));     // lost ones do not count
  CHECK_FALSE(first_is_out("fn-f-nfnfn-nf"));
  CHECK_FALSE(first_is_out("nffffffff"));  // the next one is near
}

TEST_CASE("unit: what leaves and comes back little by little is outliers where it is rough") {
  const auto taken_out = [](const std::vector<double>& excursion) {
    std::vector<double> z;
    for (std::size_t i = 0; i < 400; ++i)
      z.push_back((i % 2 == 0 ? 0.5e-3 : -0.5e-3) + 1e-6 * std::sin(double(i)));
    for (std::size_t i = 0; i < excursion.size(); ++i) z[200 + i] += excursion[i];
    std::size_t count = 0;
    for (const auto& f : screen(z).faults) count += f.count;
    return count;
  };
  // The way there and back is more than 0.3 of the farthest for each step.
  for (const double far : {0.2, -0.2}) {
    const double a = 0.2 * far;
    CHECK(taken_out({a, far, a, far, a, far, a, far, a}) == 9);
    CHECK(taken_out({a, far, -far, far, -far, far, -far, far, a}) == 9);
  }
}

TEST_CASE("unit: a coarse record stands still longer before it is stuck") {
  // Half a step a sample: five steps take between 8 and 16 samples, and 8 times 16 equal ones are a
  // sensor that stuck.
  for (const std::size_t run : {60U, 120U, 127U, 128U, 140U}) {
    std::vector<double> z;
    for (std::size_t k = 0; z.size() < 8000; ++k) {
      const double place = std::abs(static_cast<double>(k % 1600) - 800);
      z.push_back(1e-3 * std::floor(place / 2));
      if (k == 3000) z.resize(z.size() + run - 2, z.back());  // which stands twice as it is
    }
    const auto faults = screen(z).faults;
    INFO(run << " equal samples");
    REQUIRE(faults.size() == (run >= 128 ? 1 : 0));
    if (run < 128) continue;
    CHECK(faults[0].fault == Fault::stuck);
    CHECK(faults[0].count == run - 1);
  }
}

TEST_CASE("unit: no uneven spacing is reported for an even record") {
  for (const std::size_t samples : {0U, 1U}) {
    records::PlaceMap map{0.5, 7};
    if (samples > 0) map.add(0, 7.0);
    const auto u = map.unevenness();
    CHECK(u.share == 0);
    CHECK(u.from == 0);
    CHECK(u.to == 0);
    CHECK(u.spacing == 0);
    CHECK(u.overall == 0);
  }
}

namespace {

constexpr double spacing = 0.25;

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
