// What is measured: each row says what the work is, who does it, and what the machine asks for it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace bench_rows {

struct Way {
  std::string what;
  std::function<void()> run;
};

struct Row {
  std::string key, what, unit;
  double work = 0;   // in that unit
  Way ours;          // what: the method
  Way limit = {};    // what the machine asks: the same bytes or transforms and nothing else
  Way plain = {};    // what one would write first
  double share = 1;  // of the work that the plain way does, where all of it takes too long
  std::function<std::string()> count = {};  // what ours was seen to do, without a clock
};

// Each sets itself up; files go to `folder`.
std::vector<std::pair<std::string, std::function<Row()>>> all(const std::filesystem::path& folder);

}  // namespace bench_rows
