#include <railbook/rolling/force_table.hpp>

#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/rolling/creep_laws.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::rolling;

namespace {

ShareTheory theory(Theory which) {
  return [which](double ratio) {
    return shares_of([which](const RollingCase& c) { return creep_forces(which, c); }, ratio, 0.28);
  };
}

}  // namespace

TEST_CASE("property: a force table gives its nodes back, and mirrors them") {
  const auto polach = theory(Theory::polach);
  const ForceTable table({.ratios = 3, .longitudinal = 5, .lateral = 4, .spin = 7}, polach);
  const double ratio = table.ratios()[1], x = table.longitudinal()[2], y = table.lateral()[1],
               z = table.spin()[5];
  const auto exact = polach(ratio)({x, y, z}), braked = table.at(ratio, {-x, y, z}),
             mirrored = table.at(ratio, {x, -y, -z}), both = table.at(ratio, {-x, -y, -z});
  CHECK(table.at(ratio, {x, y, z}).fx == Approx(exact.fx).epsilon(1e-12));
  CHECK(braked.fx == Approx(-exact.fx).epsilon(1e-12));
  CHECK(braked.fy == Approx(exact.fy).epsilon(1e-12));
  CHECK(mirrored.fy == Approx(-exact.fy).epsilon(1e-12));
  CHECK(mirrored.mz == Approx(-exact.mz).margin(1e-15));
  CHECK(both.fx == Approx(-exact.fx).epsilon(1e-12));
}

TEST_CASE("property: the interpolation error falls about with the square of the spacing") {
  const auto she = theory(Theory::shen_hedrick_elkins);
  const auto run = [&](int n) {
    return ForceTable({.ratio_from = 1,
                       .ratio_to = 2,
                       .ratios = n,
                       .longitudinal = 2 * n,
                       .lateral = 2 * n,
                       .spin = 4 * n + 1},
                      she)
        .error(she, 500);
  };
  const auto coarse = run(4), fine = run(8);
  CHECK(fine.rms_force < 0.35 * coarse.rms_force);
  CHECK(fine.largest_force < 0.5 * coarse.largest_force);
  CHECK(coarse.points == 500);
}

TEST_CASE("property: beyond its axes a force table keeps its last value") {
  const auto she = theory(Theory::shen_hedrick_elkins);
  const ForceTable table({.ratios = 2, .longitudinal = 4, .lateral = 4, .spin = 5}, she);
  CHECK(table.at(1, {1e9, 0, 0}).fx == table.at(1, {5, 0, 0}).fx);
  CHECK(table.at(100, {1, 0, 0}).fx == table.at(2, {1, 0, 0}).fx);
  CHECK(table.at(1, {0, 0, -1e9}).fy == table.at(1, {0, 0, -5}).fy);
}

TEST_CASE("property: a force table refuses axes it cannot have") {
  const auto she = theory(Theory::shen_hedrick_elkins);
  CHECK_THROWS_AS(ForceTable({.ratio_from = 0}, she), InputError);
  CHECK_THROWS_AS(ForceTable({.ratio_from = 2, .ratio_to = 1}, she), InputError);
  CHECK_THROWS_AS(ForceTable({.spin = 4}, she), InputError);
  CHECK_THROWS_AS(ForceTable({.longitudinal = 1}, she), InputError);
  CHECK_THROWS_AS(ForceTable({.longitudinal = 1000, .lateral = 1000}, she), InputError);
}

TEST_CASE("property: the interpolation error is a distance, whichever side the table is on") {
  const auto constant = [](double moment) {
    return ShareTheory{[moment](double) {
      return ShareFunction{[moment](const Creepage&) { return ForceShares{0.3, -0.4, moment}; }};
    }};
  };
  const ForceTable nothing({.ratios = 2, .longitudinal = 3, .lateral = 3, .spin = 3},
                           [](double) { return [](const Creepage&) { return ForceShares{}; }; });
  for (const double moment : {0.2, -0.2}) {
    const InterpolationError e = nothing.error(constant(moment), 100);
    CHECK(e.largest_force == Approx(0.5).epsilon(1e-14));
    CHECK(e.rms_force == Approx(0.5).epsilon(1e-14));
    CHECK(e.largest_moment == Approx(0.2).epsilon(1e-14));
    CHECK(e.rms_moment == Approx(0.2).epsilon(1e-14));
  }
}

TEST_CASE("property: the bound of a force table holds where its error is measured") {
  for (const Theory which :
       {Theory::polach, Theory::shen_hedrick_elkins, Theory::vermeulen_johnson, Theory::linear}) {
    const ForceTable table({.ratios = 3}, theory(which));
    CHECK(table.error(theory(which), 2000).within_bound == 2000);
  }
  // A parabola along one axis is off its chords by half of what is stated.
  const ShareTheory parabola = [](double) {
    return [](const Creepage& c) {
      const double u = std::asinh(c.longitudinal / 0.5);
      return ForceShares{u * u, 0, 0};
    };
  };
  const ForceTable table({.ratio_from = 1, .ratio_to = 1, .ratios = 1}, parabola);
  const InterpolationError error = table.error(parabola, 1000);
  const InterpolationBound stated = table.bound(1, {1, 0, 0});
  CHECK(stated.force == Approx(2 * error.largest_force).epsilon(0.01));
  CHECK(stated.moment == 0);
  CHECK(table.node_bound(0, 3, 2, 1).force == Approx(stated.force));
  CHECK(std::isinf(table.bound(1, {5.1, 0, 0}).force));
  CHECK(std::isinf(table.bound(1.1, {1, 0, 0}).force));
  const ForceTable coarse({.ratio_from = 1, .ratio_to = 1, .ratios = 1, .lateral = 2}, parabola);
  CHECK(std::isinf(coarse.bound(1, {1, 0, 0}).moment));
  CHECK(coarse.error(parabola, 100).within_bound == 0);  // an infinite bound says nothing
}
