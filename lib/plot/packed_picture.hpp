// A smaller PNG of the same pixels.
#pragma once

#include <string>
#include <string_view>

namespace railbook::plot {

// The same PNG with its pixels packed by zlib at its best; as it was where that is no smaller, or
// where it is no complete PNG.
std::string packed_png(std::string_view png);

}  // namespace railbook::plot
