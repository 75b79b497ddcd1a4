/*** # Geometry-car filters: what they cost, what spoils them and where they hold

## Error against run time

Two questions on the arithmetic of the long chord, the distance of the rail from the middle of a
string of 62 ft, whichever sensors it is made from.

{{include: cost.cpp}}

{{work-precision: cost-length}}

{{include: mismatch.cpp}}

## Stability

What do stops, reversals and faults do? A car stops, it reverses, its encoder counts twice, a sensor
stands still. Each row puts one of these into a filter, or into the simulated car, and compares with
the undisturbed answer or the true rail. What may be lost is set beforehand.

{{stability}}

{{include: stability.cpp}}

## Digits

{{include: digits.cpp}}
*/
#include "sections.hpp"
