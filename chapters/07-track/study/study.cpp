/***
# Track: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: passages.cpp}}

## Stability

Where do the models and the solvers stop working? Each row strains one thing and says what its
answer is held against. A row that *holds* stays within a bound that we set for a working solver;
one that *degrades* is a case that the model leaves out, and its bound, ours too, says how large the
error may be there.

{{stability}}

{{include: extremes.cpp}}

## Digits and stated errors

{{include: digits.cpp}}
*/
