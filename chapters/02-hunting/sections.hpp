// The sections of this chapter: each file registers its tables and figures.
#pragma once

#include <numbers>

#include <railbook/report/chapter.hpp>

namespace railbook::hunting_chapter {

extern const report::Section drawings, geometry, car, describing, critical, branches, mode_shapes,
    algorithm, full_equations, scenes;
extern const report::Section cost, stiffness;  // study/
void extremes(report::Item& item);             // the rows of stability

// The paper's words as numbers: one reading for every claim of the chapter.
namespace words {
inline constexpr double drawn = 0.01;  // constant, vertical, the same: the width of a printed line
inline constexpr double nearly = 0.1;  // nearly, about, approximately; insignificant: a tenth
inline constexpr double small = 0.5;   // small, low: nearer to nothing than to what it is part of
inline constexpr double much = std::numbers::sqrt2;  // much, large, drastic: nearer to twice
inline constexpr double several = 2;
}  // namespace words

}  // namespace railbook::hunting_chapter
