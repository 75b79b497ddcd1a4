// What the name of a column says that is in it.
#pragma once

#include <optional>
#include <string>

namespace railbook::quality_tool {

// The band of EN 13848 that a column is filtered to by its name, as in "Left level D1 [mm]": D0,
// D1, D2 or D3.
std::optional<std::string> band_in_name(const std::string& header);

// Does a name say that the column is the offset of a chord: mco, versine, chord, or a length behind
// level or alignment, as in "left_profile_62_ft" and "Versine 10 m"?
bool is_offset_by_name(const std::string& header);

}  // namespace railbook::quality_tool
