/*** # Classifying track: what it costs, and where it holds

## Error against run time

{{include: accuracy.cpp}}

## Stated errors

{{include: estimates.cpp}}

## Stability

{{include: stability.cpp}}
*/
