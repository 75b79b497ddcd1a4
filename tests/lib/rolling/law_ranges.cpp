#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/random_stream.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

RollingCase unit(double axis_ratio) {
  return {std::sqrt(axis_ratio), 1 / std::sqrt(axis_ratio), 1, 1, 0.27, 1, {}};
}

}  // namespace

TEST_CASE("property: no law's moment is more than friction can bear beside its force") {
  num::RandomStream draw(3);
  for (int k = 0; k < 2000; ++k) {
    const double ratio = draw.decades(0.1, 10);
    const auto creepage = [&] { return std::exp(draw(-8, 5)) * (draw(0, 1) < 0.5 ? -1 : 1); };
    const RollingCase c = with_reduced_creepage(unit(ratio), {creepage(), creepage(), creepage()});
    for (const Theory theory : {Theory::shen_hedrick_elkins, Theory::fastsim, Theory::polach,
                                Theory::vermeulen_johnson}) {
      if (theory == Theory::fastsim && k % 20) continue;
      const CreepForces f = creep_forces(theory, c);
      INFO(name(theory) << ", a/b " << ratio);
      CHECK(std::abs(f.mz) <= moment_bound(c, std::hypot(f.fx, f.fy)) * (1 + 1e-9) + 1e-9);
    }
  }
}

TEST_CASE(
    "property: a law says when it is outside of its range, and within it holds what it states") {
  for (const double ratio : {0.15, 0.4, 1.0, 2.5, 7.0}) {
    const EllipseRolling full(ratio, 0.27, {.along = 16, .rows = 8});
    const KalkerCoefficients k = kalker_table(ratio, 0.27);
    for (const double spin : {0.0, 0.06, 0.12, 0.2, 0.25, 0.6})
      for (const double x : {0.0, 0.3, 1.0})
        for (const double y : {-1.0, -0.3, 0.0, 0.3, 1.0}) {
          const RollingCase c = with_reduced_creepage(unit(ratio), {x, y, spin});
          const CreepForces truth = full.solve(c);
          const auto off = [&](const CreepForces& f) {
            return std::hypot(f.fx - truth.fx, f.fy - truth.fy);
          };
          INFO("a/b " << ratio << ", creepage " << x << ", " << y << ", spin " << spin);
          const CreepForces she = shen_hedrick_elkins(c, k), p = polach(c, k);
          CHECK(she.warning.empty() == (spin <= 0.2 && k.c23 * spin <= 0.6));
          CHECK(p.warning.empty() == (spin <= 0.2 && k.c23 * spin <= 0.4));
          CHECK(creep_forces(Theory::vermeulen_johnson, c).warning.empty() == (spin == 0));
          if (she.warning.empty()) CHECK(off(she) < 0.2);
          if (p.warning.empty()) CHECK(off(p) < 0.25);
          CHECK(off(fastsim(c, k)) < 0.2);
        }
  }
}

TEST_CASE("property: the linear theory warns where slip takes more than an eighth") {
  const KalkerCoefficients k = kalker_table(1.5, 0.27);
  for (double x = 0.01; x < 1; x *= 1.3) {
    const RollingCase c = with_reduced_creepage(unit(1.5), {x, 0, 0});
    const double lost = 1 - shen_hedrick_elkins(c, k).fx / linear_theory(c, k).fx;
    CHECK(linear_theory(c, k).warning.empty() == (k.c11 * x <= 1.0 / 3));
    if (linear_theory(c, k).warning.empty()) CHECK(lost < 0.125);
  }
  CHECK_FALSE(linear_theory(with_reduced_creepage(unit(1.5), {0, 0, 5}), k).warning.empty());
}
