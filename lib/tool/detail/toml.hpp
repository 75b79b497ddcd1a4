// A file of options: the part of TOML that a list of options needs, by CLI11's own reader.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace railbook::tool {

struct TomlEntry {
  std::string name;  // table and key joined by dashes: [body-1] young is "body-1-young"
  std::vector<std::string> inputs;  // one, or those of an array
  std::size_t line = 0;
};

// Comments, [tables], dotted keys, texts in either quotes, numbers, booleans and arrays, which may
// go over lines. Each entry is given to CLI11 by itself, so that a message can name its line and a
// key that is given twice is refused; so is what CLI11 would read as something else (escapes, a
// text with both kinds of quotes). Throws InputError naming file, line and what is wrong.
std::vector<TomlEntry> read_toml(const std::filesystem::path& file);

}  // namespace railbook::tool
