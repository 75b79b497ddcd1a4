/*** # Classifying track by power spectral density

After J. C. Corbin and W. M. Kaufman, *Classifying Track by Power Spectral Density*, in *Mechanics of Transportation
Systems*, ASME AMD vol. 15, 1975.

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

{{include: accuracy.cpp}}

{{include: cost.cpp}}

{{include: stability.cpp}}

{{include: synthesize.cpp}}

{{include: classify.cpp}}

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
  psd::add_processes(chapter);
  psd::add_extraction(chapter);
  psd::add_zones(chapter);
  psd::add_chords(chapter);
  psd::add_classes(chapter);
  psd::add_accuracy(chapter);
  psd::add_cost(chapter);
  psd::add_stability(chapter);
  psd::add_synthesize(chapter);
  psd::add_classify(chapter);
  return chapter.run(argc, argv);
}
