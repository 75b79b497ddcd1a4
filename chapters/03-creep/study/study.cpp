/*** # Creep: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

## Stability

What defeats the solver? A case *holds* when its error stays within the bound set for it, *degrades* when
it loses accuracy in the way stated, and is *refused* when the program says why it has no number. In the
tables $X$ is the dimensionless longitudinal creepage of the first page and Φ the dimensionless spin, fx
and fy are the forces along and across over the friction limit $\mu N$, and mz is the moment over
$\mu N\sqrt{ab}$.

{{include: stability.cpp}}
*/
