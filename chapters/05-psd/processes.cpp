/*** ## Three processes

### Periodic: the rectified sine

Rails of length $l$ sag at their joints. The paper draws the profile as a rectified sine, $z=B\,|\sin(\pi x/l)|$: crests at mid rail,
joints a depth $B$ below them (figure {{fig-01}}), with dips of up to 7.6 cm reported.

{{fig-01}}

Its spectrum is a row of lines at $n\varphi_0$, $\varphi_0=1/l$. Equations (1) and (2) of the paper are

$$B_n=\frac{2B}{(4n^2-1)\pi} \tag{1}$$

$$Q_n=\tfrac12B_n^2 . \tag{2}$$

**Two conventions.** The Fourier series is $B|\sin\pi\varphi_0x|=\frac{2B}{\pi}-\sum_n\frac{4B}{\pi(4n^2-1)}\cos2\pi n\varphi_0x$. So $B_n$ as
printed is the modulus of the two-sided, complex coefficient, half the amplitude of the cosine; but (2) halves its square as if it
were that amplitude. The power of a line in a one-sided density, which is what the paper uses everywhere else, is four times the
printed one. A measured line is then read by the printed (7) as a dip twice as deep as it is. Nor does another reading help: a
two-sided density would spoil (8), which is exact for a one-sided one. The sum over all lines decides, since it must be the
variance $B^2(\frac12-\frac4{\pi^2})$ = {{line-variance}} $B^2$: the exact powers give {{line-sum-exact}}, the printed ones
{{line-sum-printed}}.

Both are kept, by name. *Printed* $B$ belongs to (7), (10) and the tables; the *physical dip* is half of it. Classes
do not depend on the choice as long as it is kept: the same line power enters (10) with the printed $B$ and $\gamma=2$, or with the
physical dip and $\gamma=4$.

{{code: spectra/rail_line.cpp line_power}}

{{lines}}

The printed $Q_2$ is the rounded $Q_1$ divided by 25, which loses its last digit.
*/
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "num/fft.hpp"
#include "sections.hpp"
#include "spectra/rail_line.hpp"
#include "units/constants.hpp"

namespace railbook::psd_chapter {

using spectra::LineConvention;

namespace {

constexpr double rail = 39 * units::foot;
constexpr double phi_0 = 1.0 / rail;

void fig_01(report::Item& item) {
  item.rebuilt("the paper's drawing has no scale; ours is the formula with 39-ft rails");
  report::Data& curve = item.data({"x_m", "z_over_B"});
  for (int i = 0; i <= 1000; ++i) {
    const double x = 4 * rail * i / 1000.0;
    curve.add(x, spectra::rectified_sine(x, rail, 1.0));
  }
}

// The power of line n of a sampled rectified sine: no formula in it.
double line_power_by_transform(std::size_t n) {
  num::RealFft fft{1 << 14};
  const auto samples = static_cast<double>(fft.size());
  for (std::size_t i = 0; i < fft.size(); ++i)
    fft.real()[i] = spectra::rectified_sine(static_cast<double>(i) / samples, 1.0, 1.0);
  fft.forward();
  return 2.0 * std::norm(fft.spectrum()[n]) / (samples * samples);
}

void lines(report::Item& item) {
  const table::CsvTable printed = item.printed("equations.csv");
  item.expect_checks(5);
  item.columns({{"n", "{:.0f}"},
                {"wavelength, m", "{:.3f}"},
                {"Qₙ/B² as printed in (2)", "{:.5e}"},
                {"Qₙ/B² exact, one-sided", "{:.5e}"},
                {"share of the variance, %", "{:.3f}"}});
  std::array<double, 2> sum{};
  for (int n = 1; n <= 2000; ++n) {
    const double as_printed = spectra::line_power(n, 1.0, LineConvention::printed);
    const double exact = spectra::line_power(n, 1.0, LineConvention::exact_one_sided);
    sum[0] += as_printed;
    sum[1] += exact;
    if (n > 4) continue;
    item.add_row(double(n), rail / n, as_printed, exact,
                 100 * exact / spectra::rectified_sine_variance(1.0));
  }
  const double Q_1 = spectra::line_power(1, 1.0, LineConvention::printed);
  const double Q_2 = spectra::line_power(2, 1.0, LineConvention::printed);
  const report::Row first = item.row(printed, "Q1");
  const report::Row second = item.row(printed, "Q2");
  first.print("printed", Q_1);
  second.print("printed", Q_2,
               report::corrected(line_power_by_transform(2) / 4, 1e-5,
                                 "the paper divided its rounded Q₁ by 25; a quarter of the line's "
                                 "power by transform"));
  item.agree("Q1-exact", "exact line 1", "B²",
             spectra::line_power(1, 1.0, LineConvention::exact_one_sided),
             line_power_by_transform(1), 1e-6, "a transform of the sampled profile");
  item.agree("Q2-exact", "exact line 2", "B²",
             spectra::line_power(2, 1.0, LineConvention::exact_one_sided),
             line_power_by_transform(2), 1e-6, "a transform of the sampled profile");
  const double variance = spectra::rectified_sine_variance(1.0);
  item.agree("sum", "sum of the exact lines", "B²", sum[1], variance, 1e-9,
             "the variance of the rectified sine");
  item.value("Q2", Q_2, "", "{:.3e}");
  item.value("line-variance", variance, "", "{:.6f}");
  item.value("line-sum-exact", sum[1], "", "{:.6f}");
  item.value("line-sum-printed", sum[0], "", "{:.6f}");
}

}  // namespace

/*** ### Resolution

A spectrum from segments of length $T$ cannot show a line narrower than about $1/T$. Each line takes the shape of the window's own
spectrum and keeps its area; peak and width are then properties of the analysis. Figure {{fig-02}} is the paper's drawing, with the
Hann window: lines, window, and the lines seen through it, for 1024 samples of 1 ft (solid) and for 256 (dashed). The recurring
width $\beta$ = 0.010 cycle/m of Table 1 is such a resolution: 512 samples of 1 ft give {{hann-512}} cycle/m at half height.

{{fig-02}}
*/
double hann_line(double offset, double df) {
  const double u = offset / df;
  double amplitude = 0.5;  // its limit at |u| = 1
  if (std::abs(u) < 1e-9) {
    amplitude = 1.0;
  } else if (std::abs(std::abs(u) - 1.0) > 1e-9) {
    amplitude = std::sin(units::pi * u) / (units::pi * u * (1.0 - u * u));
  }
  return amplitude * amplitude / (1.5 * df);
}

namespace {

// The rail's lines seen with resolution df, one-sided, for a physical dip of 10 mm.
double seen(double phi, double df) {
  double density = 0.0;
  for (int n = 1; n <= 8; ++n)
    density += spectra::line_power(n, 0.010, LineConvention::exact_one_sided) *
               hann_line(phi - n * phi_0, df);
  return density;
}

void fig_02(report::Item& item) {
  item.expect_checks(2);
  item.rebuilt("the paper's drawing has no scale; ours: dips of 10 mm, 39-ft rails, Hann window");
  const double fine = 1.0 / (1024 * units::foot);
  const double broad = 1.0 / (256 * units::foot);
  report::Data& convolved = item.data({"phi_cycle_per_m", "S_fine", "S_broad"});
  report::Data& window = item.data("window", {"phi_cycle_per_m", "W_fine", "W_broad"});
  report::Data& line = item.data("lines", {"phi_cycle_per_m", "Q_mm2"});
  for (int i = 1; i <= 1500; ++i) {
    const double phi = 0.0002 * i;
    convolved.add(phi, seen(phi, fine), seen(phi, broad));
  }
  for (int i = -300; i <= 300; ++i)
    window.add(0.0002 * i, hann_line(0.0002 * i, fine), hann_line(0.0002 * i, broad));
  for (int n = 1; n <= 3; ++n)
    line.add(n * phi_0, spectra::line_power(n, 10.0, LineConvention::exact_one_sided));

  const double Q_1 = spectra::line_power(1, 0.010, LineConvention::exact_one_sided);
  for (const double df : {fine, broad}) {
    const double step = 0.01 * df;
    double area = 0.0;
    for (double phi = 0.5 * phi_0; phi < 1.5 * phi_0; phi += step) area += step * seen(phi, df);
    item.agree(fmt::format("area-{:.0f}", 1 / (df * units::foot)),
               fmt::format("area about the first line, {:.0f} samples", 1 / (df * units::foot)),
               "m²", area, Q_1, 2e-3, "the power of the line; 0.1 % are tails and neighbours");
  }
  const double df = 1.0 / (512 * units::foot);
  double half = 0.0;
  while (hann_line(half, df) > 0.5 * hann_line(0.0, df)) half += 1e-4 * df;
  item.value("hann-512", 2 * half, "", "{:.4f}");
}

}  // namespace

const report::Section processes{
    report::figure("fig-01", "Rectified sine of 39-ft rails (Fig. 1)", fig_01),
    report::table("lines", "Line powers of the rectified sine, equations (1) and (2)", lines),
    report::figure("fig-02", "Lines, resolution, and lines seen through it (Fig. 2)", fig_02)};

}  // namespace railbook::psd_chapter
