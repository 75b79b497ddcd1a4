/*** ### How much track does it take to know roughness, corner, dip and class?

$A$ is the roughness, $\varphi_c$ the corner and $B$ the dip of the joints, as printed.
{{length-answer}}

This was counted on {{length-records}} records of zone 12, synthesised from its printed $A$,
$\varphi_0$, $\varphi_c$ and $B$, on rail of {{length-rail}}. The zone is the hardest of the
thirteen to classify: its deviation is {{length-margin}} inside the limit of class 3, which is
therefore the right class here (the paper prints 2). Each record is read after {{length-lengths}},
in three ways:

* *4096 ft* is this library: Welch's method with segments of 4096 samples, a foot apart, and a
  regression that allows for the bias of a logarithm's mean.
* *512 ft* is the same with segments of 512 ft, the paper's likely analysis.
* *Ruler* does on segments of 512 ft what the paper does by hand. It lays a line of slope −2 through
  the bins below $\varphi_0$ and one of slope −4 through those above $3\varphi_0$, without the bins
  near multiples of $\varphi_0$. Then it takes the height of the peak above them times its width at
  half that height, as in (6), both from a smooth curve through the three highest points.

{{fig-length}}

{{length-bias}} At the longest length the class from 4096 ft is right in {{length-right}} of the
records, and the library gives that class a probability of {{length-stated}} on average. The
{{length-stated}} are fewer because the library spreads the stated error around an estimate that is
itself off by that error. The ruler's class is right in {{length-ruler}}, because its $B$ is too low
and moves the zone away from the limit.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/bench/work_precision.hpp>
#include <railbook/num/parallel.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/spectrum_fit.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

namespace {

constexpr const char* quantities[]{"A", "corner", "B"};

struct ReadTrack {
  Eigen::Array3d value;                            // A, phi_c, B in the printed convention
  Eigen::Array3d stated = Eigen::Array3d::Zero();  // their standard errors; the ruler has none
  double probability = 0;                          // stated of the zone's true class
};

int class_of(const Eigen::Array3d& track) {
  return spectra::classify(track[0], track[2]).track_class;
}

ReadTrack by_library(const spectra::Spectrum& spectrum, double rail_length, int true_class) {
  const auto fit = spectra::fit_track_spectrum(spectrum, {.rail_length = rail_length});
  return {{fit.A.value, fit.phi_c.value, fit.B_printed.value},
          {fit.A.error, fit.phi_c.error, fit.B_printed.error},
          spectra::class_probabilities(fit)[static_cast<std::size_t>(true_class)]};
}

/*** The function `by_ruler` does what the paper does by hand. */
ReadTrack by_ruler(const spectra::Spectrum& s, double rail_length, int) {
  const double phi_1 = 1 / rail_length;
  double flat = 0, steep = 0;
  int n_flat = 0, n_steep = 0;
  for (Eigen::Index k = 4; s.frequency(k) < 1.2; ++k) {
    const double phi = s.frequency(k), n = std::round(phi / phi_1);
    if (n > 0 && std::abs(phi - n * phi_1) < 0.02) continue;
    if (phi < phi_1) flat += std::log(s.density[k] * phi * phi), ++n_flat;
    if (phi > 3 * phi_1) steep += std::log(s.density[k] * std::pow(phi, 4)), ++n_steep;
  }
  const double A = std::exp(flat / n_flat), phi_c = std::sqrt(std::exp(steep / n_steep) / A);
  const auto excess = [&](Eigen::Index k) {
    return s.density[k] - spectra::random_psd({.A = A, .phi_c = phi_c}, s.frequency(k));
  };
  auto top = static_cast<Eigen::Index>(std::ceil((phi_1 - 0.02) / s.df));
  for (Eigen::Index k = top; s.frequency(k) <= phi_1 + 0.02; ++k)
    if (excess(k) > excess(top)) top = k;
  // A smooth curve through the highest point and its neighbours: on the graph's logarithmic axis, a
  // parabola.
  if (!(excess(top - 1) > 0 && excess(top) > 0 && excess(top + 1) > 0)) return {{A, phi_c, 0}};
  const double left = std::log(excess(top - 1)), middle = std::log(excess(top)),
               right = std::log(excess(top + 1));
  const double curvature = middle - (left + right) / 2, slope = (right - left) / 2;
  const double C_1 = std::exp(middle + slope * slope / (4 * curvature));
  const double beta = 2 * std::sqrt(std::log(2.0) / curvature) * s.df;
  return {{A, phi_c,
           spectra::dip_from_line_power(spectra::broadened_line_power(C_1, beta),
                                        LineConvention::printed)}};
}

struct Way {
  const char* name;
  spectra::WelchOptions welch;
  ReadTrack (*read)(const spectra::Spectrum&, double, int);
};
const Way ways[]{{"4096 ft", {}, by_library},
                 {"512 ft", {.segment = 512}, by_library},
                 {"ruler", {.segment = 512}, by_ruler}};

// Over the records, relative to what was put in.
struct Statistics {
  Eigen::Array3d bias = Eigen::Array3d::Zero(), scatter = bias, stated = bias;
  double right = 0, probability = 0;
  Eigen::Array3d rms() const { return (bias.square() + scatter.square()).sqrt(); }
};

struct Study {
  spectra::SyntheticTrack track;
  Eigen::Array3d truth;
  int records = 0, true_class = 0;
  std::vector<double> lengths;
  std::vector<std::vector<Statistics>> found;  // of each way, at each length
};

using Readings = std::vector<std::vector<ReadTrack>>;  // of one record: each way, each length

Readings read(const Study& study, std::size_t record, std::span<const Way> used) {
  spectra::SyntheticTrack track = study.track;
  track.seed = 5000 + record;
  const auto z =
      spectra::synthesize(track, static_cast<std::size_t>(study.lengths.back() / track.spacing));
  Readings readings;
  for (const Way& way : used) {
    spectra::Welch welch{track.spacing, way.welch};
    auto& of_way = readings.emplace_back();
    for (const double length : study.lengths) {
      const auto upto = static_cast<std::size_t>(length / track.spacing);
      welch.push(std::span{z}.subspan(welch.samples(), upto - welch.samples()));
      of_way.push_back(way.read(welch.spectrum(), track.rail_length, study.true_class));
    }
  }
  return readings;
}

Statistics statistics_of(const std::vector<ReadTrack>& readings, const Study& s) {
  Statistics at;
  for (const ReadTrack& r : readings) {
    at.bias += (r.value / s.truth - 1) / s.records;
    at.stated += r.stated / s.truth / s.records;
    at.right += class_of(r.value) == s.true_class ? 1 : 0;
    at.probability += r.probability / s.records;
  }
  for (const ReadTrack& r : readings)
    at.scatter += (r.value / s.truth - 1 - at.bias).square() / (s.records - 1);
  at.scatter = at.scatter.sqrt();
  at.right /= s.records;
  return at;
}

// A zone of Table 1 as so many of the ways read it.
Study study_zone(const report::Item& item, std::size_t number, std::span<const Way> used) {
  const Zone zone = zones(item).at(number - 1);
  Study s{.track = synthetic(zone.track, 1),
          .truth = {zone.track.A, zone.track.phi_c, zone.track.B},
          .records = item.full() ? 1000 : 200,
          .lengths = {2.5 * km, 5 * km, 10 * km, 20 * km},
          .found = {}};
  s.true_class = class_of(s.truth);
  // Each record by its own seed, on whichever processor is free.
  const auto all = num::map_in_parallel(static_cast<std::size_t>(s.records),
                                        [&](std::size_t record) { return read(s, record, used); });
  for (std::size_t w = 0; w < used.size(); ++w) {
    s.found.emplace_back();
    for (std::size_t i = 0; i < s.lengths.size(); ++i) {
      std::vector<ReadTrack> readings;
      readings.reserve(all.size());
      for (const Readings& of_record : all) readings.push_back(of_record[w][i]);
      s.found.back().push_back(statistics_of(readings, s));
    }
  }
  return s;
}

const Study& study_of(const report::Item& item) {
  static const Study study = study_zone(item, 12, ways);
  return study;
}

void fig_length(report::Item& item) {
  item.added("the paper gives no errors; records are synthetic, from the printed parameters");
  const Study& study = study_of(item);
  const double root = std::sqrt(static_cast<double>(study.records));
  auto& data = item.data({"quantity", "method", "length_km", "bias_percent", "bias_error",
                          "scatter_percent", "scatter_error", "stated_percent"});
  auto& right =
      item.data("class", {"method", "length_km", "right_percent", "error", "stated_percent"});
  for (std::size_t w = 0; w < std::size(ways); ++w)
    for (std::size_t i = 0; i < study.lengths.size(); ++i) {
      const Statistics& s = study.found[w][i];
      for (int q = 0; q < 3; ++q)
        data.add(quantities[q], ways[w].name, study.lengths[i] / km, 100 * s.bias[q],
                 100 * s.scatter[q] / root, 100 * s.scatter[q],
                 100 * s.scatter[q] / root / std::sqrt(2.0),
                 s.stated[q] > 0 ? 100 * s.stated[q] : units::nan);
      right.add(ways[w].name, study.lengths[i] / km, 100 * s.right,
                100 * std::sqrt(s.right * (1 - s.right)) / root,
                s.probability > 0 ? 100 * s.probability : units::nan);
    }
  const auto &own = study.found[0].back(), &narrow = study.found[1].back(),
             &ruler = study.found[2].back();
  item.expect_checks(3);
  for (int q = 0; q < 3; ++q)
    item.at_most(fmt::format("bias-{}", quantities[q]),
                 fmt::format("bias at the longest length: {}", quantities[q]), "",
                 std::abs(own.bias[q]), 0.01 + by_chance(3) * own.scatter[q] / root,
                 "1 % that the fit states, and chance");
  std::vector<double> kilometres;
  for (const double length : study.lengths) kilometres.push_back(length / km);
  item.value("length-records", study.records, "", "{:.0f}");
  item.value("length-lengths", fmt::format("{:g} km", fmt::join(kilometres, ", ")));
  // To a tenth, and no "-0.0".
  const auto percent = [](const Statistics& of, int q) {
    return std::round(1000 * of.bias[q]) / 10 + 0.0;
  };
  const Study of_7 = study_zone(item, 7, std::span{ways}.first(1));
  const Statistics &second = study.found[0][1], &second_7 = of_7.found[0][1];
  const auto known = [](const Statistics& of) {
    return fmt::format(
        "roughness to {:.0f} %, the corner to {:.0f} % and the dip to {:.0f} %, and "
        "{:.0f} % of the records have the right class",
        100 * of.rms()[0], 100 * of.rms()[1], 100 * of.rms()[2], 100 * of.right);
  };
  item.value(
      "length-answer",
      fmt::format("After {:g} km of zone 12, whose joints are the deepest of all, one knows "
                  "the {}. After {:g} km of zone 7, whose joints are less than half as deep, "
                  "one knows the {}.",
                  kilometres[1], known(second), kilometres[1], known(second_7)));
  item.value(
      "length-bias",
      fmt::format(
          "Segments of 512 ft scatter as little as those of 4096 ft. At {3:g} km they make A, "
          "corner and B wrong by {0:+.1f}, {1:+.1f} and {2:+.1f} % on average, those of 4096 ft by "
          "{8:+.1f}, {9:+.1f} and {10:+.1f} %. The ruler is wrong by {4:+.1f}, {5:+.1f} and "
          "{6:+.1f} %, and its A scatters {7:.1f} times as much.",
          percent(narrow, 0), percent(narrow, 1), percent(narrow, 2), kilometres.back(),
          percent(ruler, 0), percent(ruler, 1), percent(ruler, 2),
          ruler.scatter[0] / own.scatter[0], percent(own, 0), percent(own, 1), percent(own, 2)));
  item.value("length-rail", study.track.rail_length / units::foot, "ft", "{:.0f}");
  item.value("length-margin", 100 * spectra::classify(study.truth[0], study.truth[2]).margin, "%",
             "{:.1f}");
  report::values(item, "%", "{:.0f}", "length-right", 100 * own.right, "length-stated",
                 100 * own.probability, "length-ruler", 100 * ruler.right);
}

/*** ### Which of the three should one take?

{{cost-choice}} The computer's time does not decide: a kilometre of track takes less than a
millisecond.

The time is that of one record: its spectrum by Welch's method, and the three numbers read from it.
The error is the root mean square error of $A$ over all records of that length, from {{fig-length}}.
The true $A$ is known to {{cost-doubt}}, by which the generator's own density misses the model.

{{fig-cost}}

{{work-precision: fig-cost}}
*/
// How wrong A is by the generator alone: its own density, free of scatter, through the estimator.
double generator_error(const spectra::SyntheticTrack& track, const spectra::Spectrum& like) {
  const spectra::TrackGenerator generator{track};
  spectra::Spectrum own = like;
  own.averages = 1e9;
  for (Eigen::Index k = 1; k < own.density.size(); ++k)
    own.density[k] = generator.random_density(own.frequency(k));
  return std::abs(
      spectra::fit_track_spectrum(own, {.rail_length = track.rail_length}).A.value / track.A - 1);
}

// Which of the two regressions knows A better, by the length of the record; the errors of 200
// records are themselves uncertain by 5 %.
std::string choice(const Study& study) {
  const auto error = [&](std::size_t way, std::size_t length) {
    return study.found[way][length].rms()[0];
  };
  std::size_t from = study.lengths.size();  // the first length from which on 4096 ft are as good
  while (from > 0 && error(0, from - 1) <= 1.05 * error(1, from - 1)) --from;
  std::string advice = "For the roughness take segments of 4096 ft";
  if (from == study.lengths.size()) advice = "For the roughness take segments of 512 ft";
  if (from > 0 && from < study.lengths.size())
    advice += fmt::format(
        " for {:g} km and more, and of 512 ft for {:g} km, where its error is {:.0f} % with the "
        "first and {:.0f} % with the second; no length between was tried",
        study.lengths[from] / km, study.lengths[from - 1] / km, 100 * error(0, from - 1),
        100 * error(1, from - 1));
  const auto right = [&](std::size_t way) {
    std::vector<std::string> of_length;
    for (const Statistics& s : study.found[way])
      of_length.push_back(fmt::format("{:.0f}", 100 * s.right));
    return fmt::format("{} %", fmt::join(of_length, ", "));
  };
  return advice + fmt::format(
                      ". The class is right in {} of the records with segments of 4096 ft, and in "
                      "{} with 512 ft: for the class either will do.",
                      right(0), right(1));
}

void fig_cost(report::Item& item) {
  item.added("a comparison of methods");
  const Study& study = study_of(item);
  const double A = study.truth[0];
  const auto z = spectra::synthesize(
      study.track, static_cast<std::size_t>(study.lengths.back() / study.track.spacing));
  std::vector<bench::Method> methods;
  for (std::size_t w = 0; w < std::size(ways); ++w) {
    methods.push_back({ways[w].name, {}, 0, "points transformed"});
    for (std::size_t i = 0; i < study.lengths.size(); ++i) {
      const double rms = study.found[w][i].rms()[0];
      const auto n = static_cast<std::size_t>(study.lengths[i] / study.track.spacing);
      const auto run = [&z, &way = ways[w], A, n, rms, rail_length = study.track.rail_length,
                        true_class = study.true_class] {
        const auto spectrum = spectra::welch(std::span{z}.first(n), units::foot, way.welch);
        const ReadTrack read = way.read(spectrum, rail_length, true_class);
        return bench::Outcome{.values = {A * (1 + rms)},
                              .work = static_cast<double>(spectrum.segments * way.welch.segment),
                              .converged = std::isfinite(read.value[0]),
                              .reason = "no finite A"};
      };
      methods.back().settings.push_back(
          {fmt::format("{:g} km of track", study.lengths[i] / km), run});
    }
  }
  const double doubt =
      generator_error(study.track, spectra::welch(std::span{z}.first(8192), units::foot));
  bench::figure(item, {"A", A, doubt}, methods, 0.05);
  item.value("cost-choice", choice(study));
  item.value("cost-doubt", 100 * doubt, "%", "{:.2f}");
}

}  // namespace

const report::Section accuracy{report::figure("fig-length", fig_length),
                               report::figure("fig-cost", fig_cost)};

}  // namespace railbook::psd_chapter
