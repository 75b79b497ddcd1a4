/*** # Classifying track by power spectral density

A geometry car leaves kilometres of numbers; a track engineer wants one: which speed class can this stretch be held to? The
paper goes there through the power spectral density of the profile. It finds the same pattern in every spectrum, from new
welded rail to a rough branch line: a smooth random part and the lines of the rail length. Three parameters carry it, the
roughness $A$, the corner wavenumber $\varphi_c$ and the joint dip $B$, and two of them, through the 62-ft mid-chord offset that the
US track safety standards limit, give the class.

We make synthetic track whose spectrum is known exactly, so that each step of the paper can be judged by what went in; we
recompute all tables and figures; and the estimator runs on your own records (`psd classify`).

{{include: processes.cpp}}

{{include: extraction.cpp}}

{{include: zones.cpp}}

{{include: chords.cpp}}

{{include: classes.cpp}}

{{include: exceedance.cpp}}

{{include: accuracy.cpp}}





{{include: cost.cpp}}

{{include: stability.cpp}}

{{include: stability_cases.cpp}}

## Deviations

What the paper prints and we do not, or not quite, confirm:

* **Line power, (1), (2) and (7).** A factor two in amplitude and four in power between the printed lines and a one-sided density. $B$
  of Table 1 is twice the physical dip.
* **Below (2).** $Q_2$ is {{Q2}}$\,B^2$ in the paper's convention, which does not round to 9.00: it was divided out of the rounded $Q_1$.
* **Table 1.** Rows 1, 3, 6, 7, 8, 11 and 13 contradict (7) by more than their rounding. The exponents of zone 13 are hardly legible.
  Zone 12 is said to be 10-m rail, but its $\varphi_0$ is that of {{zone-12-rail}}.
* **Table 2.** 0.99 for the 10.4-m chord on 11.9-m and on 9.1-m rail should read 0.98. The 19-m row holds for 62 ft only.
* **Table 3.** Zone 12 comes out as class 3, {{zone-12-margin}} inside its limit; printed is 2. The coefficient $k$ of (10) cannot be read; with
  {{k-low}} < $k$ ≤ {{k-high}} all thirteen classes would be as printed, (8) gives {{k-19}}. Text and table name different zones as rebuilt after the survey.
* **(6).** Height times half width is the area of the peak only for the shape of a good window. For a peak broadened by the track
  itself it is too small.
* **"The PSD cannot distinguish"** random from grouped dips. With the same spread it can: figure {{fig-04}}.
* **"Symmetrical sidebands"** need a smooth envelope. Dips that scale joint by joint give {{staircase-ratio}} to 1.

Not available: the spectra behind Figure 8 and the plot symbols of Figure 11. All tracks here are synthetic, and every figure made from them says
so.

## Limits

* One rail, one surface, stationary over the record: no crosslevel, no alignment, no curve. A spectrum has no phase and finds no single
  defect.
* The model has two straight slopes and one set of lines. Waves beyond 100 m are design, not roughness. White sensor noise needs its own term.
* Rule (10) does not ask which rail length the dips belong to. The 62-ft chord sees {{sees-39}} of a dip on 39-ft rail and {{sees-30}} on
  30-ft rail; the rule counts both with $\gamma=2$ and is far on the safe side for the latter.
* The generator is Gaussian, with dips that are Gaussian, too: from a scatter of about 0.4 on, some joints stand up. Its density is (4) within
  {{generator-error}} from 0.005 to 1.2 cycle/m for corners from 0.02 cycle/m; corners below 0.002 would need longer filters than it allows.
* The analytic spectra by track class that vehicle dynamics uses (the same two slopes, with a round corner) are not compared with Table 1:
  their coefficients are not in the paper, and we had no primary source to print them from.
* A rectified sine has kinks. Sampled at 1 ft, its folded harmonics raise the first line by {{folded}}, and the twelfth, at 1 cycle/m, by
  {{folded-12}}. Above a metre between samples do not trust the lines.

## Try next

* Fit the closed form of scattered dips to the neighbourhood of $\varphi_0$: it gives the spread of the dips and how far along the track they are
  alike, which (6) throws away, and would answer the paper's question about rock and roll.
* Measure the ratio of the two sidebands. It tells a smooth envelope (the ground) from joints that react one by one (the bars).
* Classify by the 31-ft chord, whose sensitivity to joints hardly depends on the rail: `spectra::rail_chord_sensitivity` and a set of limits
  are all it takes.
* Make zone 12 of 30-ft rail, `psd synthesize --rail 30ft`, and see what the chord of the standard and the rule make of it.

## All verdicts

{{verdicts}}
*/
#include "items.hpp"

int main(int argc, char** argv) {
  railbook::report::Chapter chapter{{.id = RAILBOOK_CHAPTER,
                                     .name = "psd",
                                     .title = "Classifying track by power spectral density",
                                     .paper = "J. C. Corbin and W. M. Kaufman, Classifying Track "
                                              "by Power Spectral Density, Mechanics of "
                                              "Transportation Systems, ASME AMD vol. 15, 1975",
                                     .sources = RAILBOOK_CHAPTER_DIR}};
  railbook::psd_chapter::add_processes(chapter);
  railbook::psd_chapter::add_extraction(chapter);
  railbook::psd_chapter::add_zones(chapter);
  railbook::psd_chapter::add_chords(chapter);
  railbook::psd_chapter::add_classes(chapter);
  railbook::psd_chapter::add_exceedance(chapter);
  railbook::psd_chapter::add_accuracy(chapter);
  railbook::psd_chapter::add_cost(chapter);
  railbook::psd_chapter::add_stability(chapter);
  return chapter.run(argc, argv);
}
