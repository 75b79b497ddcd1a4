#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/contact/geometry.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("unit: relative curvatures of aligned bodies are half the sums") {
  const RelativeCurvature c = relative_curvature({1 / 18.0, 0, units::pi / 2}, {1 / 10.0, 0, 0});
  CHECK(c.a == Approx(0.05).epsilon(1e-15));
  CHECK(c.b == Approx(1 / 36.0).epsilon(1e-15));
  CHECK(std::abs(c.angle) < 1e-15);
}

TEST_CASE("unit: relative curvatures reproduce the gap of turned bodies") {
  const Curvature one{3.0, 1.0, 0.7}, two{2.0, -0.4, -0.3};
  const Gap gap = quadratic_gap(relative_curvature(one, two));
  for (double t = 0; t < 3; t += 0.37) {
    double expected = 0;
    for (const Curvature& c : {one, two})
      expected += (c.first * std::pow(std::cos(t - c.angle), 2) +
                   c.second * std::pow(std::sin(t - c.angle), 2)) /
                  2;
    CHECK(gap(std::cos(t), std::sin(t)) == Approx(expected).epsilon(1e-14));
  }
  CHECK(std::abs(relative_curvature(one, two).angle) <= units::pi / 4 + 1e-15);
}

TEST_CASE("unit: slender relative curvatures keep their digits") {
  // Aligned bodies: the sums. Crossed cylinders of radius 1 at a small angle: A, B = (1 +- cos
  // angle)/2.
  const RelativeCurvature aligned = relative_curvature({0, 3e-14}, {5, 1e-14});
  CHECK(aligned.a == Approx(2.5).epsilon(1e-15));
  CHECK(aligned.b == Approx(2e-14).epsilon(1e-14));
  const RelativeCurvature swapped = relative_curvature({3e-14, 0}, {1e-14, 5});
  CHECK(swapped.a == Approx(2e-14).epsilon(1e-14));
  CHECK(swapped.b == Approx(2.5).epsilon(1e-15));
  const RelativeCurvature crossed = relative_curvature({1, 0}, {1, 0, 1e-6});
  CHECK(crossed.b == Approx(std::pow(std::sin(0.5e-6), 2)).epsilon(1e-12));
}

TEST_CASE("unit: the gaps of the paper's examples") {
  const Gap rail = rail_wheel_gap({18, 12.34, 10, 1.25});
  CHECK(rail(-0.5, 0) == Approx(0.125 * (1 / 10.0 - 1 / 12.34)).epsilon(1e-14));
  CHECK(rail(0.5, 0) == Approx(0.125 * (1 / 1.25 - 1 / 12.34)).epsilon(1e-14));
  CHECK(rail(0, 0.6) == Approx(0.01).epsilon(1e-14));
  const Gap roller = crowned_roller_gap({0.5, 0.5, 85});
  CHECK(roller(-0.4, 0.1) == Approx(0.01).epsilon(1e-14));
  CHECK(roller(-0.6, 0) == Approx(0.01 / 170).epsilon(1e-14));
  CHECK(std::isinf(crowned_roller_gap({0.5, 0.5, 0})(0.6, 0)));
  const Gap punch = rounded_punch_gap({0.5, 2});
  CHECK(punch(0.3, 0.4) == 0);
  CHECK(punch(0.6, 0.8) == Approx(0.0625).epsilon(1e-14));
  CHECK(std::isinf(rounded_punch_gap({0.5, 0})(0, 0.51)));
}

TEST_CASE("unit: the interpenetration curve of an ellipse") {
  const Gap gap = quadratic_gap({2, 5, 0.3});
  for (double delta : {1e-14, 1e-5, 1.0}) {
    CHECK(interpenetration_distance(gap, delta, 0.3) ==
          Approx(std::sqrt(delta / 2)).epsilon(1e-14));
    CHECK(interpenetration_distance(gap, delta, 0.3 + units::pi / 2) ==
          Approx(std::sqrt(delta / 5)).epsilon(1e-14));
  }
  CHECK(interpenetration_distance(rounded_punch_gap({0.5, 0}), 1e-3, 1.0) ==
        Approx(0.5).epsilon(1e-14));
}

TEST_CASE("input: shapes that do not touch first at the origin are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(relative_curvature({-1, 1, 0}, {0.5, 1, 0}), InputError);
  CHECK_THROWS_AS(quadratic_gap({1, 0, 0}), InputError);
  CHECK_THROWS_AS(quadratic_gap({nan, 1, 0}), InputError);
  CHECK_THROWS_AS(rail_wheel_gap({18, 9, 10, 1.25}), InputError);
  CHECK_THROWS_AS(rail_wheel_gap({18, 12.34, 0, 1.25}), InputError);
  CHECK_THROWS_AS(crowned_roller_gap({0.5, -0.1, 85}), InputError);
  CHECK_THROWS_AS(rounded_punch_gap({0, 0}), InputError);
}

TEST_CASE("input: an interpenetration curve that does not exist is refused") {
  const Gap ridge = [](double, double y) { return y * y; };
  CHECK_THROWS_AS(interpenetration_distance(ridge, 1e-3, 0), InputError);
  CHECK_THROWS_AS(interpenetration_distance(ridge, 0, 1), InputError);
  CHECK_THROWS_AS(interpenetration_distance(ridge, -1, 1), InputError);
  const Gap broken = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
  CHECK_THROWS_AS(interpenetration_distance(broken, 1e-3, 0), InputError);
}
