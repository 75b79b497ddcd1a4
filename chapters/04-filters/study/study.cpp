/*** # Filters of a geometry car: what spoils them, what they cost and where they hold

## What spoils the measurement

{{include: mismatch.cpp}}

## Error against run time

{{include: cost.cpp}}

{{work-precision: cost-length}}

## Stability

What a car does to its filters: it stops, it reverses, its encoder counts twice, a sensor stands
still. Each row puts one of these into a filter, or into the simulated car, and compares with the
undisturbed answer or the true rail; what may be lost is stated before.

{{stability}}

{{include: stability.cpp}}
*/
#include "sections.hpp"
