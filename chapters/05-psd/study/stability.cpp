/***
Real records have gaps, grades, noise, old rail under new, faults of measuring, and chords instead of profiles. Each row changes one thing of a record
of zone 7 ({{stability-length}}, a sample a foot) and lets the estimator judge itself. A row *holds* when $A$ and $B$ come out within
{{stability-errors}} of their own standard errors, which one of all rows exceeds by chance once in a hundred times, and the 1 % that the fit states. It
*degrades* when they do not, but the reading says so by itself (corner at its bound, residuals 1.25
times larger than chance, a line nobody named, a fault in the record); the loss is that of $A$. A wrong number without a word would fail.

Where the spectrum of a disturbance is known, the loss allowed is that of the same fit on this spectrum, free of chance, and the same errors on top:
of the high-pass, for one, the share of long waves that it takes. The other bounds were set before.

{{stability}}
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "sections.hpp"
#include "spectra/chord.hpp"
#include "spectra/joint_dips.hpp"
#include "spectra/line_mask.hpp"
#include "spectra/record.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

using report::Found;

namespace {

using Record = std::vector<double>;

struct Case {
  std::string id, what, stress;
  spectra::SyntheticTrack track;
  spectra::WelchOptions welch = {};
  spectra::FitOptions fit = {};
  double length = 160 * km;
  std::function<void(Record&)> spoil = {};  // what is done to the samples
  std::optional<spectra::RecordOptions> read =
      {};  // as the tool reads them: screened, gaps bridged
  report::Stands expect = report::holds;
  double loss = 0;  // degrades: bound of the relative error of A
  std::function<double(double phi, double undisturbed)> known =
      {};  // density; or, with it, by its fit
};

/*** The records: shapes of spectrum that the model has or has not, disturbances of the track, and faults of measuring. */
struct Cases {
  spectra::SyntheticTrack base;
  std::vector<Case> list = {};
  void add(const char* id, const char* what, const char* stress,
           const std::function<void(Case&)>& change) {
    list.push_back({id, what, stress, base});
    change(list.back());
  }
};

// Known to be lost: with a bound of the relative error of A, or with the spectrum that makes it.
void degrades(Case& c, double loss) {
  c.expect = report::degrades;
  c.loss = loss;
}
void degrades_by(Case& c, std::function<double(double, double)> known) {
  c.expect = report::degrades;
  c.known = std::move(known);
}

void disturbed(Cases& cases) {
  cases.add("corner-0.02", "corner at 0.02 cycle/m", "corner at its lower bound", [](Case& c) {
    c.track.phi_c = 0.02;
    degrades(c, 1);
  });
  cases.add("wave", "50 m high, 20 km long wave", "trend",
            [](Case& c) { c.track.wave_amplitude = 50; });
  cases.add("wave-boxcar", "the same, no window", "trend and leakage", [](Case& c) {
    c.track.wave_amplitude = 50;
    c.welch.window = spectra::Window::boxcar;
    degrades(c, 0.5);
  });
  constexpr double noise = 0.3 * mm;
  cases.add("noise", "sensor noise of 0.3 mm, not modelled", "floor over the steep slope",
            [](Case& c) {
              c.track.sensor_noise = noise;
              degrades_by(c, [](double, double S) { return S + 2 * units::foot * noise * noise; });
            });
  constexpr double df = 1 / (4096 * units::foot), memory = 5 * mm;
  cases.add(
      "memory", "33-ft memory, linear, not named", "line inside the window of phi_0", [=](Case& c) {
        c.track.memory_dip = memory;
        degrades_by(c, [=](double phi, double S) {
          const double power = spectra::line_power(1, memory, LineConvention::exact_one_sided);
          return S + power * hann_line(phi - 1 / old_rail, df);
        });
      });
  cases.add("modulated", "33-ft memory, nonlinear, not named", "sidebands everywhere",
            [=](Case& c) {
              c.track.memory_modulation = 0.5;
              const auto lines = spectra::modulated_lines(phi_0, c.track.dip, 0.5, eps, 1.7);
              const auto plain = spectra::modulated_lines(phi_0, c.track.dip, 0, 0, 1.7);
              degrades_by(c, [=](double phi, double S) {
                return S + lines_seen(lines, phi, df) - lines_seen(plain, phi, df);
              });
            });
  cases.add("named", "both, and the old rail named", "left out of the fit", [=](Case& c) {
    c.track.memory_dip = memory;
    c.track.memory_modulation = 0.5;
    c.fit.foreign_lengths = {old_rail};
  });
  cases.add("scatter-1", "joint depths vary by 100 %", "continuous spectrum of the joints",
            [](Case& c) {
              c.track.dip_scatter = 1;
              degrades_by(c, [dip = c.track.dip](double phi, double S) {
                return S + spectra::joint_scatter_psd({rail, dip, 1, 0}, phi);
              });
            });
}

void with_gaps(Cases& cases) {
  const auto add = [&](const char* id, const char* what, const char* stress, auto change) {
    cases.add(id, what, stress, [&](Case& c) {
      c.track.gap_share = 0.02;
      change(c);
    });
  };
  const auto lost = [](double z) { return std::isnan(z); };
  add("gaps-2-bridged", "2 % lost in gaps of 20 samples, bridged by lines",
      "straight pieces in the profile",
      [](Case& c) { c.read = {.spacing = units::foot, .bridge = 20}; });
  add("gaps-2-zeroed", "the same, zeros written into the gaps", "steps at both ends of each gap",
      [&](Case& c) {
        c.spoil = [lost](Record& z) { std::replace_if(z.begin(), z.end(), lost, 0.0); };
        degrades(c, 5);
      });
  add("gaps-2-cut", "the same, gaps cut out of the record", "steps, and distance lost",
      [&](Case& c) {
        c.spoil = [lost](Record& z) { std::erase_if(z, lost); };
        degrades(c, 0.1);
      });
}

void measured_badly(Cases& cases) {
  const auto screened = [&](const char* id, const char* what, const char* stress,
                            void (*spoil)(double& height, std::size_t i, double held)) {
    cases.add(id, what, stress, [&](Case& c) {
      c.read = {.spacing = units::foot, .bridge = 20};
      c.spoil = [spoil](Record& z) {
        double held = 0;  // the height at the last multiple of 50 000 samples
        for (std::size_t i = 0; i < z.size(); ++i) {
          if (i % 50000 == 0) held = z[i];
          spoil(z[i], i, held);
        }
      };
    });
  };
  screened("spikes", "a spike of 1 m every 10 000 samples", "outliers, screened",
           [](double& z, std::size_t i, double) { z += i % 10000 == 5000 ? 1 : 0; });
  screened("steps", "the datum steps by 0.5 m every 50 000 samples", "steps, screened",
           [](double& z, std::size_t i, double) { z += 0.5 * static_cast<double>(i / 50000); });
  screened("stuck", "the sensor sticks for 100 of every 50 000 samples", "equal values, screened",
           [](double& z, std::size_t i, double held) { z = i % 50000 < 100 ? held : z; });
  cases.add("high-pass", "high-pass filter of 70 m, order 2", "long waves missing", [](Case& c) {
    const double keep = std::exp(-2 * units::pi * units::foot / 70);
    degrades_by(c, [keep](double phi, double S) {  // keep (1 - z)/(1 - keep z), twice
      const auto z = std::polar(1.0, -2 * units::pi * phi * units::foot);
      return S * std::pow(std::norm(keep * (1.0 - z) / (1.0 - keep * z)), 2);
    });
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
  cases.add("spacing", "samples 1 m apart", "band cut, harmonics folded",
            [](Case& c) { c.track.spacing = 1; });
  cases.add("one-segment", "1.3 km", "one segment, K = 1", [](Case& c) { c.length = 1.3 * km; });
  cases.add("segment-256", "segments of 256", "resolution", [](Case& c) {
    c.welch.segment = 256;
    degrades(c, 0.3);
  });
}

/*** What comes of one: */
struct Result {
  spectra::SpectrumFit fit;
  std::string doubts;
};

Result run(const Case& c) {
  spectra::Spectrum spectrum;
  std::string doubts;
  if (!c.spoil && !c.read) {
    spectrum = record_spectrum(c.track, c.length, c.welch);
  } else {
    Record z = spectra::synthesize(c.track, static_cast<std::size_t>(c.length / c.track.spacing));
    if (c.spoil) c.spoil(z);
    spectra::Welch welch{c.track.spacing, c.welch};
    if (c.read) {
      spectra::RecordStream stream{*c.read,
                                   [&](std::span<const double> piece) { welch.push(piece); }};
      for (const double height : z) stream.add(height);
      stream.finish();
      for (const auto& doubt : stream.doubts()) doubts += ", " + doubt.key;
    } else {
      welch.push(z);
    }
    spectrum = welch.spectrum();
  }
  const auto fit = spectra::fit_track_spectrum(spectrum, c.fit);
  if (const auto stray = spectra::stray_line(spectrum, c.fit, fit))
    doubts += fmt::format(", stray line at {:.4f}", stray->phi);
  if (fit.corner == spectra::CornerState::at_low_bound) doubts += ", corner at its lower bound";
  if (fit.misfit > 1.25) doubts += fmt::format(", misfit {:.2f}", fit.misfit);
  if (!fit.converged) doubts += ", not converged";
  return {fit, doubts};
}

std::string text(const Result& r) {
  const spectra::SpectrumFit& fit = r.fit;
  const bool corner = fit.corner == spectra::CornerState::fitted;
  return fmt::format("A = {:.3g} ± {:.1g}, ", fit.A.value, fit.A.error) +
         (corner ? fmt::format("φ_c = {:.4f}, ", fit.phi_c.value) : "") +
         fmt::format("B = {:.2f} ± {:.2f} mm", fit.B_printed.value / mm, fit.B_printed.error / mm) +
         (fit.line_significant
              ? ""
              : fmt::format(" (not significant below {:.1f})", fit.B_threshold / mm)) +
         (fit.noise.value > 0 ? fmt::format(", noise {:.3g}", fit.noise.value) : "") + r.doubts;
}

// By how much A is wrong in the known spectrum of a disturbance, all chance left out.
double known_loss(const Case& c) {
  spectra::Spectrum ideal = spectra::welch(Record(8192), units::foot);
  ideal.averages = 1e9;
  const auto lines = spectra::modulated_lines(phi_0, c.track.dip, 0, 0, 1.7);
  for (Eigen::Index k = 1; k < ideal.density.size(); ++k) {
    const double phi = ideal.frequency(k);
    ideal.density[k] =
        c.known(phi, spectra::random_psd({.A = c.track.A, .phi_c = c.track.phi_c}, phi) +
                         lines_seen(lines, phi, ideal.df));
  }
  return std::abs(spectra::fit_track_spectrum(ideal, c.fit).A.value / c.track.A - 1);
}

// `errors` standard errors and 1 % is what a row may be off by and still hold; a degraded one must say so by itself.
Found judged(const Case& c, double errors) {
  const Result r = run(c);
  const spectra::SpectrumFit& fit = r.fit;
  const double B = 2 * c.track.dip, off_A = std::abs(fit.A.value - c.track.A);
  const double allowed_A = errors * fit.A.error + 0.01 * c.track.A;
  const double share_B =
      B > 0 ? std::abs(fit.B_printed.value - B) / (errors * fit.B_printed.error + 0.01 * B)
      : fit.line_significant ? 2.0
                             : 0.0;
  const double off = std::max(off_A / allowed_A, share_B);
  if (c.expect != report::degrades) return {text(r), off};
  if (off <= 1) return {text(r) + "; it holds after all", units::nan};
  if (r.doubts.empty()) return {text(r) + "; wrong, without a word", units::nan};
  // Beside a known loss there is chance; a bound set before is one of both.
  return {text(r), (c.known ? std::max(off_A - allowed_A, 0.0) : off_A) / c.track.A};
}

void table_stability(report::Item& item) {
  item.added("synthetic records");
  const spectra::SyntheticTrack base = synthetic(zones(item).at(6).track, 700);
  Cases cases{base};
  for (const auto& group : {disturbed, with_gaps, measured_badly}) group(cases);
  const double errors = by_chance(2 * static_cast<int>(cases.list.size()));
  for (const Case& c : cases.list) {
    const bool lossy = c.expect == report::degrades;
    item.stability(
        {.id = c.id,
         .what = c.what,
         .stress = c.stress,
         .expect = c.expect,
         .allowed = !lossy    ? 1
                    : c.known ? known_loss(c)
                              : c.loss,
         .reference = !lossy    ? "A and B put in, in units of those errors and 1 %"
                      : c.known ? "A put in: the loss, allowed is that of the known spectrum"
                                : "A put in: the loss"},
        [&] { return judged(c, errors); });
  }
  item.value("stability-length", 160, "km", "{:.0f}");
  item.value("stability-errors", errors, "", "{:.1f}");
}

}  // namespace

const report::Section extremes{
    report::table("stability", "What the estimator makes of difficult records", table_stability)};

}  // namespace railbook::psd_chapter
