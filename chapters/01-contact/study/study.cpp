/*** # Contact stress: what it costs, and where it holds

## Error against run time

{{include: cost.cpp}}

{{include: errors.cpp}}

## Stability

A case *holds* when its error stays within the bound set for it, *degrades* when it loses accuracy
in the way stated, and is *refused* when the program says why it has no number. Bodies that never
separate, NaN in the gap and grids beyond memory are refused as input (`tests/input`).

{{stability}}

{{include: stability.cpp}}
*/
