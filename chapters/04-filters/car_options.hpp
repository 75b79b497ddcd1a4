// Options that the tools of the car share.
#pragma once

#include "geometry_car/car.hpp"
#include "report/options.hpp"

namespace railbook::filters {

// Dimensions and corners, the same names for `simulate` and `process`, so that one TOML file serves both.
void add_layout(report::Options& options, geometry_car::Layout& layout);

}  // namespace railbook::filters
