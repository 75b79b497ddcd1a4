/*** # Track spectra: which speed may this stretch of track carry?

A measuring car (a *geometry car*) brings home kilometres of heights, and the railroad wants one
answer from them: in which speed class is each stretch of track? Without a way from the record to
the class, it finds single defects only, and not whether a whole stretch is rough or its joints have
sunk.

::: {#live-psd .live figure=psd}

{{overview}}

:::

::: findings
1. How deep are the joints behind a peak of the spectrum? Jointed rail has a peak (a *line*) in its
   spectrum at the wavenumber $\varphi_0$, one wave for each rail. The paper computes the dip $B$ of
   the joints from the area under this peak. The formula takes half of the amplitude of a wave, as a
   *two-sided* spectrum has it, but squares and halves it as if it were the whole amplitude. In a
   *one-sided* spectrum a dip therefore makes four times the area that the formula says
   ({{outcome:lines/Q1-exact}}). If the paper's spectra are one-sided, every $B$ in its Table 1 is
   twice the physical dip; if they are two-sided, $\sqrt2$ times. The paper does not say which they
   are; a damaged sign in its equation (8) speaks for one-sided.
2. Does the paper's rule (10) give the classes of its Table 3? From the roughness and the dip of a
   stretch of track (a *zone*) the rule computes an offset, and compares it with the limit of each
   class. We take the coefficient $k$ of the roughness from the paper's (8) and (9), and the limits
   from the federal standards. Then {{table-3-steady}} of 13 zones have the printed class, however
   the printed numbers were rounded; zone 12 has class 2, as printed, or class 3. The coefficient
   cannot be read in our copy, and the classes do not determine it: every value from
   {{k-most-low}} to {{k-most-high}} gives at least twelve of the thirteen.
   {{outcome:table-3/zone-12}}
3. Can a spectrum tell joints that are deep at random from joints that are deep in groups? The paper
   says that "the PSD cannot distinguish" them (PSD stands for power spectral density, the
   spectrum). We count a difference of three standard errors as seen. In five miles of a jointed
   zone, whose depths scatter by half of their mean, no single value of the spectrum differs so
   much: at $\varphi_0$ it is at most {{apart-line}}, because the line of the mean dip hides the
   rest, and two values beside it {{apart-least}} to {{apart-most}}. The fourteen values that lie
   two to eight from $\varphi_0$, taken together, differ by {{together-least}} to {{together-most}},
   so that in {{together-seen}} the whole spectrum tells the two apart.
   {{outcome:five-miles/distinguish}}
:::

## The paper

J. C. Corbin and W. M. Kaufman measured the height of the rail on thirteen stretches (*zones*) of
American track, from new rail that is welded end to end to a rough branch line. In every spectrum
they found the same pattern: a smooth random part, and a row of peaks from the joints between the
rails. Three numbers describe it. The *roughness* $A$ (m²·cycle/m) says how high the random part
lies, the *corner* $\varphi_c$ (cycle/m) where it starts to fall more steeply, and the *dip* $B$ (m)
how deep the joints are. Inspectors stretch a chord of 62 ft along the rail and measure the distance
between rail and chord at its middle, the *mid-chord offset*; the US track safety standards limit it
for each speed class. The paper computes from $A$ and $B$ which offset to expect, and so the class.

We have the paper as machine-read text, without its drawings and without its measured spectra.
Synthetic track, made with the printed numbers, stands for the measured track, and each figure is
drawn from what the text and the captions say of it. Tables and figures with a plain number are the
paper's; those of this page are numbered 5.1 and so on.

{{include: processes.cpp}}

{{include: modulation.cpp}}

{{include: extraction.cpp}}

{{include: zones.cpp}}

{{include: chords.cpp}}

{{include: classes.cpp}}

{{include: method.cpp}}

## Deviations

* **Line power, (1), (2) and (7).** The printed powers are a quarter of those of a one-sided density
  ({{outcome:lines/Q1-exact}}). If the measured densities were one-sided, which we assume for the
  sign in (8), $B$ of Table 1 is twice the physical dip, otherwise $\sqrt2$ times.
* **Truncated numbers.** $Q_2$ below (2) and the two probabilities of three sigma are truncated, not
  rounded ({{outcome:lines/Q2-printed}}).
* **Table 1.** In rows 1, 3, 6 and 8 $C_1$, $\beta$ and $B$ do not fit (7) within their rounding
  ({{outcome:table-1/1-B}}). Rows 7 and 11 fit it with $B$ rounded to half a millimetre
  ({{outcome:table-1/7-B}}); in row 13 the exponents are hardly legible.
* **Zone 12** is said to be "constructed from 10-m rail", but its $\varphi_0$ = 0.109 cycle/m is
  that of {{zone-12-rail}}. One character of our copy decides (0.100 would be 10 m), so this cannot
  be tested.
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
* **(6).** Height times width at half height is near the area of the peak only if the peak has the
  shape of a window such as Hann's ({{outcome:resolution/Q1}}). If the track itself broadens the
  peak, it is too small.
* **"The PSD cannot distinguish"** random from grouped dips: not at a glance, nor by a single
  ordinate on a few miles ({{outcome:five-miles/distinguish}}). All ordinates together can in
  {{together-seen}}, and in the others with more miles.
* **"Symmetrical sidebands"** need a smooth envelope ({{outcome:fig-04/symmetric}}). If each dip is
  deeper or shallower as a whole, the lower sideband has {{staircase-ratio}} times the power of the
  upper.

Damage of our copy, which is machine-read text without the drawings: the ½ under the root of (8); a
digit of (5); the coefficient of (10); exponents of zone 13; the plot symbols of Figure 11.

## Limits

* **One rail, one surface.** The spectrum is of the rail's height. It says nothing of the difference
  between both rails (crosslevel), of the line of the track or of its curvature, and it assumes that
  the stretch is of one kind from end to end. It has no phase, so it finds no single defect and
  cannot say where a joint is broken.
* **Two slopes, one set of lines.** The paper's model has no term for white noise of the sensor and
  no second set of lines for old rails. The library has both (`--noise`, `--foreign`); the
  [study](05-psd-study.html) says what happens without them.
* **Rule (10) does not ask for the rail length.** The 62-ft chord sees {{sees-39}} of a dip on 39-ft
  rail and {{sees-30}} on 30-ft rail. The rule counts $2B=4b$ on both: {{safe-39}} and {{safe-30}}
  times what the chord sees, before joints that are not equally low are allowed for. With $2b$ in
  place of $2B$, {{physical-changed}} would change class.
* **The synthetic dips are Gaussian.** If they scatter by more than 0.4 of their mean, some joints
  are humps: one in fifty at 0.5.

## Use it

The command `railbook psd classify` reads a table with a column of positions and one of heights and
does all steps of this page, with standard errors and the odds (here the probability) of each class.
Here it reads 20 km of synthetic track with the numbers of zone 7; `--dip` is the printed $B$. The
margin is the part of the class limit that is left:

```console
$ railbook psd synthesize track.csv --length 20km --roughness '5e-7m^2*cycle/m' --corner 0.13cycle/m --dip 11mm
synthetic track in track.csv
...
$ railbook psd classify track.csv --column profile
...
  roughness A                            5.1e-07 +- 1e-08 m^2*cycle/m   (standard error)
  corner phi_c                           0.129 +- 0.002 cycle/m   (standard error)
...
  rail length                            11.89 m   (the default, and its line is there)
  joint dip B, printed convention        10.7 +- 0.4 mm   (standard error; as in Table 1)
...
  deviation d expected of a 62-ft chord  29.77 mm   (random 20.69, joints 21.41)
  class                                  5   (margin 6.2 %)
...
    odds of class 5                      0.9999
...
```

With `--out FOLDER` it writes the spectrum, the parameters and a picture, with `--section 1km` a row
for each kilometre.

{{picture: psd-classify}}

## Try next

**Which class is zone 12?** Make it of 30-ft rail, the length that its printed $\varphi_0$ belongs
to. The paper prints class 2. This record gives class 3 with a margin of 2.7 % and a small chance of
class 2; the [study](05-psd-study.html) reads 200 such records, and not all of them are so clear:

```console
$ railbook psd synthesize zone-12.csv --length 20km --roughness '8e-7m^2*cycle/m' --corner 0.18cycle/m --dip 25mm --rail 30ft
synthetic track in zone-12.csv
...
$ railbook psd classify zone-12.csv --column profile --rail 30ft
...
  class                                  3   (margin 2.7 %)
...
    odds of class 2                      0.002
...
    odds of class 3                      0.998
...
```

**What do uneven joints do?** Let their depths scatter by half of their mean. Between the peaks the
spectrum rises, the fit takes this for roughness, and $A$ comes out 8 % too high, four of its
stated errors. The only warning is the note at the end:

```console
$ railbook psd synthesize uneven.csv --length 20km --roughness '5e-7m^2*cycle/m' --corner 0.13cycle/m --dip 11mm --scatter 0.5
synthetic track in uneven.csv
...
$ railbook psd classify uneven.csv --column profile
...
  roughness A                            5.4e-07 +- 1e-08 m^2*cycle/m   (standard error)
...
  note                                   dips that scatter by 20 % would add 0.9 % to A, which its error does not hold
```

**Which rail does the track have?** Synthesise 33-ft rail and leave `--rail` out: the command finds
the length in the spectrum, and says so.

```console
$ railbook psd synthesize old.csv --length 20km --roughness '5e-7m^2*cycle/m' --corner 0.13cycle/m --dip 11mm --rail 33ft
synthetic track in old.csv
...
$ railbook psd classify old.csv --column profile
...
  rail length                            10.06 m   (as the spectrum shows)
...
```

## Symbols

{{symbols}}

## Coverage

{{coverage}}

## Citations

::: {.fold summary="Where the paper appeared, and the other works"}

The copy at hand names no author, venue or year. These are from the Transportation Research Board's
catalogue (TRID 00128608): J. C. Corbin and W. M. Kaufman, in *Mechanics of Transportation Systems*,
AMD-Vol. 15, presented at the Winter Annual Meeting of ASME, Houston, Texas, 30 November to 5
December 1975. No DOI was found. The paper cites its sources by number, and its list of references
is not in the copy. Not the paper's: the limits of the classes, 49 CFR 213.63 (class 6 as of the
1970s; not looked up again), and their speeds, 49 CFR 213.9 and, for class 6, 213.307.

:::
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
       .title = "Track spectra: which speed may this stretch of track carry?",
       .paper = "J. C. Corbin and W. M. Kaufman, Classifying Track by Power Spectral Density, "
                "Mechanics of Transportation Systems, ASME AMD-Vol. 15, 1975 (authors and venue "
                "from TRID "
                "00128608)",
       .sources = RAILBOOK_CHAPTER_DIR},
      {method, processes, modulated, extraction, table_of_zones, chords, classes},
      {accuracy, estimates, extremes});
}
