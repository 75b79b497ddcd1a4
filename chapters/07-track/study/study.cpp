/***
# Track: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: passages.cpp}}

## Stability

Where do the models and the solvers stop working? Each row strains one thing; the reference that its
answer is compared with stands below the result. *Holds* means that the solver's error is below our
bound. *Degrades* means that the model leaves something out: the error is what this costs, and must
be below our bound too.

{{stability}}

{{include: extremes.cpp}}

## Digits and stated errors

{{include: digits.cpp}}
*/
