/***
# Track: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: methods.cpp}}

## Stability

{{stability}}

{{include: extremes.cpp}}

## Digits and stated errors

{{include: digits.cpp}}
*/
