/*** # Track quality as a vehicle feels it

::: findings
1. How smooth must track be at long waves? The paper finds that the same amplitude may be left at all waves shorter than the one that excites the vehicle at top speed, and that longer waves may grow with the square of their length. For its linear vehicle both follow exactly from its formula. {{outcome:fig-05/level}} {{outcome:fig-05/tail}}
2. Is that so for "all vehicle models regardless of how complex or nonlinear they may be", as the
   paper supposes? That the allowance cannot grow towards short waves is so for any vehicle. With our
   bump stops, met at 0.6 of the stroke limit, and the paper's damping of 0.2, it grows with the
   square of the wavelength beyond one that the speed sets. {{outcome:fig-level/shape}} The single
   level remains if the stops are as stiff as the spring. With stops ten times as stiff the allowance
   falls from {{one-wave-10}} to at most {{level-10}} for waves below {{second-10}}, because every
   third wave can keep the body swinging. {{outcome:fig-level/subharmonic}}
3. Do the curves for the wheel force "not interpenetrate each other as speed is changed"? This is not testable, because the paper prints neither masses nor dampers. It needs a damping of {{least-damping}} of the critical one or more if the body has at least twice the mass of the wheel.
:::

How rough may a track be? J. C. Corbin and A. E. Fazio answer with a vehicle. Drive it over a sine of the track and see how much of its
suspension stroke, or of the force its wheel may bear, one metre of amplitude uses up. The inverse is the amplitude that may be
left in the track at that wavelength, and the least of it over all speeds up to the posted one is what has to be maintained. The curve becomes a filter. Run over a
geometry record, its output is 1 where the track uses up what the vehicle can bear. The thesis of the paper is that a measure of the present quality of track should "be made up only of data that represent
loaded-track geometry", because these determine how a given vehicle behaves.

The paper prints few numbers and no masses or springs. So each formula is compared with integration in time, each claim
is tested and its range stated, and the paper's hypothesis is tried on a vehicle with the bump stops it mentions. We have the machine-read text of the paper and none of its drawings.

{{include: stroke.cpp}}

{{include: force.cpp}}

{{include: combined.cpp}}

{{include: spectrum.cpp}}

{{include: filter.cpp}}

{{include: nonlinear.cpp}}

{{include: histogram.cpp}}

{{include: spreading.cpp}}

## Deviations

* **The peak at 55 m** lies between the damped peak, {{peak-wavelength}}, and $v/f'$ = {{resonance-wavelength}}, and is neither rounded. {{outcome:fig-02/peak-printed}}
* **The unit gain at waves shorter than resonance** is an asymptote; at 20 m the gain is {{gain-20}}. {{outcome:fig-02/unit-gain}}
* **Curves of the wheel force that do not cross** need a damping of {{damping-A}} of critical for car A. With the 0.2 of the roll mode they would cross. The paper's damping of this mode is not printed.
* **"<7 m" and ">100 m"**, the ends of the constant level, depend on a vehicle that is not printed; {{fig-07}} says what car A gives. {{outcome:fig-07/short}} {{outcome:fig-07/long}}
* **That the allowed power "resembles that of existing track"** is not testable: spectrum and vertical scale are lost. {{fig-08}} shows how far another line's spectrum is from it.
* **One level for every vehicle**: our stops give one, two or three levels, by their stiffness, gap and damping; {{table-levels}} says which. {{outcome:fig-level/shape}} {{outcome:fig-level/subharmonic}}

Damage of our copy: the minus of (3) and the first factor of (6) are restored ({{outcome:table-equations/six}}), (7) is read from fragments. Spatial frequency is
in cycles/km in the list of symbols and in cycles/m on the axis of Figure 2; cycles/m is used. Not in the paper and therefore rebuilt: masses, springs and dampers, the speeds of Figures 5 to 7, the
vertical scale of Figure 8, all numbers of Figures 9 to 11, and the stops, starts and fractions of the nonlinear test, which it only announces. In the paper a stop is met when the stroke limit is reached;
ours are met at 0.6 of it.

## Limits

* One wheel on one rail. Two axles filter wavelengths of the wheelbase, a second truck adds phases at each end of the car, and roll and bounce are driven by different channels.
* The wheel never lifts, and the rail does not yield. Above some 20 Hz the track's own stiffness and the contact govern the force; chapter 07 has them.
* The descriptor is a bound for a lasting sine of a linear vehicle, not for a bump ({{fig-bumps}}). Of two sines on the envelope it reads up to 2. The paper says that an actual descriptor needs "detailed analysis of combinatorial geometry
  inputs", several frequencies and several kinds of geometry at once; that is not done here, except for the pairs of {{table-pairs}}.
* The stops are elastic and symmetric, the damper is linear. Freight-car damping is dry friction, of which chapter 02 makes more. The levels of {{fig-level}} are the lowest that a search found.
* The stochastic part assumes independent, normal values; neighbouring values of the channel are nearly the same value.

## Try next

* `railbook quality limit` with `--roll-damping` 0.1 and 0.3: how much track does a shock absorber buy?
* Give {{fig-level}} stops that engage at 0.9 of the limit and are 100 times as stiff as the spring. How many levels are there?
* Start {{table-starts}} with a train of five waves in place of an endless one. How many does the upper branch need?
* Make a track with `railbook psd synthesize`, run `railbook quality index` on it at three speeds, and compare the order of its worst places.

## Citation

J. C. Corbin and A. E. Fazio, *Performance-Based Track-Quality Measures and Their Application to Maintenance-of-Way Planning*, Transportation Research Record 802, from page 19 or 20 on. Authors, title and
record stand in our copy. The year, 1981, does not, and is not confirmed: one later paper (*Track Quality Index for High Speed Track*, Journal of Transportation Engineering 112(1), 1986,
reference 4) cites authors and record with 1980 and another title. A DOI was looked up and not found. From outside the copy: the speeds of {{fig-05}}, those of the US track classes 2 to 6, and
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
       .title = "Track quality as a vehicle feels it",
       .paper = "J. C. Corbin and A. E. Fazio, Performance-Based Track-Quality Measures and Their "
                "Application to Maintenance-of-Way Planning, Transportation Research Record 802, "
                "1981",
       .sources = RAILBOOK_CHAPTER_DIR},
      {stroke, force, combined, spectrum, filter, nonlinear, histogram, spreading},
      {cost, extremes});
}
