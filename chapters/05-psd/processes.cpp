/*** ## From a record to its spectrum

The *power spectral density* (PSD, here also *spectrum*) $S_z$ of a record of heights $z$ tells how
the variance of $z$ is spread over the *wavenumber* $\varphi$, the number of waves a metre. Its unit
is m² per cycle/m. The area under it between two wavenumbers, also called *power*, is the variance
of that part of the record. A *one-sided* density has all of it at positive wavenumbers. A
*two-sided* one has half of it at negative wavenumbers, and so is half as high.

The value of a spectrum at one wavenumber is called an *ordinate*. Its *standard error* is the
scatter that it would show over many records of the same track. For a single Fourier transform this
is as large as the ordinate itself, so Welch's method averages over many pieces of the record.

The function `average_spectrum` cuts the record into segments of `n` samples that overlap by half.
It takes the best straight line off each segment, multiplies it by a Hann window (a bell that is
zero at both ends, so that the cut ends add no waves), transforms it, and averages the squares. The
ordinates are one *bin* apart, the reciprocal of the length of a segment. The factor 2 makes the
density one-sided, and the sum of the squared weights makes its area the variance.

{{code: method.cpp average_spectrum}}

## Three processes

The paper takes the profile of a rail as a sum of processes: one that repeats with the rail length,
one that is random, and one that modulates the first, so that the depth of the joints varies. Each
leaves its own mark in the spectrum.

### Periodic: the rectified sine

Rails of length $l$ sag at their joints. The paper describes the profile along the distance $x$ as a
rectified sine, $z=b\,|\sin(\pi x/l)|$: crests at mid rail, joints a depth $b$ below them
({{fig-01}}), with dips of up to 7.6 cm reported. The paper calls this depth $B$, but the number $B$
that its formulas give is not the same.

{{fig-01}}

What repeats with the length $l$ has power only at $\varphi_0=1/l$ and its multiples $n\varphi_0$:
the spectrum of the rectified sine is a row of *lines*. With $B_n$ for the amplitude of line $n$ and
$Q_n$ for its power (m²), equations (1) and (2) of the paper are

$$B_n=\frac{2B}{(4n^2-1)\pi} \tag{1}$$

$$Q_n=\tfrac12B_n^2 . \tag{2}$$

**Two conventions.** The Fourier series of the profile is
$b|\sin\pi\varphi_0x|=\frac{2b}{\pi}-\sum_n\frac{4b}{\pi(4n^2-1)}\cos2\pi n\varphi_0x$. With
$B=b$, the amplitude of its cosines is twice the printed $B_n$, which is the modulus of the complex
coefficient and belongs to a two-sided spectrum. But (2) halves its square as if it were the
amplitude of a cosine. In a one-sided density a line therefore has four times the printed power.

The sum over all lines shows this. It must be the variance of the profile,
$b^2(\frac12-\frac4{\pi^2})$ = {{line-variance}} $b^2$. The exact powers add up to
{{line-sum-exact}} $b^2$, the printed ones with $B=b$ to {{line-sum-printed}} $b^2$.

What this makes of the dips depends on how the paper measured its spectra, which it does not say. If
they were one-sided, the paper's formula (7) gives dips twice as deep as they are, $B=2b$. If they
were two-sided, $B$ would be $\sqrt2\,b$. We take them as one-sided, for the reason given at (8),
and keep two numbers apart: the *printed* $B$, which goes into (7), (10) and the tables, and the
*physical dip* $b=B/2$.

The convention changes neither the number $B$ that (7) makes of a peak nor the part $4B^2$ of rule
(10). It changes what $B$ means, and the factor $k$ of the random part: if the densities were
two-sided, $k$ would be twice as large, and zone 7 would leave its printed class ({{table-k}}).

The function `line_power` of the library has both conventions. {{lines}} gives the first three lines
in each.

{{code: spectra/rail_line.cpp line_power}}

{{lines}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/fft.hpp>

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

report::Expectation truncated(const std::string& printed) {
  return report::absolute(2 * report::half_last_digit(printed),
                          "one unit of the last digit: truncated, not rounded");
}

namespace {

void fig_01(report::Item& item) {
  item.rebuilt("the paper's drawing is not in our copy: the formula with 39-ft rails");
  report::Data& curve = item.data({"x_m", "z_over_B"});
  for (int i = 0; i <= 1000; ++i) {
    const double x = 4 * rail * i / 1000.0;
    curve.add(x, spectra::rectified_sine(x, rail, 1.0));
  }
}

void lines(report::Item& item) {
  const double variance = spectra::rectified_sine_variance(1.0);
  const auto as_printed = [](int n) { return spectra::line_power(n, 1, LineConvention::printed); };
  const auto exact = [](int n) {
    return spectra::line_power(n, 1, LineConvention::exact_one_sided);
  };
  item.expect_checks(3);
  item.columns({{"n", "{:.0f}"},
                {"wavelength, m", "{:.3f}"},
                {"Qₙ/B² as printed in (2)", "{:.5e}"},
                {"Qₙ/b² exact, one-sided", "{:.5e}"},
                {"fraction of the variance, %", "{:.3f}"}});
  for (int n = 1; n <= 3; ++n)
    item.add_row(double(n), rail / n, as_printed(n), exact(n), 100 * exact(n) / variance);
  const table::CsvTable printed = item.printed("equations.csv");
  item.row(printed, "Q1").print("printed", as_printed(1));
  const report::Row row = item.row(printed, "Q2");
  row.print("printed", as_printed(2), truncated(row.printed("printed")));
  item.agree("Q1-exact", "exact line 1, one-sided", "b²", exact(1), line_power_by_transform(1),
             1e-6, "a transform of the sampled profile");
  double sum_printed = 0, sum_exact = 0;
  for (int n = 1; n <= 2000; ++n) sum_printed += as_printed(n), sum_exact += exact(n);
  report::values(item, "", "{:.6f}", "line-variance", variance, "line-sum-exact", sum_exact,
                 "line-sum-printed", sum_printed);
}

}  // namespace

/*** ### Resolution

A line has no width, but a spectrum from segments of length $T$ cannot show it narrower than about
$1/T$. It takes the shape of the window's own spectrum ({{fig-02}}) and keeps its area, the power
$Q_n$. Its height and its width are then properties of the analysis and not of the track, which is
why the paper uses the area.

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

// The area under the first line of equal dips of 10 mm, in the estimate from segments of so many
// feet.
double area_of_first_line(std::size_t segment) {
  const auto estimate = record_spectrum({.dip = 10 * mm}, 20 * km, {.segment = segment});
  double area = 0;
  for (Eigen::Index k = 0; k < estimate.density.size(); ++k)
    if (std::abs(estimate.frequency(k) / phi_0 - 1) < 0.5)
      area += estimate.density[k] * estimate.df;
  return area;
}

void fig_02(report::Item& item) {
  item.rebuilt("the paper's drawing is not in our copy: dips of 10 mm, 39-ft rails, Hann window");
  const auto lines = spectra::modulated_lines(phi_0, 10 * mm, 0, 0, 8.5 * phi_0);
  const double fine = 1.0 / (1024 * units::foot), broad = 1.0 / (256 * units::foot);
  report::Data& convolved = item.data({"phi_cycle_per_m", "S_fine", "S_broad"});
  report::Data& window = item.data("window", {"phi_cycle_per_m", "W_fine", "W_broad"});
  report::Data& line = item.data("lines", {"phi_cycle_per_m", "Q_mm2"});
  for (int i = 1; i <= 1500; ++i) {
    const double phi = 0.0002 * i, S_fine = lines_seen(lines, phi, fine),
                 S_broad = lines_seen(lines, phi, broad);
    convolved.add(phi, S_fine, S_broad);
  }
  for (int i = -300; i <= 300; ++i)
    window.add(0.0002 * i, hann_line(0.0002 * i, fine), hann_line(0.0002 * i, broad));
  for (std::size_t n = 0; n < 3; ++n) line.add(lines[n].phi, lines[n].power / (mm * mm));
  const double power = spectra::line_power(1, 10 * mm, LineConvention::exact_one_sided);
  const double broad_area = area_of_first_line(256) / power,
               fine_area = area_of_first_line(1024) / power;
  item.claims({{"area", {broad_area, fine_area, broad_area / fine_area - 1}}});
}

/*** ### Random: two slopes

Under the lines lies the random part, a smooth *continuum*. The paper first gives it one slope, (3),
and then a second one beyond the corner at the wavenumber $\varphi_c$, (4). The roughness $A$ is the
same in both:

$$S_z(\varphi)=A/\varphi^2 \tag{3}$$

$$S_z(\varphi)=\begin{cases}A/\varphi^2,&\varphi<\varphi_c\\ A\varphi_c^2/\varphi^4,&\varphi>\varphi_c\end{cases} \tag{4}$$

The paper explains (3) by a random walk: the longer the distance, the less accurately a track is
levelled, which makes the slope $-2$ on logarithmic axes. The rail is stiff and limits the short
waves, which makes the slope $-4$ beyond the corner. Waves longer than about 100 m are hills that
were built on purpose.

Only averages over segments, that is over miles, and over neighbouring wavenumbers make a spectrum
readable. {{fig-03}} shows both on five miles of synthetic track, that is of random numbers with the
spectrum (4). The standard error, counted over many such records, is {{raw-scatter}} of the ordinate
for one segment and {{mean-scatter}} for the average over five miles.

{{fig-03}}

The generator of the track filters white noise (independent random numbers) into the slope of the
track along its length. A running sum of the slope is the profile.

{{fold}}
*/
constexpr spectra::TrackParameters fair_track{.A = 2.0e-7, .phi_c = 0.12};  // zone 4 of Table 1

// The standard error of an ordinate relative to it, bins 20 to 1500, over many records of `samples`
// each.
double scatter(std::size_t samples, int records) {
  spectra::TrackGenerator generator{synthetic(fair_track, 1)};
  std::vector<double> z(samples);
  double square = 0.0;
  for (int r = 0; r < records; ++r) {
    generator.fill(z);
    const spectra::Spectrum spectrum = spectra::welch(z, units::foot);
    for (Eigen::Index k = 20; k < 1500; ++k) {
      const double model = spectra::random_psd(fair_track, spectrum.frequency(k));
      square += std::pow(spectrum.density[k] / model - 1, 2) / (1480.0 * records);
    }
  }
  return std::sqrt(square);
}

void fig_03(report::Item& item) {
  item.rebuilt("the paper's drawing is not in our copy: zone 4 of Table 1, synthetic");
  const auto five_miles = static_cast<std::size_t>(5 * units::mile / units::foot);
  const std::vector<double> z = spectra::synthesize(synthetic(fair_track, 1), five_miles);
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

  const double single = scatter(4096, 100), averaged = scatter(five_miles, 40);
  item.claims({{"ordinate", {single}},
               {"averages", {averaged, 1 / std::sqrt(all.averages), averaged / single}}});

  report::values(item, "%", "{:.0f}", "raw-scatter", 100 * single, "mean-scatter", 100 * averaged);
}

}  // namespace

const report::Section processes{report::figure("fig-01", fig_01), report::table("lines", lines),
                                report::figure("fig-02", fig_02), report::figure("fig-03", fig_03)};

}  // namespace railbook::psd_chapter
