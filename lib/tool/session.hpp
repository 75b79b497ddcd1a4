// What the program was asked: kept in every answer, so that it can be made again.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace railbook::tool {

struct Session {
  std::string program, version;
  std::vector<std::string> command;  // as it was typed
  // Options of the tool that runs, in the order of its help: those that were given, and the values
  // of those that were not.
  std::vector<std::pair<std::string, std::string>> given, assumed;
  bool json = false;   // the answer is printed as JSON, and nothing else is on standard output
  bool taken = false;  // standard output is a file's: the answer goes to standard error
};

// The one of this process; tool::run fills it before a tool starts.
Session& session();

}  // namespace railbook::tool
