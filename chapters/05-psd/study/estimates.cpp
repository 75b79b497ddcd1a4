/*** ## Are the stated standard errors true?

Yes, if the joints are equally deep. To test them, {{sweep-records}} records of 5 km of 39-ft rail
with equal joints were synthesised with $A$, $\varphi_c$ and $B$ drawn at random from the paper's
range: $A$ from $10^{-8}$ to $10^{-6}$ m²·cycle/m, $\varphi_c$ from 0.08 to 0.3 cycle/m, $B$ up to
25 mm. If the stated errors are right, the true value lies within {{sweep-interval}} of them in 95 %
of the records. In place of $B$, the power of its line is judged, which may come out negative.

On so many records chance alone brings one of the three fractions below {{sweep-least}} in one test
of a hundred; this is the limit that we ask for.

{{sweep}}

The library also states a probability for each class. That of the most probable class is
{{sweep-probability}} on average, and this class is right in {{sweep-right}} of the records.

If the depths of the joints scatter by half of their mean, the interval of $A$ holds the truth in
only {{sweep-uneven}} of {{sweep-uneven-records}} such records, because the spectrum of the scatter
is taken for roughness.
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

// Records of random tracks, read: how often the truth lies within the stated errors, the mean
// probability of the class pronounced, and the fraction in which it is right.
struct Coverage {
  Misses A{"coverage-A", "roughness A"}, corner{"coverage-corner", "corner φ<sub>c</sub>"},
      line{"coverage-line", "power of the line"};
  double probability = 0, right = 0;
};

Coverage coverage(std::size_t records, double dip_scatter) {
  struct Found {
    spectra::TrackParameters track;
    spectra::SpectrumFit fit;
  };
  const auto all = num::map_in_parallel(records, [dip_scatter](std::size_t k) {
    bench::RandomStream draw{31, k};
    const spectra::TrackParameters track{.A = draw.decades(1e-8, 1e-6),
                                         .phi_c = draw.decades(0.08, 0.3),
                                         .phi_0 = phi_0,
                                         .B = draw(0, 25 * mm)};
    auto made = synthetic(track, 40000 + k);
    made.dip_scatter = dip_scatter;
    return Found{track, spectra::fit_track_spectrum(record_spectrum(made, 5 * km, {}))};
  });
  Coverage of;
  const auto n = static_cast<double>(records);
  for (const auto& [track, fit] : all) {
    of.A.add(fit.A, track.A);
    of.line.add(fit.Q_1, spectra::line_power(1, track.B, LineConvention::printed));
    if (fit.corner == spectra::CornerState::fitted) of.corner.add(fit.phi_c, track.phi_c);
    const auto stated = spectra::class_probabilities(fit);
    const auto best = std::max_element(stated.begin(), stated.end());
    of.probability += *best / n;
    if (best - stated.begin() == spectra::classify(track.A, track.B).track_class) of.right += 1 / n;
  }
  return of;
}

// What 95 % of n may come down to by one chance in a hundred for the three rows, to one side.
double least_covered(int n) {
  return 0.95 - num::normal_quantile(1 - 0.01 / 3) * std::sqrt(0.95 * 0.05 / n);
}

void sweep(report::Item& item) {
  item.added("random tracks, seeded");
  const int records = item.full() ? 20000 : 1000;
  const Coverage of = coverage(static_cast<std::size_t>(records), 0);
  const Misses uneven = coverage(static_cast<std::size_t>(records / 5), 0.5).A;
  item.expect_checks(4);
  item.columns({"quantity", {"covered, %", "{:.1f}"}, {"worst, standard errors", "{:.1f}"}});
  for (const Misses* m : {&of.A, &of.corner, &of.line}) {
    const double share = static_cast<double>(m->covered) / m->records;
    item.add_row(m->what, 100 * share, m->worst);
    item.at_least(
        m->id, fmt::format("fraction of records whose 95 % interval covers the truth: {}", m->what),
        "", share, least_covered(m->records), "95 %, less the chance of counting");
  }
  item.at_most("calibration",
               "stated probability of the class pronounced less the fraction that is right", "",
               std::abs(of.probability - of.right),
               by_chance(1) * std::sqrt(of.probability * (1 - of.probability) / records),
               "chance of counting");
  item.value("sweep-uneven", 100.0 * uneven.covered / uneven.records, "%", "{:.0f}");
  item.value("sweep-interval", num::normal_quantile(0.975), "", "{:.2f}");
  item.value("sweep-records", records, "", "{:.0f}");
  item.value("sweep-uneven-records", uneven.records, "", "{:.0f}");
  report::values(item, "%", "{:.1f}", "sweep-least", 100 * least_covered(records),
                 "sweep-probability", 100 * of.probability, "sweep-right", 100 * of.right);
}

}  // namespace

const report::Section estimates{report::table("sweep", sweep)};

}  // namespace railbook::psd_chapter
