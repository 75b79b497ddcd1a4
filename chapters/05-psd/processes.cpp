/*** ## Three processes

### Periodic: the rectified sine

Rails of length $l$ sag at their joints. The paper draws the profile as a rectified sine, $z=B\,|\sin(\pi x/l)|$: crests at mid rail,
joints a depth $B$ below them (figure {{fig-01}}), with dips of up to 7.6 cm reported.

{{fig-01}}

Its spectrum is a row of lines at $n\varphi_0$, $\varphi_0=1/l$. Equations (1) and (2) of the paper are

$$B_n=\frac{2B}{(4n^2-1)\pi} \tag{1}$$

$$Q_n=\tfrac12B_n^2 . \tag{2}$$

**Two conventions.** The Fourier series is $B|\sin\pi\varphi_0x|=\frac{2B}{\pi}-\sum_n\frac{4B}{\pi(4n^2-1)}\cos2\pi n\varphi_0x$. So $B_n$ as
printed is the modulus of the two-sided, complex coefficient, but (2) halves its square as if it were the amplitude of the cosine. The power of
a line in a one-sided density is four times the printed one, and a measured line is read by (7) as a dip twice as deep as it is. No other reading
helps: a two-sided density would spoil (8), which is exact for a one-sided one. The sum over all lines decides, since it must be the
variance $B^2(\frac12-\frac4{\pi^2})$ = {{line-variance}} $B^2$: the exact powers give {{line-sum-exact}}, the printed ones
{{line-sum-printed}}.

Both are kept, by name. *Printed* $B$ belongs to (7), (10) and the tables; the *physical dip* is half of it. Classes
do not depend on the choice as long as it is kept: the same line power enters (10) with the printed $B$ and $\gamma=2$, or with the
physical dip and $\gamma=4$.

{{code: spectra/rail_line.cpp line_power}}

{{lines}}

The printed $Q_2$ is the rounded $Q_1$ divided by 25, which loses its last digit.
*/
#include <algorithm>
#include <cmath>

#include "num/fft.hpp"
#include "sections.hpp"

namespace railbook::psd_chapter {

double line_power_by_transform(std::size_t n) {
  num::RealFft fft{1 << 14};
  const auto samples = static_cast<double>(fft.size());
  for (std::size_t i = 0; i < fft.size(); ++i)
    fft.real()[i] = spectra::rectified_sine(static_cast<double>(i) / samples, 1.0, 1.0);
  fft.forward();
  return 2.0 * std::norm(fft.spectrum()[n]) / (samples * samples);
}

namespace {

void fig_01(report::Item& item) {
  item.rebuilt("the paper's drawing has no scale: the formula with 39-ft rails");
  report::Data& curve = item.data({"x_m", "z_over_B"});
  for (int i = 0; i <= 1000; ++i) {
    const double x = 4 * rail * i / 1000.0;
    curve.add(x, spectra::rectified_sine(x, rail, 1.0));
  }
}

void lines(report::Item& item) {
  const auto power = [](LineConvention c) {
    return [c](int n) { return spectra::line_power(n, 1, c); };
  };
  const auto as_printed = power(LineConvention::printed),
             exact = power(LineConvention::exact_one_sided);
  const double variance = spectra::rectified_sine_variance(1.0);
  item.expect_checks(5);
  item.columns({{"n", "{:.0f}"},
                {"wavelength, m", "{:.3f}"},
                {"Qₙ/B² as printed in (2)", "{:.5e}"},
                {"Qₙ/B² exact, one-sided", "{:.5e}"},
                {"share of the variance, %", "{:.3f}"}});
  for (int n = 1; n <= 4; ++n)
    item.add_row(double(n), rail / n, as_printed(n), exact(n), 100 * exact(n) / variance);
  const table::CsvTable printed = item.printed("equations.csv");
  item.row(printed, "Q1").print("printed", as_printed(1));
  item.row(printed, "Q2")
      .print("printed", as_printed(2),
             report::corrected(
                 line_power_by_transform(2) / 4, 1e-5,
                 "the paper divided its rounded Q₁ by 25; a quarter of the line's power by "
                 "transform"));
  for (const int n : {1, 2})
    item.agree(fmt::format("Q{}-exact", n), fmt::format("exact line {}", n), "B²", exact(n),
               line_power_by_transform(static_cast<std::size_t>(n)), 1e-6,
               "a transform of the sampled profile");
  double sum_printed = 0, sum_exact = 0;
  for (int n = 1; n <= 2000; ++n) sum_printed += as_printed(n), sum_exact += exact(n);
  item.agree("sum", "sum of the exact lines", "B²", sum_exact, variance, 1e-9,
             "the variance of the rectified sine");
  item.value("Q2", as_printed(2), "", "{:.3e}");
  item.value("line-variance", variance, "", "{:.6f}");
  item.value("line-sum-exact", sum_exact, "", "{:.6f}");
  item.value("line-sum-printed", sum_printed, "", "{:.6f}");
}

}  // namespace

/*** ### Resolution

A spectrum from segments of length $T$ cannot show a line narrower than about $1/T$. Each line takes the shape of the window's own
spectrum and keeps its area; peak and width are then properties of the analysis. Figure {{fig-02}} is the paper's drawing, with the
Hann window: lines, window, and the lines seen through it, for 1024 samples of 1 ft (solid) and for 256 (dashed).

{{fig-02}}
*/
double hann_line(double offset, double df) {
  const double u = std::abs(offset / df);
  const double amplitude = u < 1e-9 ? 1.0
                           : std::abs(u - 1) < 1e-9
                               ? 0.5
                               : std::sin(units::pi * u) / (units::pi * u * (1 - u * u));
  return amplitude * amplitude / (1.5 * df);
}

double lines_seen(const std::vector<spectra::Line>& lines, double phi, double df) {
  double density = 0.0;
  for (const spectra::Line& line : lines) density += line.power * hann_line(phi - line.phi, df);
  return density;
}

namespace {

void fig_02(report::Item& item) {
  item.expect_checks(2);
  item.rebuilt("the paper's drawing has no scale: dips of 10 mm, 39-ft rails, Hann window");
  const auto lines = spectra::modulated_lines(phi_0, 10 * mm, 0, 0, 8.5 * phi_0);
  const double fine = 1.0 / (1024 * units::foot), broad = 1.0 / (256 * units::foot);
  report::Data& convolved = item.data({"phi_cycle_per_m", "S_fine", "S_broad"});
  report::Data& window = item.data("window", {"phi_cycle_per_m", "W_fine", "W_broad"});
  report::Data& line = item.data("lines", {"phi_cycle_per_m", "Q_mm2"});
  for (int i = 1; i <= 1500; ++i) {
    const double phi = 0.0002 * i;
    convolved.add(phi, lines_seen(lines, phi, fine), lines_seen(lines, phi, broad));
  }
  for (int i = -300; i <= 300; ++i)
    window.add(0.0002 * i, hann_line(0.0002 * i, fine), hann_line(0.0002 * i, broad));
  for (std::size_t n = 0; n < 3; ++n) line.add(lines[n].phi, lines[n].power / (mm * mm));
  for (const auto& [id, df] : {std::pair{"area-1024", fine}, {"area-256", broad}}) {
    const double step = 0.01 * df;
    double area = 0.0;
    for (double phi = 0.5 * phi_0; phi < 1.5 * phi_0; phi += step)
      area += step * lines_seen(lines, phi, df);
    item.agree(id, "area about the first line", "m²", area, lines[0].power, 2e-3,
               "the power of the line; 0.1 % are tails and neighbours");
  }
}

/*** ### Random: two slopes

Under the lines lies a continuum, first (3), with a corner (4),

$$S_z(\varphi)=A/\varphi^2 \tag{3}$$

$$S_z(\varphi)=\begin{cases}A/\varphi^2,&\varphi<\varphi_c\\ A\varphi_c^2/\varphi^4,&\varphi>\varphi_c\end{cases} \tag{4}$$

The paper reads it as a random walk: survey accuracy falls with distance, which makes the $-2$; the stiffness of the rail holds
the short waves, which makes the $-4$ beyond the corner. Waves above about 100 m belong to the design of the line; the $-2$ is
kept there for convenience.

A single estimated ordinate scatters by as much as itself (the paper cites Kendall and Stuart for it). Only averages over
segments, that is over miles, and over neighbouring wavenumbers make a spectrum readable. Figure {{fig-03}} shows both on five miles of
synthetic track. Over many such records the ordinates of one segment have a standard error of {{raw-scatter}}, those of the
five-mile average {{mean-scatter}}.

{{fig-03}}

The track comes from a generator whose spectrum is (4) by construction: white noise, a symmetric filter that shapes the
*slope* (flat towards long waves, so the filter is short), and a leaky sum that makes the profile of it. Its density follows from its
own coefficients without statistics: from 0.005 to 1.2 cycle/m it stays within {{generator-error}} of (4), the worst place being the
corner, which a finite filter rounds. Below $10^{-4}$ cycle/m (10 km) it levels off.
*/
constexpr spectra::TrackParameters fair_track{.A = 2.0e-7, .phi_c = 0.12};  // zone 4 of Table 1

/*** The scatter is measured, not assumed: many records, each an independent estimate of the same spectrum. */
struct OrdinateScatter {
  double measured = 0, predicted = 0;  // relative standard error of an ordinate, bins 20 to 1500
  double error = 0;  // of the measured, relative: as gamma variates of shape K scatter
};
OrdinateScatter scatter(std::size_t samples, int records) {
  spectra::TrackGenerator generator{synthetic(fair_track, 1)};
  std::vector<double> z(samples);
  OrdinateScatter result;
  double square = 0.0;
  for (int r = 0; r < records; ++r) {
    generator.fill(z);
    const spectra::Spectrum spectrum = spectra::welch(z, units::foot);
    const double K = spectrum.averages;
    result.predicted = 1.0 / std::sqrt(K);
    result.error = 0.5 * std::sqrt((2 + 6 / K) * K * spectrum.band_variance / (1480.0 * records));
    for (Eigen::Index k = 20; k < 1500; ++k) {
      const double model = spectra::random_psd(fair_track, spectrum.frequency(k));
      square += std::pow(spectrum.density[k] / model - 1, 2) / (1480.0 * records);
    }
  }
  result.measured = std::sqrt(square);
  return result;
}

void fig_03(report::Item& item) {
  item.expect_checks(3);
  item.rebuilt("the paper draws a smooth curve without numbers: zone 4 of Table 1, synthetic");
  const spectra::SyntheticTrack track = synthetic(fair_track, 1);
  const auto five_miles = static_cast<std::size_t>(5 * units::mile / units::foot);
  const std::vector<double> z = spectra::synthesize(track, five_miles);
  const spectra::Spectrum one = spectra::welch(std::span{z}.first(4096), units::foot);
  const spectra::Spectrum all = spectra::welch(z, units::foot);
  report::Data& raw = item.data({"phi_cycle_per_m", "S_one", "S_five_miles", "S_model"});
  for (Eigen::Index k = 8; k < all.density.size() - 1; ++k)
    raw.add(all.frequency(k), one.density[k], all.density[k],
            spectra::random_psd(fair_track, all.frequency(k)));
  const spectra::BandSpectrum bands = spectra::band_average(all, 6, 0.006, 1.5);
  report::Data& band = item.data("bands", {"phi_cycle_per_m", "S"});
  for (Eigen::Index k = 0; k < bands.density.size(); ++k)
    band.add(bands.frequency[k], bands.density[k]);

  const OrdinateScatter single = scatter(4096, 100), averaged = scatter(five_miles, 40);
  item.agree("raw-scatter", "standard error of one ordinate of one segment", "", single.measured,
             single.predicted, by_chance(2) * single.error,
             "the exponential distribution of a periodogram");
  item.agree("mean-scatter", "standard error of one ordinate of five miles", "", averaged.measured,
             averaged.predicted, by_chance(2) * averaged.error,
             "the number of averages, overlap counted");
  item.claim("ordinate", "the standard error of an ordinate can be of the order of the ordinate",
             single.measured > 0.5 && single.measured < 2,
             fmt::format("{:.2f} of it, within the factor two", single.measured));
  item.value("raw-scatter", 100 * single.measured, "%", "{:.0f}");
  item.value("mean-scatter", 100 * averaged.measured, "%", "{:.0f}");
  const spectra::TrackGenerator generator{track};
  double worst = 0.0;
  for (double phi = 0.005; phi < 1.2; phi *= 1.003)
    worst = std::max(
        worst,
        std::abs(generator.random_density(phi) / spectra::random_psd(fair_track, phi) - 1.0));
  item.value("generator-error", 100 * worst, "%", "{:.2f}");
}

}  // namespace

const report::Section processes{
    report::figure("fig-01", "Rectified sine of 39-ft rails (Fig. 1)", fig_01),
    report::table("lines", "Line powers of the rectified sine, equations (1) and (2)", lines),
    report::figure("fig-02", "Lines, resolution, and lines seen through it (Fig. 2)", fig_02),
    report::figure("fig-03", "Random part: one segment, five miles, bands, model (Fig. 3)",
                   fig_03)};

}  // namespace railbook::psd_chapter
