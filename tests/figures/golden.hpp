// Drawn figures against the committed ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace railbook::figures {

inline constexpr int levels = 3;  // a pixel is off when a channel is further off than this
inline constexpr double allowed_share = 0.001;  // of the pixels may be off

// What was compared, one line a figure, and what is wrong with it, one line a fault.
struct Report {
  std::vector<std::string> compared;
  std::vector<std::string> faults;
};

// File names, "NN-name/id.png", that a list excludes: one a line, `#` opens a comment. A missing list is empty.
std::vector<std::string> read_list(const std::filesystem::path& file);

// Compares the PNGs of two folders by name. Every one must be in both, of one size, and alike up to `levels`
// and `allowed_share`. Left out are names in `excluded` (as folder name of `golden` / file name) and names
// ending in -time.png: figures of measured run time, which no two runs share.
// A folder without any figure, or a file that is no PNG, is a fault.
Report compare(const std::filesystem::path& drawn, const std::filesystem::path& golden,
               const std::vector<std::string>& excluded);

}  // namespace railbook::figures
