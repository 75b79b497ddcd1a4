/*** ### Modulated: uneven joints

Real joints are not equally low. The paper names two extremes, drawn in its Figure 5: dips that vary at random from joint to
joint, and dips that come and go in groups, over a soft spot or a bridge. Here joint $j$ has the dip $B_j=B(1+m\,g_j)$ with $g_j$ normal
and the correlation $\varrho$ between neighbours: $\varrho=0$ for the first, $\varrho=e^{-1/5}$ for groups of five joints, the paper's number, for
the same mean and spread.

{{fig-05}}

For this model the spectrum has a closed form. The mean dip keeps its lines; the scatter adds a continuum,

$$S(\varphi)=2m^2B^2l\,|D(\varphi l)|^2\,\frac{1-\varrho^2}{1-2\varrho\cos2\pi\varphi l+\varrho^2},$$

with $D$ the transform of one dip. Grouped dips pile their power up around the lines: at $\varphi_0$ they have
$(1+\varrho)/(1-\varrho)$ = {{grouped-ratio}} times the density of random ones, midway between two lines as many times less.
The paper says that the spectrum cannot distinguish the two. On five miles of track, its "several", an ordinate has a standard error of
{{five-mile-error}}, so the two differ by {{distinguish-errors}} of them.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "sections.hpp"
#include "spectra/joint_dips.hpp"

namespace railbook::psd_chapter {
namespace {

constexpr double mean_dip = 10 * mm;
constexpr double resolution = 1.0 / (4096 * units::foot);
const double in_groups = std::exp(-0.2);  // five joints to a group

spectra::SyntheticTrack uneven(double correlation) {
  spectra::SyntheticTrack track;
  track.dip = mean_dip;
  track.dip_scatter = 0.5;
  track.dip_correlation = correlation;
  return track;
}

double scattered(double correlation, double phi) {
  return spectra::joint_scatter_psd({rail, mean_dip, 0.5, correlation}, phi);
}

void fig_05(report::Item& item) {
  item.rebuilt("the paper draws two examples by hand; these have the same mean and spread of dips");
  item.expect_checks(1);
  const double ratio = scattered(in_groups, phi_0) / scattered(0, phi_0);
  const auto averages = spectra::welch(std::vector<double>(26400), units::foot).averages;
  // Both spectra are estimates; their ratio's standard error is that of one ordinate times the root of two.
  const double errors = std::log(ratio) * std::sqrt(averages / 2);
  item.refute(
      "distinguish", "the PSD cannot distinguish random dips from grouped ones", errors > 3,
      fmt::format("at φ₀ five miles of each differ by {:.1f} standard errors; three are the "
                  "paper's own measure",
                  errors));
  auto track = uneven(0.0);
  track.spacing = rail / 40;
  track.seed = 3;  // one that shows a group well
  const auto random = spectra::synthesize(track, 40 * 40 + 1);
  track.dip_correlation = in_groups;
  const auto grouped = spectra::synthesize(track, 40 * 40 + 1);
  report::Data& curve = item.data({"x_m", "random_mm", "grouped_mm"});
  for (std::size_t i = 0; i < random.size(); ++i)
    curve.add(static_cast<double>(i) * track.spacing, random[i] / mm, grouped[i] / mm);
  item.value("grouped-ratio", ratio, "", "{:.1f}");
  item.value("five-mile-error", 100 / std::sqrt(averages), "%", "{:.0f}");
  item.value("distinguish-errors", errors, "", "{:.1f}");
}

/*** Figure {{fig-04}} puts the three signatures of the paper side by side.

{{fig-04}}
*/
// The power of the line at `phi` of a record of whole periods: no window, no neighbours.
double direct_power(const spectra::SyntheticTrack& track, std::size_t samples, double phi) {
  const auto z = spectra::synthesize(track, samples);
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i)
    sum += z[i] * std::polar(1.0, -2 * units::pi * phi * static_cast<double>(i) * track.spacing);
  return 2 * std::norm(sum / static_cast<double>(z.size()));
}

void fig_04(report::Item& item) {
  item.expect_checks(1);
  item.rebuilt("the paper draws the three shapes without numbers: dips of 10 mm, m = 0.5");
  spectra::SyntheticTrack linear = uneven(0.0);
  linear.dip_scatter = 0.0;
  auto nonlinear = linear;
  linear.memory_dip = 0.5 * mean_dip;
  nonlinear.memory_modulation = 0.5;
  auto fine = nonlinear;
  fine.spacing = units::foot / 10;  // at 1 ft the harmonics above the 19th fold onto the lower ones
  const double lower = direct_power(fine, 4290, phi_0 - eps);  // 11 rails of 39 ft are 13 of 33 ft
  const double upper = direct_power(fine, 4290, phi_0 + eps);
  item.claim("symmetric", "modulation produces two symmetrical sidebands at φ₀ ± ε",
             std::abs(lower / upper - 1) < 1e-3, "equal to 0.1 %, for a smooth envelope");

  const auto lines = spectra::modulated_lines(phi_0, mean_dip, 0.0, eps, 1.0);
  auto with_memory = lines;
  with_memory.push_back(
      {1 / old_rail, spectra::line_power(1, linear.memory_dip, LineConvention::exact_one_sided)});
  const auto pairs = spectra::modulated_lines(phi_0, mean_dip, 0.5, eps, 1.0);
  report::Data& curve = item.data({"phi_cycle_per_m", "random", "grouped", "single", "pair"});
  for (double phi = 0.05; phi < 0.13; phi += 0.1 * resolution) {  // ten to a side lobe
    const double line = lines_seen(lines, phi, resolution);
    curve.add(phi, line + scattered(0, phi), line + scattered(in_groups, phi),
              lines_seen(with_memory, phi, resolution), lines_seen(pairs, phi, resolution));
  }
}

/*** ### Ballast memory

Before 1939 US rails were 33 ft long. Under newer rail of 39 ft the old wavelength is still found: the old joints have worked their
way into ballast and subgrade. Figure {{fig-06}} follows the paper's drawing and the letters of its captions (the text counts them one earlier).
Under welded rail the fundamental that reworking leaves (b) simply adds (d): one extra line at 1/(33 ft). When the joints of the new
rail have loosened, each dips most where an old low spot lies (e): a modulation, whose wavenumber (5) is the difference of both,

$$\varepsilon=\frac1{10.0}-\frac1{11.9}=\frac1{6?.5}, \tag{5}$$

with a digit of the result not legible in the copy at hand. Exact feet give {{epsilon-feet}}, printed metres {{epsilon-metres}}; with $\varphi_0$
rounded to 0.084 as in Table 1 it is one over {{epsilon-rounded}}, which fits the legible characters.

{{fig-06}}

A joint feels the old pattern only where it is, and at $x=jl$ the waves $\cos2\pi x/l_{old}$ and $\cos2\pi\varepsilon x$ have the same values: hence the
sidebands. If each dip scales as a whole, the envelope is a staircase and the pair is not symmetric: the line at $\varphi_0\mp\varepsilon$ has the
amplitude $mB\,D(1\mp\varepsilon l)$, and the lower one {{staircase-ratio}} times the power. The paper's symmetric pair belongs to a smooth envelope.
*/
constexpr double modulation = 0.5;

void fig_06_curves(report::Data& curve) {
  const double fundamental = -spectra::line_strength(1, 5, LineConvention::exact_one_sided);  // mm
  for (int i = 0; i <= 715; ++i) {
    const double x =
        0.6 * i * units::foot;  // one period of everything: 429 ft; joints are among them
    const double old = -10 * (1 - spectra::rectified_sine(x, old_rail, 1.0));
    const double left = fundamental * std::cos(2 * units::pi * x / old_rail);
    const double fresh = -10 * (1 - spectra::rectified_sine(x, rail, 1.0));
    const double envelope = 1 + modulation * std::cos(2 * units::pi * eps * x);
    curve.add(x, old, left, fresh, fresh + left, envelope * fresh, -10 * envelope);
  }
}

void fig_06(report::Item& item) {
  item.rebuilt("the paper draws the patterns by hand: dips of 10 mm, m = 0.5");
  fig_06_curves(item.data(
      {"x_m", "old_mm", "fundamental_mm", "new_mm", "linear_mm", "nonlinear_mm", "envelope_mm"}));
  item.value(
      "staircase-ratio",
      std::pow(spectra::dip_transform(1 - eps * rail) / spectra::dip_transform(1 + eps * rail), 2),
      "", "{:.2f}");
  item.value("epsilon-feet", eps, "cycle/m", "{:.6f}");
  item.value("epsilon-metres", 1 / 10.0 - 1 / 11.9, "cycle/m", "{:.6f}");
  item.value("epsilon-rounded", 1 / (0.100 - 0.084), "m", "{:.1f}");
}

/*** ### All together

Independent processes add their spectra. Figure {{fig-07}} is the paper's composite, here of zone 10: on linear axes, where the peak is
plain and the continuum cannot be judged, and on logarithmic ones, where both slopes are straight and the peak looks small. The points
are the measured spectrum of {{fig-07-length}} of synthetic track.

{{fig-07}}
*/
void fig_07(report::Item& item) {
  item.expect_checks(1);
  item.rebuilt("the paper draws the sum without numbers: zone 10 of Table 1, synthetic");
  const Zone zone = zones(item).at(9);
  spectra::SyntheticTrack track = synthetic(zone.track, 1);
  track.spacing = units::foot / 4;  // at 1 ft the harmonics above the 19th fold onto the lower ones
  const double length = (item.full() ? 2500 : 500) * km;
  const spectra::Spectrum spectrum = record_spectrum(track, length, {});
  const auto lines = spectra::modulated_lines(phi_0, track.dip, 0.0, 0.0, 1.7);
  report::Data& curve = item.data({"phi_cycle_per_m", "S_random", "S_periodic", "S_composite"});
  // Ten points to a lobe of the first two lines, whose feet the picture shows; twenty to the width of the others.
  const auto step = [&](double phi) {
    const double off = std::abs(phi / phi_0 - std::round(phi / phi_0)) * phi_0;
    return phi < 2.5 * phi_0         ? std::min(0.005 * phi, 0.1 * spectrum.df)
           : off < 2.5 * spectrum.df ? 0.2 * spectrum.df
                                     : std::min(0.005 * phi, spectrum.df);
  };
  for (double phi = 0.01; phi < 1.6; phi += step(phi)) {
    const double random = spectra::random_psd(zone.track, phi);
    const double line = lines_seen(lines, phi, spectrum.df);
    curve.add(phi, random, line, random + line);
  }
  report::Data& points = item.data("measured", {"phi_cycle_per_m", "S"});
  double ratio = 0.0, peak = 0.0, expected_peak = 0.0;
  int bins = 0;
  for (Eigen::Index k = 4; spectrum.frequency(k) < 1.6; ++k) {
    const double phi = spectrum.frequency(k);
    points.add(phi, spectrum.density[k]);
    if (phi < 0.02 || phi > 1.2) continue;
    const double expected =
        spectra::random_psd(zone.track, phi) + lines_seen(lines, phi, spectrum.df);
    ratio += spectrum.density[k] / expected;
    ++bins;
    if (std::abs(phi * rail - 1.0) > 0.1) continue;
    peak += spectrum.density[k] * spectrum.df;
    expected_peak += expected * spectrum.df;
  }
  item.claim(
      "additive", "the spectra of independent processes add",
      std::abs(ratio / bins - 1) < 0.02 && std::abs(peak / expected_peak - 1) < 0.02,
      fmt::format(
          "measured over their sum: {:.3f} in the mean of 0.02 to 1.2 cycle/m, {:.3f} within "
          "10 % of φ₀; leakage into the steep slope is 1 %",
          ratio / bins, peak / expected_peak));
  item.value("fig-07-length", length / km, "km", "{:.0f}");
}

}  // namespace

const report::Section modulated{
    report::figure("fig-05", "Random and grouped dips (Fig. 5)", fig_05),
    report::figure("fig-04", "Broadening, one sideband, two sidebands (Fig. 4)", fig_04),
    report::figure("fig-06", "Ballast memory: 33-ft rails under 39-ft rails (Fig. 6)", fig_06),
    report::figure("fig-07", "Composite spectrum, linear and logarithmic (Fig. 7)", fig_07)};

}  // namespace railbook::psd_chapter
