#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/contact/geometry.hpp>

#include "method/countact.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

constexpr double modulus = 1.5e7 / 0.91;
const Gap example_1 = rail_wheel_gap({18, 12.34, 10, 10});

}  // namespace

TEST_CASE("property: COUNTACT-1 and COUNTACT-2 agree on two axes of symmetry") {
  for (int n : {7, 8, 9}) {
    CountactOptions options;
    options.columns = uniform_columns(n);
    options.rows = n;
    const NormalContact one = countact_1(example_1, 4e-4, modulus, options).contact;
    const NormalContact two = countact_2(example_1, 4e-4, modulus, options).contact;
    CHECK(one.force == Approx(two.force).epsilon(1e-9));
    CHECK(one.p_max == Approx(two.p_max).epsilon(1e-9));
    CHECK(one.x_min == Approx(-two.x_max).epsilon(1e-9));
    CHECK(std::abs(one.moment_y) < 1e-8 * one.force * one.x_max);
    CHECK(one.iterations == two.iterations);
  }
}

TEST_CASE("property: exchanging the axes of the bodies exchanges the axes of the contact") {
  const Gap turned = [](double x, double y) { return example_1(y, x); };
  CountactOptions options;
  options.columns = uniform_columns(15);
  options.rows = 15;
  const NormalContact a = countact_2(example_1, 4e-4, modulus, options).contact;
  const NormalContact b = countact_2(turned, 4e-4, modulus, options).contact;
  // Columns and rows do not play the same part, so only to the order of the mesh error.
  CHECK(a.force == Approx(b.force).epsilon(2e-3));
  CHECK(a.p_max == Approx(b.p_max).epsilon(2e-3));
  CHECK(a.x_max == Approx(b.y_max).epsilon(1e-2));
  CHECK(a.y_max == Approx(b.x_max).epsilon(1e-2));
}

TEST_CASE("property: a mirrored gap gives the mirrored contact") {
  const Gap gap = rail_wheel_gap({18, 12.34, 10, 1.25});
  const Gap mirrored = [&](double x, double y) { return gap(-x, y); };
  CountactOptions options;
  options.columns = split_columns({5, 2, 0.2}, {3, 1, 0.25});
  const NormalContact a = countact_1(gap, 5e-3, modulus, options).contact;
  std::swap(options.columns.left, options.columns.right);
  const NormalContact b = countact_1(mirrored, 5e-3, modulus, options).contact;
  REQUIRE(a.converged);
  CHECK(a.force == Approx(b.force).epsilon(1e-10));
  CHECK(a.moment_y == Approx(-b.moment_y).epsilon(1e-10));
  CHECK(a.x_max == Approx(-b.x_min).epsilon(1e-10));
  CHECK(a.iterations == b.iterations);
}

TEST_CASE("property: load and pressure scale with the modulus, lengths do not") {
  const NormalContact soft = countact_2(example_1, 4e-4, 1, {}).contact;
  const NormalContact hard = countact_2(example_1, 4e-4, 1e11, {}).contact;
  CHECK(hard.force / soft.force == Approx(1e11).epsilon(1e-12));
  CHECK(hard.p_max / soft.p_max == Approx(1e11).epsilon(1e-12));
  CHECK(hard.x_max == Approx(soft.x_max).epsilon(1e-12));
}
