#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/strip_theory.hpp>

using namespace railbook;
using namespace railbook::rolling;

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

TEST_CASE("property: no theory passes the friction bound, and stick shares lie in [0, 1]") {
  everywhere([](Theory theory, const RollingCase& c) {
    const auto f = creep_forces(theory, c);
    INFO(name(theory));
    CHECK(std::hypot(f.fx, f.fy) <= c.friction * c.load * (1 + 1e-12));
    CHECK(f.stick_share >= -1e-12);
    CHECK(f.stick_share <= 1 + 1e-12);
    CHECK(f.converged);
  });
}

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

TEST_CASE(
    "property: for small creepage every theory with Kalker's coefficients is the linear one") {
  for (const double ratio : {0.12, 0.7, 1.0, 1.568, 9.0})
    for (const Theory theory : theories) {
      if (theory == Theory::vermeulen_johnson) continue;
      const bool spins = theory != Theory::fastrip;
      const auto c =
          with_reduced_creepage(elliptic_case(5e-3 * std::sqrt(ratio), 5e-3 / std::sqrt(ratio)),
                                {3e-8, 0, spins ? 2e-8 : 0});
      const auto f = creep_forces(theory, c);
      const auto l = linear_theory(c, kalker_table(ratio, c.poisson));
      INFO(name(theory) << " at a/b = " << ratio);
      CHECK(f.fx == Approx(l.fx).epsilon(theory == Theory::polach && spins ? 0.5 : 3e-3));
      if (spins && theory != Theory::polach) CHECK(f.fy == Approx(l.fy).epsilon(3e-3));
      auto pure = c;
      pure.creepage = {c.creepage.longitudinal, 0, 0};
      CHECK(creep_forces(theory, pure).fx == Approx(l.fx).epsilon(1e-6));
      if (!spins) continue;
      pure.creepage = {0, 0, c.creepage.spin};
      CHECK(creep_forces(theory, pure).fy == Approx(l.fy).epsilon(3e-3));
    }
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

TEST_CASE("property: shares of mu N depend on the reduced creepage alone") {
  const Creepage reduced{0.12, -0.05, 0.2};
  const auto small = with_reduced_creepage(elliptic_case(1.2e-3, 0.8e-3), reduced);
  auto large = elliptic_case(12e-3, 8e-3);
  large.load = 7, large.friction = 0.02, large.shear_modulus = 3e9;
  large = with_reduced_creepage(large, reduced);
  for (const Theory theory : {Theory::shen_hedrick_elkins, Theory::fastsim, Theory::polach}) {
    const auto f = creep_forces(theory, small), g = creep_forces(theory, large);
    CHECK(f.fx / (0.35 * 80e3) == Approx(g.fx / (0.02 * 7)).epsilon(1e-12));
    CHECK(f.fy / (0.35 * 80e3) == Approx(g.fy / (0.02 * 7)).epsilon(1e-12));
    CHECK(f.mz / (0.35 * 80e3 * 1.2e-3) == Approx(g.mz / (0.02 * 7 * 12e-3)).epsilon(1e-12));
  }
}

TEST_CASE("property: no cell's traction passes its bound, and the cells make the forces") {
  const auto k = kalker_table(1.5, 0.28);
  for (const Creepage& reduced :
       {Creepage{0.2, 0, 0}, Creepage{0.1, 0.2, 0}, Creepage{0.1, -0.1, 0.6}}) {
    const auto c = with_reduced_creepage(elliptic_case(6e-3, 4e-3), reduced);
    std::vector<CreepForces> all = {
        fastsim(c, k, {.keep_tractions = true}),
        fastsim(c, k, {.bound = Bound::elliptic, .keep_tractions = true})};
    if (reduced.spin == 0) all.push_back(strip_theory(c, k, {.keep_tractions = true}));
    for (const auto& f : all) {
      const auto& t = f.tractions;
      const Eigen::ArrayXd size = (t.px.array().square() + t.py.array().square()).sqrt();
      CHECK((size <= t.bound.array() * (1 + 1e-9) + 1e-6).all());
      const Eigen::ArrayXd area = t.dx.array() * t.dy.array();
      CHECK((area * t.bound.array()).sum() == Approx(c.friction * c.load).epsilon(1e-12));
      CHECK((area * t.px.array()).sum() == Approx(f.fx).epsilon(5e-3));
    }
  }
}
