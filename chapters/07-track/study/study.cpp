/***
# Track: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: passages.cpp}}

## Stability

{{stability}}

{{include: extremes.cpp}}

## Digits and stated errors

{{include: digits.cpp}}
*/
