// What the name of a column says that is in it.
#pragma once

#include <optional>
#include <string>

namespace railbook::quality_tool {

// The band of EN 13848 that a column is filtered to by its name, as in "Left level D1 [mm]": D0,
// D1, D2 or D3.
std::optional<std::string> band_in_name(const std::string& header);

// Does a name say that the column is the offset of a chord: mco, mid-ordinate, versine, chord, the
// FRA's chords of 31, 62 and 124 ft as in "L PROF 62", or a length behind level or alignment, as in
// "left_profile_62_ft" and "Versine 10 m"?
bool is_offset_by_name(const std::string& header);

// The longest wavelength, m, that Britain's high-pass filters leave, as in "Top left 35m": 35 or
// 70.
std::optional<int> high_pass_in_name(const std::string& header);

}  // namespace railbook::quality_tool
