/*** ### Ballast memory

Before 1939 US rails were 33 ft long. Under newer rail of 39 ft the old wavelength is still found: the old joints have worked their
way into ballast and subgrade. Figure {{fig-06}} follows the paper's drawing. What is left after reworking is the fundamental of the
old pattern (b). Under welded rail it simply adds (d): no new wavelength, one extra line at 1/(33 ft). When the joints of the new
rail have loosened, each dips most where an old low spot lies (e): a modulation, whose wavenumber (5) is the difference of both,

$$\varepsilon=\frac1{10.0}-\frac1{11.9}=\frac1{6?.5}, \tag{5}$$

with a digit of the result not legible in the copy at hand. Exact feet give {{epsilon-feet}}, printed metres {{epsilon-metres}}; with $\varphi_0$
rounded to 0.084 as in Table 1 it is $0.100-0.084=0.016$, one over {{epsilon-rounded}}, which fits the legible characters.

{{fig-06}}

**Why the sidebands are there, and why they need not be equal.** A joint feels the old pattern only where it is. At $x=jl$ the waves
$\cos2\pi x/l_{old}$ and $\cos2\pi\varepsilon x$ have the same values, so modulation by the old wavelength is modulation by $\varepsilon$. But if each dip
scales as a whole, with the old pattern at its joint, the envelope is a staircase, not a wave, and the pair is not symmetric: the
line at $\varphi_0\mp\varepsilon$ then has the amplitude $mB\,D(1\mp\varepsilon l)$, with the lower sideband {{staircase-ratio}} times as strong as the upper. The paper's
symmetric pair belongs to a smooth envelope. Between its "single sideband" and its "symmetric sidebands" there is a
continuum of cases, and one process alone can make most of it.
*/
#include <array>
#include <cmath>

#include "num/fft.hpp"
#include "sections.hpp"
#include "spectra/joint_dips.hpp"
#include "spectra/rail_line.hpp"
#include "units/constants.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double new_rail = 39 * units::foot;
constexpr double old_rail = 33 * units::foot;
const double eps = 1 / old_rail - 1 / new_rail;
constexpr double modulation = 0.5;

void fig_06_curves(report::Data& curve) {
  const double dip = 10.0;  // mm
  for (int i = 0; i <= 1430; ++i) {
    const double x = 0.1 * i * units::foot * 3;  // one period of everything: 429 ft
    const double old = -dip * (1 - spectra::rectified_sine(x, old_rail, 1.0));
    const double fundamental =
        -spectra::line_strength(1, dip / 2, spectra::LineConvention::exact_one_sided) *
        std::cos(2 * units::pi * x / old_rail);
    const double fresh = -dip * (1 - spectra::rectified_sine(x, new_rail, 1.0));
    const double envelope = 1 + modulation * std::cos(2 * units::pi * eps * x);
    curve.add(x, old, fundamental, fresh, fresh + fundamental, envelope * fresh, -dip * envelope);
  }
}

/*** The staircase is checked on one period, 429 ft, of a finely sampled record: eleven dips, each scaled by the old pattern at its
joint, transformed.
*/
std::array<double, 2> staircase_sidebands() {
  num::RealFft fft{429 * 32};
  const double length = 429 * units::foot;
  for (std::size_t i = 0; i < fft.size(); ++i) {
    const double x = length * static_cast<double>(i) / static_cast<double>(fft.size());
    const double joint = std::round(x / new_rail);
    const double depth = 1 + modulation * std::cos(2 * units::pi * joint * new_rail / old_rail);
    fft.real()[i] = -depth * spectra::dip_shape(x / new_rail - joint);
  }
  fft.forward();
  const auto power = [&](double phi) {
    const auto k = static_cast<std::size_t>(std::lround(phi * length));
    return 2 * std::norm(fft.spectrum()[k] / static_cast<double>(fft.size()));
  };
  return {power(1 / new_rail - eps), power(1 / new_rail + eps)};
}

void fig_06(report::Item& item) {
  item.expect_checks(2);
  item.rebuilt("the paper draws the patterns by hand; ours: dips of 10 mm, m = 0.5");
  fig_06_curves(item.data(
      {"x_m", "old_mm", "fundamental_mm", "new_mm", "linear_mm", "nonlinear_mm", "envelope_mm"}));
  const auto [lower, upper] = staircase_sidebands();
  const auto formula = [](double phi) {
    const double amplitude = modulation * spectra::dip_transform(phi * new_rail);
    return amplitude * amplitude / 2;
  };
  const double low = formula(1 / new_rail - eps);
  const double high = formula(1 / new_rail + eps);
  item.agree("lower", "staircase, sideband at φ₀ − ε", "B²", lower, low, 1e-4,
             "the formula m D(1 − εl)");
  item.agree("upper", "staircase, sideband at φ₀ + ε", "B²", upper, high, 1e-4,
             "the formula m D(1 + εl)");
  item.value("staircase-ratio", low / high, "", "{:.2f}");
  item.value("epsilon-feet", eps, "cycle/m", "{:.6f}");
  item.value("epsilon-metres", 1 / 10.0 - 1 / 11.9, "cycle/m", "{:.6f}");
  item.value("epsilon-rounded", 1 / (0.100 - 0.084), "m", "{:.1f}");
}

}  // namespace

const report::Section memory{
    report::figure("fig-06", "Ballast memory: 33-ft rails under 39-ft rails (Fig. 6)", fig_06)};

}  // namespace railbook::psd_chapter
