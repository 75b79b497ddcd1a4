#include <catch2/catch.hpp>
#include <limits>
#include <utility>
#include <vector>

#include <railbook/contact/geometry.hpp>
#include <railbook/units/input_error.hpp>

#include "method/countact.hpp"
#include "method/countaxi.hpp"
#include "method/punch.hpp"

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

const Gap gap = rail_wheel_gap({18, 12.34, 10, 10});

template <class Change>
void refused(Change change) {
  CountactOptions options;
  change(options);
  CHECK_THROWS_AS((void)countact_2(gap, 4e-4, 1e7, options), InputError);
}

}  // namespace

TEST_CASE("input: an approach or a modulus that is no number is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)countact_1(gap, nan, 1e7), InputError);
  CHECK_THROWS_AS((void)countact_2(gap, 4e-4, 0), InputError);
  CHECK_THROWS_AS((void)countaxi(gap, nan, 1e7), InputError);
}

TEST_CASE("input: meshes that make no sense are refused") {
  CHECK_THROWS_AS(uniform_columns(2), InputError);
  CHECK_THROWS_AS(graded_columns(0, 3), InputError);
  CHECK_THROWS_AS(split_columns({0, 1, 0.2}, {2, 1, 0.2}), InputError);
  CHECK_THROWS_AS(split_columns({2, 1, 1.2}, {2, 1, 0.2}), InputError);
  refused([](CountactOptions& o) { o.columns = {}; });
  refused([](CountactOptions& o) { o.columns.whole = {0, 0.6, 0.4, 1}; });
  refused([](CountactOptions& o) { o.columns = split_columns({3, 0, 0}, {2, 0, 0}); });
  refused([](CountactOptions& o) { o.rows = 2; });
  refused([](CountactOptions& o) { o.rows = 3, o.fit = Fit::three_points; });
  refused([](CountactOptions& o) { o.tolerance = 0; });
}

TEST_CASE("input: columns for two axes of symmetry must be their own mirror image") {
  const auto columns = [](std::vector<double> whole) {
    CountactOptions options;
    options.columns.whole = std::move(whole);
    return options;
  };
  for (const std::vector<double>& lopsided :
       {std::vector<double>{0, 0.2, 0.5, 0.9, 1}, {0, 0.1, 0.4, 0.7, 1}, {0, 0.2, 0.49, 0.8, 1}}) {
    CHECK_THROWS_AS((void)countact_2(gap, 4e-4, 1e7, columns(lopsided)), InputError);
    CHECK_NOTHROW((void)countact_1(gap, 4e-4, 1e7, columns(lopsided)));
  }
  CHECK_NOTHROW((void)countact_2(gap, 4e-4, 1e7, columns({0, 0.2, 0.5, 0.8, 1})));
}

TEST_CASE("input: a dense matrix that does not fit is refused before it is allocated") {
  refused([](CountactOptions& o) { o.columns = uniform_columns(2001), o.rows = 2001; });
  refused([](CountactOptions& o) { o.most_bytes = 1000; });
}

TEST_CASE("input: a gap that is NaN somewhere is refused") {
  const Gap broken = [](double x, double y) {
    return x > 0.01 ? std::numeric_limits<double>::quiet_NaN() : x * x + y * y;
  };
  CHECK_THROWS_AS((void)countact_1(broken, 1e-2, 1e7), InputError);
}

TEST_CASE("input: a gap without the symmetry a solver relies on is refused") {
  const Gap turned = quadratic_gap({1, 3, 0.3});
  CHECK_THROWS_AS((void)countact_1(turned, 1e-3, 1e7), InputError);
  CHECK_THROWS_AS((void)countact_2(turned, 1e-3, 1e7), InputError);
  const Gap jump = rail_wheel_gap({18, 12.34, 10, 1.25});  // symmetric about x only
  CHECK_THROWS_AS((void)countact_2(jump, 1e-3, 1e7), InputError);
}

TEST_CASE("input: an unsymmetric gap is refused to either side, rounding is not") {
  for (const double odd : {-1.0, -0.01, 0.01, 1.0}) {
    const Gap about_x = [=](double x, double y) { return x * x + 3 * y * y + 1e-3 * odd * y; };
    CHECK_THROWS_AS((void)countact_1(about_x, 1e-3, 1e7), InputError);
    CHECK_THROWS_AS((void)countact_2(about_x, 1e-3, 1e7), InputError);
    const Gap about_y = [=](double x, double y) { return x * x + 3 * y * y + 1e-3 * odd * x; };
    CHECK_NOTHROW((void)countact_1(about_y, 1e-3, 1e7));
    CHECK_THROWS_AS((void)countact_2(about_y, 1e-3, 1e7), InputError);
    const Gap rounding = [=](double x, double y) { return x * x + 3 * y * y + 1e-9 * odd * y; };
    CHECK_NOTHROW((void)countact_1(rounding, 1e-3, 1e7));
  }
}

TEST_CASE("input: the punch refuses an empty contact and a shape that is no punch") {
  CHECK_THROWS_AS(punch_from_approach({0.5, 1}, 1e11, 0), InputError);
  CHECK_THROWS_AS(punch_from_approach({0.5, 1}, -1, 1e-5), InputError);
  CHECK_THROWS_AS(punch_from_approach({0, 0}, 1e11, 1e-5), InputError);
  CHECK_THROWS_AS(punch_from_approach({-0.5, 1}, 1e11, 1e-5), InputError);
  CHECK_THROWS_AS(punch_pressure(punch_from_approach({0.5, 1}, 1e11, 1e-5), -0.1), InputError);
}
