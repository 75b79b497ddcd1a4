/***
Below {{fig-11}} a track can be chosen by its roughness $A$ and its dip $B$: the class that rule (10) gives it, and how much of the deviation each part has.
*/
#include <cmath>

#include "report/answer.hpp"
#include "sections.hpp"
#include "spectra/classify.hpp"

namespace railbook::psd_chapter {

void class_answer(report::Item& item) {
  const spectra::ClassRule rule{.chord = 19.0};
  report::Answer answer{item,
                        {"A_m²-cycle/m", "B_mm"},
                        {{"random part of the spectrum", "wavenumber, cycle/m",
                          "density, m²/(cycle/m)", 0.005, 1, 1e-9, 0.1, "log"},
                         {"design deviation", "class", "mm", 0.5, 6.5, 0, 80},
                         {.name = "class", .kind = "says"}}};
  for (int i = 0; i <= 10; ++i) {
    const double A = 1e-8 * std::pow(10.0, 0.25 * i);
    for (double B = 0; B < 21; B += 2) {
      const auto c = spectra::classify(A, B * mm, rule);
      answer.at({A, B});
      for (int k = 0; k <= 8; ++k) {
        const double phi = 0.005 * std::pow(200.0, k / 8.0);
        answer.point("random part of the spectrum", "", phi, spectra::random_psd({.A = A}, phi));
      }
      for (int m = 1; m <= spectra::classes; ++m)
        answer.point("design deviation", "limit of the class", m,
                     rule.limits[static_cast<std::size_t>(m - 1)] / mm);
      answer.point("design deviation", "this track", 0.5, c.deviation / mm);
      answer.point("design deviation", "this track", 6.5, c.deviation / mm);
      answer.says("class", "class", c.track_class);
      answer.says("class", "deviation d, mm", c.deviation / mm);
      answer.says("class", "of the random part, mm", c.random / mm);
      answer.says("class", "of the joints, mm", c.periodic / mm);
    }
  }
}

}  // namespace railbook::psd_chapter
