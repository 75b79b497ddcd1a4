/***
## Track geometry as input

What makes wheel and track move? Track that was laid with joints sags at the joints, and each rail
becomes an arc: the *rectified sine* $z=D\,(1-|\sin(\pi x/L)|)$ for rails of length $L$ with dips of
the depth $D$, at the distance $x$ along the rail. Its series is

$$|\sin(\pi x/L)|=\frac2\pi-\frac4\pi\sum_{n\ge1}\frac{\cos(2\pi nx/L)}{4n^2-1}.$$

North American practice staggers the joints by half a rail. The paper says what follows: the odd
harmonics of the rail length excite a car in roll, the even ones in bounce. (Bounce is the car's
motion up and down, roll its rotation about the track's direction.) This is exact, because a shift
by $L/2$ changes the sign of odd harmonics only; {{harmonics}} shows it by a Fourier transform of
sampled surfaces.

{{harmonics: rows}}

The *cross level*, the difference in height of the two rails, is twice the roll in the table.
Staggered joints put their odd harmonics into it; coincident joints, as in Britain, are the same on
both rails and put nothing into it.
*/
#include <fmt/format.h>

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

constexpr int shown = 9;

// Amplitudes of bounce and of roll on half-staggered rails, from a Fourier transform of samples.
std::pair<std::vector<double>, std::vector<double>> bounce_and_roll() {
  constexpr int samples = 1 << 14;
  std::vector<double> bounce(samples), roll(samples);
  for (int i = 0; i < samples; ++i) {
    const auto both = half_staggered({1, 1}, double(i) / samples);
    bounce[std::size_t(i)] = both.bounce, roll[std::size_t(i)] = both.roll;
  }
  return {cosine_amplitudes(bounce, shown), cosine_amplitudes(roll, shown)};
}

void harmonics(report::Item& item) {
  const auto [b, r] = bounce_and_roll();
  const table::CsvTable claims = item.printed("numbers.csv");
  item.expect_checks(2);
  item.print_text("roll", claims.at("roll", "what"), claims.at("roll", "printed"), parity(r));
  item.print_text("bounce", claims.at("bounce", "what"), claims.at("bounce", "printed"), parity(b));
  item.columns({{"harmonic of 39 ft", "{:.0f}"},
                {"wavelength, ft", "{:.3f}"},
                {"one rail, (4/π)/(4n²−1)", "{:.6f}"},
                {"bounce", "{:.6f}"},
                {"roll", "{:.6f}"}});
  for (int n = 1; n < shown; ++n) {
    const auto k = std::size_t(n);
    const auto clean = [](double a) { return std::abs(a) < 1e-12 ? 0.0 : a; };
    item.add_row(double(n), 39.0 / n, rectified_sine_harmonic(n), clean(b[k]), clean(r[k]));
  }
}

/***
A measured profile is the paper's Figure 7, which is lost. "This type of profile has been modeled
quite adequately by the rectified sinewave", says the paper; without the profile this cannot be
tested.

::: {.fold summary="The rectified sine on two rails, and what a car feels of it"}

{{fig-07}} shows the rectified sine instead, on two rails with staggered joints, and what a
car feels of them.

{{fig-07}}

:::

::: {.fold summary="Random track: spectra of cross level"}

The second kind of input is random. Cross level is the difference in height of the two rails. Our
copy has the legends of the paper's Figure 6, but not its curves. They name a spectrum of cross
level for an idealized track of class 6 (the US classes rise with the speed permitted, up to 6), and
the ranges of data measured on a high-speed demonstration track and on British Rail. In its place we
show a family of curves for the classes of the Federal Railroad Administration from the later
literature,

$$S(\phi)=\frac{A\,\phi_2^2}{(\phi^2+\phi_1^2)(\phi^2+\phi_2^2)},$$

with the wavenumber $\phi$ in cycles per length, the roughness $A$ of {{rough-6}} for class 6 and
{{rough-3}} for class 3, and the break frequencies $\phi_1$ = {{break-1}} and $\phi_2$ =
{{break-2}}. The marks at the top of {{fig-06}} show at which
wavenumbers half-staggered 39-foot rails add power of their own, not how much. The height of the
curves is doubtful: other published lists of the same family have roughness constants $A$ about
{{feet-squared}} times as large, and so amplitudes {{feet}} times as large. This factor is
$(1/0.3048)^2$, as if feet had been converted to metres twice in one of the lists; the
original was not at hand. The shape of the curves does not depend on it.

{{fig-06}}

The cross level's root mean square over wavelengths of 2 to 100 m is {{rms-6}} for class 6 and
{{rms-3}} for class 3 with these constants, {{rms-6-high}} and {{rms-3-high}} with the larger ones.
The paper points to the different effect of staggered (North American) and coincident (British)
joints on such spectra.

:::
*/

// Half-staggered rails with joints half an inch deep, and what a car feels of them.
void profile(report::Item& item) {
  item.lost(
      "the measured profile is not in the copy: the rectified sine that the paper puts for it");
  auto& curves = item.data({"distance_ft", "left_in", "right_in", "bounce_in", "roll_in"});
  const RectifiedSine rail = joint_dip(0.5);
  for (double x = 0; x <= 117.001; x += 0.25) {
    const auto height = [&](double at) {
      return surface_at(rail, at * units::foot).z / units::inch;
    };
    const auto both = half_staggered(rail, x * units::foot);
    curves.add(x, height(x), height(x - 19.5), both.bounce / units::inch, both.roll / units::inch);
  }
}

constexpr double per_foot = units::inch * units::inch * units::foot;  // in^2/(cycle/ft) in m^3

void cross_level(report::Item& item) {
  const CrossLevelSpectrum class_6, class_3{.roughness = 4.92e-8};
  auto& curve = item.data({"cycles_per_ft", "class_6_in2_per_cpf", "class_3_in2_per_cpf"});
  for (double f = 0.002; f <= 0.5; f *= 1.05)
    curve.add(f, class_6.density(f / units::foot) / per_foot,
              class_3.density(f / units::foot) / per_foot);
  auto& joints = item.data("joints", {"cycles_per_ft", "harmonic"});
  for (int n = 1; n <= 7; n += 2) joints.add(n / 39.0, n);
  item.lost("the paper's curve and measured bands are not in the text: a later published family");
  item.value("rough-6", fmt::format("{:.2f}×10⁻⁸ m", class_6.roughness * 1e8));
  item.value("rough-3", fmt::format("{:.2f}×10⁻⁸ m", class_3.roughness * 1e8));
  item.value("break-1", fmt::format("{:.4f} cycle/m", class_6.low_break));
  item.value("break-2", fmt::format("{:.3f} cycle/m", class_6.high_break));
  const double feet = 1 / units::foot;
  item.value("feet-squared", feet * feet, "", "{:.1f}");
  item.value("feet", feet, "", "{:.1f}");
  for (const auto& [id, spectrum] : {std::pair{"rms-6", class_6}, {"rms-3", class_3}}) {
    const double rms = 1e3 * std::sqrt(spectrum.variance(0.01, 0.5));
    item.value(id, rms, "mm", "{:.1f}");
    item.value(fmt::format("{}-high", id), rms * feet, "mm", "{:.1f}");
  }
}

}  // namespace

const report::Section geometry{report::table("harmonics", harmonics),
                               report::figure("fig-07", profile),
                               report::figure("fig-06", cross_level)};

}  // namespace railbook::track_chapter
