#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <vector>

#include <railbook/spectra/welch.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;

namespace {

std::vector<double> noise(std::size_t n) {
  std::mt19937_64 generator{42};
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  for (double& value : x) value = normal(generator);
  return x;
}

// Pages of this process in memory, now, in bytes.
double resident() {
  std::ifstream statm{"/proc/self/statm"};
  double total = 0, pages = 0;
  statm >> total >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

TEST_CASE("extreme: segments begin anew after a gap") {
  const NoFpFault no_fault;
  auto x = noise(20 * 64);
  const auto whole = spectra::welch(x, 1.0, {.segment = 128});
  CHECK(whole.segments == 19);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto broken = x;
    broken[5 * 64 + 3] = bad;    // four segments before it
    broken[5 * 64 + 4] = -bad;   // infinity - infinity must not be formed
    broken[19 * 64 + 63] = bad;  // thirteen between them
    spectra::Welch stream{1.0, {.segment = 128}};
    stream.push(broken);
    const auto spectrum = stream.spectrum();
    CHECK(spectrum.segments == 19);
    CHECK(spectrum.unused == 0);
    CHECK(stream.gap_samples() == 3);
    CHECK(spectrum.averages < 17 + 61.0 / 64);
    CHECK(spectrum.density.allFinite());
    // The same segments averaged by hand: segments begin anew after a gap, and the last one before it ends there.
    const auto density = [&](std::size_t from, std::size_t count) {
      return spectra::welch(std::span{x}.subspan(from, count), 1.0, {.segment = 128}).density;
    };
    const double first = 3.0 / 64, second = 58.0 / 64;
    const Eigen::VectorXd mean =
        (density(0, 5 * 64) * 4 + density(5 * 64 + 3 - 128, 128) * first +
         density(5 * 64 + 5, 14 * 64) * 13 + density(19 * 64 + 63 - 128, 128) * second) /
        (17 + first + second);
    CHECK((spectrum.density - mean).norm() < 1e-12 * mean.norm());
  }
}

TEST_CASE(
    "extreme: nothing but gaps, or a record shorter than a segment, is an error that says so") {
  spectra::Welch stream{1.0, {.segment = 128}};
  stream.push(std::vector<double>(127, 1.0));
  CHECK_THROWS_AS(stream.spectrum(), InputError);
  stream.push(std::vector<double>(1000, std::nan("")));
  CHECK_THROWS_AS(stream.spectrum(), InputError);
  CHECK_THROWS_WITH(stream.spectrum(), Catch::Contains("1000 of them missing"));
}

TEST_CASE("extreme: a large offset and a steep line cost no more than their rounding") {
  const auto x = noise(4096 * 4);
  auto high = x;
  for (std::size_t i = 0; i < x.size(); ++i) high[i] += 1e7 + 3.0 * static_cast<double>(i);
  const auto a = spectra::welch(x, 0.3), b = spectra::welch(high, 0.3);
  CHECK(((a.density - b.density).array() / a.density.array()).abs().segment(2, 2000).maxCoeff() <
        1e-5);
  const auto flat = spectra::welch(std::vector<double>(10000, 1e3), 0.3);
  CHECK(flat.density.maxCoeff() < 1e-20);
}

TEST_CASE("extreme: ten million samples stream through a fixed small memory") {
  const auto chunk = noise(100000);
  spectra::Welch stream{0.3};
  stream.push(chunk);
  const double before = resident();
  for (int i = 1; i < 100; ++i) stream.push(chunk);
  CHECK(resident() - before < 1 << 20);
  const auto spectrum = stream.spectrum();
  CHECK(spectrum.segments == (10000000 - 4096) / 2048 + 1);
  CHECK(spectrum.density.segment(2, 2000).mean() == Approx(2 * 0.3).epsilon(0.02));
}
