// The roll mode of Corbin and Fazio's vehicle.
#pragma once

#include <railbook/quality/vehicle.hpp>

inline constexpr railbook::quality::Suspension roll{0.5, 0.2};
