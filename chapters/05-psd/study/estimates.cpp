/*** ### Are the stated standard errors true?

{{sweep-records}} records of 5 km at random, from the whole of the paper's range: $A$ from
$10^{-8}$ to $10^{-6}$, corner 0.08 to 0.3 cycle/m, $B$ up to 25 mm. What was put in should lie
within {{sweep-interval}} stated standard errors to each side in 95 % of them, as for a normal
error. For the dip, the power of its line is judged, which may come out negative. A fraction counted
on so many records is itself uncertain: only below {{sweep-least}} would it contradict 95 %, with one
chance in a hundred of a false alarm among the three.

{{sweep}}

A class is given with a probability: on average {{sweep-probability}} for the class pronounced,
which was right in {{sweep-right}} of the records.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/bench/evidence.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/num/random_source.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/spectrum_fit.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

namespace {

// How many standard errors the truth is off, over the records.
struct Misses {
  const char *id, *what;
  int records = 0, covered = 0;
  double worst = 0;
  void add(const spectra::Estimate& found, double truth) {
    const double off = std::abs(found.value - truth) / found.error;
    ++records;
    covered += off <= num::normal_quantile(0.975);
    worst = std::max(worst, off);
  }
};

void sweep(report::Item& item) {
  item.added("random tracks, seeded");
  const int records = item.full() ? 20000 : 1000;
  Misses of_A{"coverage-A", "roughness A"}, of_corner{"coverage-corner", "corner φ_c"},
      of_line{"coverage-line", "power of the line"};
  double probability = 0, right = 0;
  struct Found {
    spectra::TrackParameters track;
    spectra::SpectrumFit fit;
  };
  const auto all = num::map_in_parallel(static_cast<std::size_t>(records), [](std::size_t k) {
    bench::RandomStream draw{31, k};
    const spectra::TrackParameters track{.A = draw.decades(1e-8, 1e-6),
                                         .phi_c = draw.decades(0.08, 0.3),
                                         .phi_0 = phi_0,
                                         .B = draw(0, 25 * mm)};
    return Found{track, spectra::fit_track_spectrum(
                            record_spectrum(synthetic(track, 40000 + k), 5 * km, {}))};
  });
  for (const auto& [track, fit] : all) {
    of_A.add(fit.A, track.A);
    of_line.add(fit.Q_1, spectra::line_power(1, track.B, LineConvention::printed));
    if (fit.corner == spectra::CornerState::fitted) of_corner.add(fit.phi_c, track.phi_c);
    const auto stated = spectra::class_probabilities(fit);
    const auto best = std::max_element(stated.begin(), stated.end());
    probability += *best / records;
    right += best - stated.begin() == spectra::classify(track.A, track.B).track_class
                 ? 1.0 / records
                 : 0;
  }
  item.expect_checks(4);
  item.columns({"quantity", {"covered, %", "{:.1f}"}, {"worst, standard errors", "{:.1f}"}});
  // One chance in a hundred for the three rows, to one side.
  const auto least = [](int n) {
    return 0.95 - num::normal_quantile(1 - 0.01 / 3) * std::sqrt(0.95 * 0.05 / n);
  };
  for (const Misses* m : {&of_A, &of_corner, &of_line}) {
    const double share = static_cast<double>(m->covered) / m->records;
    item.add_row(m->what, 100 * share, m->worst);
    item.at_least(
        m->id, fmt::format("fraction of records whose 95 % interval covers the truth: {}", m->what),
        "", share, least(m->records), "95 %, less the chance of counting");
  }
  item.at_most(
      "calibration", "stated probability of the class pronounced less the share that is right", "",
      std::abs(probability - right),
      by_chance(1) * std::sqrt(probability * (1 - probability) / records), "chance of counting");
  item.value("sweep-interval", num::normal_quantile(0.975), "", "{:.2f}");
  item.value("sweep-least", 100 * least(records), "%", "{:.1f}");
  item.value("sweep-records", records, "", "{:.0f}");
  item.value("sweep-probability", 100 * probability, "%", "{:.1f}");
  item.value("sweep-right", 100 * right, "%", "{:.1f}");
}

}  // namespace

const report::Section estimates{
    report::table("sweep",
                  "Stated errors hold in nineteen records of twenty. Random tracks from the whole "
                  "of the paper's range: how often the truth lies within the stated interval.",
                  sweep)};

}  // namespace railbook::psd_chapter
