/*** # Classifying track: what it costs, and where it holds

## Error against run time: how much track, and which reading?

{{include: accuracy.cpp}}

{{include: estimates.cpp}}

## Stability: which records break the method, and does it say so?

{{include: stability.cpp}}
*/
