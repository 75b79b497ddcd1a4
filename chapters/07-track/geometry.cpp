/***
## Track geometry as input

Track that was laid with joints sags at the joints, and each rail becomes an arc: the *rectified sine*
$z=A\,(1-|\sin(\pi x/L)|)$ for rails of length $L$. Its series is

$$|\sin(\pi x/L)|=\frac2\pi-\frac4\pi\sum_{n\ge1}\frac{\cos(2\pi nx/L)}{4n^2-1}.$$

North American practice staggers the joints by half a rail. The paper says what follows: the odd harmonics of the rail length excite a car in roll, the even ones
in bounce. That is exact, since a shift by $L/2$ changes the sign of odd harmonics only; the table shows it on sampled surfaces by a Fourier transform.

{{harmonics}}
*/
#include <array>
#include <cmath>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// "odd" or "even" when only such harmonics are above rounding; else what was found.
std::string parity(std::span<const double> amplitudes) {
  double odd = 0, even = 0;
  for (std::size_t n = 1; n < amplitudes.size(); ++n)
    (n % 2 ? odd : even) = std::max(n % 2 ? odd : even, std::abs(amplitudes[n]));
  const double rounding = 1e-12 * std::max(odd, even);
  if (even <= rounding && odd > 0) return "odd";
  if (odd <= rounding && even > 0) return "even";
  return "both";
}

void harmonics(report::Item& item) {
  constexpr int samples = 1 << 14, shown = 9;
  std::vector<double> bounce, roll;
  for (int i = 0; i < samples; ++i) {
    const auto both = half_staggered({1, 1}, double(i) / samples);
    bounce.push_back(both.bounce);
    roll.push_back(both.roll);
  }
  const auto b = cosine_amplitudes(bounce, shown), r = cosine_amplitudes(roll, shown);
  const table::CsvTable claims = item.printed("numbers.csv");
  item.expect_checks(2);
  item.print_text("roll", claims.at("roll", "what"), claims.at("roll", "printed"), parity(r));
  item.print_text("bounce", claims.at("bounce", "what"), claims.at("bounce", "printed"), parity(b));
  item.columns({{"harmonic of 39 ft", "{:.0f}"},
                {"wavelength, ft", "{:.3f}"},
                {"one rail, (4/pi)/(4n^2-1)", "{:.6f}"},
                {"bounce", "{:.6f}"},
                {"roll", "{:.6f}"}});
  for (int n = 1; n < shown; ++n) {
    const auto k = std::size_t(n);
    const auto clean = [](double a) { return std::abs(a) < 1e-12 ? 0.0 : a; };
    item.add_row(double(n), 39.0 / n, rectified_sine_harmonic(n), clean(b[k]), clean(r[k]));
  }
}

/***
The second kind of input is random. Figure 6 of the paper shows an idealized cross-level spectrum, in
double logarithmic axes, over the range of measured data. Its curves and its bands are not in the text. What stands
here is the family that the Federal Railroad Administration's classes were given later in the literature (quoted by Frýba),

$$S(\phi)=\frac{A\,\phi_2^2}{(\phi^2+\phi_1^2)(\phi^2+\phi_2^2)},$$

with its constants for class 6 and class 3, and the lines at which half-staggered 39-foot rails add power of their own. The level is doubtful: other
published lists of the same family have amplitudes about {{feet-squared}}, that is $(1/0.3048)^2$, times as large, as if feet had been converted once too often. That is an
inference from two such lists; the original was not at hand. The shape of the curves does not depend on it.

{{fig-06}}

The rms from 2 to 100 m is {{rms-6}} for class 6 and {{rms-3}} for class 3. Figure 7 of the paper, a measured profile, is lost; whether the rectified sine models it
"quite adequately" cannot be told.
*/

constexpr double per_foot = units::inch * units::inch * units::foot;  // in^2/(cycle/ft) in m^3

void cross_level(report::Item& item) {
  const CrossLevelSpectrum class_6, class_3{.roughness = 4.92e-8};
  auto& curve = item.data({"cycles_per_ft", "class_6_in2_per_cpf", "class_3_in2_per_cpf"});
  for (double f = 0.002; f <= 0.5; f *= 1.05)
    curve.add(f, class_6.density(f / units::foot) / per_foot,
              class_3.density(f / units::foot) / per_foot);
  auto& lines = item.data("joints", {"cycles_per_ft", "low", "high"});
  for (int n = 1; n <= 7; n += 2)
    lines.add(n / 39.0, 1e-6, class_3.density(n / 39.0 / units::foot) / per_foot);
  item.lost("the paper's curve and measured bands are not in the text: a later published family");
  item.value("feet-squared", 1 / (units::foot * units::foot), "", "{:.2f}");
  for (const auto& [id, spectrum] : {std::pair{"rms-6", class_6}, {"rms-3", class_3}})
    item.value(id, 1e3 * std::sqrt(spectrum.variance(0.01, 0.5)), "mm", "{:.3f}");
}

}  // namespace

const report::Section geometry{
    report::table("harmonics", "Half-staggered joints in bounce and roll", harmonics),
    report::figure("fig-06", "Cross-level spectrum (in place of the paper's Fig. 6)", cross_level)};

}  // namespace railbook::track_chapter
