/*** # Classifying track: what it costs, and where it holds

## Error against run time

{{include: accuracy.cpp}}

## Stability

{{include: stability.cpp}}

## Stated errors and digits

{{include: digits.cpp}}
*/
