/*** # What spoils the filters of a geometry car, what they cost and where they hold

{{include: mismatch.cpp}}

{{include: cost.cpp}}

{{work-precision: cost-length}}

## What do stops, reversals and faults do?

A car stops, it reverses, its encoder counts twice, a sensor stands still. Each row puts one of
these into a filter, or into the simulated car, and compares with the undisturbed answer or the true
rail. What may be lost is set beforehand.

{{stability}}

{{include: stability.cpp}}
*/
#include "sections.hpp"
