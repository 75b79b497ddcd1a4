#include <algorithm>
#include <cmath>

#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/moving_load.hpp>

#include "support/claim.hpp"

using namespace railbook;
using namespace railbook::tests;
using namespace railbook::track;

TEST_CASE("claim: the moving load by finite elements") {
  Claim steady("track::fe_steady"), newmark("track::fe_newmark"),
      twice("track::fe_newmark_extrapolated"), largest("track::largest_difference");
  RandomStream draw(32);
  for (int k = 0; k < 20; ++k) {
    const double theta = draw(0, 1.5), zeta = draw(0.1, 1), h = draw.decades(5e-4, 0.2);
    const FeShape fe = fe_steady(theta, zeta, {h, 1e-15});
    const MovingLoadShape exact = moving_load(theta, zeta);
    const double unit = (h * h * h * h + 2e-14) * exact.maximum().y;
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
  for (int k = 0; k < 3; ++k) {
    const double theta = draw(0.2, 1.2), zeta = draw(0.3, 1);
    const FeNewmarkOptions options{.element = 0.2, .step = 0.05, .neglect = 1e-7, .margin = 30};
    const MovingLoadShape exact = moving_load(theta, zeta);
    const auto hold = [&](Claim& claim, const FeShape& fe) {
      for (std::size_t i = 0; i < fe.s.size(); ++i)
        claim.error(std::abs(fe.y[i] - exact.deflection(fe.s[i])));
    };
    hold(newmark, fe_newmark(theta, zeta, options));
    hold(twice, fe_newmark_extrapolated(theta, zeta, options));
  }
}
