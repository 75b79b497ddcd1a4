/*** ### How much track does it take?

Each zone can be synthesised from its printed $A$, $\varphi_c$ and $B$ and estimated back. The points are the scatter of $A$ over such records, the lines
what the estimator claims for one record.

{{fig-length}}

The error of $A$ falls with the square root of the length. To know $A$ to 5 % takes {{length-1}} of zone 1, {{length-10}} of zone 10 and
{{length-13}} of zone 13: the higher the corner, the more of the spectrum belongs to the first slope. The "several miles" that the paper asks for are
well chosen. The claims are true: scatter over claim is {{claim-ratio}} over all points.
*/
#include <algorithm>
#include <cmath>
#include <map>

#include "num/roots.hpp"
#include "sections.hpp"
#include "spectra/spectrum_fit.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr double km = units::kilometre;

struct Scatter {
  double sum = 0, squares = 0;
  int n = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
    ++n;
  }
  double deviation() const { return std::sqrt((squares - sum * sum / n) / (n - 1)); }
};

// Of A over what was put in.
double scatter(const Zone& zone, double length, int records) {
  Scatter A;
  for (int r = 0; r < records; ++r) {
    const auto seed = 1000 * std::stoul(zone.name) + static_cast<std::uint64_t>(r);
    const auto fit =
        spectra::fit_track_spectrum(record_spectrum(synthetic(zone.track, seed), length, {}));
    A.add(fit.A.value / zone.track.A);
  }
  return A.deviation();
}

// What a record of a given length will claim can be told without any random number: the expected spectrum, the model plus
// the lines as the window shows them, goes through the estimator as a record of 500 km, and errors grow with the root of
// the number of segments that a shorter record lacks.
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

void fig_length(report::Item& item) {
  const auto all = zones(item.printed("table-1.csv"));
  auto& claimed = item.data({"zone", "length_km", "error_percent"});
  auto& counted =
      item.data("records", {"zone", "length_km", "scatter_percent", "low_percent", "high_percent"});
  const int records = item.full() ? 200 : 40;
  double ratio = 0;
  int points = 0;
  for (const char* name : {"1", "10", "13"}) {
    const Zone& zone =
        *std::find_if(all.begin(), all.end(), [&](const Zone& z) { return z.name == name; });
    const auto error = [&](double length) {
      return expected_fit(zone, length).A.error / zone.track.A;
    };
    for (const double length : lengths()) claimed.add(name, length / km, 100 * error(length));
    claimed.gap();
    for (const double length : {2 * km, 5 * km, 10 * km, 20 * km}) {
      const double found = 100 * scatter(zone, length, records),
                   own = found / std::sqrt(2.0 * records);
      counted.add(name, length / km, found, found - own, found + own);
      ratio += found / (100 * error(length)), ++points;
    }
    const auto root = num::find_root([&](double length) { return error(length) - 0.05; }, 1.5 * km,
                                     200 * km, 1e-3);
    item.value(std::string{"length-"} + name, root.x / km, "km", "{:.1f}");
  }
  item.expect_checks(1);
  // Twelve scatters of n records: their mean has a standard error of 1/sqrt(24 n).
  item.agree("claim", "scatter of A over its claim, mean of the points", "", ratio / points, 1,
             0.02 + 4 / std::sqrt(24.0 * records), "standard errors of the regression");
  item.value("claim-ratio", ratio / points, "", "{:.2f}");
  item.added("the paper gives no errors; records are synthetic, from the printed parameters");
}

}  // namespace

const report::Section record_length{report::figure(
    "fig-length", "Error of the roughness against the length of the record", fig_length)};

}  // namespace railbook::psd_chapter
