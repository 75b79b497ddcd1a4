/*** # How rough may a track be before a vehicle minds?

A track may look smooth and still throw a freight car about, because waves of one length excite the
swing of its body on the springs. Limits that ask only for a height take no notice of this: they may
demand repairs that no vehicle needs, and miss a place that one does. J. C. Corbin and A. E. Fazio
asked which roughness a given vehicle can bear at each wavelength.

::: {#live-quality .live figure=quality}

{{fig-01}}

:::

::: findings
1. **How smooth must a track be at long waves?** The paper finds that one amplitude is allowed for
   all waves shorter than the one that excites resonance at top speed, and that beyond it the
   allowed amplitude grows with the square of the wavelength. For its linear vehicle both follow
   exactly from its formula (constant amplitude: {{outcome:fig-05/level}}; growth:
   {{outcome:fig-05/tail}}).
2. **Is that so for "all vehicle models regardless of how complex or nonlinear they may be"**, as
   the paper supposes? We gave its vehicle bump stops that are met at 0.6 of the stroke limit. In
   the end the allowed amplitude still grows with the square of the wavelength
   ({{outcome:fig-level/shape}}). With stops as stiff as the spring, short waves still have one
   allowed amplitude. With stops ten times as stiff it falls from {{one-wave-10}} to at most
   {{level-10}} for waves below {{second-10}} at 100 km/h (without stops it is {{level-linear}}),
   because there the body can make one swing in three waves, which keep it going
   ({{outcome:fig-level/subharmonic}}). The damping is the paper's; the place and the stiffness of
   the stops are ours.
3. **Does a faster train always need smoother track at short waves?** There the force on the wheel
   counts, and the paper says that its curves for different speeds do "not interpenetrate each other
   as speed is changed". This is not testable, because the paper prints neither masses nor dampers.
   If the body has at least twice the mass of the wheel, it is true when the damping is at least
   {{enough-damping}} of critical damping, at which a free body no longer swings.
:::

## The idea

The authors drive a vehicle over a sine wave of the track and ask how large its amplitude may be.
The vehicle can bear only so much *stroke* of its suspension, the change of length of the spring,
before it meets a stop, and only so much force between wheel and rail. Stroke and force of a linear
vehicle grow in proportion to the amplitude, so each limit gives an amplitude at which it is
reached.

The smaller of the two, at the worst speed up to the *posted* one (the line's speed limit), is the
amplitude that is *allowed* at this wavelength. It is what has to be maintained.

The curve of the allowed amplitudes becomes a filter. Run over a record of the track, it gives the
*descriptor*, which is 1 on a lasting wave of the allowed amplitude. In the drawing it stays near 0
on a hill of 60 mm, reads {{read-bump}} on a short bump of 16 mm, and {{read-waves}} on three waves
of 12 mm. In truth the bump uses up only {{stroke-10}} of the stroke limit ({{fig-bumps}}), and the
waves {{stroke-waves}}.

The thesis of the paper is that a measure of the present quality of track should "be made up only of
data that represent loaded-track geometry", the shape of the rails under a train, because these
determine how a given vehicle behaves.

We have the paper as machine-read text, and none of its drawings. It prints few numbers and no
masses or springs. So we test its formulas and claims on vehicles of our own.

{{include: stroke.cpp}}

{{include: force.cpp}}

{{include: combined.cpp}}

{{include: filter.cpp}}

{{include: spectrum.cpp}}

{{include: nonlinear.cpp}}

{{include: histogram.cpp}}

{{include: spreading.cpp}}

## Deviations

* **The peak at 55 m** lies between the damped peak, {{peak-wavelength}}, and $v/f'$ =
  {{resonance-wavelength}}, and neither of the two rounds to it ({{outcome:fig-02/peak-printed}}).
* **Curves of the wheel force that do not cross** need a damping of {{damping-A}} of critical for
  car A. With the 0.2 of the roll mode they would cross. The paper does not print the damping that
  it uses for the wheel force.
* **"<7 m" and ">100 m"**, the ends of the constant level, depend on a vehicle that is not printed,
  and are not testable; {{fig-07}} says what car A gives.
* **That the allowed power "resembles that of existing track"** is not testable: spectrum and
  vertical scale are lost.
* **One allowed amplitude at short waves for every vehicle**: our stops give one or two in
  {{fig-level}} ({{outcome:fig-level/levels}}) and up to three in {{table-levels}}, by their
  stiffness, gap and damping.
* **Damaged in our copy**: the minus of (3) and the first factor of (6), both restored
  ({{outcome:table-equations/six}}); (7) is read from fragments. Spatial frequency is in cycles/km
  in the paper's list of symbols and in cycles/m on the axis of its Figure 2; cycles/m is used.
* **Chosen here**, because the paper does not print it: masses, springs and dampers, the speeds of
  {{fig-05}}, {{fig-06}} and {{fig-07}}, the vertical scale of {{fig-08}}, all numbers of the
  histograms, and the stops, starts and fractions of the nonlinear test, which the paper only
  announces. 

## Limits

* The vehicle is one wheel on one rail. A real car has axles and trucks that meet a wave one after
  the other, so that some wavelengths cancel and others add. 
* The wheel never lifts, and the rail does not yield. Above some 20 Hz the track's own stiffness and
  the contact govern the force; chapter 07 has them.
* The descriptor is a bound for a linear vehicle on a lasting sine, not on a bump ({{fig-bumps}}).
  On two sines of allowed amplitude at once it reads up to 2. The paper says that an actual
  descriptor needs "detailed analysis of combinatorial geometry inputs", several frequencies and
  several kinds of geometry at once; that is not done here, except for the pairs of {{table-pairs}}.
* The stops are elastic and symmetric, and the damper is linear. Freight-car damping is dry
  friction, which chapter 02 treats. 
* The stochastic part assumes independent, normal values; neighbouring values of a descriptor are
  nearly the same value.

## Use it

`railbook quality limit` gives the allowed amplitude for a car of your own, here for the file
`freight.toml` of the examples, which is car A:

```console
$ railbook quality limit --speed 100km/h --car freight.toml --wavelength 5m 20m 100m
...
  amplitude allowed for short waves  1.6 cm
    up to the wavelength             53.29 m
...
  wheel force counts below           4.308 m
  at 5 m                             1.6 cm   (stroke)
  at 20 m                            1.6 cm   (stroke)
  at 100 m                           9.606 cm   (stroke)
```

`railbook quality index` gives the descriptor of a record, here of two kilometres of crosslevel from
the examples:

```console
$ railbook quality index track.csv --speed 100km/h --column crosslevel --out mine
...
  exceedances                          3   (1.506 per km)
...
  worst                                +1.250 at 10400.0 m, wavelength 12.9 m, stroke
                                       +1.141 at 11209.8 m, wavelength 39.8 m, stroke
```

The folder `mine` then holds the descriptor sample by sample, the places beyond the limit, a class
for each 200 m, and a picture like this one of another record, 20 km of profile.

{{picture: quality-index}}

## Try next

* How much track does a shock absorber buy? Compare dampings of 0.1, 0.2 and 0.3.
* Which of the places above remains beyond the limit at 60 km/h?

```console
$ railbook quality limit --speed 100km/h --roll-damping 0.1 --stroke 2.54cm
...
  amplitude allowed for short waves  0.5055 cm
...
$ railbook quality index track.csv --speed 60km/h --column crosslevel
...
  exceedances                          1   (0.5021 per km)
...
```

## Symbols

Under the pointer, each symbol of a formula says what it is.

<details> <summary>All symbols of this chapter</summary>

{{symbols}}

</details>

## Citation

J. C. Corbin and A. E. Fazio, *Performance-Based Track-Quality Measures and Their Application to
Maintenance-of-Way Planning*, Transportation Research Record 802, from page 19 or 20 on. Authors,
title and record stand in our copy. The year, 1981, does not, and is not confirmed: one later paper
(*Track Quality Index for High Speed Track*, Journal of Transportation Engineering 112(1), 1986,
reference 4) cites authors and record with 1980 and another title. A DOI was looked up and not
found. From outside the copy: the speeds of {{fig-05}}, those of the US track classes 2 to 6, and
the spectrum of {{fig-08}}, from the paper of chapter 05.

## Coverage

{{coverage}}
*/
#include "sections.hpp"

namespace railbook::quality_chapter {

quality::StrokeLimit level_limit() {
  return quality::stroke_limit_of_level(roll, flat_level);
}

quality::ForceLimit car(const report::Item& item, const std::string& key) {
  const table::CsvTable table = item.printed("cars.csv");
  const auto number = [&](const char* column) {
    return report::printed_number(table.at(key, column));
  };
  return {quality::make_car(number("wheel_kg"), number("body_kg"),
                            {number("frequency_Hz"), number("damping")}),
          wheel_force_limit};
}

std::vector<double> speeds(const report::Item& item) {
  const table::CsvTable table = item.printed("speeds.csv");
  std::vector<double> result;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    result.push_back(report::printed_number(table.at(i, "kmh")) * kmh);
  return result;
}

}  // namespace railbook::quality_chapter

int main(int argc, char** argv) {
  using namespace railbook::quality_chapter;
  return railbook::report::run(
      argc, argv,
      {.id = RAILBOOK_CHAPTER,
       .name = "quality",
       .title = "How rough may a track be before a vehicle minds?",
       .paper = "J. C. Corbin and A. E. Fazio, Performance-Based Track-Quality Measures and Their "
                "Application to Maintenance-of-Way Planning, Transportation Research Record 802 "
                "(1981?)",
       .sources = RAILBOOK_CHAPTER_DIR},
      {stroke, force, combined, spectrum, filter, nonlinear, histogram, spreading},
      {cost, extremes});
}
