// The command line of a program of tools: `railbook contact solve --config case.toml`.
//
// Every option may stand in a TOML file, named by --config or given as the first word after the tool's name. Exit
// status: 0 good, 2 bad input or usage, 3 the outside failed (a full disk, gnuplot; quietly when the reader of standard
// output went away), 1 anything else.
#pragma once

#include <string>
#include <vector>

#include "tool/options.hpp"

namespace railbook::tool {

// Tools about one subject.
struct Subject {
  std::string name, help;
  std::vector<Tool> tools;
};

// Reads the command line, runs the tool it names, and returns the exit status.
int run(int argc, char** argv, const std::string& name, const std::string& about,
        const std::vector<Subject>& subjects);

}  // namespace railbook::tool
