/***
# Track: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: passages.cpp}}

## Stability

Where do the models and the solvers stop working? Each row strains one thing and says what its
answer is held against. A row that *holds* stays within the bound set before; one that *degrades*
loses accuracy in a known way, by no more than its bound.

{{stability}}

{{include: extremes.cpp}}

## Digits and stated errors

{{include: digits.cpp}}
*/
