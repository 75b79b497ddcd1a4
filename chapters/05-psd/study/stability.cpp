/***
Real records have gaps, grades, noise, old rail under new, faults of measuring, and chords instead of profiles. Each row changes one thing of a record
of zone 7 ({{stability-length}}, a sample a foot) and lets the estimator judge itself. A row *holds* when $A$ and $B$ come out within four of
their own standard errors and 1 %. It *degrades* when they do not, but the reading says so by itself (corner at its bound, residuals 1.25
times larger than chance, a line nobody named, a fault in the record); the loss is that of $A$. A wrong number without a word would fail.

{{stability}}
*/
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "sections.hpp"
#include "spectra/chord.hpp"
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
  double loss = 1;  // degrades: bound of the relative error of A
};

/*** The records: shapes of spectrum that the model has or has not, disturbances of the track, and faults of measuring. */
class Cases {
 public:
  explicit Cases(const spectra::SyntheticTrack& base) : base_(base) {}
  void add(const char* id, const char* what, const char* stress,
           const std::function<void(Case&)>& change) {
    list.push_back({id, what, stress, base_});
    change(list.back());
  }
  std::vector<Case> list;

 private:
  spectra::SyntheticTrack base_;
};

// Known to be lost, with a bound of the relative error of A.
void degrades(Case& c, double loss) {
  c.expect = report::degrades;
  c.loss = loss;
}

void shapes(Cases& cases) {
  cases.add("plain", "zone 7 as it is", "nothing", [](Case&) {});
  cases.add("no-line", "no joints", "B must not be made of noise",
            [](Case& c) { c.track.dip = 0; });
  cases.add("line-only", "nothing but joints", "no roughness to fit",
            [](Case& c) { c.track.A = 0; });
  cases.add("corner-0.02", "corner at 0.02 cycle/m", "corner at its lower bound", [](Case& c) {
    c.track.phi_c = 0.02;
    degrades(c, 1);
  });
  cases.add("corner-0.6", "corner at 0.6 cycle/m", "corner at its upper bound",
            [](Case& c) { c.track.phi_c = 0.6; });
  cases.add("no-corner-one", "no corner, one slope fitted", "equation (3)", [](Case& c) {
    c.track.phi_c = spectra::no_corner;
    c.fit.slopes = spectra::Slopes::one;
  });
}

void disturbed(Cases& cases) {
  cases.add("wave", "50 m high, 20 km long wave", "trend",
            [](Case& c) { c.track.wave_amplitude = 50; });
  cases.add("wave-boxcar", "the same, no window", "trend and leakage", [](Case& c) {
    c.track.wave_amplitude = 50;
    c.welch.window = spectra::Window::boxcar;
    degrades(c, 0.5);
  });
  cases.add("noise", "sensor noise of 0.3 mm, not modelled", "floor over the steep slope",
            [](Case& c) {
              c.track.sensor_noise = 0.3 * mm;
              degrades(c, 0.8);
            });
  cases.add("noise-fitted", "the same, noise model automatic", "floor over the steep slope",
            [](Case& c) {
              c.track.sensor_noise = 0.3 * mm;
              c.fit.noise = spectra::NoiseModel::automatic;
            });
  for (const bool named : {false, true}) {
    const auto change = [named](Case& c) {
      if (named)
        c.fit.foreign_lengths = {old_rail};
      else
        degrades(c, 0.02);
    };
    cases.add(named ? "memory-named" : "memory",
              named ? "the same, named" : "33-ft memory, linear, not named",
              "line inside the window of phi_0", [&](Case& c) {
                c.track.memory_dip = 5 * mm;
                change(c);
              });
    cases.add(named ? "modulated-named" : "modulated",
              named ? "the same, named" : "33-ft memory, nonlinear, not named",
              "sidebands everywhere", [&](Case& c) {
                c.track.memory_modulation = 0.5;
                change(c);
              });
  }
  cases.add("scatter-1", "joint depths vary by 100 %", "continuous spectrum of the joints",
            [](Case& c) {
              c.track.dip_scatter = 1;
              degrades(c, 0.3);
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
  add("gaps-2", "2 % lost, gaps of 20 samples", "no whole segment left",
      [](Case& c) { c.expect = report::refused; });
  add("gaps-2-short", "the same, segments of 1024", "most segments drop out",
      [](Case& c) { c.welch.segment = 1024; });
  add("gaps-2-bridged", "the same, 4096, bridged by lines", "straight pieces in the profile",
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
  const auto screened = [](Case& c, const std::function<void(Record&)>& spoil) {
    c.read = {.spacing = units::foot, .bridge = 20};
    c.spoil = spoil;
  };
  cases.add("spikes", "a spike of 1 m every 10 000 samples", "outliers, screened", [&](Case& c) {
    screened(c, [](Record& z) {
      for (std::size_t i = 5000; i < z.size(); i += 10000) z[i] += 1;
    });
  });
  cases.add("steps", "the datum steps by 0.5 m every 50 000 samples", "steps, screened",
            [&](Case& c) {
              screened(c, [](Record& z) {
                for (std::size_t i = 0; i < z.size(); ++i)
                  z[i] += 0.5 * static_cast<double>(i / 50000);
              });
            });
  cases.add("stuck", "the sensor sticks for 100 of every 50 000 samples", "equal values, screened",
            [&](Case& c) {
              screened(c, [](Record& z) {
                for (std::size_t i = 0; i < z.size(); ++i)
                  if (i % 50000 < 100) z[i] = z[i - i % 50000];
              });
            });
  cases.add("high-pass", "high-pass filter of 70 m, order 2", "long waves missing", [](Case& c) {
    c.spoil = [](Record& z) {
      const double keep = std::exp(-2 * units::pi * units::foot / 70);
      for (int pass = 0; pass < 2; ++pass) {
        double before = z[0], out = 0;
        for (double& height : z) {
          out = keep * (out + height - before);
          before = std::exchange(height, out);
        }
      }
    };
    degrades(c, 0.5);
  });
  cases.add("stretched", "distances 1 % too long", "the rail's line moves",
            [](Case& c) { c.track.rail_length *= 1.01; });
  for (const auto& [id, chord, stress] :
       {std::tuple{"chord-100", 100, "blind at 0.066 cycle/m, next to the line"},
        {"chord-78", 78, "chord blind to the rail length"}})
    cases.add(id, id, stress, [chord = chord](Case& c) {
      c.what = fmt::format("{}-ft chord offsets", chord);
      c.fit.chord = chord * units::foot;
      if (chord == 78) c.expect = report::refused;
      c.spoil = [length = c.fit.chord](Record& z) {
        z = spectra::mid_chord_offsets(z, units::foot, length).offset;
      };
    });
  cases.add("spacing", "samples 1 m apart", "band cut, harmonics folded",
            [](Case& c) { c.track.spacing = 1; });
  cases.add("short", "1 km", "shorter than a segment", [](Case& c) {
    c.length = 1 * km;
    c.expect = report::refused;
  });
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
  std::string result = fmt::format("A = {:.3g} ± {:.1g}, ", fit.A.value, fit.A.error);
  if (fit.corner == spectra::CornerState::fitted)
    result += fmt::format("φ_c = {:.4f}, ", fit.phi_c.value);
  result +=
      fmt::format("B = {:.2f} ± {:.2f} mm", fit.B_printed.value / mm, fit.B_printed.error / mm);
  if (!fit.line_significant)
    result += fmt::format(" (not significant below {:.1f})", fit.B_threshold / mm);
  if (fit.noise.value > 0) result += fmt::format(", noise {:.3g}", fit.noise.value);
  return result + r.doubts;
}

// Four standard errors and 1 % is what a row may be off by and still hold; a degraded one must say so by itself.
Found judged(const Case& c) {
  const Result r = run(c);
  const spectra::SpectrumFit& fit = r.fit;
  const double B = 2 * c.track.dip;
  const double share_A =
      std::abs(fit.A.value - c.track.A) / (4 * fit.A.error + 0.01 * c.track.A + 1e-14);
  const double share_B =
      B > 0 ? std::abs(fit.B_printed.value - B) / (4 * fit.B_printed.error + 0.01 * B)
      : fit.line_significant ? 2.0
                             : 0.0;
  const double off = std::max(share_A, share_B);
  if (c.expect != report::degrades) return {text(r), off};
  if (off <= 1) return {text(r) + "; it holds after all", units::nan};
  if (r.doubts.empty()) return {text(r) + "; wrong, without a word", units::nan};
  return {text(r), c.track.A > 0 ? std::abs(fit.A.value / c.track.A - 1) : 0.0};
}

// One record says nothing about chance: how often is a line found in short records that have none?
Found false_alarms(const spectra::SyntheticTrack& base, double length, int records) {
  int alarms = 0;
  for (int r = 0; r < records; ++r) {
    Case c{"", "", "", base};
    c.track.dip = 0;
    c.track.seed += static_cast<std::uint64_t>(r);
    c.length = length;
    alarms += run(c).fit.line_significant ? 1 : 0;
  }
  const double share = static_cast<double>(alarms) / records;
  return {fmt::format("passed in {:.1f} % of {} records", 100 * share, records),
          std::abs(share - 0.05)};
}

void table_stability(report::Item& item) {
  item.added("synthetic records");
  const spectra::SyntheticTrack base = synthetic(zones(item).at(6).track, 700);
  Cases cases{base};
  for (const auto& group : {shapes, disturbed, with_gaps, measured_badly}) group(cases);
  for (const Case& c : cases.list) {
    const bool lossy = c.expect == report::degrades;
    item.stability({.id = c.id,
                    .what = c.what,
                    .stress = c.stress,
                    .expect = c.expect,
                    .allowed = lossy                       ? c.loss
                               : c.expect == report::holds ? 1
                                                           : units::nan,
                    .reference = lossy ? "A put in: the loss"
                                       : "A and B put in, in units of 4 standard errors and 1 %"},
                   [&] { return judged(c); });
  }
  const int records = item.full() ? 1000 : 100;
  item.stability({.id = "no-line-5",
                  .what = "no joints, records of 5 km",
                  .stress = "the threshold of B must be passed in 5 %",
                  .allowed = 3 * std::sqrt(0.05 * 0.95 / records),
                  .reference = "5 %; three standard errors of counting"},
                 [&] { return false_alarms(base, 5 * km, records); });
  item.value("stability-length", 160, "km", "{:.0f}");
}

}  // namespace

const report::Section extremes{
    report::table("stability", "What the estimator makes of difficult records", table_stability)};

}  // namespace railbook::psd_chapter
