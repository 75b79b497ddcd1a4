/***
# Hunting: what it costs and where it holds

The second page of this chapter: methods against each other, and cases that strain them. The first page tells the paper.

## Error against run time

{{include: cost.cpp}}

{{include: stiffness.cpp}}

## Stability

{{stability}}

{{include: extremes.cpp}}
*/
