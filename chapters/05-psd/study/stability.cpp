/*** Real records have gaps, grades, noise, old rail under new, faults of measuring, and chords
instead of profiles. Each row changes one thing of a record of zone 7 ({{stability-length}}, a
sample a foot). The column *result* has the numbers found, with their standard errors, and behind
"for" those put in. *Misfit* is how many times larger the residuals of the fit are than chance makes
them.

A row *holds* when $A$ and $B$ come out right within an allowance: {{stability-errors}} of their own
standard errors and 1 % for the fit. Chance alone would fail a row in one of a hundred runs of the
whole table; rows that share a record share its errors. A row that holds may have warnings as well.
A row *degrades* when $A$ or $B$ is wrong and the answer says so by itself: the corner is at its
bound, the misfit is above 1.25, there is a line that the options do not name, or the record has a
fault. A wrong number without such a warning would fail the run.

The error of a row that holds is the fraction of the allowance that it uses. The error of a row that
degrades is the relative error of $A$ or of $B$, whichever is larger. Where the spectrum of the
disturbance is known, the allowance for chance is taken off that error, and the rest must not exceed
the error that the same fit makes on the known spectrum: with linear ballast memory $B$ is
{{memory-off}} off, and {{memory-chance}} may be chance. The other bounds were fixed before the run.

One record is not in the table, because no warning tells that it is read wrong: with depths of the
joints that scatter by 50 % of their mean, $A$ is {{uneven-off}} too high, {{uneven-errors}} of its
stated errors. The command `psd classify` prints a note on uneven dips with every jointed record.

{{stability}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <railbook/records/record.hpp>
#include <railbook/spectra/chord.hpp>
#include <railbook/spectra/joint_dips.hpp>
#include <railbook/spectra/line_mask.hpp>
#include <railbook/spectra/spectrum_fit.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

using report::Found;

namespace {

using Record = std::vector<double>;
constexpr double length = 160 * km, df = 1 / (4096 * units::foot);

struct Case {
  std::string id, what, stress;
  spectra::SyntheticTrack track;
  spectra::WelchOptions welch = {};
  spectra::FitOptions fit = {};
  std::function<void(Record&)> spoil = {};  // what is done to the samples
  std::optional<records::RecordOptions> read =
      {};           // as the tool reads them: screened, gaps bridged
  double loss = 0;  // known to be lost: the bound of the relative error of A and B
  // Known to be lost: the density that the disturbance makes of the undisturbed one.
  std::function<double(double phi, double undisturbed)> known = {};
  bool lossy() const { return loss > 0 || known; }
};

// The records: shapes of spectrum that the model has or has not, disturbances of the track, and
// faults of measuring.
struct Cases {
  spectra::SyntheticTrack base;
  std::vector<Case> list = {};
  template <class Change>
  void add(const char* id, const char* what, const char* stress, const Change& change) {
    list.push_back({id, what, stress, base});
    change(list.back());
  }
  // As the tool reads it; `spoil` is given a sample, its place, and the height at the last multiple
  // of 50 000.
  template <class Spoil>
  void add_screened(const char* id, const char* what, const char* stress, const Spoil& spoil) {
    add(id, what, stress, [&](Case& c) {
      c.read = {.spacing = units::foot, .bridge = 20};
      c.spoil = [spoil, held = 0.0](Record& z) mutable {
        for (std::size_t i = 0; i < z.size(); ++i) {
          if (i % 50000 == 0) held = z[i];
          spoil(z[i], i, held);
        }
      };
    });
  }
};

void disturbed_track(Cases& cases) {
  cases.add("corner-0.02", "corner at 0.02 cycle/m", "corner at its lower bound",
            [](Case& c) { c.track.phi_c = 0.02, c.loss = 1; });
  cases.add("corner-line", "corner at the rail's own wavenumber", "the corner lies under the line",
            [](Case& c) { c.track.phi_c = phi_0; });
  cases.add("wave", "50 m high, 20 km long wave", "trend",
            [](Case& c) { c.track.wave_amplitude = 50; });
  cases.add("wave-boxcar", "the same, no window", "trend and leakage", [](Case& c) {
    c.track.wave_amplitude = 50;
    c.welch.window = spectra::Window::boxcar;
    c.loss = 0.5;
  });
  cases.add("memory", "ballast memory of 33-ft rail, linear, not named in the options",
            "line inside the window of φ₀", [](Case& c) {
              c.track.memory_dip = 5 * mm;
              const double power =
                  spectra::line_power(1, c.track.memory_dip, LineConvention::exact_one_sided);
              c.known = [power](double phi, double S) {
                return S + power * hann_line(phi - 1 / old_rail, df);
              };
            });
  cases.add("modulated", "the same, nonlinear", "sidebands everywhere", [](Case& c) {
    c.track.memory_modulation = 0.5;
    const auto lines = spectra::modulated_lines(phi_0, c.track.dip, 0.5, eps, 1.7);
    const auto plain = spectra::modulated_lines(phi_0, c.track.dip, 0, 0, 1.7);
    c.known = [lines, plain](double phi, double S) {
      return S + lines_seen(lines, phi, df) - lines_seen(plain, phi, df);
    };
  });
  cases.add("two-tracks", "half of the record is four times as rough as the other",
            "a record of two tracks; what is put in is their mean", [](Case& c) {
              auto smooth = c.track, rough = c.track;
              smooth.A *= 0.4;
              rough.A *= 1.6;
              rough.seed += 1;
              c.spoil = [smooth, rough](Record& z) {
                const std::size_t half = z.size() / 2;
                const Record first = spectra::synthesize(smooth, half),
                             second = spectra::synthesize(rough, z.size() - half);
                for (std::size_t i = 0; i < z.size(); ++i)
                  z[i] = i < half ? first[i] : first.back() + second[i - half] - second[0];
              };
            });
  cases.add("unknown-rail", "30-ft rail, read as 39-ft rail", "the line is looked for elsewhere",
            [](Case& c) { c.track.rail_length = 30 * units::foot, c.loss = 1.05; });
  cases.add("scatter-1", "joint depths vary by 100 %", "continuous spectrum of the joints",
            [](Case& c) {
              c.track.dip_scatter = 1;
              c.known = [dip = c.track.dip](double phi, double S) {
                return S + spectra::joint_scatter_psd({rail, dip, 1, 0}, phi);
              };
            });
}

void measured_badly(Cases& cases) {
  cases.add(
      "noise", "sensor noise of 0.3 mm, not modelled", "floor over the steep slope", [](Case& c) {
        c.track.sensor_noise = 0.3 * mm;
        c.known = [](double, double S) { return S + 2 * units::foot * std::pow(0.3 * mm, 2); };
      });
  cases.add("gaps-2-bridged", "2 % lost in gaps of 20 samples, bridged by straight lines",
            "straight pieces in the profile", [](Case& c) {
              c.track.gap_share = 0.02;
              c.read = {.spacing = units::foot, .bridge = 20};
            });
  cases.add_screened("spikes", "a spike of 1 m every 10 000 samples", "outliers, screened",
                     [](double& z, std::size_t i, double) { z += i % 10000 == 5000 ? 1 : 0; });
  cases.add_screened("steps", "the datum steps by 0.5 m every 50 000 samples", "steps, screened",
                     [](double& z, std::size_t i, double) {
                       const std::size_t stretch = i / 50000;
                       z += 0.5 * static_cast<double>(stretch);
                     });
  cases.add_screened("stuck", "the sensor sticks for 100 of every 50 000 samples",
                     "equal values, screened",
                     [](double& z, std::size_t i, double held) { z = i % 50000 < 100 ? held : z; });
  cases.add("high-pass", "high-pass filter of 70 m, order 2", "long waves missing", [](Case& c) {
    const double keep = std::exp(-2 * units::pi * units::foot / 70);
    c.known = [keep](double phi, double S) {  // keep (1 - z)/(1 - keep z), twice
      const auto z = std::polar(1.0, -2 * units::pi * phi * units::foot);
      return S * std::pow(std::norm(keep * (1.0 - z) / (1.0 - keep * z)), 2);
    };
    c.spoil = [keep](Record& z) {
      for (int pass = 0; pass < 2; ++pass) {
        double before = z[0], out = 0;
        for (double& height : z) {
          out = keep * (out + height - before);
          before = std::exchange(height, out);
        }
      }
    };
  });
  cases.add("stretched", "distances 1 % too long", "the rail's line moves",
            [](Case& c) { c.track.rail_length *= 1.01; });
  cases.add("chord-100", "100-ft chord offsets", "blind at 0.066 cycle/m, next to the line",
            [](Case& c) {
              c.fit.chord = 100 * units::foot;
              c.spoil = [](Record& z) {
                z = spectra::mid_chord_offsets(z, units::foot, 100 * units::foot).offset;
              };
            });
}

// What comes of one.
struct Result {
  spectra::SpectrumFit fit;
  std::string warnings;
};

Result run(const Case& c) {
  Record z = spectra::synthesize(c.track, static_cast<std::size_t>(length / c.track.spacing));
  if (c.spoil) c.spoil(z);
  spectra::Welch welch{c.track.spacing, c.welch};
  std::string warnings;
  if (c.read) {
    records::RecordStream stream{*c.read,
                                 [&](std::span<const double> piece) { welch.push(piece); }};
    for (const double height : z) stream.add(height);
    stream.finish();
    for (const auto& warning : stream.warnings()) warnings += ", " + warning.key;
  } else {
    welch.push(z);
  }
  const auto spectrum = welch.spectrum();
  const auto fit = spectra::fit_track_spectrum(spectrum, c.fit);
  if (const auto stray = spectra::stray_line(spectrum, c.fit, fit))
    warnings += fmt::format(", stray line at {:.4f} cycle/m", stray->phi);
  if (const auto other = spectra::contradicting_rail(spectrum, c.fit, fit))
    warnings += fmt::format(", rails of {:.2f} m", *other);
  if (fit.corner == spectra::CornerState::at_low_bound) warnings += ", corner at its lower bound";
  if (fit.misfit > 1.25) warnings += fmt::format(", misfit {:.2f}", fit.misfit);
  if (!fit.converged) warnings += ", not converged";
  return {fit, warnings};
}

struct Loss {
  double A = 0, B = 0;  // relative
  double larger() const { return std::max(A, B); }
};

Loss loss_of(const Case& c, const spectra::SpectrumFit& fit) {
  return {std::abs(fit.A.value / c.track.A - 1),
          std::abs(fit.B_printed.value / (2 * c.track.dip) - 1)};
}

// By how much A and B are wrong in the known spectrum of a disturbance, all chance left out.
Loss known_loss(const Case& c) {
  spectra::Spectrum ideal = spectra::welch(Record(8192), units::foot);
  ideal.averages = 1e9;
  const auto lines = spectra::modulated_lines(phi_0, c.track.dip, 0, 0, 1.7);
  for (Eigen::Index k = 1; k < ideal.density.size(); ++k) {
    const double phi = ideal.frequency(k);
    ideal.density[k] =
        c.known(phi, spectra::random_psd({.A = c.track.A, .phi_c = c.track.phi_c}, phi) +
                         lines_seen(lines, phi, ideal.df));
  }
  return loss_of(c, spectra::fit_track_spectrum(ideal, c.fit));
}

// `errors` standard errors and 1 % is what a row may be off by and still hold; a degraded one must
// say so by itself.
Found judged(const Case& c, double errors) {
  const auto [fit, warnings] = run(c);
  const double B = 2 * c.track.dip;
  const Loss lost = loss_of(c, fit), chance{errors * fit.A.error / c.track.A + 0.01,
                                            errors * fit.B_printed.error / B + 0.01};
  const double off = std::max(lost.A / chance.A, lost.B / chance.B);
  const auto text =
      fmt::format("A = {:.3g} ± {:.1g} for {:.3g} m²·cycle/m, B = {:.2f} ± {:.2f} for {:.2f} mm",
                  fit.A.value, fit.A.error, c.track.A, fit.B_printed.value / mm,
                  fit.B_printed.error / mm, B / mm) +
      warnings;
  if (!c.lossy()) return {text, off};
  if (off <= 1) return {text + "; it holds after all", units::nan};
  if (warnings.empty()) return {text + "; wrong, without a word", units::nan};
  if (!c.known) return {text, lost.larger()};
  // Beside a known loss there is chance.
  const Loss known = known_loss(c);
  if (lost.A > known.A + chance.A || lost.B > known.B + chance.B)
    return {text + "; more is lost than the known spectrum loses", units::nan};
  return {text, std::max(lost.A - chance.A, lost.B - chance.B)};
}

void table_stability(report::Item& item) {
  item.added("synthetic records");
  Cases cases{synthetic(zones(item).at(6).track, 700)};
  disturbed_track(cases);
  measured_badly(cases);
  const double errors = by_chance(2 * static_cast<int>(cases.list.size()));
  for (const Case& c : cases.list)
    item.stability(
        {.id = c.id,
         .what = c.what,
         .stress = c.stress,
         .expect = c.lossy() ? report::degraded : report::accurate,
         .allowed = c.known     ? known_loss(c).larger()
                    : c.lossy() ? c.loss
                                : 1,
         .reference =
             c.known
                 ? "A and B put in: the loss beyond chance, allowed is that of the known spectrum"
             : c.lossy() ? "A and B put in: the loss"
                         : "A and B put in, in units of those errors and 1 %"},
        [&] { return judged(c, errors); });
  const auto memory = std::ranges::find(cases.list, "memory", &Case::id);
  const auto fit = run(*memory).fit;
  item.value("memory-off", 100 * loss_of(*memory, fit).B, "%", "{:.0f}");
  item.value("memory-chance", 100 * (errors * fit.B_printed.error / (2 * memory->track.dip) + 0.01),
             "%", "{:.0f}");
  auto uneven = cases.base;
  uneven.dip_scatter = 0.5;
  const Result of_uneven = run({"", "", "", uneven});
  const auto& A = of_uneven.fit.A;
  item.value("uneven-off", 100 * (A.value / uneven.A - 1), "%", "{:.0f}");
  item.value("uneven-errors", (A.value - uneven.A) / A.error, "", "{:.0f}");
  item.value("stability-length", length / km, "km", "{:.0f}");

  item.value("stability-errors", errors, "", "{:.1f}");
}

}  // namespace

const report::Section extremes{report::table("stability", table_stability)};

}  // namespace railbook::psd_chapter
