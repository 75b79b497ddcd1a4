// Text from outside (a cell, a name, an option) made safe to print.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace railbook::units {

// `text` as one line that cannot steer a terminal: control characters, line breaks, marks of
// direction and bytes that are not UTF-8 become \x1b style escapes. What is longer than `most`
// bytes (at least 1) is cut between characters, and its length stated.
std::string printable(std::string_view text, std::size_t most = 80);

}  // namespace railbook::units
