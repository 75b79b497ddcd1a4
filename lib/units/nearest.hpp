// A word mistyped, and the one that may have been meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace railbook::units {

// "; did you mean \"classify\"?" for "clasify", where one of `known` is that near: letters left
// out, put in, changed or swapped come to at most a third of the word. Empty where none is.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace railbook::units
