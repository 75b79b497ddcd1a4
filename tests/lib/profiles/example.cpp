#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/profiles/depth_profile.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: the wheel S1002") {
  // example
  // depth below the running circle, and slope, 37.5 mm towards the flange
  const profiles::Profile wheel = profiles::s1002();
  const auto flange = wheel.at(-0.0375);
  const double height = wheel.at(-0.055).depth;  // of the flange, m
  // end
  CHECK(std::abs(flange.depth - 0.010) < 5e-6);
  CHECK(std::abs(height - 0.028) < 1e-12);
}
