/*** # Geometry-car filters: what they cost, what spoils them and where they hold

On this page $T$ is the time between two samples, $\theta$ the phase by which a wave of the track
advances between them, and $\kappa$ the corner of an analog filter in rad/s times $T$. $B$ and $F$
are the analog filters of the yaw gyro and of the accelerometers, $C$ and $G$ the digital filters
that undo them. The track and the perfect sensors are those of the first page. Errors of the car are
root mean squares (RMS) without the first and the last 700 ft, so they differ a little from those of
a whole run there.

How wrong may corner and clock be if the error of the profile at 60 mph is to stay below 0.1 mm? The
next two sections find, of the steps and errors of the clock that were tried:

| cause | tolerable |
|---|---|
| corner of the analog filters | {{corner-tolerable}} |
| steps of the clock | {{step-tolerable}} |
| random error of each reading of the clock | {{jitter-tolerable}} |

{{include: mismatch.cpp}}

## Error against run time

The long chord is the distance of the rail from the middle of a string of 62 ft. Two questions
concern its arithmetic; the answers hold for any sensors.

{{include: cost.cpp}}

## Stability

What do stops, reversals and faults do? A car stops, it reverses, its encoder counts twice, a sensor
stands still. Each row puts one of these into a filter, or into the simulated car, and compares with
the undisturbed answer or the true rail. What may be lost is set beforehand. A row *holds* when its
error stays within that, and *degrades* when accuracy is lost in the way that was expected. Errors
and bounds of the filters are relative, those of the car are in metres.

{{stability}}

{{include: stability.cpp}}

## Digits

{{include: digits.cpp}}
*/
#include "sections.hpp"
