/*** # What track quality costs to compute, and where it holds

{{include: cost.cpp}}

{{include: stability.cpp}}
*/
