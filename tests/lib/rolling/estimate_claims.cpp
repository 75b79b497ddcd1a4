#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/contact.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::rolling;
using railbook::tests::Claim;

TEST_CASE("claim: the estimates are above the errors of 95 % of random cases", "[rolling]") {
  Claim beyond("rolling::EllipseRolling", 120);
  num::RandomStream draw(11);
  int force = 0, moment = 0, all = 0;
  double claimed = 0, made = 0;
  for (int k = 0; k < 12; ++k) {
    const double ratio = draw.decades(0.1, 10), poisson = draw(0, 0.5);
    const EllipseRolling best(ratio, poisson, {.along = 32, .rows = 16});
    const EllipseRolling coarse(ratio, poisson, {.along = 8, .rows = 4}),
        middle(ratio, poisson, {.along = 16, .rows = 8});
    RollingCase c{std::sqrt(ratio), 1 / std::sqrt(ratio), 1, 1, poisson, 1, {}};
    for (int j = 0; j < 5; ++j) {
      const double size = 4 * draw(0, 1) * draw(0, 1), angle = draw(0, 6.2832);
      c = with_reduced_creepage(c, {size * std::cos(angle), size * std::sin(angle),
                                    j < 2 ? 0 : 5 * draw(-1, 1) * draw(0, 1)});
      const CreepForces truth = best.solve(c);
      REQUIRE(truth.converged);
      for (const EllipseRolling* contact : {&coarse, &middle}) {
        const CreepForces f = contact->solve(c);
        REQUIRE(f.converged);
        ++all;
        force += std::hypot(f.fx - truth.fx, f.fy - truth.fy) <= f.error + 1e-9;
        moment += std::abs(f.mz - truth.mz) <= f.mz_error + 1e-9;
        claimed += f.error;
        made += std::hypot(f.fx - truth.fx, f.fy - truth.fy);
      }
    }
  }
  for (int k = 0; k < all; ++k) beyond.error(1 - static_cast<double>(force) / all);
  CHECK(moment >= 0.95 * all);
  CHECK(claimed < 4 * made);  // and they say something
}
