// The three pairs of wheel and rail as this chapter names them.
#pragma once

#include <array>

#include "wheelrail/paper_pairs.hpp"

namespace railbook::hunting_chapter {}  // namespace railbook::hunting_chapter
