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

namespace {

// The fit by another method: orthogonal factors of the two columns 1 and size^-order.
struct Fit {
  double left = 0, order = 0;
  std::vector<double> limits;
};
Fit by_factors(const std::vector<Grid>& grids) {
  Fit best{INFINITY, 0, {}};
  const auto n = static_cast<Eigen::Index>(grids.size());
  const auto answers = static_cast<Eigen::Index>(grids[0].answers.size());
  for (int step = 0; step <= 30; ++step) {
    const double order = 1 + step / 20.;
    Eigen::MatrixXd a(n, 2), y(n, answers);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Grid& grid = grids[static_cast<std::size_t>(i)];
      a.row(i) << 1, std::pow(grid.size, -order);
      for (Eigen::Index k = 0; k < answers; ++k)
        y(i, k) = grid.answers[static_cast<std::size_t>(k)];
    }
    const Eigen::MatrixXd x = a.colPivHouseholderQr().solve(y);
    const double left = (a * x - y).squaredNorm();
    if (left >= best.left) continue;
    best = {left, order, {}};
    for (Eigen::Index k = 0; k < answers; ++k) best.limits.push_back(x(0, k));
  }
  return best;
}

}  // namespace

TEST_CASE("unit: a limit and its error are those of orthogonal factors, at any order") {
  for (const double order : {0.6, 1.3, 2.2, 3.1})
    for (const std::size_t count : {4U, 5U, 9U, 10U}) {
      RandomStream draw(7, count);
      std::vector<Grid> grids;
      for (std::size_t i = 0; i < count; ++i) {
        const double n = 16 + 4. * static_cast<double>(i);
        const double size = count == 5 ? 1e-12 : 1;  // of the answers
        grids.push_back({n,
                         {size * (1 + std::pow(n, -order) + 1e-5 * draw(-1, 1)),
                          size * (-3 + 2 * std::pow(n, -order) + 1e-5 * draw(-1, 1))}});
      }
      const Limit limit = limit_of(grids);
      const Fit fit = by_factors(grids);
      CAPTURE(order, count);
      CHECK(limit.order == Approx(fit.order).epsilon(1e-12));
      const std::size_t finer = count == 10 ? 5 : count == 9 ? 5 : 4;
      const Fit half = by_factors({grids.end() - static_cast<long>(finer), grids.end()});
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(limit.answers[k] == Approx(fit.limits[k]).epsilon(1e-9));
        double squares = std::pow(half.limits[k] - fit.limits[k], 2);
        std::vector<Grid> own;
        own.reserve(count);
        for (const Grid& g : grids) own.push_back({g.size, {g.answers[k]}});
        squares += std::pow(by_factors(own).limits[0] - fit.limits[k], 2);
        for (std::size_t i = 0; i < count; ++i) {
          std::vector<Grid> others = grids;
          others.erase(others.begin() + static_cast<long>(i));
          squares += (static_cast<double>(count) - 1) / static_cast<double>(count) *
                     std::pow(by_factors(others).limits[k] - fit.limits[k], 2);
        }
        CHECK(limit.uncertainty[k] == Approx(std::sqrt(squares)).epsilon(1e-6));
      }
    }
}

TEST_CASE("unit: a limit refuses too few grids") {
  CHECK_THROWS_AS(limit_of({{8, {1}}, {16, {1}}, {32, {1}}}), std::logic_error);
  CHECK_THROWS_AS(limit_of({{8, {1}}, {12, {1}}, {16, {1, 2}}, {32, {1}}}), std::logic_error);
}
