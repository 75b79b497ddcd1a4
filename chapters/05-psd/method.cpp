/*** ### One zone, from its peak to its class

{{worked}} takes zone 7, a jointed main line, through all steps twice: once with the numbers of the
paper's Table 1 ($B$ from $C_1$ and $\beta$ by (7)), and once from a record, {{worked-length}} of
synthetic track with the zone's $A$, $\varphi_c$ and $B$, by the functions of this page. The peak of
the record differs from the printed one in height and in width, because both depend on the analysis
as well as on the track. Its power is {{worked-power}} above the printed one, because the track was
made with the printed $B$ = 11 mm, which the printed height and width of the peak do not give; the
class is the same. The checks below compare the functions of this page with the library's.

{{worked}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/fft.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/spectrum_fit.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

namespace {

// What is left of samples without the straight line that fits them best.
std::vector<double> without_line(std::span<const double> z) {
  const auto n = static_cast<double>(z.size());
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    sum += z[i];
    moment += (static_cast<double>(i) - (n - 1) / 2) * z[i];
  }
  const double slope = 12 * moment / (n * (n * n - 1));
  std::vector<double> rest(z.begin(), z.end());
  for (std::size_t i = 0; i < z.size(); ++i)
    rest[i] -= sum / n + slope * (static_cast<double>(i) - (n - 1) / 2);
  return rest;
}

bool near_line(double phi, double phi_1) {
  const double n = std::round(phi / phi_1);
  return n > 0 && std::abs(phi - n * phi_1) < (n > 1 ? 0.008 : 0.02);
}

}  // namespace

std::vector<double> average_spectrum(std::span<const double> z, double spacing, std::size_t n) {
  num::RealFft fft{n};
  std::vector<double> density(n / 2 + 1);
  double segments = 0, squares = 0;
  std::vector<double> window(n);
  for (std::size_t i = 0; i < n; ++i) {
    window[i] = std::pow(std::sin(units::pi * static_cast<double>(i) / static_cast<double>(n)), 2);
    squares += window[i] * window[i];
  }
  for (std::size_t start = 0; start + n <= z.size(); start += n / 2) {
    const std::vector<double> rest = without_line(z.subspan(start, n));
    for (std::size_t i = 0; i < n; ++i) fft.real()[i] = window[i] * rest[i];
    fft.forward();
    for (std::size_t k = 0; k <= n / 2; ++k)
      density[k] += 2 * spacing * std::norm(fft.spectrum()[k]) / squares;
    ++segments;
  }
  for (double& S : density) S /= segments;
  return density;
}

spectra::TrackParameters lay_two_lines(const std::vector<double>& density, double df, double phi_1,
                                       double averages) {
  spectra::TrackParameters best{.phi_0 = phi_1};
  double least = units::infinity;
  for (double phi_c = 0.04; phi_c < 0.5; phi_c *= 1.0005) {
    double sum = 0, squares = 0, count = 0;
    for (std::size_t k = 1; k < density.size(); ++k) {
      const double phi = df * static_cast<double>(k);
      if (phi < std::max(0.01, 4 * df) || phi > 1.2 || near_line(phi, phi_1)) continue;
      const double above =
          std::log(density[k] / spectra::random_psd({.A = 1, .phi_c = phi_c}, phi));
      sum += above, squares += above * above, ++count;
    }
    const double mean = sum / count;  // ln A, but for the bias of a logarithm
    if (squares - sum * mean > least) continue;
    least = squares - sum * mean;
    best.phi_c = phi_c;
    best.A = std::exp(mean + 1 / (2 * averages));
  }
  return best;
}

Peak read_peak(const std::vector<double>& density, double df,
               const spectra::TrackParameters& track) {
  Peak peak;
  for (std::size_t k = 1; k < density.size(); ++k) {
    const double phi = df * static_cast<double>(k);
    if (std::abs(phi - track.phi_0) > 0.02) continue;
    const double excess = density[k] - spectra::random_psd(track, phi);
    peak.C_1 = std::max(peak.C_1, excess);
    peak.Q_1 += excess * df;
  }
  peak.beta = peak.Q_1 / peak.C_1;
  peak.B = 3 * units::pi * std::sqrt(peak.Q_1 / 2);
  return peak;
}

int highest_class(double A, double B) {
  const double k = 4.5 * units::pi * units::pi * 19.0;
  const double d = std::sqrt(k * A + 4 * B * B);
  for (int m = 6; m >= 1; --m)
    if (d <= spectra::profile_limits[static_cast<std::size_t>(m - 1)]) return m;
  return 0;
}

namespace {

// Zone 7 from a peak to its class, by the functions of this page and by the library's rule.
struct Steps {
  spectra::TrackParameters track;
  Peak peak;
  spectra::Classification by_library;
  int track_class = 0;
};

const spectra::ClassRule chord_of_19_m{.chord = 19.0};

Steps steps_from(const spectra::TrackParameters& track, const Peak& peak) {
  return {track, peak, spectra::classify(track.A, peak.B, chord_of_19_m),
          highest_class(track.A, peak.B)};
}

Steps steps_from_print(const Zone& zone) {
  return steps_from(
      zone.track,
      {.C_1 = zone.C_1, .beta = zone.beta, .Q_1 = zone.C_1 * zone.beta, .B = dip_by_7(zone)});
}

Steps steps_from_record(const std::vector<double>& density, double df, double averages) {
  const auto track = lay_two_lines(density, df, phi_0, averages);
  return steps_from(track, read_peak(density, df, track));
}

// The largest relative difference of two densities, without their ends.
double largest_difference(const std::vector<double>& density, const spectra::Spectrum& other) {
  double off = 0;
  for (std::size_t k = 1; k + 1 < density.size(); ++k)
    off = std::max(off, std::abs(density[k] / other.density[static_cast<Eigen::Index>(k)] - 1));
  return off;
}

void show_steps(report::Item& item, const Steps& print, const Steps& record) {
  item.columns({"step", "quantity", "unit", "from the printed A, C₁ and β", "from the record"});
  const auto row = [&](const char* step, const char* what, const char* unit, const char* format,
                       const auto& value) {
    item.add_row(step, what, unit, fmt::format(fmt::runtime(format), double(value(print))),
                 fmt::format(fmt::runtime(format), double(value(record))));
  };
  using S = const Steps&;
  row("two lines, (4)", "roughness A", "10⁻⁷ m²·cycle/m", "{:.2f}",
      [](S s) { return 1e7 * s.track.A; });
  row("", "corner φ<sub>c</sub>", "cycle/m", "{:.3f}", [](S s) { return s.track.phi_c; });
  row("peak at φ₀", "height C₁", "10⁻⁴ m²/(cycle/m)", "{:.2f}",
      [](S s) { return 1e4 * s.peak.C_1; });
  row("", "width β, of the record Q₁/C₁", "cycle/m", "{:.4f}", [](S s) { return s.peak.beta; });
  row("power, (6)", "Q₁ = β C₁", "mm²", "{:.2f}", [](S s) { return s.peak.Q_1 / (mm * mm); });
  row("dip, (7)", "B", "mm", "{:.1f}", [](S s) { return s.peak.B / mm; });
  row("deviation, (10)", "random part 3σ", "mm", "{:.1f}",
      [](S s) { return s.by_library.random / mm; });
  row("", "joints 2B", "mm", "{:.1f}", [](S s) { return s.by_library.periodic / mm; });
  row("", "d", "mm", "{:.1f}", [](S s) { return s.by_library.deviation / mm; });
  row("class", "highest m with d ≤ D<sub>m</sub>", "", "{:.0f}", [](S s) { return s.track_class; });
  row("", "its limit D<sub>m</sub>", "mm", "{:.2f}", [](S s) {
    return spectra::profile_limits.at(static_cast<std::size_t>(s.track_class - 1)) / mm;
  });
}

void worked(report::Item& item) {
  item.rebuilt(
      "the printed numbers of zone 7, and synthetic track with its A, φ<sub>c</sub> and B");
  const Zone zone = zones(item).at(6);
  constexpr std::size_t segment = 512;
  const double length = 40 * km;
  const auto z =
      spectra::synthesize(synthetic(zone.track, 7), static_cast<std::size_t>(length / units::foot));
  const std::vector<double> density = average_spectrum(z, units::foot, segment);
  const spectra::Spectrum like = spectra::welch(z, units::foot, {.segment = segment});
  const Steps print = steps_from_print(zone);
  const Steps record = steps_from_record(density, like.df, like.averages);
  show_steps(item, print, record);
  const auto fit = spectra::fit_track_spectrum(like);
  item.expect_checks(5);
  item.at_most("welch", "largest relative difference of the page's spectrum from the library's", "",
               largest_difference(density, like), 1e-9,
               "rounding, of a spectrum that spans eight decades");
  item.agree("A", "roughness by the page's two lines", "10⁻⁷ m²·cycle/m", 1e7 * record.track.A,
             1e7 * fit.A.value, 2e-3, "the library's regression; the page tries corners in steps");
  item.agree("B", "dip by the page's peak", "mm", record.peak.B / mm, fit.B_printed.value / mm,
             5e-3, "the library's fit");
  item.agree("class-print", "class of zone 7 by the page's rule, from C₁, β and A", "",
             print.track_class, print.by_library.track_class, 1e-12, "the library's rule");
  item.agree("class-record", "class of zone 7 by the page's rule, from the record", "",
             record.track_class,
             spectra::classify(fit.A.value, fit.B_printed.value, chord_of_19_m).track_class, 1e-12,
             "the library's fit and rule");
  item.value("worked-length", length / km, "km", "{:.0f}");
  item.value("worked-power", 100 * (record.peak.Q_1 / print.peak.Q_1 - 1), "%", "{:.0f}");
}

// A record, and the spectrum of its kind with the three parameters: zone 7.
void overview(report::Item& item) {
  item.added("the spectrum is the model's for zone 7, the record is synthetic");
  const Zone zone = zones(item).at(6);
  auto& rails = item.data({"x_m", "z_over_B"});
  for (int i = 0; i <= 800; ++i) {
    const double x = 4 * rail * i / 800.0;
    rails.add(x, spectra::rectified_sine(x, rail, 1.0));
  }
  spectra::SyntheticTrack track = synthetic(zone.track, 12);
  track.spacing = rail / 40;
  const auto z = without_line(spectra::synthesize(track, 40 * 8 + 1));
  auto& record = item.data("record", {"x_m", "z_mm"});
  for (std::size_t i = 0; i < z.size(); ++i)
    record.add(static_cast<double>(i) * track.spacing, z[i] / mm);
  const double df = 1 / (512 * units::foot);
  const auto lines = spectra::modulated_lines(phi_0, track.dip, 0, 0, 1.0);
  auto& spectrum = item.data("spectrum", {"phi_cycle_per_m", "S", "S_random"});
  for (double phi = 0.01; phi < 0.6; phi += std::min(0.01 * phi, 0.1 * df)) {
    const double random = spectra::random_psd(zone.track, phi);
    spectrum.add(phi, random + lines_seen(lines, phi, df), random);
  }
  auto& marks = item.data("marks", {"phi_0", "phi_c", "S_under", "S_peak", "S_corner"});
  const double under = spectra::random_psd(zone.track, phi_0);
  marks.add(phi_0, zone.track.phi_c, under, under + lines_seen(lines, phi_0, df),
            spectra::random_psd(zone.track, zone.track.phi_c));
}

}  // namespace

const report::Section method{report::figure("overview", overview), report::table("worked", worked)};

}  // namespace railbook::psd_chapter
