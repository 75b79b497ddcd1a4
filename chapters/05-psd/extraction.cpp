/*** ## Reading the parameters off a spectrum

The paper lays two straight lines on each measured spectrum, of slope −2 at the long waves and −4 at
the short ones. The height of the first gives $A$, and where they meet is $\varphi_c$. The function
`lay_two_lines` does this by least squares instead of by eye. It tries many corners and divides the
spectrum by (4) with each of them and $A=1$. At the right corner the quotient is $A$ at every
wavenumber, so the function keeps the corner at which its logarithms scatter least, and their mean
is $\ln A$. Bins near the joints' lines are left out. A mean of logarithms is too low when the
numbers scatter: here by half the reciprocal of the number of averages, which the code adds.

{{code: method.cpp lay_two_lines}}

Then the paper takes the height $C_1$ (m²/(cycle/m)) of the first peak above the two straight lines
and its width $\beta$ (cycle/m) at half that height. Their product is the power $Q_1$ of the line,
and (1) and (2) with $n=1$ give the dip:

$$Q_1 = \beta\, C_1 \tag{6}$$

$$B = 3\pi\sqrt{\tfrac12\beta C_1}. \tag{7}$$

The function `read_peak` sums what stands above the two straight lines within 0.02 cycle/m of
$\varphi_0$, which is $Q_1$ itself, and takes the highest value for $C_1$. As a width it returns
$Q_1/C_1$, that of a rectangle of the same area and height; the paper's $\beta$ is the width at half
the height.

{{code: method.cpp read_peak}}

::: {.fold summary="The six measured spectra of the paper, with synthetic track in their place"}

The paper shows six measured spectra as pictures, which our copy does not have. {{fig-08}} shows
synthetic track with the printed $A$, $\varphi_c$ and peak of the same zones. Where the printed
$\beta$ is wider than the window, the joints are given random depths, with depth and correlation
chosen so that height and width of the peak are the printed $C_1$ and $\beta$; they scatter by ten
times their mean, so that nearly half of the joints are humps. A narrow peak comes from equal
joints.

{{fig-08}}

In the paper, panels (c) and (d) are examples of ballast memory; ours do not show it. Table 1 calls
zone 11, panel (d), an "Example of ballast memory". Beside zones 1 to 3 it says the same of one of
the three: the digit reads 3, but panel (c) is zone 2. Our track has no line at 1/(33 ft) and no
sidebands, only a broad peak of the printed width, {{beta-2}} and {{beta-11}} cycle/m. The old
rail's line is {{epsilon-off}} cycle/m from $\varphi_0$ and so lies inside such a peak; how high it
is, the print does not say.

:::

The power is the area under the peak. Equation (6) takes that of a rectangle, as high as the peak
and as wide as the peak is at half its height ({{fig-09}}). A peak of the shape of a resonance curve
has {{lorentz}} times this area, and $B$ by (6) and (7) is then {{lorentz-B}} too small. Where
$\beta$ is wide, the random depths of the joints also lift the spectrum between the peaks. The
regression takes this for roughness, and $A$ comes out high, in zone 12 ({{fig-08}}) by
{{lifted-12}}.

{{fig-09}}

### The narrow peaks are as wide as the window

Five zones have $\beta$ = 0.010 cycle/m. A line of no width at all looks nearly as wide,
{{beta-512}} cycle/m at half its height, if it is analysed in segments of 512 ft under a Hann
window. So 0.010 is probably the resolution of the paper's analysis, and $C_1$ of these zones says
as much about the window as about the track.

::: {.fold summary="A line of no width in segments of three lengths"}

{{resolution}}

The area $Q_1$ of the peak does not depend on the segment. The product $\beta C_1$ of (6) is
{{resolution-least}} to {{resolution-most}} of it.

:::
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/spectrum_fit.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr std::size_t paper_segment = 512;  // samples of 1 ft: a guess at the paper's analysis
constexpr std::size_t shown[]{7, 10, 2, 11, 12, 13};  // Figure 8 (a) to (f)

bool broad(const Zone& zone) {
  return zone.beta > 0.015;
}

// How a broad peak is made (`reconstructed_track`): depths B_j of a correlation rho from joint to
// joint spread the line into a resonance curve whose width follows from rho alone, the root of
// rho^2 - (4 - 2 cos(pi beta l)) rho + 1 = 0. The peak's height then fixes the scatter of the
// depths. Their mean is made small, so that hardly any sharp line is left in the middle. (The shape
// of a dip, falling off with phi, skews the peak a little.)
spectra::SyntheticTrack reconstructed_track(const Zone& zone) {
  spectra::SyntheticTrack track = synthetic(zone.track, 80 + std::stoul(zone.name));
  track.rail_length = 1 / zone.track.phi_0;
  if (broad(zone)) {
    const double p = 2 - std::cos(units::pi * zone.beta * track.rail_length);
    track.dip_correlation = p - std::sqrt(p * p - 1);
    track.dip_scatter = 10;  // times the mean: of the sharp line 1/100 of the power is left
    const spectra::JointDips unit{.rail_length = track.rail_length,
                                  .dip = 1,
                                  .scatter = track.dip_scatter,
                                  .correlation = track.dip_correlation};
    track.dip = std::sqrt(zone.C_1 / spectra::joint_scatter_psd(unit, zone.track.phi_0));
  }
  return track;
}

struct ZoneSpectrum {
  Zone zone;
  spectra::Spectrum spectrum;
  spectra::SpectrumFit fit;
};

const std::vector<ZoneSpectrum>& readings(const report::Item& item) {
  static const auto result = [&] {
    std::vector<ZoneSpectrum> made;
    for (const std::size_t number : shown) {
      const Zone zone = zones(item).at(number - 1);
      const auto spectrum =
          record_spectrum(reconstructed_track(zone), 40 * km, {.segment = paper_segment});
      made.push_back(
          {zone, spectrum,
           spectra::fit_track_spectrum(spectrum, {.rail_length = 1 / zone.track.phi_0,
                                                  .line_half_width = broad(zone) ? 0.035 : 0.02})});
    }
    return made;
  }();
  return result;
}

void fig_08(report::Item& item) {
  auto& measured = item.data({"zone", "phi_cycle_per_m", "S_over_printed"});
  auto& lines = item.data("lines", {"zone", "phi_cycle_per_m", "fitted_over_printed"});
  auto& marks = item.data("marks", {"zone", "phi_cycle_per_m", "peak_over_printed", "phi_c"});
  for (const ZoneSpectrum& r : readings(item)) {
    const std::string& name = r.zone.name;
    for (Eigen::Index k = 2; k < r.spectrum.density.size(); ++k)
      if (r.spectrum.frequency(k) < 1.2)
        measured.add(
            name, r.spectrum.frequency(k),
            r.spectrum.density[k] / spectra::random_psd(r.zone.track, r.spectrum.frequency(k)));
    measured.gap();
    for (double phi = 0.01; phi < 1.2; phi *= 1.05)
      lines.add(name, phi,
                std::exp(r.fit.regression.log_density(std::log(phi))) /
                    spectra::random_psd(r.zone.track, phi));
    lines.gap();
    marks.add(name, r.zone.track.phi_0,
              1 + r.zone.C_1 / spectra::random_psd(r.zone.track, r.zone.track.phi_0),
              r.zone.track.phi_c);
  }
  item.rebuilt(
      "the paper's spectra are not in our copy: synthetic track with the printed parameters; (c) "
      "and (d) show no ballast memory, of which the paper's are examples");
  report::values(item, "", "{:.3f}", "beta-2", zones(item).at(1).beta, "beta-11",
                 zones(item).at(10).beta, "epsilon-off", eps);
  for (const ZoneSpectrum& r : readings(item))
    if (r.zone.name == "12")
      item.value("lifted-12", 100 * (r.fit.A.value / r.zone.track.A - 1), "%", "{:.0f}");
}

// Equal joints, no roughness.
void table_resolution(report::Item& item) {
  item.added("what a window makes of a line of no width");
  const Zone zone = zones(item).at(6);
  const double Q_1 = spectra::line_power(1, zone.track.B, LineConvention::printed);
  item.expect_checks(2);
  item.columns({{"segment, ft", "{:.0f}"},
                {"bin, cycle/m", "{:.5f}"},
                {"width at half height, cycle/m", "{:.4f}"},
                {"Q₁/C₁, cycle/m", "{:.4f}"},
                {"C₁ of zone 7, m²/(cycle/m)", "{:.2e}"},
                {"Q₁, m²", "{:.2e}"}});
  std::vector<double> of_area;  // height times width at half height, over the area
  for (const std::size_t segment : {256U, 512U, 4096U}) {
    spectra::SyntheticTrack joints = synthetic(zone.track, 1);
    joints.A = 0;
    const auto spectrum = record_spectrum(joints, 20 * km, {.segment = segment});
    const auto fit = spectra::fit_track_spectrum(spectrum);
    item.add_row(double(segment), spectrum.df, fit.half_width, fit.beta, fit.C_1, fit.Q_1.value);
    of_area.push_back(fit.half_width * fit.C_1 / fit.Q_1.value);
    if (segment != paper_segment) continue;
    item.print("beta", "width of a line at half its height, 512 ft", "cycle/m", "0.010",
               fit.half_width,
               report::fitted("the segment length was chosen for it",
                              report::relative(0.12, "of the powers of two 512 comes closest")));
    item.value("beta-512", fit.half_width, "", "{:.4f}");
    item.agree("Q1", "power under the peak", "m²", fit.Q_1.value, Q_1, 0.01, "equation (2)");
  }
  const auto [least, most] = std::ranges::minmax(of_area);
  report::values(item, "", "{:.2f}", "resolution-least", least, "resolution-most", most);
}

void fig_09(report::Item& item) {
  item.value("lorentz", units::pi / 2, "", "{:.2f}");
  item.value("lorentz-B", 100 * (1 - std::sqrt(2 / units::pi)), "%", "{:.0f}");
  const Zone zone = zones(item).at(6);
  const double Q_1 = spectra::line_power(1, zone.track.B, LineConvention::printed);
  const double df = 1 / (static_cast<double>(paper_segment) * units::foot);
  const double top = zone.track.phi_0, under = spectra::random_psd(zone.track, top);
  const double C_1 = Q_1 * hann_line(0, df);
  double half = 0;  // of the width at half the height
  while (hann_line(half, df) > hann_line(0, df) / 2) half += 1e-4 * df;
  const double beta = 2 * half;
  auto& curve = item.data({"phi_cycle_per_m", "S_random", "S_total"});
  for (double phi = 0.055; phi < 0.1151; phi += 0.0002) {
    const double random = spectra::random_psd(zone.track, phi);
    curve.add(phi, random, random + Q_1 * hann_line(phi - top, df));
  }
  auto& box = item.data("box", {"phi_cycle_per_m", "S"});
  for (const double side : {-0.5, 0.5}) {
    const double foot = spectra::random_psd(zone.track, top + side * beta);
    box.add(top + side * beta, side < 0 ? foot : under + C_1);
    box.add(top + side * beta, side < 0 ? under + C_1 : foot);
  }
  auto& marks = item.data("marks", {"phi_0", "S_under", "S_peak"});
  marks.add(top, under, under + C_1);
  item.rebuilt("the paper's drawing is not in our copy: zone 7, from its formula");
}

}  // namespace

const report::Section extraction{report::figure("fig-08", fig_08), report::figure("fig-09", fig_09),
                                 report::table("resolution", table_resolution)};

}  // namespace railbook::psd_chapter
