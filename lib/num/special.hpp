// Special functions the chapters need, on GSL.
#pragma once

namespace railbook::num {

// The sine integral Si(x) = integral from 0 to x of sin(t)/t dt, for any finite x; relative
// accuracy 1e-15. Si(-x) = -Si(x), Si(infinity) = pi/2. NaN gives NaN.
double sine_integral(double x);

// What a variable of Student's distribution with so many degrees of freedom (> 0) stays below with
// a probability of 0 to 1 (there infinite); relative accuracy 1e-10. Throws InputError on others.
double student_quantile(double probability, double degrees);

}  // namespace railbook::num
