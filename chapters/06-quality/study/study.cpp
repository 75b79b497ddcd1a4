/*** # What track quality costs to compute, and where it holds

## Error against run time

Three questions: how to filter a record, to follow a body with stops, and to spread a histogram. The
best method stands at the lower left of a panel.

{{include: cost.cpp}}

## Stability

What a single start or a linear formula can miss comes first, then the extreme cases.

{{include: stability.cpp}}
*/
