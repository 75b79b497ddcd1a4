#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include <railbook/num/random_stream.hpp>
#include <railbook/rolling/contact.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

RollingCase unit(double axis_ratio, double poisson) {
  return {std::sqrt(axis_ratio), 1 / std::sqrt(axis_ratio), 1, 1, poisson, 1, {}};
}

struct Path {
  const EllipseRolling& contact;
  RollingCase c;
  Creepage from, to;  // reduced

  CreepForces at(double t) const {
    return contact.solve(with_reduced_creepage(
        c,
        {from.longitudinal + t * (to.longitudinal - from.longitudinal),
         from.lateral + t * (to.lateral - from.lateral), from.spin + t * (to.spin - from.spin)}));
  }
};

double distance(const CreepForces& f, const CreepForces& g) {
  return std::hypot(f.fx - g.fx, f.fy - g.fy, f.mz - g.mz);
}

// Walks the path; where a step differs most from the one before, halves towards the larger half
// until what is left is a jump or nothing.
void require_continuous(const Path& path) {
  constexpr std::size_t steps = 200;
  const auto place = [](std::size_t i) { return static_cast<double>(i) / steps; };
  std::vector<CreepForces> walk;
  for (std::size_t i = 0; i <= steps; ++i) walk.push_back(path.at(place(i)));
  std::vector<std::size_t> order(steps - 1);
  std::iota(order.begin(), order.end(), 1);
  const auto bend = [&](std::size_t i) {
    const CreepForces &f = walk[i - 1], &g = walk[i], &h = walk[i + 1];
    return std::hypot(f.fx - 2 * g.fx + h.fx, f.fy - 2 * g.fy + h.fy, f.mz - 2 * g.mz + h.mz);
  };
  std::ranges::sort(order, std::greater{}, bend);
  for (std::size_t k = 0; k < 5; ++k) {
    double low = place(order[k] - 1), high = place(order[k] + 1);
    CreepForces below = walk[order[k] - 1], above = walk[order[k] + 1];
    while (high - low > 1e-10) {
      const double middle = (low + high) / 2;
      const CreepForces f = path.at(middle);
      if (distance(f, below) > distance(f, above))
        high = middle, above = f;
      else
        low = middle, below = f;
    }
    INFO("at " << low << " of the path");
    REQUIRE(below.converged);
    REQUIRE(above.converged);
    CHECK(distance(below, above) <= below.error / 100 + 1e-9);
  }
}

}  // namespace

TEST_CASE("property: forces are continuous in the creepages", "[rolling]") {
  num::RandomStream draw(5);
  for (int k = 0; k < 3; ++k) {
    const double ratio = draw.decades(0.2, 5), poisson = draw(0, 0.5);
    const EllipseRolling contact(ratio, poisson, {.along = k % 2 ? 16 : 12, .rows = 8});
    const auto point = [&] { return Creepage{draw(-1, 1), draw(-1, 1), draw(-3, 3)}; };
    const Path path{contact, unit(ratio, poisson), point(), point()};
    INFO("a/b " << ratio << ", nu " << poisson);
    require_continuous(path);
  }
}

TEST_CASE("property: forces do not jump where a cell changes state, nor where spin begins",
          "[rolling]") {
  const EllipseRolling contact(1.5, 0.3, {.along = 12, .rows = 8});
  const RollingCase c = unit(1.5, 0.3);
  require_continuous({contact, c, {0.05, 0.1, 0}, {0.05, 0.1, 4}});
  const Path begins{contact, c, {0.05, 0.3, -1e-9}, {0.05, 0.3, 1e-9}};
  CHECK(distance(begins.at(0), begins.at(0.5)) < 1e-7);
  CHECK(distance(begins.at(0.5), begins.at(1)) < 1e-7);
}
