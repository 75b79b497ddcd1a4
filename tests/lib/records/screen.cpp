#include <railbook/records/screen.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/warning.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
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

// Steps of 1 mm, up and down.
std::vector<double> saw(std::size_t samples) {
  std::vector<double> z(samples);
  for (std::size_t i = 0; i < samples; ++i) z[i] = i % 2 == 0 ? 0 : 1e-3;
  return z;
}
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

TEST_CASE("unit: the doubt about steps names the largest of them, whatever its sign") {
  for (const double first : {-0.5, 0.5, -0.03, 0.03})
    for (const double second : {-0.1, 0.1}) {
      auto z = track();
      for (std::size_t i = 0; i < z.size(); ++i)
        z[i] += (i >= 8192 ? first : 0) + (i >= 20000 ? second : 0);
      CAPTURE(first, second);
      const auto s = screen(z);
      REQUIRE(s.warnings.size() == 1);
      CHECK(s.warnings[0].key == "steps");
      const bool is_first = std::abs(first) > std::abs(second);
      CHECK_THAT(s.warnings[0].text, Catch::Contains(is_first ? "m at 2048 m" : "m at 5000 m"));
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

TEST_CASE("unit: a record of fewer than fifty steps is not judged, one of more is") {
  for (const std::size_t samples : {45U, 60U})
    for (const std::size_t at : {0U, 20U}) {
      std::vector<double> z(track().begin() + 100,
                            track().begin() + 100 + static_cast<long>(samples));
      z[at] = -9.999;
      CAPTURE(samples, at);
      CHECK(screen(z).faults.size() == (samples > 50 ? 1 : 0));
    }
}

TEST_CASE("unit: a Screen hands on every sample once, whatever the pieces it is given") {
  for (const std::size_t piece : {1UL, 777UL, 40000UL})
    CHECK(Direct(track(), piece).out == track());
  CHECK(Direct({}).out.empty());
  CHECK_FALSE(Direct({}).screen.still());
  CHECK(Direct({0.5}).out == std::vector{0.5});
}

TEST_CASE("unit: far off is twelve median steps, and three more for each sample missing") {
  for (const std::size_t missing :
       {1UL, 3UL, 7UL})  // odd: the samples beside them are of one height
    for (const double sign : {1.0, -1.0}) {
      auto z = saw(3000);
      const std::size_t at = 1000;
      const double limit = 1e-3 * (12 + 3 * static_cast<double>(missing));
      std::fill_n(z.begin() + static_cast<std::ptrdiff_t>(at - missing), missing, lost);
      auto near = z, far = z;
      shift(near, at, z.size(), sign * (limit - 1e-5));
      shift(far, at, z.size(), sign * (limit + 1e-5));
      CAPTURE(missing, sign);
      CHECK(Direct(near).screen.faults().empty());
      const auto found = Direct(far).screen.faults();
      REQUIRE(found.size() == 1);
      CHECK(found[0].fault == Fault::outlier);  // the next one may be 3 mm farther, and is near
      CHECK(found[0].first == at);
      CHECK(found[0].count == 1);
      CHECK(found[0].value == Approx(sign * (limit + 1e-5)));
    }
}

TEST_CASE("unit: no farther than four times the largest of the three steps before is not far off") {
  for (const std::size_t since : {0UL, 1UL, 2UL, 3UL})  // usual steps after one of 5 mm
    for (const double jump : {19.9e-3, 20.1e-3}) {
      auto z = saw(3000);
      shift(z, 1001, z.size(), 4e-3);  // 5 mm up
      shift(z, 1002 + since, z.size(), (1002 + since) % 2 == 0 ? jump + 1e-3 : jump - 1e-3);
      CAPTURE(since, jump);
      CHECK(Direct(z).screen.faults().empty() == (since < 3 && jump < 20e-3));
    }
}

TEST_CASE("unit: what leaves at once and is back at once is outliers, however high or long") {
  for (const double height : {0.05, 1.0, -2.0, 50.0})
    for (const std::size_t length : {1UL, 2UL, 8UL, 100UL, 250UL}) {
      if (std::abs(height) < 1 && length > 8) continue;  // 3 mm more may be off each sample on
      auto z = saw(3000);
      shift(z, 1000, 1000 + length, height);
      CAPTURE(height, length);
      const Direct d(z);
      REQUIRE(d.screen.faults().size() == 1);
      CHECK(d.screen.faults()[0].fault == Fault::outlier);
      CHECK(d.screen.faults()[0].first == 1000);
      CHECK(d.screen.faults()[0].count == length);
      CHECK(d.screen.faults()[0].value == Approx(height));
      CHECK(static_cast<std::size_t>(std::count_if(
                d.out.begin(), d.out.end(), [](double v) { return std::isnan(v); })) == length);
    }
  // For longer it is another level, and back.
  auto z = saw(3000);
  shift(z, 1000, 1300, 2);
  const auto found = Direct(z).screen.faults();
  REQUIRE(found.size() == 2);
  CHECK(found[0].fault == Fault::step);
  CHECK(found[1].fault == Fault::step);
  CHECK(found[1].first == 1300);
}

TEST_CASE("unit: the longest stuck stretch is reported with its place") {
  std::vector<double> z = track();
  for (double& value : z) value = 1e-4 * std::round(1e4 * value);
  CHECK_FALSE(Direct(z).screen.still());
  z.insert(z.begin(), 16000, z.front());
  std::size_t equal = 16000;
  while (z[equal] == z.front()) ++equal;
  const auto still = Direct(z).screen.still();
  REQUIRE(still);
  CHECK(still->fault == Fault::stuck);
  CHECK(still->first == 0);
  CHECK(still->count == equal);
  CHECK(still->value == z.front());
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
