#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/strip_theory.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/rig_case.hpp"

using namespace railbook;
using namespace railbook::rolling;

TEST_CASE("unit: Kalker's table gives the printed digits at its rows") {
  const auto round = kalker_table(1, 0.25);
  CHECK(round.c11 == Approx(4.12).epsilon(1e-12));
  CHECK(round.c22 == Approx(3.67).epsilon(1e-12));
  CHECK(round.c23 == Approx(1.47).epsilon(1e-12));
  CHECK(round.c33 == Approx(1.19).epsilon(1e-12));
  CHECK(kalker_table(0.1, 0).c11 == Approx(2.51).epsilon(1e-12));
  CHECK(kalker_table(10, 0.5).c22 == Approx(16.0).epsilon(1e-12));
}

TEST_CASE("unit: Kalker's table between its rows, against the half-space program CONTACT") {
  // a/b = 1.568, computed with the public program CONTACT, 31 and 63 cells extrapolated.
  const auto quarter = kalker_table(1.568, 0.25), steel = kalker_table(1.568, 0.3);
  CHECK(quarter.c11 == Approx(4.690).epsilon(0.003));
  CHECK(quarter.c22 == Approx(4.396).epsilon(0.005));
  CHECK(quarter.c23 == Approx(2.115).epsilon(0.005));
  CHECK(steel.c11 == Approx(4.865).epsilon(0.003));
  CHECK(steel.c22 == Approx(4.491).epsilon(0.005));
  CHECK(steel.c23 == Approx(2.162).epsilon(0.005));
  CHECK(steel.c33 == Approx(0.904).epsilon(0.02));
}

TEST_CASE("unit: Kalker's table against the coefficients computed, also where it is misprinted") {
  for (const double ratio : {0.8, 1.25, 3.3}) {
    const auto table = kalker_table(ratio, 0.25);
    const auto computed = kalker_coefficients(ratio, 0.25);
    CHECK(table.c11 == Approx(computed.c11).epsilon(5e-3));
    CHECK(table.c22 == Approx(computed.c22).epsilon(5e-3));
    CHECK(table.c23 == Approx(computed.c23).epsilon(1e-2));  // 1.15 at 0.8 would be 8 % off
  }
}

namespace {

const std::vector<Theory> theories = {Theory::vermeulen_johnson, Theory::shen_hedrick_elkins,
                                      Theory::fastsim, Theory::fastrip, Theory::polach};

RollingCase elliptic_case(double a, double b) {
  return {.a = a,
          .b = b,
          .load = 80e3,
          .shear_modulus = 80e9,
          .poisson = 0.28,
          .friction = 0.35,
          .creepage = {}};
}

// Every theory, several ellipses, reduced creepages of all signs over eight decades.
void everywhere(const std::function<void(Theory, const RollingCase&)>& visit) {
  for (const double ratio : {0.12, 0.7, 1.0, 1.568, 9.0})
    for (const double size : {1e-6, 0.03, 0.2, 0.9, 40.0})
      for (const Creepage& way : {Creepage{1, 0, 0}, Creepage{-0.6, 0.8, 0}, Creepage{0, -1, 0},
                                  Creepage{0, 0, 1}, Creepage{0.5, -0.3, -0.7}})
        for (const Theory theory : theories) {
          if (theory == Theory::fastrip && way.spin != 0) continue;
          visit(theory, with_reduced_creepage(
                            elliptic_case(5e-3 * std::sqrt(ratio), 5e-3 / std::sqrt(ratio)),
                            {size * way.longitudinal, size * way.lateral, size * way.spin}));
        }
}

}  // namespace

TEST_CASE("property: forces turn with the creepages") {
  everywhere([](Theory theory, const RollingCase& c) {
    const auto f = creep_forces(theory, c);
    RollingCase braked = c, mirrored = c;
    braked.creepage.longitudinal *= -1;
    mirrored.creepage.lateral *= -1, mirrored.creepage.spin *= -1;
    const auto g = creep_forces(theory, braked), h = creep_forces(theory, mirrored);
    const double tiny = 1e-12 * c.friction * c.load;
    INFO(name(theory));
    CHECK(std::abs(g.fx + f.fx) <= tiny);
    CHECK(std::abs(g.fy - f.fy) <= tiny);
    CHECK(std::abs(g.mz - f.mz) <= tiny * c.a);
    CHECK(std::abs(h.fx - f.fx) <= tiny);
    CHECK(std::abs(h.fy + f.fy) <= tiny);
    CHECK(std::abs(h.mz + f.mz) <= tiny * c.a);
  });
}

TEST_CASE("property: without spin the force rises with the creepage") {
  for (const Theory theory : theories) {
    double last = 0;
    for (double x = 1e-3; x < 3; x *= 1.05) {
      const auto c = with_reduced_creepage(elliptic_case(6e-3, 4e-3), {0.6 * x, 0.8 * x, 0});
      const auto f = creep_forces(theory, c);
      const double size = std::hypot(f.fx, f.fy);
      INFO(name(theory) << " at X = " << x);
      CHECK(size >= last * (1 - 1e-14));
      last = size;
    }
    CHECK(last == Approx(0.35 * 80e3).epsilon(0.01));
  }
}

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
