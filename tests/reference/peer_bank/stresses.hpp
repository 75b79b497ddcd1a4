// The bank's stresses (stresses.csv): pressures and tractions of cells, and stresses below them.
#pragma once

#include <string>
#include <vector>

#include "half_space.hpp"

namespace railbook::peer_bank {

// Comparisons with the rows of `file`; those of cells are of the `cases` that they name. Throws
// std::runtime_error when a solver does not converge, or a row names no case.
std::vector<Comparison> answer_stresses(const std::vector<HalfSpaceCase>& cases,
                                        const std::string& file);

}  // namespace railbook::peer_bank
