/*** ## Closed loop: do the numbers come back?

The paper fits by eye. Ours is a program, and a program can be tested on track it has not seen but we have: each zone is
synthesised from its printed $A$, $\varphi_c$ and $B$, and estimated back, over and over. Per record: a spectrum by Welch's method
(4096 samples of 1 ft, straight line off each segment, Hann, half overlapped, averaged), a regression of $\ln S$ on the two slopes of
(4) outside the lines, and the power of the first line above it.

Two traps lie there. The mean of a logarithm is not the logarithm of the mean: $\ln\hat S$ of $K$ averages is low by $\ln K-\psi(K)$,
{{log-bias}} at 5 km, and has to be raised by it. And the averages of overlapped segments, like the bins of a windowed spectrum, are not
independent; counted as if they were, standard errors come out too small. The program takes both from the window itself.

The corner needs no search. With the corner between two given neighbouring bins, (4) is a straight mean left of it and another one right
of it; trying all gaps costs one pass and finds the exact minimum. Errors in brackets are the scatter of a single record, behind
the semicolon what the estimator itself claims for it.

{{closed-loop}}

No bias can be seen: the worst zone mean is {{closed-loop-worst}} off, over {{closed-loop-records}} records of {{closed-loop-km}} each, within
what their scatter leaves open. The claimed errors are the true ones, too: over all zones the ratio of scatter to claim is
{{closed-loop-ratio}} for $A$ and {{closed-loop-ratio-B}} for the power of the line.

### How much track does it take?

{{fig-length}}

The error of $A$ falls with the square root of the length. To know $A$ to 5 % takes {{length-1}} of zone 1, {{length-10}} of zone 10 and
{{length-13}} of zone 13: the higher the corner, the more of the spectrum belongs to the first slope, and the more it
says about $A$. The "several miles" the paper asks for are well chosen.

### Borderline zones

{{fig-class}}

For zones 7, 10 and 12 the deviation $d$ lies near a limit, and the class of a short record is a matter of luck. As $d^2=kA+4B^2$ is
linear in what is estimated, $A$ and the power of the line, its error and so the odds of each class follow from one record
(lines); the points count classes over the synthetic records. `psd classify` prints these odds.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "items.hpp"
#include "num/roots.hpp"
#include "spectra/classify.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double mm = units::millimetre, km = units::kilometre;
const spectra::ClassRule paper_rule{.chord = 19.0};

}  // namespace

spectra::SyntheticTrack synthetic(const spectra::TrackParameters& track, std::uint64_t seed) {
  return {.seed = seed,
          .A = track.A,
          .phi_c = track.phi_c,
          .rail_length = 39 * units::foot,  // of all zones: the 9.2 m of zone 12 are in doubt
          .dip = spectra::convert_dip(track.B, spectra::LineConvention::printed,
                                      spectra::LineConvention::exact_one_sided)};
}

spectra::Spectrum record_spectrum(const spectra::SyntheticTrack& track, double length,
                                  const spectra::WelchOptions& options) {
  spectra::TrackGenerator generator{track};
  spectra::Welch welch{track.spacing, options};
  std::vector<double> piece(1 << 15);
  auto left = static_cast<std::size_t>(length / track.spacing);
  while (left > 0) {
    const auto part = std::span{piece}.first(std::min(left, piece.size()));
    generator.fill(part);
    welch.push(part);
    left -= part.size();
  }
  return welch.spectrum();
}

namespace {

struct Scatter {
  double sum = 0, squares = 0, claims = 0;
  int n = 0;
  void add(double value, double claimed) {
    sum += value;
    squares += value * value;
    claims += claimed * claimed;
    ++n;
  }
  double mean() const { return sum / n; }
  double deviation() const { return std::sqrt((squares - sum * sum / n) / (n - 1)); }
  double claim() const { return std::sqrt(claims / n); }
};

struct Loop {
  Scatter A, phi_c, B, Q, d;  // A, phi_c and Q as shares of what was put in; B, d in m
  std::array<int, spectra::classes + 1> counts{};
};

Loop closed_loop(const Zone& zone, double length, int records) {
  Loop loop;
  const double Q_1 = 2 * std::pow(zone.track.B / (3 * units::pi), 2);  // equation (2)
  for (int r = 0; r < records; ++r) {
    const auto seed = 1000 * std::stoul(zone.name) + static_cast<std::uint64_t>(r);
    const auto fit =
        spectra::fit_track_spectrum(record_spectrum(synthetic(zone.track, seed), length, {}));
    loop.A.add(fit.A.value / zone.track.A, fit.A.error / zone.track.A);
    loop.phi_c.add(fit.phi_c.value / zone.track.phi_c, fit.phi_c.error / zone.track.phi_c);
    loop.B.add(fit.B_printed.value, fit.B_printed.error);
    loop.Q.add(fit.Q_1.value / Q_1, fit.Q_1.error / Q_1);
    const auto result = spectra::classify(fit.A.value, fit.B_printed.value, paper_rule);
    loop.d.add(result.deviation, 0);
    ++loop.counts[static_cast<std::size_t>(result.track_class)];
  }
  return loop;
}

// The runs of a length, for all zones; computed once.
struct Plan {
  double length;
  int records;
};
std::vector<Plan> plans(bool full) {
  if (!full) return {{5 * km, 60}};
  return {{5 * km, 400}, {50 * km, 100}, {500 * km, 8}};
}
const std::vector<Loop>& loops(const std::vector<Zone>& all, const Plan& plan) {
  static std::map<double, std::vector<Loop>> done;
  auto& result = done[plan.length];
  if (result.empty())
    for (const Zone& zone : all) result.push_back(closed_loop(zone, plan.length, plan.records));
  return result;
}

std::string counted(const std::array<int, spectra::classes + 1>& counts) {
  std::string text;
  for (int m = spectra::classes; m >= 0; --m)
    if (const int n = counts[static_cast<std::size_t>(m)]; n > 0)
      text += fmt::format("{}{} × {}", text.empty() ? "" : ", ", n, m);
  return text;
}

// How much lower the mean of the logarithm of K averages lies, as a share: psi by differences of ln gamma.
double log_bias(double K) {
  const double h = 1e-3, psi = (std::lgamma(K + h) - std::lgamma(K - h)) / (2 * h);
  return 1 - std::exp(psi) / K;
}

/*** A mean over $n$ records is itself uncertain by the scatter over $\sqrt n$. The check allows three times that, and 1 % for bias.
*/
void table_closed_loop(report::Item& item) {
  const auto all = zones(item.printed("table-1.csv"));
  const auto runs = plans(item.full());
  item.expect_checks(static_cast<int>(runs.size() * (all.size() + 2)));
  item.reconstructed("not in the paper: records are synthetic, from the printed parameters");
  const auto shortest = record_spectrum(synthetic(all.front().track, 1), 5 * km, {});
  item.value("log-bias", 100 * log_bias(shortest.averages), "%", "{:.0f}");
  item.columns({"zone", "record, km", "A / A₀", "φ<sub>c</sub> / φ<sub>c0</sub>", "B, mm",
                "B put in, mm", "d, mm", "records × class"});
  for (const Plan& plan : runs) {
    const std::string length = fmt::format("{:g}", plan.length / km);
    double worst = 0, spread = 0, claim = 0, spread_Q = 0, claim_Q = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Loop& l = loops(all, plan)[i];
      const auto cell = [](const Scatter& s, double unit) {
        return fmt::format("{:.4g} ({:.2g}; {:.2g})", s.mean() / unit, s.deviation() / unit,
                           s.claim() / unit);
      };
      item.agree(fmt::format("zone-{}-{}km", all[i].name, length),
                 fmt::format("zone {}, mean A, {} km records", all[i].name, length), "m² cycle/m",
                 l.A.mean() * all[i].track.A, all[i].track.A,
                 0.01 + 3 * l.A.claim() / std::sqrt(plan.records), "synthesis");
      item.add_row({all[i].name, length, cell(l.A, 1), cell(l.phi_c, 1), cell(l.B, mm),
                    fmt::format("{:g}", all[i].track.B / mm),
                    fmt::format("{:.1f} ({:.2g})", l.d.mean() / mm, l.d.deviation() / mm),
                    counted(l.counts)});
      worst = std::max(worst, std::abs(l.A.mean() - 1));
      spread += std::pow(l.A.deviation(), 2);
      claim += std::pow(l.A.claim(), 2);
      spread_Q += std::pow(l.Q.deviation() / l.Q.claim(), 2) / static_cast<double>(all.size());
      claim_Q += 1.0 / static_cast<double>(all.size());
    }
    // 13 zones of n records: the ratio has a standard error of 1/sqrt(26 n), and tails are not quite normal.
    const double allowed = 0.02 + 4 / std::sqrt(26.0 * plan.records);
    item.agree("claim-A-" + length, "scatter of A over all zones, against the claim", "",
               std::sqrt(spread / claim), 1, allowed, "standard errors of the regression");
    item.agree("claim-Q-" + length, "scatter of the line power, against the claim", "",
               std::sqrt(spread_Q / claim_Q), 1, allowed, "standard errors of the line");
    if (&plan != &runs[runs.size() > 1 ? 1 : 0]) continue;  // the prose tells of one length
    item.value("closed-loop-worst", 100 * worst, "%", "{:.1f}");
    item.value("closed-loop-records", plan.records, "", "{:.0f}");
    item.value("closed-loop-km", plan.length / km, "km", "{:.0f}");
    item.value("closed-loop-ratio", std::sqrt(spread / claim), "", "{:.2f}");
    item.value("closed-loop-ratio-B", std::sqrt(spread_Q / claim_Q), "", "{:.2f}");
  }
}

/*** What a record of a given length will claim can be told without any random number: the expected spectrum, the model plus the
lines as the window shows them, goes through the estimator as a record of 500 km, and errors grow with the root of the number of
segments that a shorter record lacks.
*/
const spectra::SpectrumFit& long_fit(const Zone& zone, double length) {
  static std::map<std::string, spectra::SpectrumFit> done;
  if (const auto known = done.find(zone.name); known != done.end()) return known->second;
  spectra::SyntheticTrack joints = synthetic(zone.track, 1);
  joints.A = 0;
  spectra::Spectrum expected = record_spectrum(joints, length, {});
  const spectra::TrackParameters random{.A = zone.track.A, .phi_c = zone.track.phi_c};
  for (Eigen::Index k = 1; k < expected.density.size(); ++k)
    expected.density[k] += spectra::random_psd(random, expected.frequency(k));
  return done[zone.name] = spectra::fit_track_spectrum(expected);
}

spectra::SpectrumFit expected_fit(const Zone& zone, double length) {
  const double long_record = 500 * km, hop = 2048 * units::foot;
  auto fit = long_fit(zone, long_record);
  const double growth = (long_record - hop) / (length - hop);  // of the variances
  fit.A.error *= std::sqrt(growth);
  fit.Q_1.error *= std::sqrt(growth);
  fit.A_Q_covariance *= growth;
  return fit;
}

std::vector<double> lengths() {
  std::vector<double> result;
  for (double length = 2 * km; length < 501 * km; length *= std::pow(250.0, 1.0 / 24))
    result.push_back(length);
  return result;
}

const Zone& zone_named(const std::vector<Zone>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Zone& z) { return z.name == name; });
}

void fig_length(report::Item& item) {
  const auto all = zones(item.printed("table-1.csv"));
  auto& claimed = item.data({"zone", "length_km", "error_percent"});
  auto& counted =
      item.data("records", {"zone", "length_km", "scatter_percent", "low_percent", "high_percent"});
  for (const char* name : {"1", "10", "13"}) {
    const Zone& zone = zone_named(all, name);
    const auto error = [&](double length) {
      return expected_fit(zone, length).A.error / zone.track.A;
    };
    for (const double length : lengths()) claimed.add(name, length / km, 100 * error(length));
    claimed.gap();
    const int records = item.full() ? 200 : 40;
    for (const double length : {2 * km, 5 * km, 10 * km, 20 * km}) {
      const Loop loop = closed_loop(zone, length, records);
      const double scatter = 100 * loop.A.deviation(), own = scatter / std::sqrt(2.0 * records);
      counted.add(name, length / km, scatter, scatter - own, scatter + own);
    }
    const auto root = num::find_root([&](double length) { return error(length) - 0.05; }, 1.5 * km,
                                     200 * km, 1e-3);
    item.value(std::string{"length-"} + name, root.x / km, "km", "{:.1f}");
  }
  item.reconstructed(
      "the paper gives no errors; records are synthetic, from the printed parameters");
}

void fig_class(report::Item& item) {
  const auto all = zones(item.printed("table-1.csv"));
  auto& odds = item.data({"zone", "length_km", "class_2", "class_3", "class_4", "class_5"});
  auto& counts =
      item.data("records", {"zone", "length_km", "class_2", "class_3", "class_4", "class_5"});
  for (const char* name : {"7", "10", "12"}) {
    const Zone& zone = zone_named(all, name);
    for (const double length : lengths()) {
      const auto p = spectra::class_probabilities(expected_fit(zone, length), paper_rule);
      odds.add(name, length / km, p[2], p[3], p[4], p[5]);
    }
    odds.gap();
    for (const Plan& plan : plans(item.full())) {
      const Loop& loop = loops(all, plan)[static_cast<std::size_t>(&zone - all.data())];
      const auto share = [&](std::size_t m) {
        return loop.counts[m] / static_cast<double>(plan.records);
      };
      counts.add(name, plan.length / km, share(2), share(3), share(4), share(5));
    }
  }
  item.reconstructed("the paper gives no odds; records are synthetic, from the printed parameters");
}

}  // namespace

void add_accuracy(report::Chapter& chapter) {
  chapter.table("closed-loop", "Estimates from synthetic records of the thirteen zones",
                table_closed_loop);
  chapter.figure("fig-length", "Error of the roughness against the length of the record",
                 fig_length);
  chapter.figure("fig-class", "Odds of the class against the length of the record", fig_class);
}

}  // namespace railbook::psd_chapter
