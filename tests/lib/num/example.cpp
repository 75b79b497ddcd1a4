#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/num/roots.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a root and an integral") {
  // example
  const num::Root root = num::find_root([](double x) { return std::cos(x) - x; }, 0, 1);
  const num::Integral area =
      num::integrate([](double x) { return std::exp(-x * x); }, 0, HUGE_VAL, 1e-10);
  const bool good = root.converged && area.converged;  // results say so, bad input throws
  // end
  CHECK(good);
  CHECK(std::abs(std::cos(root.x) - root.x) < 1e-14 * std::abs(root.x));
  CHECK(std::abs(area.value - std::sqrt(std::atan(1.0))) <
        1e-10 * std::abs(std::sqrt(std::atan(1.0))));
}
