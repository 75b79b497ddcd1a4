// What `railbook verify` computes for a reference number.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace railbook::verify_tool {

// The inputs of a number: as text, and those that are numbers.
struct At {
  std::vector<std::string> words;
  double operator[](std::size_t i) const;  // throws InputError unless word i is a number
};

using Quantities = std::map<std::string, std::function<double(const At&)>, std::less<>>;

// By the name that the data files give them. `data` is the folder of those files, which hold two
// profiles as well.
Quantities closed_forms();
Quantities solvers(const std::filesystem::path& data);

}  // namespace railbook::verify_tool
