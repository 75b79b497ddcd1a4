#include <array>
#include <utility>

#include <railbook/num/double_double.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;
using num::DoubleDouble;

namespace {

__extension__ typedef __float128 Quad;  // 113 binary digits

Quad quad(const DoubleDouble& x) {
  return Quad{x.high} + x.low;
}
Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}

// All digits, of either sign, in each decade alike.
DoubleDouble number(RandomStream& draw, double low, double high) {
  const double sign = draw(0, 1) < 0.5 ? -1 : 1;
  return DoubleDouble{sign * draw.decades(low, high)} * (DoubleDouble{1} + 2e-16 * draw(-1, 1));
}

}  // namespace

TEST_CASE("claim: arithmetic of twice a double's digits") {
  Claim claim("num::DoubleDouble");
  RandomStream draw(61);
  const auto hold = [&](const DoubleDouble& found, Quad exact, Quad scale) {
    claim.error(static_cast<double>(magnitude(quad(found) - exact) / scale));
    CHECK(std::abs(found.low) <= 1.2e-16 * std::abs(found.high));
  };
  for (int k = 0; k < 3000; ++k) {
    const DoubleDouble a = number(draw, 1e-140, 1e140);
    // Near a, so that the leading digits of a sum cancel, or far from it.
    const DoubleDouble b = k % 2 == 0 ? a * number(draw, 0.99, 1.01) : number(draw, 1e-140, 1e140);
    const Quad x = quad(a), y = quad(b);
    hold(a + b, x + y, magnitude(x) + magnitude(y));
    hold(a - b, x - y, magnitude(x) + magnitude(y));
    hold(a * b, x * y, magnitude(x * y));
    hold(a / b, x / y, magnitude(x / y));
  }
}
