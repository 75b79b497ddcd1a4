// Options that the tools of the car share.
#pragma once

#include <railbook/geometry_car/car.hpp>
#include <railbook/tool/options.hpp>

namespace railbook::filters_tool {

// Dimensions and corners, the same names for `simulate` and `process`, so that one TOML file serves
// both.
void add_layout(tool::OptionParser& parser, geometry_car::Layout& layout);

}  // namespace railbook::filters_tool
