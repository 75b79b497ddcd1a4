/***
# Creep on a rig of two wheels

A wheel that pulls or brakes turns a little faster or slower than it rolls. The difference, divided by the speed,
is the *creep* $\xi$; it is a few parts in a thousand, and it decides how much force a wheel can pass to the rail
before it spins. The paper measures it: a wheel of 8 in diameter runs on one of 36 in, is braked, and the friction
coefficient $\mu=T/N$ is read against the creep at several loads. The curves differ from load to load and from wheel
to wheel, and the paper brings them together: plotted as $\mu/\mu_c$ over

$$X=\frac{G\,a\,b\,\xi}{\mu_cN},$$

with the largest coefficient $\mu_c$, the shear modulus $G$ and the axes $a$, $b$ of the contact ellipse *as it really
is*, enlarged by wear, they fall on one curve, the one that Kalker's theory predicts.

{{include: rig_scene.cpp}}

{{include: geometry.cpp}}

## How accurate is a measured creep?

{{include: appendix_a.cpp}}

{{include: appendix_b.cpp}}

{{include: full_curve.cpp}}

{{include: pixels.cpp}}

{{include: carter.cpp}}

{{include: cattaneo.cpp}}

{{include: coefficients.cpp}}

{{include: coefficient_proof.cpp}}

{{include: tractions.cpp}}

{{include: scene.cpp}}

{{include: theories.cpp}}

{{include: fastsim_cells.cpp}}

{{include: experiment.cpp}}

{{include: reduction.cpp}}

{{include: state.cpp}}

{{include: area_law.cpp}}

{{include: master_curve.cpp}}

## Tools for a contact of your own






## Error against run time

{{include: cost.cpp}}

## Stability

{{stability}}

{{include: stability.cpp}}

## Deviations

What the paper prints that we do not confirm, or confirm in part only:

* **The upper bound of Appendix A** is none: its terms cancel. All errors together make {{xi-conspire}}, not 0.0005; as
  independent errors {{xi-rss}}, which bears the claim out. The slips of both appendices are in their tables, row by row.
* **8.224 km/h at 50 rpm** is not the speed of the wheel's rim, {{speed-b}}.
* **Full axes or semi-axes.** The nomenclature makes the abscissa of Figure 11 four times that of the theory it is compared
  with. One of the two must have been converted, and the paper does not say which.
* **The printed reading** cannot be had with Hertz's area. This is for the paper and not against it; see {{fig-state}}.
* **Friction falls with the load "as predicted".** The theory predicts $N^{-1/3}$ for the linear part of the curves. It does not
  predict the largest friction at all, which is an input to it.
* **Creep times area.** Constant if the contact grows alike in both directions. While only the profile wears flat it rises by
  {{rise-moderate}} as the area grows by {{area-moderate}}.
* **Vermeulen and Johnson**, cited beside Kalker, start {{vj-excess}} too steep. With the scatter of the points in {{fig-11}} no
  experiment of this kind could tell their curve from his.
* **Finishes of 20 and 15 µm**, after polishing with 400 grit, must be microinches.
* **Kalker's table**, which the paper takes its theory from, is off by up to {{table-worst}} % in its end rows; see {{table-coefficients}}.

Not reproducible: the measured points and average curves of Figures 3 to 8 and 11, the areas of Figures 9 and 10, three of the
four loads, the tracks' widths and the factors $C$ of equation (7), $\mu_c$, and the shear modulus used. They stand in the figures
or not at all.

## Limits

The full theory is that of two elastic half-spaces of one material, with Coulomb's friction at one coefficient, in steady state.
The rig's contact is {{contact-share}} of the small wheel's profile radius wide, which half-spaces bear. A worn wheel is neither
elliptic nor smooth, and the "true area" of the paper puts all of that into one number. A largest pressure of some 1500 MPa, with
0.3 of it as traction, is more than most wheel steels bear elastically; the paper says itself that its contacts deformed plastically. Real friction
falls at large creep, with speed and heat; no curve here does.

Of the fast theories, linear and Vermeulen-Johnson know no bound or no spin; Shen-Hedrick-Elkins fails at large spin, where it
stays at full force while the truth returns to zero; the strips are without spin; Polach has no moment. Only FASTSIM and the full
theory take everything. All but the full theory need Kalker's coefficients, from his table for $0.1\le a/b\le10$, or computed.

## Try next

* `creep curve` with `--theory fastsim` and `--theory full` for your own wheel: where do they differ most?
* Let the friction fall with the slip, $\mu(s)$, in the full theory: the curve gets its maximum, and the rig becomes unstable
  beyond it.
* A second test of wear: let the rolling radius wear as well and look when creep times area really stays constant.
* `creep table` with twice the nodes: does its error fall by four?
* Add the 0.2 rpm of Appendix A to the synthetic counters instead of a normal error: what does the fit of the area lose?
*/

#include "items.hpp"

using namespace railbook;

int main(int argc, char** argv) {
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "creep",
       .title = "Wheel and rail creep on a two-wheel rig",
       .paper =
           "C. A. Sciammarella, S. Kumar, L. Nailescu and B. B. Seth, Similitude Law for the "
           "Creep-Adhesion Function in Dry Contact, Journal of Engineering for Industry (ASME) "
           "101(3), 1979, pp. 278-284",
       .sources = RAILBOOK_CHAPTER_DIR}};
  creep_chapter::add_rig_scene(chapter);
  creep_chapter::add_geometry(chapter);
  creep_chapter::add_appendix_a(chapter);
  creep_chapter::add_appendix_b(chapter);
  creep_chapter::add_full_curve(chapter);
  creep_chapter::add_pixels(chapter);
  creep_chapter::add_carter(chapter);
  creep_chapter::add_cattaneo(chapter);
  creep_chapter::add_coefficients(chapter);
  creep_chapter::add_kalker_proof(chapter);
  creep_chapter::add_tractions(chapter);
  creep_chapter::add_scene(chapter);
  creep_chapter::add_theories(chapter);
  creep_chapter::add_fastsim_cells(chapter);
  creep_chapter::add_experiment(chapter);
  creep_chapter::add_reduction(chapter);
  creep_chapter::add_state(chapter);
  creep_chapter::add_area_law(chapter);
  creep_chapter::add_full_cost(chapter);
  creep_chapter::add_full_stability(chapter);
  return chapter.run(argc, argv);
}
