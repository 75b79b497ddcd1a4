/*** # Track quality as a vehicle feels it

::: findings
1. "Control of long waves": a constant level from the resonance at top speed down to any wavelength, and $\lambda^2$ beyond. Result: exact for the linear vehicle, in closed form. {{outcome:fig-05/level}} {{outcome:fig-05/tail}}
2. "These characteristics are ascribable to all vehicle models, however nonlinear." Result: the shape survives bump stops of any stiffness; its threshold drops from {{level-linear}} to {{level-10}}, and only hard starts find it. {{outcome:fig-level/shape}}
3. "The curves" of the wheel force "do not interpenetrate as speed is changed". Result: not testable, for masses and dampers are not printed; it needs {{least-damping}} of critical damping or more, and the paper's only damping, 0.2, would not do. {{outcome:table-damping/least}}
:::

How rough may a track be? J. C. Corbin and A. E. Fazio answer with a vehicle. Drive it over a sine of the track and see how much of its
suspension stroke, or of the force its wheel may bear, one metre of amplitude uses up; the inverse is the amplitude that may be
left in the track at that wavelength; the least of it over all speeds up to the posted one is what has to be maintained. The curve becomes a filter. Run over a
geometry record, its output is 1 where the track uses up what the vehicle can bear.

The paper prints few numbers and no masses or springs. So each formula is held against integration in time, each claim
is tested and its range stated, and the paper's hypothesis is tried on a vehicle with the bump stops it mentions.

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
* **"Unit gain at wavelengths shorter than resonance"** is an asymptote; at 20 m the gain is {{gain-20}}. {{outcome:fig-02/unit-gain}}
* **"The curves do not interpenetrate"** in the wheel-force mode needs a damping of {{damping-A}} of critical for car A. With the 0.2 of the roll mode they would. {{outcome:table-damping/least}}
* **"Below 7 m" and "above 100 m"** depend on a vehicle that is not printed; {{fig-07}} says what car A gives. {{outcome:fig-07/short}} {{outcome:fig-07/long}}
* **"Resembles" the spectrum of track** is not testable: spectrum and vertical scale are lost. {{fig-08}} shows how far another line's spectrum is from it.

Damage of our copy: the minus of (3) and the first factor of (6) are restored ({{outcome:table-equations/six}}), (7) is read from fragments. Spatial frequency is
in cycles/km in the list of symbols and in cycles/m on the axis of Figure 2; cycles/m is used. Not in the paper and therefore rebuilt: masses, springs and dampers, the speeds of Figures 5 to 7, the
vertical scale of Figure 8, all numbers of Figures 9 to 11, and the stops, starts and shares of the nonlinear test, which it only announces.

## Limits

* One wheel on one rail. Two axles filter wavelengths of the wheelbase, a second truck adds phases at each end of the car, and roll and bounce are driven by different channels.
* The wheel never lifts, and the rail does not yield. Above some 20 Hz the track's own stiffness and the contact govern the force; chapter 07 has them.
* The descriptor is a bound for a lasting sine, not for a bump ({{fig-bumps}}) nor for several waves at once: two sines on the envelope read up to 2.
* The stops are elastic and symmetric, the damper is linear. Freight-car damping is dry friction, of which chapter 02 makes more.
* The stochastic part assumes independent, normal values; neighbouring values of the channel are nearly the same value.

## Try next

* `railbook quality limit` with `--roll-damping` 0.1 and 0.3: how much track does a shock absorber buy?
* Give {{fig-level}} softer stops that engage earlier. Is there a stop that keeps the level of the linear car?
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
