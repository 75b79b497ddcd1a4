/***
# Hunting: what it costs and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: stiffness.cpp}}

## Stability

{{stability}}

{{include: extremes.cpp}}
*/
