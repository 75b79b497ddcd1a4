/***
## The joint

Where two rails meet, bars bolted to both carry a part of the bending, or none when they are loose.
How much stiffness is left? Figure 3 of the paper shows the stiffness $K_j$ under a wheel near a
joint for two kinds of joint: a *pinned* one, which carries shear but no bending, and a *free* one,
which carries nothing. Both are cases of two semi-infinite rails linked by a shear spring $k_v$
(N/m) and a rotational spring $k_{rot}$ (N·m/rad).

Start from the unjointed rail, with the wheel at the distance $\xi=\beta X$ from the place of the
joint. There its moment is proportional to $c(\xi)=e^{-\xi}(\cos\xi-\sin\xi)$ and its shear to
$d(\xi)=e^{-\xi}\cos\xi$. A joint that does not carry the moment opens by a kink in proportion to
$c$; one that does not carry the shear opens by a step in proportion to $d$. How far does the rail
below the wheel sink by a kink or a step at the joint? By reciprocity (the theorem of Maxwell and
Betti) in proportion to $c$ and to $d$ once more. So the deflection below the wheel, 1 for unjointed
rail, grows by $c^2$ for a missing moment and by $2d^2$ for a missing shear:

$$\frac{K_j}{K_r}=\frac1{1+\kappa_m\,c^2(\xi)+2\kappa_v\,d^2(\xi)},\qquad
  \kappa_m=\frac1{1+2k_{rot}/\beta EI},\qquad\kappa_v=\frac1{1+k_v/\beta^3EI}.$$

The number $\kappa_m$ says how much of the moment is missing, $\kappa_v$ how much of the shear. The
pinned joint has $\kappa_m=1$, $\kappa_v=0$; the free joint, whose springs are zero, has both 1. The
function `jointed_deflection` adds kink and step to the beam, for any load and place; `side` is the
sign of that place, left or right of the joint.

{{code: track/joint.cpp jointed_deflection}}

The squares in {{fig-03}} are a check with finite elements that are exact for this beam.

{{fig-03}}

{{joint: checks}}

At a free end exactly a quarter of $K_r$ is left: the paper's "as little as 25 percent". A pinned
joint keeps a half, and its curve is **not monotone**. With the wheel at $\xi=\pi/4$ from it, the
pin lies where the unbroken rail has no bending moment, and makes no difference ($K_j=K_r$). Farther
away the stiffness dips once more, to {{hinge-dip}} of $K_r$ at $\xi=\pi/2$. Beyond $\xi=2$, where
the paper lets the joint's effect disappear, up to {{free-left}} (free) and {{hinge-left}} (pinned)
of $K_r$ are missing.

Is there one formula for all joints? The paper offers one for the curves of Figure 3 and calls it "a
good approximation of the curve":

$$\frac{K_j}{K_r}=1-(1-\delta)\bigl(1-\sin(0.65\,\beta X)\bigr)^2,\qquad0.65\,\beta X\le\frac\pi2, \tag{8}$$

with $\delta$ the ratio $K_j/K_r$ at the joint. The paper does not say what "good" means, nor how
the error is to be counted. For the free joint (8) errs by {{free-error-size}} of $K_r$ at most and
by {{free-rms}} in the root mean square up to $\xi=2$, and no factor in place of 0.65 does much
better. For the pinned joint it errs by {{hinge-error-size}} at most and by {{hinge-rms}} in the
root mean square. Leaving the joint out ($K_j=K_r$) errs by {{hinge-out-rms}} in the root mean
square, which is more; but on {{hinge-worse}} of the distance up to $\xi=2$ the curve is nearer to
$K_r$ than to (8). A factor of {{hinge-factor}} suits the pinned joint better, but no monotone formula
can follow its second dip.

::: {.fold summary="A joint in good condition"}

A joint in good condition, says the paper, might lose "perhaps 25 to 30 percent". A joint that
carries all shear loses as much if its rotational spring $k_{rot}$ is between $\beta EI$ and
$\frac23\beta EI$, which is {{k-theta-25}} to {{k-theta-30}} on the typical track.

:::
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/report/values.hpp>
#include <railbook/track/beam_elements.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// K_j / K_r by exact elements, rail cut at beta L = 20 on both sides.
double ratio_by_elements(const WinklerBeam& beam, const Joint& joint, double xi) {
  const Eigen::VectorXd x =
      xi > 0 ? Eigen::VectorXd{{-20.0, 0.0, xi, 20.0 + xi}} : Eigen::VectorXd{{-20.0, 0.0, 20.0}};
  const BeamModel model{.bending_stiffness = beam.bending_stiffness,
                        .foundation_modulus = beam.foundation_modulus,
                        .x = x / beam.beta(),
                        .joints = {{1, joint}}};
  const Eigen::Index node = xi > 0 ? 2 : 1;
  return 1.0 / (solve_beam(model, {{node, 1.0}}).deflection(node) * beam.point_stiffness());
}

// What a kind of joint does to the rail: kappa_m = 1, kappa_v as given, delta the ratio at the
// joint.
struct JointCurve {
  double at_joint, lowest_beyond_2;
  JointFit fit;        // largest error of (8)
  double best_factor;  // in place of 0.65, and the largest error then
  double best_error;
  // Over 0 < xi < 2: the root mean square error of (8) and of leaving the joint out, over K_r, and
  // the share where leaving it out is nearer to the curve.
  double rms, rms_without, worse;
};

JointCurve joint_curve(double kappa_v) {
  JointCurve curve{joint_stiffness_ratio(0, 1, kappa_v), 1, {}, 0, 0, 0, 0, 0};
  for (double xi = 2; xi < 8; xi += 1e-3)
    curve.lowest_beyond_2 = std::min(curve.lowest_beyond_2, joint_stiffness_ratio(xi, 1, kappa_v));
  for (double xi = 5e-4; xi < 2; xi += 1e-3) {
    const double exact = joint_stiffness_ratio(xi, 1, kappa_v),
                 error = std::abs(paper_joint_ratio(xi, curve.at_joint) - exact);
    curve.rms += error * error / 2000;
    curve.rms_without += (1 - exact) * (1 - exact) / 2000;
    curve.worse += error > 1 - exact ? 1 / 2000. : 0;
  }
  curve.rms = std::sqrt(curve.rms);
  curve.rms_without = std::sqrt(curve.rms_without);
  curve.fit = paper_joint_error(curve.at_joint, 1, kappa_v);
  curve.best_factor = best_joint_factor(curve.at_joint, 1, kappa_v);
  curve.best_error =
      std::abs(paper_joint_error(curve.at_joint, 1, kappa_v, curve.best_factor).error);
  return curve;
}

void fig_03(report::Item& item) {
  auto& curve = item.data({"beta_x", "hinge", "free", "eq8_hinge", "eq8_free"});
  for (int i = 0; i <= 300; ++i) {
    const double xi = 0.01 * i;
    curve.add(xi, joint_stiffness_ratio(xi, 1, 0), joint_stiffness_ratio(xi, 1, 1),
              paper_joint_ratio(xi, 0.5), paper_joint_ratio(xi, 0.25));
  }
  auto& points = item.data("elements", {"beta_x", "hinge", "free"});
  const auto beam = typical_beam();
  double off = 0;
  for (const double xi : {0.0, 0.5, 0.785, 1.57, 2.0}) {
    const double pinned = ratio_by_elements(beam, hinge, xi),
                 free = ratio_by_elements(beam, free_joint, xi);
    points.add(xi, pinned, free);
    off = std::max({off, std::abs(joint_stiffness_ratio(xi, 1, 0) / pinned - 1),
                    std::abs(joint_stiffness_ratio(xi, 1, 1) / free - 1)});
  }
  item.expect_checks(1);
  item.at_most("elements", "largest difference from exact beam elements, relative", "", off, 1e-9,
               "rounding of the elements");
}

void joint_table(report::Item& item) {
  item.columns({"joint",
                {"K<sub>j</sub>/K<sub>r</sub> at the joint", "{:.4f}"},
                {"lowest beyond βX = 2", "{:.4f}"},
                {"largest error of (8)", "{:+.4f}"},
                {"at βX", "{:.3f}"},
                {"best factor for 0.65", "{:.2f}"},
                {"error with it", "{:.3f}"}});
  const JointCurve free = joint_curve(1), pinned = joint_curve(0);
  for (const auto& [name, c] : {std::pair{"free", free}, {"pinned", pinned}})
    item.add_row(name, c.at_joint, c.lowest_beyond_2, c.fit.error, c.fit.xi, c.best_factor,
                 c.best_error);
  item.expect_checks(3);
  const table::CsvTable printed = item.printed("numbers.csv");
  const auto beam = typical_beam();
  item.row(printed, "free-joint")
      .print("printed", 100 * joint_stiffness_ratio(beam, free_joint, 0));
  for (const char* row : {"good-joint-low", "good-joint-high"}) {
    const double loss = report::printed_number(printed.at(row, "printed"));
    const double spring = rotational_stiffness_for_loss(beam, loss / 100);
    item.row(printed, row)
        .print("printed", 100 * (1 - ratio_by_elements(beam, sprung_joint(spring), 0.0)),
               report::fitted("the joint's rotational spring is chosen for it"));
    item.value(fmt::format("k-theta-{:.0f}", loss), spring / 1e6, "MN·m/rad", "{:.2f}");
  }
  const auto of = [](const JointCurve& c) {
    return std::vector{std::abs(c.fit.error), c.rms, c.rms_without, c.rms / c.rms_without,
                       100 * (1 - c.worse)};
  };
  item.claims({{"eq8-free", of(free)}, {"eq8-pinned", of(pinned)}});
  report::values(item, "", "{:.2f}", "free-rms", free.rms, "hinge-rms", pinned.rms, "hinge-out-rms",
                 pinned.rms_without, "hinge-factor", pinned.best_factor, "free-error-size",
                 std::abs(free.fit.error), "hinge-error-size", std::abs(pinned.fit.error));
  report::values(item, "%", "{:.1f}", "free-left", 100 * (1 - free.lowest_beyond_2), "hinge-left",
                 100 * (1 - pinned.lowest_beyond_2));
  item.value("hinge-worse", 100 * pinned.worse, "%", "{:.0f}");
  item.value("hinge-dip", joint_stiffness_ratio(units::pi / 2, 1, 0), "", "{:.4f}");
}

}  // namespace

const report::Section joint{report::figure("fig-03", fig_03), report::table("joint", joint_table)};

}  // namespace railbook::track_chapter
