/*** # What spoils the filters of a geometry car, what they cost and where they hold

{{include: mismatch.cpp}}

## Error against run time

Two questions on the arithmetic of the long chord, whichever sensors it is made from.

{{include: cost.cpp}}

{{work-precision: cost-length}}

## Stability

What do stops, reversals and faults do? A car stops, it reverses, its encoder counts twice, a sensor
stands still. Each row puts one of these into a filter, or into the simulated car, and compares with
the undisturbed answer or the true rail. What may be lost is set beforehand.

{{stability}}

{{include: stability.cpp}}
*/
#include "sections.hpp"
