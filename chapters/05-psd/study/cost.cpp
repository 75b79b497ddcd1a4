/*** ### What accuracy costs

Eight records of zone 7 of {{cost-lengths}} each, estimated in several ways: Welch's method with 4096 samples a segment and a regression on the two
slopes ("Hann"), and with one thing changed. The error is the root mean square of the eight. The true $A$ is known
but for {{cost-doubt}}, by which the generator's own density misses the model.

{{fig-cost}}

{{work-precision: fig-cost}}

Longer records buy accuracy until segments or window set a limit of their own: short segments smear the steep spectrum, Hamming's side lobes
and a missing window fill its low end with power of the long waves, and no length of track repairs that.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "bench/work_precision.hpp"
#include "sections.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

using spectra::Window;

namespace {

constexpr double km = units::kilometre;

Zone zone_7(const report::Item& item) {
  return zones(item.printed("table-1.csv")).at(6);
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
  };
  const std::vector<Way> ways{{"Hann", {}, {}},
                              {"512 samples", {.segment = 512}, {}},
                              {"octave bands", {}, {.averaging = spectra::Averaging::bands}},
                              {"Hamming", {.window = Window::hamming}, {}},
                              {"no window", {.window = Window::boxcar}, {}}};
  std::vector<bench::Method> methods;
  for (const Way& way : ways) {
    methods.push_back({way.name, {}});
    for (const double length : lengths) {
      const std::size_t n = samples(length);
      const auto run = [&all, &way, n, A] {
        std::vector<spectra::Spectrum> spectra(records);
        for (std::size_t r = 0; r < records; ++r) {
          const std::span record = std::span{all}.subspan(r * n, n);
          spectra[r] = spectra::welch(record, units::foot, way.welch);
        }
        return outcome(spectra, way.welch.segment, way.fit, A);
      };
      methods.back().settings.push_back({fmt::format("{:g} km", length / km), run});
    }
  }
  const double doubt =
      generator_error(track, spectra::welch(std::span{all}.first(8192), units::foot));
  bench::figure(item, {"A", A, doubt}, methods, item.full() ? 0.5 : 0.03);
  std::vector<double> kilometres;
  for (const double length : lengths) kilometres.push_back(length / km);
  item.value("cost-lengths", fmt::format("{:g} km", fmt::join(kilometres, ", ")));
  item.value("cost-doubt", 100 * doubt, "%", "{:.2f}");
  item.added("our own study");
}

}  // namespace

const report::Section cost{report::figure(
    "fig-cost", "Error of the roughness against run time and points transformed", fig_cost)};

}  // namespace railbook::psd_chapter
