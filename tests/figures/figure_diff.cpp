// figure_diff compare|data|accept OUT GOLDEN RECORDED HERE: the figures, or their data alone, of
// the run with --out OUT and the committed folder GOLDEN, figures/NN-name. RECORDED names what the
// committed pictures were made with, HERE what draws on this machine. Exit status 0: alike, or
// accepted; 1: not, each fault on a line of its own; 2: usage.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <sstream>
#include <string>

#include "golden.hpp"

namespace {

std::string text_of(const char* file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace railbook::figures;
  const std::string verb = argc == 6 ? argv[1] : "";
  if (verb != "compare" && verb != "data" && verb != "accept") {
    fmt::print(stderr, "usage: figure_diff compare|data|accept OUT GOLDEN RECORDED HERE\n");
    return 2;
  }
  const std::filesystem::path golden = argv[3];
  const Drawn drawn = read_run(argv[2], golden.filename().string());
  const bool pixels = text_of(argv[4]) == text_of(argv[5]);
  if (verb == "accept") {
    if (!pixels) {
      fmt::print(stderr,
                 "The golden pictures were made with other programs ({}) than those of this "
                 "machine ({}).\nAccept where "
                 "they were made, or accept all chapters here.\n",
                 argv[4], argv[5]);
      return 1;
    }
    const Report done = accept(drawn, golden);
    for (const std::string& line : done.compared) fmt::print("  {}\n", line);
    fmt::print("{}: {} files changed\n", drawn.chapter, done.compared.size());
    return 0;
  }
  const Report report =
      verb == "data" ? compare_data(drawn.data, golden) : compare(drawn, golden, pixels);
  for (const std::string& line : report.compared) fmt::print("{}\n", line);
  if (verb == "compare" && !pixels)
    fmt::print("Pictures by size only: the golden ones were made with other programs, see {}.\n",
               argv[4]);
  for (const std::string& line : report.faults) fmt::print("FAULT {}\n", line);
  fmt::print("{} files alike, {} faults\n", report.compared.size(), report.faults.size());
  return report.faults.empty() ? 0 : 1;
} catch (const std::exception& e) {
  fmt::print(stderr, "figure_diff: {}\n", e.what());
  return 2;
}
