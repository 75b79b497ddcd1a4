/*** ## Taking the long waves out

Hills are no defects, and the integral of an accelerometer's bias is a hill. The paper's composite filter turns short offsets into long ones and
removes long waves in one go; Figure 13 showed the response of its high-pass part, and we do not know it. Ours is

$$H=1-b_M^{\,p},\qquad b_M(\theta)=\frac{\sin M\theta/2}{M\sin\theta/2},$$

one minus the centred mean over $M={{hp-length}}$ samples, applied $p={{hp-passes}}$ times: of zero phase, as reads the same in both directions, and again made of
running sums. The paper says which waves must pass: up to 150 ft at speeds to 90 mph, up to 200 ft at 120 mph. Both are the same frequency in
the car, {{limit-hertz}}: what counts is what shakes the car. Our choice passes {{hp-150}} of 150 ft and {{hp-200}} of 200 ft; it loses 3 dB
at {{hp-3dB}} and 6 dB at {{hp-6dB}}.

{{fig-13}}

The zero of $H$ at DC is double. With a chord it removes a constant acceleration altogether. The *pseudo space curve*, what
is left of the profile itself, is the short offset times $H/(1-\cos\theta)$, again a polynomial, divided without remainder. One factor of
the double zero goes into the division by the other: at DC the gain is $p(M^2-1)/12=${{curve-dc}}, and a constant bias in the acceleration shifts
the space curve. $H^2$, a second stage, takes that out too, for {{hp-200-two}} of 200 ft.

{{high-pass}}

The driven column is no response of weights but of the whole chain: a sampled sine, its short offsets, the streaming filter, at the crest.
*/
#include "filters/high_pass.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "configuration.hpp"
#include "filters/geometry_chain.hpp"
#include "items.hpp"
#include "num/roots.hpp"
#include "spectra/chord.hpp"

namespace railbook::filters_chapter {
namespace {

using filters::HighPass;
const HighPass ours{};

double gain_at(double wavelength_ft, const HighPass& filter = ours) {
  return filters::high_pass_gain(filter,
                                 2 * units::pi * units::foot / (wavelength_ft * sample_distance));
}

// What the chain makes of the crest of a sine: short offsets in, space curve out.
double driven_gain(double wavelength_ft) {
  const std::size_t half = filters::reach(ours) + 31;
  const double theta = 2 * units::pi / wavelength_ft;
  std::vector<double> z(2 * half + 1);
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = 1e-3 * std::cos(theta * (static_cast<double>(k) - static_cast<double>(half)));
  const auto short_offsets = spectra::mid_chord_offsets(z, 1, 2).offset;
  return filters::geometry(short_offsets).space_curve.at(half - 1) / 1e-3;
}

double wavelength_of(double gain) {
  return num::find_root([&](double w) { return gain_at(w) - gain; }, 200, 2000).x;
}

void fig_13(report::Item& item) {
  auto& data = item.data({"wavelength_ft", "ours", "one_pass", "two_stages"});
  constexpr int points = 400;
  for (int i = 0; i <= points; ++i) {
    const double w = 20 * std::pow(250.0, static_cast<double>(i) / points);
    data.add(w, gain_at(w), gain_at(w, {301, 1}), gain_at(w, {151, 4, 2}));
  }
  auto& driven = item.data("driven", {"wavelength_ft", "gain"});
  for (const double w : {20.0, 62.0, 150.0, 200.0, 300.0, 500.0, 1000.0, 3000.0})
    driven.add(w, driven_gain(w));
  auto& limits = item.data("limits", {"wavelength_ft", "what"});
  limits.add(150.0, "90 mph");
  limits.add(200.0, "120 mph");
  item.reconstructed("the paper's curve is not legible and it does not say how the filter is made");
}

void high_pass(report::Item& item) {
  const auto table = item.printed("high-pass.csv");
  const auto constants = item.printed("high-pass-constants.csv");
  item.expect_checks(static_cast<int>(2 * table.rows.size() + constants.rows.size()));
  item.columns({"wavelength, ft", "formula", "driven through the chain"});
  for (const auto& cells : table.rows) {
    const std::string& key = cells.at(0);
    const double w = report::printed_number(key), formula = gain_at(w), driven = driven_gain(w);
    item.row(table, key).check("gain", formula);
    item.check("driven-" + key, "the same, driven", "", table.at(key, "gain"), driven);
    item.add_row({key, fmt::format("{:.5f}", formula), fmt::format("{:.5f}", driven)});
  }
  const auto check = [&](const char* key, double value) {
    item.row(constants, key).check("value", value);
  };
  const double three = wavelength_of(std::sqrt(0.5)), six = wavelength_of(0.5);
  const double hertz_90 = 90 * units::mph / (150 * units::foot),
               hertz_120 = 120 * units::mph / (200 * units::foot);
  check("limit-90", hertz_90);
  check("limit-120", hertz_120);
  check("3dB", three);
  check("6dB", six);
  check("taps", static_cast<double>(filters::high_pass_taps(ours).size()));
  // A constant through the chain, not through the formula.
  const std::vector<double> constant(661, 1e-6);
  check("curve-dc", filters::geometry(constant).space_curve.at(330) / 1e-6);
  item.reconstructed(
      "the filter is ours; the reference values were worked out beforehand, not printed");
  item.value("hp-length", ours.length, "", "{:.0f}");
  item.value("hp-passes", ours.passes, "", "{:.0f}");
  item.value("limit-hertz", hertz_90, "Hz", "{:.2f}");
  item.value("hp-150", gain_at(150), "", "{:.3f}");
  item.value("hp-200", gain_at(200), "", "{:.3f}");
  item.value("hp-200-two", gain_at(200, {151, 4, 2}), "", "{:.3f}");
  item.value("hp-3dB", three, "ft", "{:.0f}");
  item.value("hp-6dB", six, "ft", "{:.0f}");
  item.value("curve-dc", filters::space_curve_gain(ours, 0), "", "{:.0f}");
}

}  // namespace

void add_high_pass(report::Chapter& chapter) {
  chapter.figure("fig-13", "Figure 13. High-pass part of the composite filter", fig_13);
  chapter.table("high-pass", "Gain of the high-pass", high_pass);
}

}  // namespace railbook::filters_chapter
