#include <algorithm>
#include <cmath>

#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/moving_load.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;
using namespace railbook::track;

TEST_CASE("claim: the moving load by finite elements") {
  Claim steady("track::fe_steady"), largest("track::largest_difference");
  RandomStream draw(32);
  for (int k = 0; k < 20; ++k) {
    const double theta = draw(0, 1.5), zeta = draw(0.1, 1), h = draw.decades(0.005, 0.2);
    const FeShape fe = fe_steady(theta, zeta, {h, 1e-15});
    const MovingLoadShape exact = moving_load(theta, zeta);
    const double h4 = h * h * h * h, unit = (h4 + 3e-18 / h4) * exact.maximum().y;
    for (std::size_t i = 0; i < fe.s.size(); ++i)
      steady.error(std::abs(fe.y[i] - exact.deflection(fe.s[i])) / unit);
    for (int j = 0; j < 50; ++j) {
      const double low = draw(-5, 0), high = draw(0, 5);
      double most = 0;
      for (std::size_t i = 0; i < fe.s.size(); ++i)
        if (fe.s[i] >= low && fe.s[i] <= high)
          most = std::max(most, std::abs(fe.y[i] - exact.deflection(fe.s[i])));
      largest.error(std::abs(largest_difference(fe, theta, zeta, low, high) - most));
    }
  }
}
