/***
### Statics

First the deflection under a wheel on the continuous foundation, relative to the closed form (1). The Fourier
integral needs no knowledge of the solution and reaches its tolerance whatever that is. Cubic elements with the
consistent foundation matrix converge with the fourth power of their length (measured {{cubic-order}}), until
rounding, which grows with the inverse fourth power, takes over at {{cubic-floor}}: more elements then make it
*worse*. Exact elements need one on each side, and their only error is where the rail is cut, $e^{-2\beta L}$.

{{cost-statics}}

{{work-precision: cost-statics}}

On discrete ties there is no closed form as simple; the reference is the Bloch integral. Elements from tie to
tie are exact but for the cut, so that ten digits cost {{ties-count}} unknowns and {{ties-time}}. The smeared
foundation is off by a fixed {{smeared-error}}, and takes no time at all: that is the trade the paper makes, and
it is a good one.

{{cost-ties}}

{{work-precision: cost-ties}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bench/work_precision.hpp"
#include "items.hpp"
#include "track/beam_elements.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

bench::Outcome beam_outcome(const WinklerBeam& beam, double reach, int elements_a_side,
                            Element element) {
  const double end = reach / beam.beta();
  const BeamModel model{.bending_stiffness = beam.bending_stiffness,
                        .foundation_modulus = beam.foundation_modulus,
                        .x = Eigen::VectorXd::LinSpaced(2 * elements_a_side + 1, -end, end),
                        .element = element};
  const auto solution = solve_beam(model, {{elements_a_side, 1.0}});
  return {.values = {solution.deflection(elements_a_side)},
          .work = double(solution.unknowns),
          .reason = ""};
}

void cost_statics(report::Item& item) {
  const auto beam = typical_beam();
  bench::Method fourier{"Fourier integral", {}}, cubic{"cubic elements", {}},
      exact{"exact elements cut at beta L", {}};
  for (const double relative : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    fourier.settings.push_back({fmt::format("asked for {:.0e}", relative), [=] {
                                  const auto y = deflection_by_fourier(beam, 1.0, 0.0, relative);
                                  return bench::Outcome{.values = {y.value},
                                                        .work = double(y.evaluations),
                                                        .converged = y.converged,
                                                        .reason = "quadrature stopped early"};
                                }});
  for (const int n : {7, 14, 28, 56, 112, 224, 448, 896, 1792})
    cubic.settings.push_back({fmt::format("{} a side, beta L = 14", n),
                              [=] { return beam_outcome(beam, 14, n, Element::cubic); }});
  for (const double reach : {2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0})
    exact.settings.push_back({fmt::format("beta L = {:.0f}", reach),
                              [=] { return beam_outcome(beam, reach, 1, Element::exact); }});
  const auto points =
      bench::measure("cost-statics", {{"deflection", 1.0 / beam.point_stiffness(), 1e-15}},
                     {fourier, cubic, exact}, item.timings(), 0.1);
  bench::show(item, points, "deflection");
  const auto smooth = [](const report::WorkPrecision& p) { return p.error > 1e-8; };
  std::vector<report::WorkPrecision> before_rounding;
  std::ranges::copy_if(points, std::back_inserter(before_rounding), smooth);
  double floor = 1;
  for (const auto& p : points)
    if (p.method == cubic.name) floor = std::min(floor, p.error);
  item.value("cubic-floor", floor, "", "{:.0e}");
  item.value("cubic-order", -bench::observed_slope(before_rounding, "deflection", cubic.name), "",
             "{:.2f}");
  item.reconstructed("not in the paper: our own study of methods");
}

void cost_ties(report::Item& item) {
  const auto support = typical_support();
  const auto beam = typical_beam();
  const double seat = stiffness_chain(support).seat;
  const double b = beam.beta() * support.tie_spacing;
  const double reference = discrete_tie_ratio(b, LoadPlace::over_tie) * beam.point_stiffness();
  bench::Method elements{"elements from tie to tie", {}};
  for (const int bays : {5, 10, 15, 20, 30, 40})
    elements.settings.push_back(
        {fmt::format("{} bays a side", bays), [=] {
           const auto model = rail_on_ties(beam.bending_stiffness, seat, support.tie_spacing, bays,
                                           LoadPlace::over_tie);
           const auto s = solve_beam(model, {{bays, 1.0}});
           return bench::Outcome{
               .values = {1.0 / s.deflection(bays)}, .work = double(s.unknowns), .reason = ""};
         }});
  const bench::Method smeared{"smeared ties",
                              {{"equation (2)", [=] {
                                  return bench::Outcome{
                                      .values = {beam.point_stiffness()}, .work = 1, .reason = ""};
                                }}}};
  const auto points = bench::measure("cost-ties", {{"stiffness", reference, 1e-14}},
                                     {elements, smeared}, item.timings(), 0.1);
  bench::show(item, points, "stiffness");
  item.reconstructed("not in the paper: our own study of methods");
  item.value("smeared-error", 100 * std::abs(beam.point_stiffness() / reference - 1), "%",
             "{:.3f}");
  for (const auto& point : points)
    if (point.method == elements.name && point.error < 1e-10) {
      item.value("ties-time", 1e6 * point.seconds_min, "µs", "{:.0f}");
      item.value("ties-count", point.work, "", "{:.0f}");
      break;
    }
}

}  // namespace

void track_chapter::add_static_cost(report::Chapter& chapter) {
  chapter.figure("cost-statics", "Error against cost: rail on a continuous foundation",
                 cost_statics);
  chapter.figure("cost-ties", "Error against cost: rail on discrete ties", cost_ties);
}
