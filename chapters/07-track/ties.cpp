/***
## Does smearing the ties matter?

The rail sits on ties, not on a continuous bed; the paper says that theory and experiment agree "more or less".
In statics the discrete track can be solved exactly, twice over. Cubic beam elements with nodes at the ties and
under the wheel leave no discretisation error, since between nodes nothing acts on the rail. And the infinite
periodic track reduces to one integral over the phase $\varphi$ between neighbouring ties (Bloch): with $b=\beta
l_t$, for a wheel over a tie,

$$\frac{K_r^{ties}}{K_r}=\left[8b^3\cdot\frac1{2\pi}\int_{-\pi}^{\pi}
  \frac{d\varphi}{4b^4+12\,(1-\cos\varphi)^2/(2+\cos\varphi)}\right]^{-1}.$$

{{fig-ties}}

At the typical spacing, $\beta l_t$ = {{beta-spacing}}, the wheel feels {{over-tie}} more stiffness over a tie and
{{midspan}} less between two. The deviations are about {{over-factor}} and {{midspan-factor}} times $(\beta l_t)^4$. So smearing is
harmless on any track that a train can use, and the measured scatter behind "more or less" is not the ties'
spacing. The wheel does feel the passing ties as a rhythm, though, and Winkler's bed has none.

The last check is against another code. ROSE, a public finite-element program for train and track, has a
benchmark of 100 ties at $\beta l_t$ = {{rose-spacing}}, for which its answer is compared with Winkler's closed
form and found to differ by {{rose-gap}}. That gap is not the program's error: it is the ties. Against the exact
discrete solution ROSE is right to {{rose-error}}.
*/

#include <fmt/format.h>

#include <cmath>

#include "items.hpp"
#include "track/beam_elements.hpp"
#include "track/typical_track.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {

double ratio_by_elements(double b, LoadPlace place) {
  const WinklerBeam smeared{.bending_stiffness = 1.0, .foundation_modulus = 4 * b * b * b * b};
  const int bays = int(18.0 / b) + 12;  // beta L = 18: the cut costs e^-36
  const auto track = rail_on_ties(1.0, smeared.foundation_modulus, 1.0, bays, place);
  const double deflection = solve_beam(track, {{bays, 1.0}}).deflection(bays);
  return 1.0 / (deflection * smeared.point_stiffness());
}

// The benchmark of another code: 100 ties, the load over one in the middle.
void peer(report::Item& item) {
  const auto peers = item.printed("peers.csv");
  const double ei = 4.41e5, tie = 2.75e5, spacing = 1.0, force = 18e3;
  const double exact =
      solve_beam(rail_on_ties(ei, tie, spacing, 50, LoadPlace::over_tie), {{50, force}})
          .deflection(50);
  item.check(
      "rose", peers.at("rose", "what"), "mm", peers.at("rose", "printed"), exact * 1e3,
      report::relative(2e-5, "a dynamic run that settles to the static answer; not exact in time"));
  const WinklerBeam smeared{ei, tie / spacing};
  const double theirs = report::printed_number(peers.at("rose", "printed")) / 1e3;
  item.value("rose-spacing", smeared.beta() * spacing, "", "{:.4f}");
  item.value("rose-gap", 100 * (1 - theirs * smeared.point_stiffness() / force), "%", "{:.2f}");
  item.value("rose-error", std::abs(theirs / exact - 1), "", "{:.0e}");
}

void ties(report::Item& item) {
  auto& curve = item.data({"beta_spacing", "over_tie", "minus_midspan"});
  for (double b = 0.1; b <= 2.0; b *= 1.03)
    curve.add(b, discrete_tie_ratio(b, LoadPlace::over_tie) - 1,
              1 - discrete_tie_ratio(b, LoadPlace::midspan));
  auto& points = item.data("elements", {"beta_spacing", "over_tie", "minus_midspan"});

  const double typical = typical_beam().beta() * typical_support().tie_spacing;
  item.reconstructed(
      "not in the paper: two exact solutions of the discrete track against each other");
  item.expect_checks(11);
  for (const double b : {0.2, typical, 0.75, 1.0, 2.0}) {
    const double over = ratio_by_elements(b, LoadPlace::over_tie);
    const double mid = ratio_by_elements(b, LoadPlace::midspan);
    points.add(b, over - 1, 1 - mid);
    item.agree(fmt::format("over-{:.3g}", b), fmt::format("over a tie, beta l_t = {:.4g}", b), "",
               over, discrete_tie_ratio(b, LoadPlace::over_tie), 1e-10, "the Bloch integral");
    item.agree(fmt::format("mid-{:.3g}", b), fmt::format("at midspan, beta l_t = {:.4g}", b), "",
               mid, discrete_tie_ratio(b, LoadPlace::midspan), 1e-10, "the Bloch integral");
  }
  peer(item);
  auto& spacing = item.data("typical", {"beta_spacing"});
  spacing.add(typical);
  const double fourth = std::pow(typical, 4);
  item.value("over-factor", (discrete_tie_ratio(typical, LoadPlace::over_tie) - 1) / fourth, "",
             "{:+.4f}");
  item.value("midspan-factor", (discrete_tie_ratio(typical, LoadPlace::midspan) - 1) / fourth, "",
             "{:+.4f}");
  item.value("beta-spacing", typical, "", "{:.4f}");
  item.value("over-tie", 100 * (discrete_tie_ratio(typical, LoadPlace::over_tie) - 1), "%",
             "{:.4f}");
  item.value("midspan", 100 * (1 - discrete_tie_ratio(typical, LoadPlace::midspan)), "%", "{:.4f}");
}

}  // namespace

void track_chapter::add_ties(report::Chapter& chapter) {
  chapter.figure("fig-ties", "What smearing the ties costs, against their spacing", ties);
}
