/*** ## What a chord sees

The US track safety standards limit the mid-chord offset: the height of the rail above the middle of a 62-ft (19-m) chord stretched
on it. For a sine of wavenumber $\varphi$ a chord $L$ reads $1-\cos\pi L\varphi$ times the amplitude.

### Of the random part

On $A/\varphi^2$ the variance of the offset is $A\int_0^\infty(1-\cos\pi L\varphi)^2\varphi^{-2}d\varphi$. The integral is $\frac12\pi^2L$, and so

$$\sigma(L)=\pi\sqrt{\tfrac12AL}, \tag{8}$$

the paper's (8), with the damaged glyph under the root confirmed. It holds for a one-sided density; a two-sided $A$ would lose the
$\frac12$. The paper leaves the corner out of it, since long chords respond most below $\varphi_c$. With the corner the integral has
a closed form too, in sine integrals. The table compares: for the corners of Table 1, (8) is {{equation-8-least}} to {{equation-8-most}} above the
two-slope value for the 19-m chord, on the safe side, and up to {{equation-8-short}} for the 9.5-m chord. The Monte Carlo is of synthetic
track, {{equation-8-length}} for each corner; its last column is the share of offsets beyond three sigma of (8), where a normal offset
without corner would have {{three-sigma}}.

{{equation-8}}

The paper's two probabilities for three sigma, 0.99 for a normal offset (exactly {{normal-share}}) and 0.8 for the worst distribution
(Chebyshev, {{chebyshev-share}}), are both cut after the last printed digit, not rounded.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "num/quadrature.hpp"
#include "sections.hpp"
#include "spectra/chord.hpp"
#include "spectra/classify.hpp"
#include "spectra/rail_line.hpp"
#include "spectra/synthetic_track.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double long_chord = 62 * units::foot;
constexpr double short_chord = 31 * units::foot;
constexpr double A = 5e-7;  // every ratio below is free of it

// Offsets of a chord along synthetic track: their standard deviation, and the share beyond three sigma of (8).
struct Offsets {
  double sigma = 0;
  double beyond = 0;
};
Offsets monte_carlo(double phi_c, double chord, std::size_t samples, std::uint64_t seed) {
  spectra::SyntheticTrack track;
  track.seed = seed;
  track.A = A;
  track.phi_c = phi_c;
  const auto mco =
      spectra::mid_chord_offsets(spectra::synthesize(track, samples), track.spacing, chord).offset;
  const double limit = 3 * spectra::chord_sigma(A, chord);
  double square = 0.0;
  double beyond = 0.0;
  for (const double m : mco) {
    square += m * m;
    beyond += std::abs(m) > limit;
  }
  const auto count = static_cast<double>(mco.size());
  return {std::sqrt(square / count), beyond / count};
}

double ratio(double phi_c, double chord) {
  return spectra::chord_sigma({.A = A, .phi_c = phi_c}, chord) / spectra::chord_sigma(A, chord);
}

// The integral of (8) without its closed form: lobe by lobe, the rest with the mean 3/2 of the squared gain.
double sigma_by_quadrature(double chord) {
  const auto integrand = [&](double phi) {
    const double gain = spectra::chord_gain(chord, phi);
    return gain * gain * A / (phi * phi);
  };
  constexpr int lobes = 400;
  double variance = 1.5 * A * chord / (2.0 * lobes);
  for (int k = 0; k < lobes; ++k)
    variance +=
        num::integrate(integrand, std::max(1e-9, 2.0 * k / chord), 2.0 * (k + 1) / chord, 1e-9)
            .value;
  return std::sqrt(variance);
}

/*** Each corner of Table 1: */
void equation_8(report::Item& item) {
  const std::vector<double> corners{0.10, 0.11, 0.12, 0.13, 0.14, 0.18, 0.25};  // of Table 1
  const std::size_t samples = item.full() ? 8'000'000 : 500'000;
  item.expect_checks(4 + static_cast<int>(corners.size()));
  item.columns({{"corner φ<sub>c</sub>, cycle/m", "{:.2f}"},
                {"σ/(8), 9.5-m chord", "{:.4f}"},
                {"σ/(8), 19-m chord", "{:.4f}"},
                {"Monte Carlo, 19-m", "{:.4f}"},
                {"share beyond 3σ", "{:.4f}"}});
  item.agree("sigma", "(8) for the 62-ft chord", "m", spectra::chord_sigma(A, long_chord),
             sigma_by_quadrature(long_chord), 1e-6, "quadrature");
  std::uint64_t seed = 0;
  for (const double phi_c : corners) {
    const Offsets offsets = monte_carlo(phi_c, long_chord, samples, ++seed);
    const double measured = offsets.sigma / spectra::chord_sigma(A, long_chord);
    item.add_row(phi_c, ratio(phi_c, short_chord), ratio(phi_c, long_chord), measured,
                 offsets.beyond);
    item.agree(fmt::format("corner-{:.2f}", phi_c),
               fmt::format("Monte Carlo, corner {:.2f}", phi_c), "", measured,
               ratio(phi_c, long_chord), 0.02, "the closed form; statistics of the record");
  }
  const auto excess = [](double r) { return 100 * (1 / r - 1); };
  item.value("equation-8-least", excess(ratio(corners.back(), long_chord)), "%", "{:.1f}");
  item.value("equation-8-most", excess(ratio(corners.front(), long_chord)), "%", "{:.1f}");
  item.value("equation-8-short", excess(ratio(corners.front(), short_chord)), "%", "{:.0f}");
  item.value("equation-8-length", static_cast<double>(samples) * units::foot / units::kilometre,
             "km", "{:.0f}");

  const table::CsvTable printed = item.printed("equations.csv");
  const double normal = std::erf(3 / std::sqrt(2.0));
  item.value("three-sigma", 1 - normal, "", "{:.4f}");
  item.row(printed, "normal")
      .print("printed", normal,
             report::corrected(1 - spectra::normal_exceedance(3), 1e-12,
                               "cut after the second digit, not rounded"));
  item.row(printed, "chebyshev")
      .print("printed", 1 - 1 / 9.0,
             report::corrected(1 - spectra::chebyshev_exceedance(3), 1e-12,
                               "cut after the first digit, not rounded"));
  item.claim("corner-ignored", "for long chords the effect of φ_c can be ignored",
             excess(ratio(corners.front(), long_chord)) < 10,
             fmt::format("(8) is {:.1f} to {:.1f} % too high for the 19-m chord, on the safe side",
                         excess(ratio(corners.back(), long_chord)),
                         excess(ratio(corners.front(), long_chord))));
  item.value("normal-share", normal, "", "{:.4f}");
  item.value("chebyshev-share", 1 - 1 / 9.0, "", "{:.4f}");
}

}  // namespace

const report::Section chords{report::table(
    "equation-8", "Offset of a chord on the random part: what leaving the corner out costs",
    equation_8)};

}  // namespace railbook::psd_chapter
