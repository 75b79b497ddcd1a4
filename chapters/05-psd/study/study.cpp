/*** # Classifying track: what it costs, and where it holds

## Error against run time

{{include: length.cpp}}

{{include: cost.cpp}}

## Stability

{{include: stability.cpp}}

{{include: cases.cpp}}
*/
