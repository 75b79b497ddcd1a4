/*** ### Modulated: uneven joints

Real joints are not equally low. The paper names two extremes, drawn in its Figure 5: dips that vary at random from joint to
joint, and dips that come and go in groups, over a soft spot or a bridge. Here joint $j$ has the dip $B_j=B(1+m\,g_j)$ with $g_j$ normal
and the correlation $\varrho$ between neighbours: $\varrho=0$ and $\varrho=0.9$ below, for the same mean and spread.

{{fig-05}}

For this model the spectrum has a closed form. The mean dip keeps its lines, sharp as ever; the scatter adds a continuum,

$$S(\varphi)=2m^2B^2l\,|D(\varphi l)|^2\,\frac{1-\varrho^2}{1-2\varrho\cos2\pi\varphi l+\varrho^2},$$

with $D$ the transform of one dip. Random dips spread their power over all wavenumbers, grouped dips pile it up around the lines.
The paper says that the spectrum cannot distinguish the two. With the same spread of dips, the
share of the scattered power within ±0.02 cycle/m of the rail's lines is {{near-random}} for random dips and {{near-grouped}} for grouped ones; the
second looks like a broadened peak, the first hardly. (The rest of both goes into long waves and hides under $A/\varphi^2$.) Either way
(6) counts only what is near the peak, as the paper warns below its equation (5).
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "sections.hpp"
#include "spectra/rail_line.hpp"
#include "spectra/synthetic_track.hpp"
#include "spectra/welch.hpp"

namespace railbook::psd_chapter {

using spectra::LineConvention;

namespace {

constexpr double rail = 39 * units::foot;
constexpr double phi_0 = 1.0 / rail;
const double eps = 1.0 / (33 * units::foot) - phi_0;  // equation (5)
constexpr double dip = 0.010;
constexpr double resolution = 1.0 / (4096 * units::foot);

spectra::SyntheticTrack uneven(double correlation) {
  spectra::SyntheticTrack track;
  track.dip = dip;
  track.dip_scatter = 0.5;
  track.dip_correlation = correlation;
  return track;
}

spectra::JointDips joints(double correlation) {
  return {rail, dip, 0.5, correlation};
}

/*** Where the scattered power goes: */
// The share of the scattered power that lies within `width` of a line n phi_0, n >= 1.
double share_near_lines(double correlation, double width) {
  double near = 0.0;
  double all = 0.0;
  const double step = 1e-5;
  for (double phi = 0.5 * step; phi < 2.0; phi += step) {
    const double density = spectra::joint_scatter_psd(joints(correlation), phi);
    const double n = std::max(1.0, std::round(phi * rail));
    all += density;
    if (std::abs(phi - n * phi_0) < width) near += density;
  }
  return near / all;
}

/*** The two profiles come from one generator with one seed: */
void fig_05(report::Item& item) {
  item.rebuilt("the paper draws two examples by hand; these have the same mean and spread of dips");
  const double near_random = 100 * share_near_lines(0.0, 0.02);
  const double near_grouped = 100 * share_near_lines(0.9, 0.02);
  item.expect_checks(1);
  item.refute("distinguish", "the PSD cannot distinguish random dips from grouped ones",
              near_grouped > 1.5 * near_random,
              fmt::format("within .02 cycle/m of the lines lie {:.0f} % of the scattered power of "
                          "random dips, {:.0f} % of grouped ones",
                          near_random, near_grouped));
  const double spacing = rail / 40;
  auto track = uneven(0.0);
  track.spacing = spacing;
  track.seed = 3;  // one that shows a group well
  const auto random = spectra::synthesize(track, 40 * 40 + 1);
  track.dip_correlation = 0.9;
  const auto grouped = spectra::synthesize(track, 40 * 40 + 1);
  report::Data& curve = item.data({"x_m", "random_mm", "grouped_mm"});
  for (std::size_t i = 0; i < random.size(); ++i)
    curve.add(static_cast<double>(i) * spacing, 1e3 * random[i], 1e3 * grouped[i]);
  item.value("near-random", near_random, "%", "{:.0f}");
  item.value("near-grouped", near_grouped, "%", "{:.0f}");
}

/*** Figure {{fig-04}} puts the three signatures of the paper side by side, each as closed form (lines) and as the average spectrum of
{{fig-04-length}} of synthetic track (points).

{{fig-04}}

The checks compare lines of a record whose length holds whole rails of both kinds, so that each falls on one bin, with the formula:
a pair at $\varphi_0\pm\varepsilon$ with $(m/2)^2$ of the power of the carrier, and one about each harmonic. They sample every 0.1 ft. At the
usual 1 ft the harmonics above the 19th fold exactly onto the lower ones and add as amplitudes: the first line then reads
{{folded}} high.
*/
double lines_at(const std::vector<spectra::Line>& lines, double phi) {
  double density = 0.0;
  for (const spectra::Line& line : lines)
    density += line.power * hann_line(phi - line.phi, resolution);
  return density;
}

// The power of the line at `phi` of a record of whole periods: no window, no neighbours.
double direct_power(const std::vector<double>& z, double spacing, double phi) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i)
    sum += z[i] * std::polar(1.0, -2 * units::pi * phi * static_cast<double>(i) * spacing);
  return 2 * std::norm(sum / static_cast<double>(z.size()));
}

/*** The four lines against their formula: */
void check_lines(report::Item& item, spectra::SyntheticTrack track) {
  const double Q_1 = spectra::line_power(1, dip, LineConvention::exact_one_sided);
  const double Q_2 = spectra::line_power(2, dip, LineConvention::exact_one_sided);
  const double share = track.memory_modulation * track.memory_modulation / 4;
  auto plain = track;
  plain.memory_modulation = 0.0;
  const auto coarse = spectra::synthesize(plain, 39);
  const auto folded = [&](int n) {
    const double true_power = spectra::line_power(n, dip, LineConvention::exact_one_sided);
    return 100 * (direct_power(coarse, plain.spacing, n * phi_0) / true_power - 1);
  };
  item.value("folded", folded(1), "%", "{:.2f}");
  item.value("folded-12", folded(12), "%", "{:.0f}");
  track.spacing = units::foot / 10;
  const auto z = spectra::synthesize(track, 4290);  // 11 rails of 39 ft are 13 of 33 ft
  const auto agree = [&](const char* id, const char* what, double phi, double power) {
    item.agree(id, what, "m²", direct_power(z, track.spacing, phi), power, 1e-3, "the formula");
  };
  agree("carrier", "line at φ₀", phi_0, Q_1);
  agree("lower", "sideband at φ₀ − ε", phi_0 - eps, share * Q_1);
  agree("upper", "sideband at φ₀ + ε", phi_0 + eps, share * Q_1);
  const double lower = direct_power(z, track.spacing, phi_0 - eps),
               upper = direct_power(z, track.spacing, phi_0 + eps);
  item.claim("symmetric", "modulation produces two symmetrical sidebands at φ₀ ± ε",
             std::abs(lower / upper - 1) < 1e-3, "equal to 0.1 %, for a smooth envelope");
  agree("second", "sideband at 2φ₀ − ε", 2 * phi_0 - eps, share * Q_2);
}

/*** The figure: */
void fig_04(report::Item& item) {
  item.expect_checks(5);
  item.rebuilt("the paper draws the three shapes without numbers; ours: dips of 10 mm, m = 0.5");
  auto linear = uneven(0.0);
  linear.dip_scatter = 0.0;
  auto nonlinear = linear;
  linear.memory_dip = 0.5 * dip;
  nonlinear.memory_modulation = 0.5;
  check_lines(item, nonlinear);

  const double length = (item.full() ? 1000 : 200) * units::kilometre;
  const auto random_dips = record_spectrum(uneven(0.0), length, {});
  const auto grouped_dips = record_spectrum(uneven(0.9), length, {});
  const auto one_sideband = record_spectrum(linear, length, {});
  const auto two_sidebands = record_spectrum(nonlinear, length, {});
  report::Data& points = item.data({"phi_cycle_per_m", "random", "grouped", "single", "pair"});
  for (Eigen::Index k = 60; k < 170; ++k)
    points.add(random_dips.frequency(k), random_dips.density[k], grouped_dips.density[k],
               one_sideband.density[k], two_sidebands.density[k]);

  const auto plain = spectra::modulated_lines(phi_0, dip, 0.0, eps, 1.0);
  auto with_memory = plain;
  with_memory.push_back(
      {1.0 / linear.memory_length,
       spectra::line_power(1, linear.memory_dip, LineConvention::exact_one_sided)});
  const auto pairs = spectra::modulated_lines(phi_0, dip, 0.5, eps, 1.0);
  report::Data& curve =
      item.data("formula", {"phi_cycle_per_m", "random", "grouped", "single", "pair"});
  for (double phi = 0.05; phi < 0.13; phi += 0.02 * resolution) {
    const double line = lines_at(plain, phi);
    curve.add(phi, line + spectra::joint_scatter_psd(joints(0.0), phi),
              line + spectra::joint_scatter_psd(joints(0.9), phi), lines_at(with_memory, phi),
              lines_at(pairs, phi));
  }
  item.value("fig-04-length", length / units::kilometre, "km", "{:.0f}");
}

}  // namespace

const report::Section modulated{
    report::figure("fig-05", "Random and grouped dips (Fig. 5)", fig_05),
    report::figure("fig-04", "Broadening, one sideband, two sidebands (Fig. 4)", fig_04)};

}  // namespace railbook::psd_chapter
