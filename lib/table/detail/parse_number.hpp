#pragma once

#include <string_view>

namespace railbook::table {

// A whole cell as a finite number with a decimal point; false where it is none.
bool parse_number(std::string_view cell, double& value);

}  // namespace railbook::table
