// A file of options: the part of TOML that a list of options needs.
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

// Comments, [tables], dotted and quoted keys, strings in either quotes with their escapes, numbers,
// booleans and arrays, which may go over lines; a bare value with a unit (load = 80 kN) is taken as
// it stands. Refused are arrays of tables, inline tables, strings over several lines, and a key
// given twice. Throws InputError naming file, line and what is wrong.
std::vector<TomlEntry> read_toml(const std::filesystem::path& file);

}  // namespace railbook::tool
