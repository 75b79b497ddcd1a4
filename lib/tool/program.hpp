// The command line of a program of tools: `railbook contact solve --config case.toml`.
//
// Every option may stand in a TOML file, named by --config or given as the first word after the
// tool's name. Exit status: 0 good, 2 bad input or usage, 3 the outside failed (a full disk,
// gnuplot; quietly when the reader of standard output went away), 1 anything else.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <railbook/tool/options.hpp>

namespace railbook::tool {

// Tools about one subject. A single one without a name is the command itself: `railbook verify`.
struct Subject {
  std::string name, help;
  std::vector<Tool> tools;
};

// The program: its name, what it is for, its version and those of the libraries that only its
// caller knows, and what
// --help says at its end.
struct Program {
  std::string name, about, version;
  std::vector<std::pair<std::string, std::string>> libraries;
  std::string help;
};

// Reads the command line, runs the tool it names, and returns the exit status. Besides, there are
// --version, --help,
// --manual (the manual page) and --completion bash or zsh.
int run(int argc, char** argv, const Program& program, const std::vector<Subject>& subjects);

}  // namespace railbook::tool
