#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>

#include "support/no_fp_fault.hpp"
#include "support/rig_case.hpp"

using namespace railbook;
using namespace railbook::rolling;

namespace {

constexpr const RollingCase& rig = rig_case;
constexpr Theory theories[] = {Theory::linear,  Theory::vermeulen_johnson,
                               Theory::fastsim, Theory::shen_hedrick_elkins,
                               Theory::fastrip, Theory::polach};

}  // namespace

TEST_CASE("extreme: creepage from 1e-300 to 1e10, friction down to 1e-300, nothing trapped") {
  const NoFpFault no_fault;
  for (const Theory theory : theories)
    for (const double friction : {0.3, 1e-6, 1e-100, 1e-300})
      for (double creep = 1e-300; creep < 1e11; creep *= 1e10) {
        auto c = rig;
        c.friction = friction;
        c.creepage = {creep, -creep, theory == Theory::fastrip ? 0 : creep / c.a};
        const auto f = creep_forces(theory, c);
        CHECK(std::isfinite(f.fx));
        CHECK(std::isfinite(f.fy));
        CHECK(std::isfinite(f.mz));
        if (theory != Theory::linear)
          CHECK(std::hypot(f.fx, f.fy) <= friction * c.load * (1 + 1e-12));
      }
}

TEST_CASE("extreme: no creepage and no friction have an answer") {
  const NoFpFault no_fault;
  for (const Theory theory : theories) {
    const auto rest = creep_forces(theory, rig);
    CHECK(rest.fx == 0);
    CHECK(rest.fy == 0);
    CHECK(rest.mz == 0);
    CHECK(rest.stick_share == Approx(1).epsilon(1e-12));
    auto slippery = rig;
    slippery.friction = 0;
    slippery.creepage.longitudinal = 1e-3;
    if (theory == Theory::linear) continue;
    const auto slip = creep_forces(theory, slippery);
    CHECK(slip.fx == 0);
    CHECK(slip.stick_share == Approx(0).margin(1e-12));
  }
}

TEST_CASE("extreme: a creepage of 1e-9 has all its digits") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  for (const Theory theory :
       {Theory::shen_hedrick_elkins, Theory::fastsim, Theory::fastrip, Theory::polach}) {
    auto c = rig;
    c.creepage.longitudinal = 1e-13;
    CHECK(creep_forces(theory, c, k).fx == Approx(linear_theory(c, k).fx).epsilon(1e-9));
  }
}

TEST_CASE("extreme: large spin grinds: no force, the moment of full spin") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  const auto f =
      fastsim_grid(with_reduced_creepage(rig, {0, 0, 1e6}), k, {.along = 200, .strips = 200});
  const double limit = rig.friction * rig.load;
  CHECK(std::abs(f.fx) < 1e-12 * limit);
  CHECK(std::abs(f.fy) < 1e-3 * limit);
  // The same moment from tractions across the radius, by the midpoint rule in polar coordinates.
  double moment = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double r = (i + 0.5) / n, t = 2 * 3.14159265358979 * (j + 0.5) / n;
      const double x = rig.a * r * std::cos(t), y = rig.b * r * std::sin(t);
      moment += 4.0 * limit / n / n * (1 - r * r) * r * std::hypot(x, y);
    }
  CHECK(f.mz == Approx(moment).epsilon(1e-3));
}

TEST_CASE("extreme: one cell is a coarse answer within the bound") {
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  for (const Creepage& reduced : {Creepage{0.2, 0, 0}, Creepage{0.1, 0.1, 0.4}}) {
    const auto f = fastsim_grid(with_reduced_creepage(rig, reduced), k, {.along = 1, .strips = 1});
    CHECK(std::hypot(f.fx, f.fy) <= rig.friction * rig.load * (1 + 1e-14));
    CHECK(f.fx > 0);
  }
}
