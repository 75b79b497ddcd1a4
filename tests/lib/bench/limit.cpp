#include <railbook/bench/limit.hpp>

#include <Eigen/QR>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/bench/evidence.hpp>

using namespace railbook::bench;

TEST_CASE("unit: the limit of a ladder of grids is found with its order") {
  std::vector<Grid> grids;
  for (const double n : {8., 12., 16., 24., 32.})
    grids.push_back({n, {1 + 3 * std::pow(n, -1.5), -2 - std::pow(n, -1.5)}});
  const Limit limit = limit_of(grids);
  CHECK(limit.order == Approx(1.5));
  CHECK(std::abs(limit.answers[0] - 1) < 1e-12);
  CHECK(std::abs(limit.answers[1] + 2) < 1e-12);
  CHECK(limit.uncertainty[0] < 1e-12);
}

TEST_CASE("unit: the uncertainty of a limit covers the truth of noisy ladders") {
  int covered = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    RandomStream draw(31, k);
    std::vector<Grid> grids;
    for (const double n : {16., 20., 24., 28., 32.})
      grids.push_back({n, {1 + std::pow(n, -2) + 1e-4 * draw(-1, 1)}});
    const Limit limit = limit_of(grids);
    covered += std::abs(limit.answers[0] - 1) <= 2 * limit.uncertainty[0];
  }
  CHECK(covered >= 180);
}

TEST_CASE("unit: where errors are no one power, leaving out half of the grids shows it") {
  // The jackknife alone is 5 to 8 times too small here.
  std::vector<Grid> bent, apart;
  for (const double n : {24., 28., 32., 36., 40., 44., 48., 56., 64.}) {
    bent.push_back({n, {std::pow(n, -1.5) - 3 * std::pow(n, -2), 0.5 * std::pow(n, -2)}});
    apart.push_back({n, {std::pow(n, -1.5), 5 * std::pow(n, -2)}});
  }
  for (const auto& grids : {bent, apart}) {
    const Limit limit = limit_of(grids);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(std::abs(limit.answers[k]) < 3 * limit.uncertainty[k]);
      CHECK(limit.uncertainty[k] < 1e-3);
    }
  }
}

TEST_CASE("unit: a limit refuses too few grids") {
  CHECK_THROWS_AS(limit_of({{8, {1}}, {16, {1}}, {32, {1}}}), std::logic_error);
  CHECK_THROWS_AS(limit_of({{8, {1}}, {12, {1}}, {16, {1, 2}}, {32, {1}}}), std::logic_error);
}
