/*** # Track quality as a vehicle feels it

How rough may a track be? J. C. Corbin and A. E. Fazio answer with a vehicle. Drive it over a sine of the track and see how much of its
suspension stroke, or of the force its wheel may bear, one metre of amplitude uses up; the inverse is the amplitude that may be
left in the track at that wavelength; the least of it over all speeds up to the posted one is what has to be maintained. The curve becomes a filter. Run over a
geometry record, its output is 1 where the track uses up what the vehicle can bear.

The paper prints few numbers and no masses or springs at all. So here each formula is proven against integration in time, each claim
is tested and its range stated, the filter is built and run on long records, and the paper's hypothesis, that the curves hold for any vehicle
however nonlinear, is put to the test with the bump stops it mentions. It fails, and we show where.

{{include: stroke.cpp}}

{{include: force.cpp}}

{{include: combined.cpp}}

{{include: time_domain.cpp}}

{{include: psd.cpp}}

{{include: filter.cpp}}

{{include: nonlinear.cpp}}

{{include: branches.cpp}}

{{include: pairs.cpp}}

{{include: index.cpp}}

{{include: spreading.cpp}}







## Error against run time

{{include: cost.cpp}}

## Stability

{{stability}}

{{include: stability.cpp}}

## Deviations

What the paper prints that we do not confirm, or confirm for some data only:

* **Equation (3)** lacks a minus on the right, which (1) requires. The factor before (6) cannot be read; with $(2\pi)^4m^2v^4\varphi^4$ it agrees with (5) to rounding. Spatial frequency is
  in cycles/km in the list of symbols and in cycles/m on the axis of Figure 2; we use cycles/m.
* **The peak at 55 m** lies between the damped peak, {{peak-wavelength}}, and $v/f'$ = {{resonance-wavelength}}, and is neither rounded. "Resonance at maximum speed" as the end of the flat level is the damped peak.
* **"Unit gain at wavelengths shorter than resonance"** is an asymptote; at 20 m the gain is {{gain-20}}.
* **"The curves do not interpenetrate"** in the wheel-force mode needs a damping of {{damping-A}} of critical for car A ({{table-damping}} is exact). With the 0.2 of the roll mode they would.
* **"Below 7 m"** for the corner of the wheel force fits the reconstructed car up to 130 km/h; at 177 km/h it is {{corner-177}}. With a loaded 70-ton car it is {{corner-B}} at 100 km/h.
* **"Above 100 m"** for the growth fits 177 km/h; at 100 km/h the allowed amplitude has doubled at {{double-100}}.
* **"Resembles" the spectrum of track** holds within about a decade: {{mismatch-squared}} or {{mismatch-relative}}, by the reading of the squared amplitude.
* **The hypothesis of any nonlinear vehicle** fails for a vehicle with stops: {{high-1}} of stroke where 2.54 cm is promised, {{high-12}} at 1.2 Hz. The shape of the curve survives, with another level and corner ({{fig-level}}).
* **The viscous blob** of Figure 10, taken literally, has no tails, so it never exceeds a threshold its edge has not reached.

Not in the paper, and therefore reconstructed: masses, springs and dampers, the speeds of Figures 5 to 7, the vertical scale of Figure 8, all numbers of Figures 9 to 11, and the stops, starts and
shares of the nonlinear test, which it only announces. It does not say which three or four parameters of the filter are free; for us they are $f'$, $\rho$, $x_0$ and the wheel mass that governs
short waves.

## Limits

* One wheel on one rail. Two axles filter wavelengths of the wheelbase, a second truck adds phases at each end of the car, and roll and bounce are driven by different channels: cross level and profile. The combined curve
  is applied to whichever channel it is given.
* The wheel never lifts, and the rail does not yield. Above some 20 Hz the track's own stiffness and the contact govern the force; chapter 07 has them. Waves below a metre are beyond this model.
* The descriptor is a bound for a lasting sine, not for a bump ({{fig-bumps}}) nor for several waves at once: two sines on the envelope read up to 2.
* Near the ends of a record and at its gaps the filter continues the track. The tool marks what lies within a resonant wavelength of them.
* The stops are elastic and symmetric, the damper is linear. Freight-car damping is dry friction, of which chapter 02 makes more.
* The chaotic pair has no settled stroke, only samples of one, and another compiler may find others.
* The stochastic part assumes independent, normal values. Neighbouring values of the channel are nearly the same value: exceedances per kilometre count places, values above the threshold count samples.

## Try next

* `quality limit` with `--roll-damping` 0.1 and 0.3: how much track does a shock absorber buy?
* Give {{fig-level}} softer stops that engage earlier, `stopped` with another gap. Is there a stop that keeps the level of the linear car?
* Start {{table-starts}} with a train of five waves in place of an endless one. How many does the upper branch need?
* Replace the linear damper by dry friction (`lib/dynamics` has its describing function) in the curve of {{fig-branches}}.
* Make a track with `psd synthesize`, run `quality index` on it at three speeds, and compare the order of its worst places.
* Put the histogram of your record, instead of a point, into `quality::spread`, once with each law.

## All verdicts

{{verdicts}}
*/
#include "items.hpp"
#include "num/log_spaced.hpp"

#include <cmath>

using namespace railbook;

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
  report::Chapter chapter{
      {.id = RAILBOOK_CHAPTER,
       .name = "quality",
       .title = "Track quality as a vehicle feels it",
       .paper = "J. C. Corbin and A. E. Fazio, Performance-Based Track-Quality Measures and Their "
                "Application to Maintenance-of-Way Planning, Transportation Research Record 802",
       .sources = RAILBOOK_CHAPTER_DIR}};
  railbook::quality_chapter::add_stroke(chapter);
  railbook::quality_chapter::add_force(chapter);
  railbook::quality_chapter::add_combined(chapter);
  railbook::quality_chapter::add_time_domain(chapter);
  railbook::quality_chapter::add_psd(chapter);
  railbook::quality_chapter::add_filter(chapter);
  railbook::quality_chapter::add_nonlinear(chapter);
  railbook::quality_chapter::add_branches(chapter);
  railbook::quality_chapter::add_pairs(chapter);
  railbook::quality_chapter::add_index(chapter);
  railbook::quality_chapter::add_spreading(chapter);
  railbook::quality_chapter::add_cost(chapter);
  railbook::quality_chapter::add_stability(chapter);
  return chapter.run(argc, argv);
}
