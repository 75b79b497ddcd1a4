/*** # Track quality: which method for which question, and where each stops working

## Error against run time

Each panel answers one question: how to filter a record, how to follow a body with stops, and how to
spread a histogram. It draws the error of each method against its run time, so the best method
stands at the lower left; the sentence below it names the fastest of the settings that were tried.

{{include: cost.cpp}}

## Stability

First comes what a single start or a linear formula can miss, then the extreme cases.

{{include: stability.cpp}}
*/
