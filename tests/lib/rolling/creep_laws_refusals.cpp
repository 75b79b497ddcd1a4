#include <catch2/catch.hpp>
#include <limits>

#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/units/input_error.hpp>

#include "support/rig_case.hpp"

using namespace railbook;
using namespace railbook::rolling;

namespace {

constexpr RollingCase rig = [] {
  RollingCase c = rig_case;
  c.creepage.longitudinal = 1e-3;
  return c;
}();

}  // namespace

TEST_CASE("input: the fast theories refuse arguments out of range") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Theory theory : {Theory::linear, Theory::vermeulen_johnson, Theory::fastsim,
                              Theory::shen_hedrick_elkins, Theory::fastrip, Theory::polach}) {
    auto c = rig;
    c.a = 0;
    CHECK_THROWS_AS(creep_forces(theory, c), InputError);
    c = rig, c.load = -1;
    CHECK_THROWS_AS(creep_forces(theory, c), InputError);
    c = rig, c.friction = nan;
    CHECK_THROWS_AS(creep_forces(theory, c), InputError);
    c = rig, c.poisson = 0.6;
    CHECK_THROWS_AS(creep_forces(theory, c), InputError);
    c = rig, c.creepage.longitudinal = nan;
    CHECK_THROWS_AS(creep_forces(theory, c), InputError);
  }
}

TEST_CASE("input: Kalker's table ends at axis ratios of 0.1 and 10") {
  CHECK_NOTHROW(kalker_table(0.1, 0));
  CHECK_NOTHROW(kalker_table(10, 0.5));
  CHECK_THROWS_AS(kalker_table(0.0999, 0.3), InputError);
  CHECK_THROWS_AS(kalker_table(10.01, 0.3), InputError);
  CHECK_THROWS_AS(kalker_table(1, -0.01), InputError);
  CHECK_THROWS_AS(kalker_table(1, 0.51), InputError);
}

TEST_CASE("input: spin where a theory has none, and grids without cells") {
  auto c = rig;
  c.creepage.spin = 0.1;
  const auto k = kalker_table(rig.a / rig.b, rig.poisson);
  CHECK_THROWS_AS(creep_forces(Theory::fastrip, c), InputError);
  CHECK_THROWS_AS(fastsim_without_spin(c, k), InputError);
  CHECK_THROWS_AS(fastsim_grid(c, k, {.along = 0}), InputError);
  CHECK_THROWS_AS(fastsim_grid(c, k, {.strips = 5000}), InputError);
}
