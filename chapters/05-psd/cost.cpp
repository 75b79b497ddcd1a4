/*** ## Windows on a steep spectrum

A profile spectrum falls by six orders of magnitude in the band of interest. An estimate leaks power from the high side to the low
one, and the window decides how much. The figure divides what six estimators see on the random part of zone 7 by what is there.

{{fig-windows}}

Without a window, power of the longest waves covers everything above 0.1 cycle/m: the estimate falls with $\varphi^{-2}$ whatever the track
does, and at 1 cycle/m it is {{boxcar-constant-1}} times too high; a straight line off each segment helps, to {{boxcar-linear-1}}
times. Hamming's window, whose steps at the ends leave side lobes that do not fall, is {{hamming-1}} times too high there. Hann, Blackman-Harris and
the Slepian sequence follow the track. A slope read off an unwindowed spectrum says nothing about a corner.

## Error against run time

Eight records of zone 7 of {{cost-lengths}} each, estimated in several ways: as described above ("Hann"), and with one thing changed. The error is the root mean square of the eight. The true $A$ is known
but for {{cost-doubt}}, by which the generator's own density misses the model.

{{fig-cost}}

{{work-precision}}

With a good window and segments that resolve the slope, longer records buy accuracy with the square root of the time, and how the points
are averaged does not matter. Short segments save next to nothing and stop at an error of their own: they smear the steep spectrum, and no
length of track repairs that. Nor does it repair a missing window. The whole array (explained below) gives the same digits later.

## Streams

The spectrum of a network is that of a single long record: 10⁸ samples of a foot are 30 000 km. The textbook way cuts the record into
segments, transforms all, squares all and averages, and holds all of it in memory. Ours holds one segment. It is also faster, for the
same reason: a segment stays in the cache from the first touch to the last. The straight line through it comes from sums that
overlapping segments share, and is taken off while the window is applied, so that each segment is read once and written once before the
transform, and its power is added to the average at once.

{{stream}}
*/
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "items.hpp"
#include "num/fft.hpp"
#include "num/stopwatch.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

using namespace railbook;
using spectra::Detrend;
using spectra::Window;

namespace {

constexpr double km = units::kilometre;

Zone zone_7(const report::Item& item) {
  return zones(item.printed("table-1.csv")).at(6);
}

void fig_windows(report::Item& item) {
  const Zone zone = zone_7(item);
  spectra::SyntheticTrack track = synthetic(zone.track, 71);
  track.dip = 0;
  struct Estimator {
    std::string name;
    spectra::WelchOptions options;
  };
  const std::vector<Estimator> estimators{
      {"boxcar-constant", {.window = Window::boxcar, .detrend = Detrend::constant}},
      {"boxcar-linear", {.window = Window::boxcar}},
      {"hamming", {.window = Window::hamming}},
      {"hann", {}},
      {"blackman-harris", {.window = Window::blackman_harris}},
      {"dpss", {.window = Window::dpss}}};
  auto& data = item.data({"window", "phi_cycle_per_m", "ratio"});
  for (const Estimator& e : estimators) {
    const auto spectrum = record_spectrum(track, item.full() ? 2000 * km : 200 * km, e.options);
    const auto bands = spectra::band_average(spectrum, 6, 0.005, 1.5);
    double nearest = 1e9, at_1 = 0;
    for (Eigen::Index i = 0; i < bands.density.size(); ++i) {
      const double phi = bands.frequency[i];
      const double ratio = bands.density[i] / spectra::random_psd(zone.track, phi);
      data.add(e.name, phi, ratio);
      if (std::abs(phi - 1) < nearest) {
        nearest = std::abs(phi - 1);
        at_1 = ratio;
      }
    }
    data.gap();
    item.value(e.name + "-1", at_1, "", "{:.3g}");
  }
  item.reconstructed("not in the paper, which does not name its window");
}

// Welch as a textbook writes it: all segments, all transforms, all powers, then the average.
Eigen::VectorXd whole_array_welch(std::span<const double> x, double spacing, std::size_t n) {
  const std::size_t hop = n / 2, segments = (x.size() - n) / hop + 1, bins = n / 2 + 1;
  std::vector<double> rows(segments * n), power(segments * bins);
  for (std::size_t s = 0; s < segments; ++s)
    std::copy_n(x.data() + s * hop, n, rows.data() + s * n);
  const double size = static_cast<double>(n), centre = 0.5 * (size - 1);
  for (std::size_t s = 0; s < segments; ++s) {
    double sum = 0, moment = 0;
    for (std::size_t i = 0; i < n; ++i) {
      sum += rows[s * n + i];
      moment += (static_cast<double>(i) - centre) * rows[s * n + i];
    }
    const double mean = sum / size, slope = 12 * moment / (size * (size * size - 1));
    for (std::size_t i = 0; i < n; ++i)
      rows[s * n + i] -= mean + slope * (static_cast<double>(i) - centre);
  }
  const Eigen::VectorXd w = spectra::window_weights(Window::hann, static_cast<Eigen::Index>(n));
  for (std::size_t s = 0; s < segments; ++s)
    for (std::size_t i = 0; i < n; ++i) rows[s * n + i] *= w[static_cast<Eigen::Index>(i)];
  num::RealFft fft{n};
  for (std::size_t s = 0; s < segments; ++s) {
    std::copy_n(rows.data() + s * n, n, fft.real().data());
    fft.forward();
    for (std::size_t k = 0; k < bins; ++k) power[s * bins + k] = std::norm(fft.spectrum()[k]);
  }
  Eigen::VectorXd density = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bins));
  for (std::size_t s = 0; s < segments; ++s)
    for (std::size_t k = 0; k < bins; ++k)
      density[static_cast<Eigen::Index>(k)] += power[s * bins + k];
  density *= 2 * spacing / (w.squaredNorm() * static_cast<double>(segments));
  density[0] *= 0.5;
  density[density.size() - 1] *= 0.5;
  return density;
}

// How wrong A is by the generator alone: its own density, free of scatter, through the estimator.
double generator_error(const spectra::SyntheticTrack& track, const spectra::Spectrum& like) {
  const spectra::TrackGenerator generator{track};
  spectra::Spectrum own = like;
  own.averages = 1e9;
  for (Eigen::Index k = 1; k < own.density.size(); ++k)
    own.density[k] = generator.random_density(own.frequency(k));
  return std::abs(spectra::fit_track_spectrum(own).A.value / track.A - 1);
}

constexpr int records = 8;

// The rms error of A over the records, put as a value: A (1 + rms).
bench::Outcome outcome(const std::vector<spectra::Spectrum>& spectra, std::size_t segment,
                       const spectra::FitOptions& options, double A) {
  double squares = 0, points = 0;
  for (const auto& spectrum : spectra) {
    const double found = spectra::fit_track_spectrum(spectrum, options).A.value;
    squares += std::pow(found / A - 1, 2) / records;
    points += static_cast<double>(spectrum.segments * segment);
  }
  return {
      .values = {A * (1 + std::sqrt(squares))}, .work = points, .converged = true, .reason = ""};
}

void fig_cost(report::Item& item) {
  const Zone zone = zone_7(item);
  const double A = zone.track.A;
  const spectra::SyntheticTrack track = synthetic(zone.track, 72);
  std::vector<double> lengths{5 * km, 20 * km, 80 * km};
  if (item.full()) lengths.push_back(320 * km);
  const auto samples = [](double length) { return static_cast<std::size_t>(length / units::foot); };
  const auto all = spectra::synthesize(track, records * samples(lengths.back()));
  struct Way {
    std::string name;
    spectra::WelchOptions welch;
    spectra::FitOptions fit;
    bool whole = false;
  };
  const std::vector<Way> ways{{"Hann", {}, {}},
                              {"512 samples", {.segment = 512}, {}},
                              {"octave bands", {}, {.averaging = spectra::Averaging::bands}},
                              {"Hamming", {.window = Window::hamming}, {}},
                              {"no window", {.window = Window::boxcar}, {}},
                              {"whole array", {}, {}, true}};
  std::vector<bench::Method> methods;
  for (const Way& way : ways) {
    methods.push_back({way.name, {}});
    for (const double length : lengths) {
      const std::size_t n = samples(length);
      // The whole array gives densities only; the counts that go with them are taken from here.
      const auto counts = spectra::welch(std::span{all}.first(n), units::foot, way.welch);
      const auto run = [&all, &way, counts, n, A] {
        std::vector<spectra::Spectrum> spectra(records, counts);
        for (std::size_t r = 0; r < records; ++r) {
          const std::span record = std::span{all}.subspan(r * n, n);
          if (way.whole)
            spectra[r].density = whole_array_welch(record, units::foot, way.welch.segment);
          else
            spectra[r] = spectra::welch(record, units::foot, way.welch);
        }
        return outcome(spectra, way.welch.segment, way.fit, A);
      };
      methods.back().settings.push_back({fmt::format("{:g} km", length / km), run});
    }
  }
  const double doubt =
      generator_error(track, spectra::welch(std::span{all}.first(8192), units::foot));
  const auto points =
      bench::measure("cost", {{"A", A, doubt}}, methods, item.timings(), item.full() ? 0.5 : 0.03);
  bench::show(item, points, "A");
  std::vector<double> kilometres;
  for (const double length : lengths) kilometres.push_back(length / km);
  item.value("cost-lengths", fmt::format("{:g} km", fmt::join(kilometres, ", ")));
  item.value("cost-doubt", 100 * doubt, "%", "{:.2f}");
  item.reconstructed("not in the paper");
}

double resident_megabytes() {
  std::ifstream statm{"/proc/self/statm"};
  double total = 0, pages = 0;
  statm >> total >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double best_of(int runs, const std::function<void()>& call) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < runs; ++i) {
    const num::Stopwatch watch;
    call();
    best = std::min(best, watch.seconds());
  }
  return best;
}

void table_stream(report::Item& item) {
  std::vector<std::size_t> sizes{500'000, 4'000'000};
  if (item.full()) sizes.push_back(100'000'000);
  item.expect_checks(2 * static_cast<int>(sizes.size()) + (item.timings() ? 1 : 0));
  item.reconstructed("a benchmark of ours, not in the paper");
  item.columns({"samples", "streamed, ns a sample", "whole array, ns a sample", "ratio",
                "streamed, memory beyond the input, MB", "whole array, MB"});
  for (const std::size_t n : sizes) {
    const std::string label = fmt::format("{:g}", static_cast<double>(n));
    const auto record = spectra::synthesize(synthetic(zone_7(item).track, 73), n);
    const int runs = n > 10'000'000 ? 1 : 5;
    Eigen::VectorXd streamed, whole;
    const double before = resident_megabytes();
    double memory = 0;
    const double fast = best_of(runs, [&] {
      spectra::Welch welch{units::foot};
      welch.push(record);
      memory =
          std::max(static_cast<double>(welch.state_bytes()) / 1e6, resident_megabytes() - before);
      streamed = welch.spectrum().density;
    });
    const double slow =
        best_of(runs, [&] { whole = whole_array_welch(record, units::foot, 4096); });
    const Eigen::Index n_bins =
        whole.size() - 1;  // the mean is removed: nothing but rounding in bin 0
    Eigen::Index worst = 0;
    (streamed.tail(n_bins).array() / whole.tail(n_bins).array() - 1).abs().maxCoeff(&worst);
    item.agree("density-" + label, "density, worst bin, " + label + " samples", "m²/(cycle/m)",
               streamed[worst + 1], whole[worst + 1], 1e-9, "whole-array Welch");
    item.check("memory-" + label, "resident beyond the input, " + label + " samples", "MB", "64",
               memory, report::at_most("the most a stream may hold, however long"));
    if (item.timings() && n == sizes.back()) {
      item.check("ratio-" + label, "speed over whole array, " + label + " samples", "", "3",
                 slow / fast, report::at_least("the gain asked for"));
    }
    const double ns = 1e9 / static_cast<double>(n);
    const std::size_t segments = n / 2048 - 1;
    const double array = static_cast<double>(segments * (4096 + 2049) * sizeof(double)) / 1e6;
    const auto timed = [&](double value, const char* format) {
      return item.timings() ? fmt::format(fmt::runtime(format), value) : std::string{"-"};
    };
    item.add_row({label, timed(fast * ns, "{:.1f}"), timed(slow * ns, "{:.1f}"),
                  timed(slow / fast, "{:.1f}"), fmt::format("{:.2g}", memory),
                  fmt::format("{:.3g}", array)});
  }
}

}  // namespace

void add_cost(report::Chapter& chapter) {
  chapter.figure("fig-windows", "What windows make of a steep spectrum", fig_windows);
  chapter.figure("fig-cost", "Error of the roughness against run time and points transformed",
                 fig_cost);
  chapter.table("stream", "One segment at a time against the whole array", table_stream);
}

}  // namespace railbook::psd_chapter
