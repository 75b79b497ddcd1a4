/*** # Classifying track by power spectral density

::: findings
1. A line of the spectrum has the power $Q_n=\frac12B_n^2$. Result: that is a quarter of the power in the one-sided density used everywhere else; the $B$ of Table 1 is twice the physical dip. {{outcome:lines/Q1-exact}} {{outcome:lines/Q2-printed}}
2. Rule (10) gives the classes of Table 3. Result: twelve of thirteen, with the coefficient derived; zone 12 lies {{zone-12-margin}} inside class 3, printed is 2. {{outcome:table-3/zone-12}}
3. "The PSD cannot distinguish" random dips from grouped ones. Result: it can; on five miles of each their densities at $\varphi_0$ are {{distinguish-errors}} standard errors apart. {{outcome:fig-05/distinguish}}
:::

A geometry car leaves kilometres of numbers; a track engineer wants one: which speed class can this stretch be held to? The
paper finds the same pattern in every spectrum of the profile, from new welded rail to a rough branch line: a smooth random part and the lines of the
rail length. Three parameters carry it, the roughness $A$, the corner wavenumber $\varphi_c$ and the joint dip $B$, and two of them, through the 62-ft
mid-chord offset that the US track safety standards limit, give the class.

The measured spectra of the paper are not to be had. Synthetic track whose spectrum is known stands for them. For records of your own there is
`railbook psd classify`.

{{include: processes.cpp}}

{{include: modulation.cpp}}

{{include: extraction.cpp}}

{{include: zones.cpp}}

{{include: chords.cpp}}

{{include: classes.cpp}}

## Deviations

* **Line power, (1), (2) and (7).** A factor two in amplitude and four in power between the printed lines and a one-sided density ({{outcome:lines/Q1-exact}}). $B$
  of Table 1 is twice the physical dip.
* **Below (2).** $Q_2$ is {{Q2}}$\,B^2$ in the paper's convention, which does not round to 9.00 ({{outcome:lines/Q2-printed}}).
* **Table 1.** Rows 1, 3, 6, 7, 8, 11 and 13 do not fit (7) within their rounding ({{outcome:table-1/1-B}}): values read off graphs, in zone 13 illegible exponents.
  Zone 12 is said to be 10-m rail, but its $\varphi_0$ is that of {{zone-12-rail}} ({{outcome:table-1/ten-metres}}).
* **"Quite satisfactory for wavelengths longer than 6 m"** is said of (3), but most corners of Table 1 lie at longer ones
  ({{outcome:table-1/six-metres}}).
* **Table 2.** 0.99 for the 10.4-m chord on 11.9-m and on 9.1-m rail should read 0.98 ({{outcome:table-2/34-39-printed}}). The 19-m row holds for 62 ft only.
* **Three sigma.** 0.99 and 0.8 are cut, not rounded ({{outcome:equation-8/normal-printed}}).
* **Table 3.** Zone 12 comes out as class 3; printed is 2 ({{outcome:table-3/zone-12}}). The coefficient $k$ of (10) cannot be read; with
  {{k-low}} < $k$ ≤ {{k-high}} all thirteen classes would be as printed, (8) gives {{k-19}} ({{outcome:table-k/k-19}}). Text and table name different zones as rebuilt after the survey.
* **(6).** Height times half width is the area of the peak only for the shape of a good window ({{outcome:resolution/Q1}}). For a peak broadened by the track
  itself it is too small.
* **"The PSD cannot distinguish"** random from grouped dips. With the same mean and spread it can ({{outcome:fig-05/distinguish}}).
* **"Symmetrical sidebands"** need a smooth envelope ({{outcome:fig-04/symmetric}}). Dips that scale joint by joint give {{staircase-ratio}} to 1.

Damage of our copy: the square root's ½ in (8), confirmed by derivation; a digit of (5); the coefficient of (10); the plot symbols of Figure 11.

## Limits

* One rail, one surface, stationary over the record: no crosslevel, no alignment, no curve. A spectrum has no phase and finds no single
  defect.
* The model has two straight slopes and one set of lines. White sensor noise needs its own term.
* Rule (10) does not ask which rail length the dips belong to. The 62-ft chord sees {{sees-39}} of a dip on 39-ft rail and {{sees-30}} on
  30-ft rail; the rule counts both with $\gamma=2$ and is far on the safe side for the latter.
* The dips are Gaussian: from a scatter of about 0.4 on, some joints stand up. Corners below 0.002 cycle/m would need longer filters than the generator
  allows.

## Try next

* Fit the closed form of scattered dips to the neighbourhood of $\varphi_0$: it gives the spread of the dips and how far along the track they are
  alike, and would answer the paper's question about rock and roll.
* Classify by the 31-ft chord, whose sensitivity to joints hardly depends on the rail.
* Make zone 12 of 30-ft rail, `railbook psd synthesize --rail 30ft`, and see what the chord of the standard and the rule make of it.

## Citations

The copy at hand names no author, venue or year. These are from the Transportation Research Board's catalogue (TRID 00128608): J. C. Corbin and W. M.
Kaufman, in *Mechanics of Transportation Systems*, AMD-Vol. 15, presented at the Winter Annual Meeting of ASME, Houston, Texas, 30 November to 5 December
1975. No DOI was found. The paper cites its sources by number, and its list of references is not in the copy. Not the paper's: the limits of the classes,
49 CFR 213.63 (class 6 as of the 1970s; not looked up again).

## Coverage

{{coverage}}
*/
#include <algorithm>

#include "num/random_source.hpp"
#include "sections.hpp"

namespace railbook::psd_chapter {

spectra::SyntheticTrack synthetic(const spectra::TrackParameters& track, std::uint64_t seed) {
  return {.seed = seed,
          .A = track.A,
          .phi_c = track.phi_c,
          .rail_length = rail,
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
