/*** ### Modulated: uneven joints

Real joints are not equally low. The paper names two extremes ({{fig-05}}): dips that vary at random
from joint to joint, and dips that come and go in groups, over a soft spot or a bridge. Does the
spectrum tell them apart? To answer this, joint $j$ is given the dip $b_j=b(1+\mu\,g_j)$, where
$\mu$ is the scatter of the dips over their mean and $g_j$ a normal random number. Neighbours have
the correlation $\varrho$, joints $i$ rails apart $\varrho^i$. For the random dips $\varrho=0$. For
the grouped dips $\varrho=\cos(\pi/5)$: then a run of joints deeper than the mean is five joints
long on average, as in the paper. Both kinds have the same mean and the same scatter.

{{fig-05}}

::: {.fold summary="The spectrum of uneven joints in closed form"}

For this model the one-sided spectrum has a closed form. The mean dip keeps its lines; the scatter
adds a continuum,

$$S(\varphi)=2\mu^2b^2l\,|F(\varphi l)|^2\,\frac{1-\varrho^2}{1-2\varrho\cos2\pi\varphi l+\varrho^2},$$

where $F$ is the Fourier transform of one dip of depth 1. Grouped dips collect their power around
the lines. At $\varphi_0$ their continuum is {{grouped-ratio}} times as high as that of random dips;
midway between two lines it is lower by the same factor.

:::

Can one see this in a spectrum? The paper says that "the PSD cannot distinguish between these two
extreme cases". {{five-miles}} compares the spectra of both kinds of track. We read the paper's
"several miles" as five miles of each, and the window is a Hann window on segments of 4096 ft. The
difference is given in standard errors of the difference, by the distance from $\varphi_0$ in bins.
At $\varphi_0$ itself the line of the mean dip is so much stronger than either continuum that the
two agree within {{apart-line}} standard errors, even on track without roughness. They differ most
two bins away.

{{five-miles}}

With the printed $A$, $\varphi_c$ and $b=B/2$ of the six jointed zones, and with depths that scatter
by a half of their mean, an ordinate two bins away differs by {{apart-least}} to {{apart-most}}
standard errors. If three are needed, one cannot tell the two cases apart by looking at the peak, as
the paper says. The information is in the spectrum all the same. An observer who knew both shapes
could combine the ordinates two to eight bins away on both sides. He would find a difference of
{{together-least}} to {{together-most}} standard errors, more than three in {{together-seen}} alone,
and twice as many on four times the track.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include <railbook/num/parallel.hpp>
#include <railbook/spectra/joint_dips.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {
namespace {

constexpr double mean_dip = 10 * mm;
constexpr double resolution = 1.0 / (4096 * units::foot);
constexpr std::size_t five_miles = 5 * 5280;  // samples of 1 ft
const double in_groups =
    std::cos(units::pi / 5);  // runs above the mean are pi/arccos(rho) joints long

spectra::SyntheticTrack uneven(double correlation) {
  spectra::SyntheticTrack track;
  track.dip = mean_dip;
  track.dip_scatter = 0.5;
  track.dip_correlation = correlation;
  return track;
}

double scattered(double correlation, double phi) {
  return spectra::joint_scatter_psd({rail, mean_dip, 0.5, correlation}, phi);
}

void fig_05(report::Item& item) {
  item.rebuilt(
      "the paper's drawings are not in our copy; these have the same mean and scatter of dips");
  auto track = uneven(0.0);
  track.spacing = rail / 40;
  const auto random = spectra::synthesize(track, 40 * 40 + 1);
  track.dip_correlation = in_groups;
  const auto grouped = spectra::synthesize(track, 40 * 40 + 1);
  report::Data& curve = item.data({"x_m", "random_mm", "grouped_mm"});
  for (std::size_t i = 0; i < random.size(); ++i)
    curve.add(static_cast<double>(i) * track.spacing, random[i] / mm, grouped[i] / mm);
  item.value("grouped-ratio", scattered(in_groups, phi_0) / scattered(0, phi_0), "", "{:.1f}");
}

// How `apart` counts the standard errors: far from a line the average of M segments that overlap by
// half has the variance N^2/K, with N the density of the continuum as the window shows it and K the
// number of independent averages, a little less than M. Near a line of density P the two interfere,
// which adds 2PN/M, a third more for the overlap. And the depths of the joints vary in phase with
// the line, not at random phase: on the line itself the scatter's part of both terms counts twice,
// and within a bin or two still a little more than once.
constexpr int bins = 9;          // from the line on
constexpr double seen_from = 3;  // standard errors that count as a difference
using PerBin = std::array<double, bins>;

// The amplitude of a line as a Hann window shows it, `u` bins away.
double hann_amplitude(double u) {
  const double below = std::abs(u) < 1e-6 ? 1 : std::sin(units::pi * u) / (units::pi * u);
  return std::abs(std::abs(u) - 1) < 1e-6 ? 0.5 : below / (1 - u * u);
}

PerBin apart(const spectra::SyntheticTrack& track) {
  const spectra::Spectrum like = spectra::welch(std::vector<double>(five_miles), track.spacing);
  const auto segments = static_cast<double>(like.segments);
  const double interference = 2 * (1 + (1 - 1 / segments) / 3) / segments;
  const double phi_1 = 1 / track.rail_length;
  const double line_power = spectra::line_power(1, track.dip, LineConvention::exact_one_sided);
  PerBin errors{};
  for (std::size_t k = 0; k < bins; ++k) {
    const auto bin = static_cast<double>(k);
    struct Seen {
      double N = 0, in_phase = 0;  // the continuum, and what of it is in phase with the line
    };
    const auto continuum = [&](double correlation) {
      const spectra::JointDips dips{track.rail_length, track.dip, track.dip_scatter, correlation};
      Seen seen;
      double weight = 0;
      for (double off = -3.05; off < 3.1; off += 0.1) {  // bins from this one
        const double phi = phi_1 + (bin + off) * resolution, w = hann_amplitude(off);
        const double scatter = spectra::joint_scatter_psd(dips, phi);
        seen.N +=
            w * w * (scatter + spectra::random_psd({.A = track.A, .phi_c = track.phi_c}, phi));
        seen.in_phase += w * hann_amplitude(2 * bin + off) * scatter;
        weight += w * w;
      }
      return Seen{seen.N / weight, seen.in_phase / weight};
    };
    const double line = line_power * hann_line(bin * resolution, resolution);
    const auto variance = [&](const Seen& s) {
      return (s.N * s.N + s.in_phase * s.in_phase) / like.averages +
             interference * line * (s.N + s.in_phase);
    };
    const Seen random = continuum(0), grouped = continuum(in_groups);
    errors[k] = (grouped.N - random.N) / std::sqrt(variance(grouped) + variance(random));
  }
  return errors;
}

// The same, counted over records of five miles.
PerBin apart_counted(const spectra::SyntheticTrack& like, std::size_t records) {
  struct Densities {
    std::array<PerBin, 2> of;  // random, grouped
  };
  const auto first = static_cast<Eigen::Index>(std::round(1 / (like.rail_length * resolution)));
  const auto all = num::map_in_parallel(records, [&](std::size_t record) {
    Densities found{};
    for (std::size_t grouped = 0; grouped < 2; ++grouped) {
      auto track = like;
      track.seed = 9000 + 2 * record + grouped;
      track.dip_correlation = grouped == 1 ? in_groups : 0.0;
      const auto spectrum = spectra::welch(spectra::synthesize(track, five_miles), track.spacing);
      for (std::size_t k = 0; k < bins; ++k)
        found.of[grouped][k] = spectrum.density[first + static_cast<Eigen::Index>(k)];
    }
    return found;
  });
  PerBin errors{};
  for (std::size_t k = 0; k < bins; ++k) {
    double mean = 0, square = 0;  // of the difference of two records
    for (const Densities& d : all) {
      const double difference = d.of[1][k] - d.of[0][k];
      mean += difference / static_cast<double>(records);
      square += difference * difference / static_cast<double>(records);
    }
    errors[k] = mean / std::sqrt(square - mean * mean);
  }
  return errors;
}

// The best that the ordinates two to eight bins away on both sides give together: each weighed by
// its own difference; neighbouring bins of a Hann window are correlated by 4/9, the next but one by
// 1/36.
double together(const PerBin& apart) {
  double signal = 0, variance = 0;
  for (std::size_t i = 2; i < bins; ++i) {
    signal += apart[i] * apart[i];
    for (std::size_t j = 2; j < bins; ++j) {
      const std::size_t off = i > j ? i - j : j - i;
      const double correlation = off == 0 ? 1.0 : off == 1 ? 4 / 9.0 : off == 2 ? 1 / 36.0 : 0.0;
      variance += correlation * apart[i] * apart[j];
    }
  }
  return std::sqrt(2 / variance) * signal;
}

// The six jointed zones, with depths that scatter by half of their mean; `most` over half and twice
// the scatter as well.
struct Jointed {
  std::vector<PerBin> zones;
  std::vector<double> two_away, all_together;
  std::vector<std::string> seen_together;  // where all together differ enough to be seen
  double on_line = 0, most = 0;
};

Jointed jointed_zones(const std::vector<Zone>& all) {
  Jointed found;
  for (std::size_t zone = 7; zone <= 12; ++zone) {
    spectra::SyntheticTrack track = synthetic(all.at(zone - 1).track, 1);
    for (const double scatter : {0.25, 1.0, 0.5}) {
      track.dip_scatter = scatter;
      const PerBin errors = apart(track);
      found.most = std::max(found.most, std::ranges::max(errors));
      if (scatter != 0.5) continue;
      found.zones.push_back(errors);
      found.two_away.push_back(errors[2]);
      found.all_together.push_back(together(errors));
      if (found.all_together.back() > seen_from) found.seen_together.push_back(all[zone - 1].name);
      found.on_line = std::max(found.on_line, errors[0]);
    }
  }
  return found;
}

// How far the counted are off the computed, at most, in their own standard errors.
double worst_count(const PerBin& counted, const PerBin& computed, std::size_t records) {
  double worst = 0;
  for (std::size_t k = 0; k < bins; ++k) {
    const double error = std::sqrt((1 + computed[k] * computed[k]) / static_cast<double>(records));
    worst = std::max(worst, std::abs(counted[k] - computed[k]) / error);
  }
  return worst;
}

void table_five_miles(report::Item& item) {
  item.added("grouped less random dips, in standard errors, for five miles of each");
  const auto alone = uneven(0.0);  // no roughness
  const std::size_t records = item.full() ? 4000 : 400;
  const PerBin computed = apart(alone), counted = apart_counted(alone, records);
  const Jointed jointed = jointed_zones(zones(item));
  std::vector<report::Heading> headings{
      {"bins from φ<sub>0</sub>", "{:.0f}"},
      {"no roughness, b = 10 mm: computed", "{:.1f}"},
      {fmt::format("the same, counted over {} records", records), "{:.1f}"}};
  for (const char* zone : {"zone 7", "8", "9", "10", "11", "12"})
    headings.emplace_back(zone, "{:.1f}");
  item.columns(headings);
  for (std::size_t k = 0; k < bins; ++k) {
    const auto& z = jointed.zones;
    item.add_row(double(k), computed[k], counted[k], z[0][k], z[1][k], z[2][k], z[3][k], z[4][k],
                 z[5][k]);
  }
  item.expect_checks(1);
  item.at_most("counted", "computed less counted, over the error of counting", "",
               worst_count(counted, computed, records), by_chance(bins), "chance");
  const auto [least_two, most_two] = std::ranges::minmax(jointed.two_away);
  const auto [least_all, most_all] = std::ranges::minmax(jointed.all_together);
  item.claims({{"distinguish", {jointed.most, jointed.on_line, most_all}}});
  item.value("together-seen", fmt::format("zones {}", fmt::join(jointed.seen_together, " and ")));
  report::values(item, "", "{:.1f}", "apart-line",
                 std::max({computed[0], counted[0], jointed.on_line}), "apart-least", least_two,
                 "apart-most", most_two, "together-least", least_all, "together-most", most_all);
}

// The power of the line at `phi` of a record of whole periods: no window, no neighbours.
double direct_power(const spectra::SyntheticTrack& track, std::size_t samples, double phi) {
  const auto z = spectra::synthesize(track, samples);
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i)
    sum += z[i] * std::polar(1.0, -2 * units::pi * phi * static_cast<double>(i) * track.spacing);
  return 2 * std::norm(sum / static_cast<double>(z.size()));
}

void fig_04(report::Item& item) {
  item.rebuilt(
      "the paper's drawings are not in our copy: dips of 10 mm, scatter and modulation of half of "
      "them");
  spectra::SyntheticTrack linear = uneven(0.0);
  linear.dip_scatter = 0.0;
  auto nonlinear = linear;
  linear.memory_dip = 0.5 * mean_dip;
  nonlinear.memory_modulation = 0.5;
  auto fine = nonlinear;
  fine.spacing = units::foot / 10;  // at 1 ft the harmonics above the 19th fold onto the lower ones
  const double lower = direct_power(fine, 4290, phi_0 - eps);  // 11 rails of 39 ft are 13 of 33 ft
  const double upper = direct_power(fine, 4290, phi_0 + eps);
  item.claims({{"symmetric", {lower / upper - 1}}});

  const auto lines = spectra::modulated_lines(phi_0, mean_dip, 0.0, eps, 1.0);
  auto with_memory = lines;
  with_memory.push_back(
      {1 / old_rail, spectra::line_power(1, linear.memory_dip, LineConvention::exact_one_sided)});
  const auto pairs = spectra::modulated_lines(phi_0, mean_dip, 0.5, eps, 1.0);
  report::Data& curve = item.data({"phi_cycle_per_m", "random", "grouped", "single", "pair"});
  for (double phi = 0.05; phi < 0.13; phi += 0.1 * resolution) {  // ten to a side lobe
    const double line = lines_seen(lines, phi, resolution);
    curve.add(phi, line + scattered(0, phi), line + scattered(in_groups, phi),
              lines_seen(with_memory, phi, resolution), lines_seen(pairs, phi, resolution));
  }
}

/*** ### Ballast memory

Before 1939 US rails were 33 ft long. Under newer rail of 39 ft the old wavelength is still found,
for the old joints have worked their way into the ballast (the bed of stone) and the ground below
it. The paper calls this *ballast memory*. {{fig-06}} shows its two kinds, with the letters of the
paper's captions (the paper's text is one letter behind them). In the first kind the new rail is
welded or its joints are tight. The wave that maintenance has left of the old dips (b) is then added
to the new profile (c), and the sum (d) has one extra line at 1/(33 ft).

In the second kind the joints of the new rail have loosened, and each dips most where an old low
spot lies (e). This modulation puts a *sideband* on each side of the line, at
$\varphi_0\pm\varepsilon$. The wavenumber $\varepsilon$ is the difference of those of old and new
rail,

$$\varepsilon=\frac1{10.0}-\frac1{11.9}=\frac1{6?.5}, \tag{5}$$

where one digit of the result cannot be read in our copy. Lengths in feet give {{epsilon-feet}},
the printed metres {{epsilon-metres}}. With $\varphi_0$ rounded to 0.084 as in Table 1 it is
1/({{epsilon-rounded}}), which fits the legible characters.

{{fig-06}}

{{fig-04}} puts the paper's three signatures side by side: a peak whose foot uneven joints lift, and
the one or two extra peaks of old rail.

{{fig-04}}

::: {.fold summary="Why the difference of the wavenumbers? Why two equal sidebands?"}

Why $\varepsilon$? A joint feels the old pattern, whose rails are $l_{old}$ long, only at the place
where it lies. At the joints $x=jl$ the waves $\cos2\pi x/l_{old}$ and $\cos2\pi\varepsilon x$ have
the same values, so the depth of the joints varies with the wavenumber $\varepsilon$. The paper's
two sidebands are equal because it multiplies the profile by a smooth envelope. If instead each dip
is deeper or shallower as a whole, by up to the fraction $\nu$, the envelope is a staircase. The
line at $\varphi_0\mp\varepsilon$ then has the amplitude $\nu b\,F(1\mp\varepsilon l)$, and the
lower one has {{staircase-ratio}} times the power of the upper.

:::
*/
constexpr double modulation = 0.5;

void fig_06_curves(report::Data& curve) {
  const double fundamental = -spectra::line_strength(1, 5, LineConvention::exact_one_sided);  // mm
  for (int i = 0; i <= 715; ++i) {
    const double x =
        0.6 * i * units::foot;  // one period of everything: 429 ft; joints are among them
    const double old = -10 * (1 - spectra::rectified_sine(x, old_rail, 1.0));
    const double left = fundamental * std::cos(2 * units::pi * x / old_rail);
    const double fresh = -10 * (1 - spectra::rectified_sine(x, rail, 1.0));
    const double envelope = 1 + modulation * std::cos(2 * units::pi * eps * x);
    curve.add(x, old, left, fresh, fresh + left, envelope * fresh, -10 * envelope);
  }
}

void fig_06(report::Item& item) {
  item.rebuilt(
      "the paper's drawings are not in our copy: dips of 10 mm, modulated by half of them");
  fig_06_curves(item.data(
      {"x_m", "old_mm", "fundamental_mm", "new_mm", "linear_mm", "nonlinear_mm", "envelope_mm"}));
  item.value(
      "staircase-ratio",
      std::pow(spectra::dip_transform(1 - eps * rail) / spectra::dip_transform(1 + eps * rail), 2),
      "", "{:.2f}");
  report::values(item, "cycle/m", "{:.6f}", "epsilon-feet", eps, "epsilon-metres",
                 1 / 10.0 - 1 / 11.9);
  item.value("epsilon-rounded", 1 / (0.100 - 0.084), "m", "{:.1f}");
}

/*** ### All together

Independent processes add their spectra. On {{fig-07-length}} of synthetic track, made as a sum of
processes, the estimated spectrum agrees with the sum of their spectra.

::: {.fold summary="Random part and joints together, on linear and on logarithmic axes"}

{{fig-07}} is the paper's composite spectrum, here of zone 10. On linear axes the continuum cannot be
judged; on logarithmic ones both slopes are straight, and the peak is seen as well. The points are
the estimate.

{{fig-07}}

:::
*/
// Where to draw a spectrum with lines: ten points to a lobe of the first two, whose feet are in the
// picture; twenty to the width of the others.
double next_wavenumber(double phi, double df) {
  const double off = std::abs(phi / phi_0 - std::round(phi / phi_0)) * phi_0;
  return phi + (phi < 2.5 * phi_0 ? std::min(0.005 * phi, 0.1 * df)
                : off < 2.5 * df  ? 0.2 * df
                                  : std::min(0.005 * phi, df));
}

// An estimated spectrum over the sum of the random part and the lines: the mean of the ratios, and
// the ratio of the power within 10 % of the first line.
struct Ratios {
  double mean = 0, peak = 0;
};

Ratios over_sum(const spectra::Spectrum& estimate, const spectra::TrackParameters& track,
                const std::vector<spectra::Line>& lines) {
  double sum = 0, peak = 0, expected_peak = 0;
  int used = 0;  // bins
  for (Eigen::Index k = 4; estimate.frequency(k) <= 1.2; ++k) {
    const double phi = estimate.frequency(k);
    if (phi < 0.02) continue;
    const double expected = spectra::random_psd(track, phi) + lines_seen(lines, phi, estimate.df);
    sum += estimate.density[k] / expected;
    ++used;
    if (std::abs(phi * rail - 1.0) > 0.1) continue;
    peak += estimate.density[k];
    expected_peak += expected;
  }
  return {sum / used, peak / expected_peak};
}

void fig_07(report::Item& item) {
  item.rebuilt("the paper's drawing is not in our copy: zone 10 of Table 1, synthetic");
  const Zone zone = zones(item).at(9);
  spectra::SyntheticTrack track = synthetic(zone.track, 1);
  track.spacing = units::foot / 4;  // at 1 ft the harmonics above the 19th fold onto the lower ones
  const double length = (item.full() ? 2500 : 500) * km;
  const spectra::Spectrum spectrum = record_spectrum(track, length, {});
  const auto lines = spectra::modulated_lines(phi_0, track.dip, 0.0, 0.0, 1.7);
  report::Data& curve = item.data({"phi_cycle_per_m", "S_random", "S_periodic", "S_composite"});
  for (double phi = 0.01; phi < 1.6; phi = next_wavenumber(phi, spectrum.df)) {
    const double random = spectra::random_psd(zone.track, phi);
    const double line = lines_seen(lines, phi, spectrum.df);
    curve.add(phi, random, line, random + line);
  }
  report::Data& points = item.data("measured", {"phi_cycle_per_m", "S"});
  for (Eigen::Index k = 4; spectrum.frequency(k) < 1.6; ++k)
    points.add(spectrum.frequency(k), spectrum.density[k]);
  const Ratios ratios = over_sum(spectrum, zone.track, lines);
  item.claims({{"additive", {ratios.mean, ratios.peak}}});
  item.value("fig-07-length", length / km, "km", "{:.0f}");
}

}  // namespace

const report::Section modulated{report::figure("fig-05", fig_05),
                                report::table("five-miles", table_five_miles),
                                report::figure("fig-04", fig_04), report::figure("fig-06", fig_06),
                                report::figure("fig-07", fig_07)};

}  // namespace railbook::psd_chapter
