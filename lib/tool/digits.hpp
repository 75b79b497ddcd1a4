// Numbers as the answers of the tools print them: with the digits that they deserve.
#pragma once

#include <string>

namespace railbook::tool {

// Four significant digits, for a number whose error is not known. What four digits hold exactly, as
// 12.7, has no zeros at its end, and a whole number stands as it is.
std::string to_text(double value);

// So many significant digits; powers of ten from 1e7 up and below 1e-4. What they hold exactly, to
// 1e-12, has no zeros at its end.
std::string to_significant(double value, int digits);

// The last digit stands in the place of the error's first one, from one digit to seven. An error of
// zero or an infinite one says nothing: to_text.
std::string to_digits_of(double value, double error);

// The same with the error, "144.54 +- 0.02".
std::string with_error(double value, double error);

}  // namespace railbook::tool
