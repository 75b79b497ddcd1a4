/***
**What a fit states of its error, and what is true.** {{sweep-records}} records of 5 km at random, from the whole of the paper's range: $A$ from $10^{-8}$ to $10^{-6}$,
corner 0.08 to 0.3 cycle/m, $B$ up to 25 mm. What was put in should lie within the stated interval in 95 % of them. Two standard errors, enough for a normal
error, fall a little short with the few averages of such a record, so the interval is {{sweep-interval}} standard errors to each side; of the dip it is the power of
the line, which may come out negative, that is stated.

{{sweep}}

A class is given with a probability: on average {{sweep-probability}} for the class pronounced, which was right in {{sweep-right}} of the records.
*/
#include <algorithm>
#include <cmath>

#include "bench/evidence.hpp"
#include "sections.hpp"
#include "spectra/chord.hpp"
#include "spectra/classify.hpp"
#include "spectra/joint_dips.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

namespace {

struct Drawn {
  spectra::TrackParameters track;
  spectra::SpectrumFit fit;
};

Drawn drawn(std::uint64_t k) {
  bench::Draw draw{31, k};
  const spectra::TrackParameters track{.A = draw.decades(1e-8, 1e-6),
                                       .phi_c = draw.decades(0.08, 0.3),
                                       .phi_0 = phi_0,
                                       .B = draw(0, 25 * mm)};
  return {track,
          spectra::fit_track_spectrum(record_spectrum(synthetic(track, 40000 + k), 5 * km, {}))};
}

constexpr double interval = 2.1;  // standard errors to each side that are to cover 95 %

// How many standard errors the truth is off, over the records.
struct Misses {
  int covered = 0;
  double worst = 0;
  void add(double off) {
    covered += off <= interval;
    worst = std::max(worst, off);
  }
};

double errors_off(const spectra::Estimate& found, double truth) {
  return std::abs(found.value - truth) / found.error;
}

void sweep(report::Item& item) {
  item.added("random tracks, seeded");
  const int records = item.full() ? 20000 : 1000;
  Misses of_A, of_corner, of_line;
  double probability = 0, right = 0;
  int corners = 0;
  for (int i = 0; i < records; ++i) {
    const auto [track, fit] = drawn(static_cast<std::uint64_t>(i));
    of_A.add(errors_off(fit.A, track.A));
    of_line.add(errors_off(fit.Q_1, spectra::line_power(1, track.B, LineConvention::printed)));
    if (fit.corner == spectra::CornerState::fitted) {
      of_corner.add(errors_off(fit.phi_c, track.phi_c));
      ++corners;
    }
    const auto stated = spectra::class_probabilities(fit);
    const auto best = std::max_element(stated.begin(), stated.end());
    probability += *best / records;
    right += best - stated.begin() == spectra::classify(track.A, track.B).track_class
                 ? 1.0 / records
                 : 0;
  }
  item.expect_checks(4);
  item.columns({"quantity", "covered, %", "worst, standard errors"});
  const auto show = [&](const char* id, const char* what, const Misses& misses, int n) {
    const double share = static_cast<double>(misses.covered) / n;
    item.add_row(what, fmt::format("{:.1f}", 100 * share), fmt::format("{:.1f}", misses.worst));
    item.at_least(id,
                  fmt::format("share of records whose stated interval covers the truth: {}", what),
                  "", share, 0.95, "what an interval of 95 % owes its user");
  };
  show("coverage-A", "roughness A", of_A, records);
  show("coverage-corner", "corner φ_c", of_corner, corners);
  show("coverage-line", "power of the line", of_line, records);
  item.at_most(
      "calibration", "stated probability of the class pronounced less the share that is right", "",
      std::abs(probability - right), 3 * std::sqrt(probability * (1 - probability) / records),
      "three standard errors of counting");
  item.value("sweep-interval", interval, "", "{:.1f}");
  item.value("sweep-records", records, "", "{:.0f}");
  item.value("sweep-probability", 100 * probability, "%", "{:.1f}");
  item.value("sweep-right", 100 * right, "%", "{:.1f}");
}

/*** **Digits.** Closed forms against extended precision:

{{digits}}
*/
using Long = long double;

void digits_table(report::Item& item) {
  item.added("closed forms against extended precision");
  item.expect_checks(3);
  std::vector<double> small, wide, tail;
  bench::Draw draw{7, 0};
  for (int i = 0; i < 20000; ++i) {
    small.push_back(draw.decades(1e-8, 1));
    wide.push_back(draw.decades(1e-6, 20));
    tail.push_back(draw.decades(1e-15, 0.4));
  }
  const Long pi = std::acos(Long(-1));
  const auto dip = [pi](Long nu) {  // of a dip, by its two cosines; nu is nowhere near 1/2
    const Long t = pi * nu;
    return std::sin(t) / t - (1 + std::sin(t)) / (pi + 2 * t) - (1 - std::sin(t)) / (pi - 2 * t);
  };
  const auto quantile = [](Long p) {  // Newton's iteration from the value in double
    Long x = num::normal_quantile(double(p));
    for (int i = 0; i < 3; ++i)
      x -= (std::erfc(-x / std::sqrt(Long(2))) / 2 - p) * std::sqrt(2 * std::acos(Long(-1))) *
           std::exp(x * x / 2);
    return x;
  };
  bench::digits_table(
      item, {bench::worst_digits(
                 {"chord-gain", "gain of a chord", "Lφ from 1e-8 to 1",
                  "2 sin² in 80-bit arithmetic", 2e-15},
                 small, [](double phi) { return spectra::chord_gain(1, phi); },
                 [pi](Long phi) { return 2 * std::pow(std::sin(pi * phi / 2), 2); }),
             bench::worst_digits(
                 {"dip-transform", "transform of a dip", "φl from 1e-6 to 20",
                  "its formula in 80-bit arithmetic", 1e-12},
                 wide, [](double nu) { return spectra::dip_transform(nu); }, dip),
             bench::worst_digits(
                 {"normal-quantile", "quantile of the normal distribution", "p from 1e-15 to 0.4",
                  "erfc inverted in 80-bit arithmetic", 4e-15},
                 tail, [](double p) { return num::normal_quantile(p); }, quantile)});
}

}  // namespace

const report::Section digits{
    report::table("digits", "Digits of the closed forms", digits_table),
    report::table("sweep", "Random records: how often the stated errors cover", sweep)};

}  // namespace railbook::psd_chapter
