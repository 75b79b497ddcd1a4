/*** ## Crosslevel

Crosslevel needs the roll of the car against gravity, and two sensors measure it, each of them
badly. The inclinometer is right in the long run, but takes every lateral acceleration for a roll.
The roll gyro is right for fast changes, but the integral of its bias grows without bound. The
*complementary filter* adds a low-pass of the one to a high-pass of the other, with gains that sum
to one at every frequency.

Let $\vartheta_k$ be the roll at sample $k$ in radians, $\Delta\vartheta_k$ its change over the last
foot by the gyro, and $\gamma_k$ its value by the inclinometer. Then

$$\vartheta_k=c_k\left(\vartheta_{k-1}+\Delta\vartheta_k\right)+(1-c_k)\,\gamma_k,\qquad c_k=e^{-T_k/\tau},$$

where the time constant $\tau$ says how long the gyro is trusted.

The corner is the one frequency that the paper gives: about two octaves, a factor of four, below the
lateral mode of the body, which is typically at 1.25 Hz. This makes a corner of {{roll-corner}} and
a time constant of {{roll-tau}}. The slower the car, the longer is $T_k$ and the closer is $c_k$ to
zero, so that at a crawl the inclinometer alone has the answer.

The paper speaks of stages of first and of second order. With $n$ equal poles the inclinometer
passes $L^n$, where $L=1/(1+s\tau)$, and the gyro the rest, $1-L^n$; the formula above is that of
one pole. Two are our choice: the formula is applied twice, the second time with the result of the
first in place of $\gamma_k$. The table says how much of a sway at the body's own mode is left. It
also says the price of more poles: at the corner the gain of the gyro exceeds one, so that its noise
there is amplified, and a gyro bias $\beta$ makes a roll of $n\tau\beta$.

{{roll}}

Before the inclinometer is used, the other accelerations that it feels are subtracted: the
centrifugal $V\dot\psi$ of the car's speed and yaw rate; $\ell\ddot\psi$ of a yaw that grows, at its
distance $\ell$ from the middle of the car; and $h\ddot\vartheta$ of a roll that grows, at its
height $h$ above the rails, about which the simulated body rolls. The height sensors then give the
track's roll against the body's, and the track's roll times the distance of the rails is the
crosslevel.

How much is each correction of the paper worth? The car runs at 60 mph over the whole standard track
with perfect sensors, and one correction is left out at a time. The first four rows are the
corrections named so far and the roll gyro. The last four belong to profile and alignment, the next
section:

* *The leaning body*: its vertical accelerometers feel less of gravity and some of the centrifugal
  acceleration.
* *Transducers beside the rail*: they and the height sensors do not sit over the rails, so that the
  roll of the axle enters, which the height sensors give.
* *The rolling beam*: its lateral accelerometer feels gravity.
* *The beam above the rails*: the accelerometer moves sideways when the beam rolls.

{{table-corrections: rows}}

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include <railbook/filters/complementary.hpp>

#include "configuration.hpp"
#include "experiment.hpp"
#include "sections.hpp"

namespace railbook::filters_chapter {

using namespace geometry_car;

namespace {

void roll(report::Item& item) {
  item.columns({{"poles", "{:g}"},
                {"inclinometer at 1.25 Hz", "{:.4f}"},
                {"gain of the gyro at the corner", "{:.3f}"},
                {"roll by a bias of 0.01 deg/s, mrad", "{:.3f}"}});
  const double tau = filters::time_constant(roll_corner);
  for (const int n : {1, 2, 3}) {
    const double sway = std::abs(filters::low_pass_gain(tau, n, 1.25));
    item.add_row(static_cast<double>(n), sway,
                 std::abs(1.0 - filters::low_pass_gain(tau, n, roll_corner)),
                 1e3 * filters::gyro_bias_error(0.01 * units::degree, tau, n, 0.01));
  }
  item.claims({{"sway", {std::abs(filters::low_pass_gain(tau, roll_poles, 1.25))}}});
  item.value("roll-corner", roll_corner, "Hz", "{:g}");
  item.value("roll-tau", tau, "s", "{:.4f}");
}

void table_corrections(report::Item& item) {
  item.rebuilt("track and car are chosen");
  item.columns(
      {"left out", "measurement", {"RMS error with it, mm", "{:.3g}"}, {"without", "{:.3g}"}});
  const Record record = cruise(main_line(), 60 * mph);
  const Measurement& t = main_line().truth;
  const Measurement whole = reconstruct(record, chosen_processing());
  using enum Parameter;
  struct Correction {  // one that the paper names, and the parameter it is for
    const char *id, *what;
    bool Corrections::*which;
    Parameter parameter;
  };
  for (const auto& [id, what, which, parameter] : std::initializer_list<Correction>{
           {"centrifugal", "centrifugal acceleration", &Corrections::centrifugal, crosslevel},
           {"yaw-centre", "distance to the yaw centre", &Corrections::yaw_centre, crosslevel},
           {"roll-acceleration", "roll acceleration", &Corrections::roll_acceleration, crosslevel},
           {"roll-gyro", "roll gyro", &Corrections::gyro, crosslevel},
           {"attitude", "gravity and centrifugal acceleration on the leaning body",
            &Corrections::vertical_attitude, profile_left},
           {"transducers", "transducers beside the rail", &Corrections::transducer_place,
            profile_left},
           {"gravity", "gravity on the rolling beam", &Corrections::gravity, alignment_left},
           {"beam-height", "beam above the rails", &Corrections::beam_height, alignment_left}}) {
    Processing less = chosen_processing();
    less.corrections.*which = false;
    const double with = rms_error(whole, t, parameter) / mm;
    const double without = rms_error(reconstruct(record, less), t, parameter) / mm;
    std::string name(parameter_list()[static_cast<std::size_t>(parameter)].name);
    std::ranges::replace(name, '_', ' ');
    item.add_row(what, name, with, without);
    item.claims({{id, {without / with, with, without}}});
  }
}

}  // namespace

const report::Section crosslevel{report::table("roll", roll),
                                 report::table("table-corrections", table_corrections)};

}  // namespace railbook::filters_chapter
