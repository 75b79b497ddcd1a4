/*** # Classifying track by power spectral density

::: findings
1. How deep are the joints behind a peak of the spectrum? The paper finds the dip $B$ from the power
   $Q_n=\frac12B_n^2$ of a line, where $B_n$ is the amplitude of a two-sided spectrum. If its
   densities are one-sided, as its (8) requires, we find four times this power, and the $B$ of
   Table 1 is twice the physical dip. {{outcome:lines/Q1-exact}}
2. Does rule (10) give the classes of Table 3? With the coefficient that (8) and (9) give and the
   limits of the federal standards it does for {{table-3-steady}} of 13 zones, within all roundings;
   the numbers of zone 12 allow the printed class 2 as well as 3. The coefficient itself is
   unreadable in our copy, and the classes do not tell it: any from {{k-most-low}} to
   {{k-most-high}} gives twelve or more. {{outcome:table-3/zone-12}}
3. Can a spectrum tell joints that are deep at random from joints that are deep in groups? The paper
   says that "the PSD cannot distinguish" them. On five miles of its jointed zones it hardly can. If
   depths scatter by half of their mean, the two densities differ by at most {{apart-line}}
   standard errors at $\varphi_0$, where the line of the mean dip hides both, and by {{apart-least}}
   to {{apart-most}} two bins away. The more miles, the plainer the difference.
   {{outcome:five-miles/distinguish}}
:::

A geometry car leaves kilometres of numbers; a track engineer wants one: which speed class can this
stretch be held to? The paper finds the same pattern in every spectrum of the profile, from new
welded rail to a rough branch line: a smooth random part and the lines of the rail length. Three
parameters carry it, the roughness $A$, the corner wavenumber $\varphi_c$ and the joint dip $B$, and
two of them, through the 62-ft mid-chord offset that the US track safety standards limit (the height
of the rail above the middle of a 62-ft chord), give the class.

The paper shows its spectra only as pictures, and we do not have them. Synthetic track whose
spectrum is known stands for them. For records of your own there is `railbook psd classify`.

{{include: processes.cpp}}

{{include: modulation.cpp}}

{{include: extraction.cpp}}

{{include: zones.cpp}}

{{include: chords.cpp}}

{{include: classes.cpp}}

## Deviations

* **Line power, (1), (2) and (7).** A factor four in power between the printed lines and those of a
  one-sided density ({{outcome:lines/Q1-exact}}). $B$ of Table 1 is twice the physical dip if the
  measured densities were one-sided; if they were two-sided, $\sqrt2$ times, and (8) is then wrong.
* **Truncated numbers.** $Q_2$ below (2) and the two probabilities of three sigma are truncated, not
  rounded ({{outcome:lines/Q2-printed}}).
* **Table 1.** In rows 1, 3, 6 and 8 $C_1$, $\beta$ and $B$ do not fit (7) within their rounding
  ({{outcome:table-1/1-B}}). Rows 7 and 11 fit it with $B$ rounded to half a millimetre
  ({{outcome:table-1/7-B}}); in row 13 the exponents are hardly legible.
* **Zone 12** is said to be 10-m rail, but its $\varphi_0$ is that of {{zone-12-rail}}. It rests on
  one glyph, and cannot be tested.
* **"Quite satisfactory for wavelengths longer than 6 m"** is said of (3). {{corner-long}} of 13
  corners lie at longer waves, and at 6 m (3) is {{six-metres-median}} times too high in the median
  ({{outcome:table-1/six-metres}}).
* **Table 2.** 0.99 for the 10.4-m chord on 11.9-m and on 9.1-m rail should read 0.98
  ({{outcome:table-2/34-39-printed}}). The 19-m row holds for 62 ft only.
* **Table 3.** Zone 12 comes out as class 3 with its $A$ and $B$, and as class 2 or 3 with its $C_1$
  and $\beta$; printed is 2 ({{outcome:table-3/zone-12}}). Text and table name different zones as
  rebuilt after the survey.
* **The coefficient $k$ of (10)** cannot be read. (8) gives {{k-19}} ({{outcome:table-k/k-19}}), and
  the printed classes allow any from {{k-most-low}} to {{k-most-high}}.
* **(6).** Height times width at half height is the area of the peak only for the shape of a good
  window ({{outcome:resolution/Q1}}). For a peak broadened by the track itself it is too small.
* **"The PSD cannot distinguish"** random from grouped dips: not at a glance, and not on a few
  miles; their spectra differ all the same ({{outcome:five-miles/distinguish}}).
* **"Symmetrical sidebands"** need a smooth envelope ({{outcome:fig-04/symmetric}}). Dips that scale
  joint by joint give {{staircase-ratio}} to 1.

Damage of our copy, which is machine-read text without the drawings: the square root's ½ in (8),
confirmed by derivation; a digit of (5); the coefficient of (10); exponents of zone 13; the plot
symbols of Figure 11.

## Limits

* One rail, one surface, stationary over the record: no crosslevel, no alignment, no curve. A
  spectrum has no phase and finds no single defect.
* The model has two straight slopes and one set of lines. White sensor noise needs its own term.
* Rule (10) does not ask which rail length the dips belong to. The 62-ft chord sees {{sees-39}} of a
  dip on 39-ft rail and {{sees-30}} on 30-ft rail; the rule counts both with $\gamma=2$ and is far
  on the safe side for the latter.
* The dips are Gaussian: from a scatter of about 0.4 on, some joints are humps instead of dips.
  Corners below 0.002 cycle/m would need longer filters than the generator allows.

## Try next

* Fit the closed form of scattered dips to the neighbourhood of $\varphi_0$: it gives the spread of
  the dips and how far along the track they are alike, and would answer the paper's question about
  rock and roll.
* Classify by the 31-ft chord, whose sensitivity to joints hardly depends on the rail.
* Make zone 12 of 30-ft rail, `railbook psd synthesize --rail 30ft`, and see what the chord of the
  standard and the rule make of it.

## Citations

The copy at hand names no author, venue or year. These are from the Transportation Research Board's
catalogue (TRID 00128608): J. C. Corbin and W. M. Kaufman, in *Mechanics of Transportation Systems*,
AMD-Vol. 15, presented at the Winter Annual Meeting of ASME, Houston, Texas, 30 November to 5
December
1975. No DOI was found. The paper cites its sources by number, and its list of references is not in
      the copy. Not the paper's: the limits of the classes, 49 CFR 213.63 (class 6 as of the 1970s;
      not looked up again), and their speeds, 49 CFR 213.9 and, for class 6, 213.307.

## Coverage

{{coverage}}
*/
#include <algorithm>
#include <cmath>

#include <railbook/num/random_source.hpp>

#include "sections.hpp"

namespace railbook::psd_chapter {

spectra::SyntheticTrack synthetic(const spectra::TrackParameters& track, std::uint64_t seed) {
  const bool of_39_feet = track.phi_0 == 0 || std::abs(track.phi_0 - phi_0) < 0.0005;  // 0.084
  return {.seed = seed,
          .A = track.A,
          .phi_c = track.phi_c,
          .rail_length = of_39_feet ? rail : 1 / track.phi_0,
          .dip = spectra::convert_dip(track.B, LineConvention::printed,
                                      LineConvention::exact_one_sided)};
}

double by_chance(int rows) {
  return num::normal_quantile(1 - 0.005 / rows);
}

spectra::Spectrum record_spectrum(const spectra::SyntheticTrack& track, double length,
                                  const spectra::WelchOptions& options) {
  spectra::TrackGenerator generator{track};
  spectra::Welch welch{track.spacing, options};
  std::vector<double> piece(1 << 15);
  auto left = static_cast<std::size_t>(length / track.spacing);
  while (left > 0) {
    const auto part = std::span{piece}.first(std::min(left, piece.size()));
    generator.fill(part);
    welch.push(part);
    left -= part.size();
  }
  return welch.spectrum();
}

}  // namespace railbook::psd_chapter

int main(int argc, char** argv) {
  using namespace railbook::psd_chapter;
  return railbook::report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "psd",
       .title = "Classifying track by power spectral density",
       .paper = "J. C. Corbin and W. M. Kaufman, Classifying Track by Power Spectral Density, "
                "Mechanics of Transportation Systems, ASME AMD-Vol. 15, 1975 (authors and venue "
                "from TRID "
                "00128608)",
       .sources = RAILBOOK_CHAPTER_DIR},
      {processes, modulated, extraction, table_of_zones, chords, classes},
      {accuracy, estimates, extremes});
}
