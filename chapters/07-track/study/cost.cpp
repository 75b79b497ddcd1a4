/***
### Which method gives the deflection under a moving load?

The load runs at half of the critical speed $V_c$ ($\theta=V/V_c$ = 0.5) with 0.2 of critical
damping ($\zeta$ = 0.2). {{moving-answer}} They are exact to rounding and the quickest, and the
library uses them. Beside them stand the textbook's way, by the four roots of the quartic; finite
elements that move with the load (*steady elements*); and the *lumped* model of the first page, seen
from trackside. At $V_c$ the four roots lose most of their digits (see below). The error of the
finite elements should fall with the fourth power of the size of an element, and does so until
rounding shows in the last point. (The slope found in the figure includes that point.) The condition
number of their system grows as fast as the error falls, so the system is solved in 80-bit
arithmetic. The lumped model keeps its modelling error, {{lumped-error}} with the mass of (15)
($\mu$ = 3/4); even $\mu$ = 1/4 is right at low speed only, and for the peak, which with damping
comes after the load has passed. The reference is the Fourier integral
$\frac8\pi\,\mathrm{Re}\int_0^\infty\frac{d\nu}{\nu^4-4\theta^2\nu^2-8i\zeta\theta\nu+4}$ in 80-bit
arithmetic, which shares nothing with any of them but the differential equation.

{{cost-moving}}

{{work-precision: cost-moving}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <railbook/bench/work_precision.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/track/fe_moving_load.hpp>
#include <railbook/track/lumped.hpp>
#include <railbook/track/moving_load.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

double deflection_by_roots(double theta, double zeta) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) << -4, 8 * zeta * theta, -4 * theta * theta, 0;
  std::complex<double> sum = 0;
  for (const std::complex<double>& p : num::eigenvalues(companion))
    if (p.real() < 0) sum += 8.0 / (4.0 * p * p * p + 8 * theta * theta * p - 8 * zeta * theta);
  return sum.real();
}

namespace {

constexpr double theta = 0.5, zeta = 0.2;

double lumped_at_load(double mu) {
  const double root = theta * std::sqrt(mu);
  return Passage{single_mass(1, 2 * zeta * root, root * root), 1, 1}.state(0)[0];
}

// The deflection under the load as the integral over all waves, by the trapezoidal rule in u, k =
// sinh u.
double at_load_by_waves(double step) {
  using Long = long double;
  const Long t = theta, z = zeta, h = step;
  const auto wave = [&](Long u) {
    const Long k = std::sinh(u);
    const std::complex<Long> impedance{k * k * k * k - 4 * t * t * k * k + 4, -8 * z * t * k};
    return std::cosh(u) * (Long(1) / impedance).real();
  };
  Long sum = wave(0) / 2;
  for (int i = 1; i * h < 16; ++i) sum += wave(i * h);
  return static_cast<double>(8 / std::numbers::pi_v<Long> * h * sum);
}

bench::Outcome outcome(double value, double work) {
  return {.values = {value}, .work = work, .reason = ""};
}

void cost_moving(report::Item& item) {
  item.added("a comparison of methods");
  const double exact = at_load_by_waves(0.02);
  const std::vector<double> elements{0.4, 0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625};
  // What another step of the rule changes; half a unit in the last place when they agree to the
  // bit.
  const double uncertainty = std::max(std::abs(at_load_by_waves(0.03) / exact - 1), 1.1e-16);
  const auto points = bench::figure(
      item, {"the deflection", exact, uncertainty},
      {{"quadratic factors", {{"", [] { return outcome(moving_load(theta, zeta).at_load(), 2); }}}},
       {"four roots", {{"", [] { return outcome(deflection_by_roots(theta, zeta), 4); }}}},
       bench::sweep("lumped at trackside", std::vector<double>{0.75, 0.25},
                    [](double mu) { return outcome(lumped_at_load(mu), 1); })
           .labelled("μ = {}"),
       bench::sweep("steady elements", elements,
                    [](double h) {
                      const auto fe = fe_steady(theta, zeta, {.element = h, .neglect = 1e-12});
                      return outcome(fe.at_load, fe.unknowns);
                    })
           .labelled("elements of {}/β")
           .expects(-4)},
      0.05);
  item.value("moving-answer", bench::answer(points, "the deflection", {1e-3, 1e-8}));
  item.value("lumped-error", 100 * std::abs(lumped_at_load(0.75) / exact - 1), "%", "{:.1f}");
}

}  // namespace

const report::Section cost{report::figure("cost-moving", cost_moving)};

}  // namespace railbook::track_chapter
