// figure_diff DRAWN GOLDEN [LIST]: compares two folders of PNGs; LIST names figures to leave out.
// Exit status 0: alike; 1: not, each fault on a line of its own; 2: usage.
#include <fmt/format.h>

#include <exception>

#include "golden.hpp"

int main(int argc, char** argv) try {
  using namespace railbook::figures;
  if (argc < 3 || argc > 4) {
    fmt::print(stderr, "usage: figure_diff DRAWN GOLDEN [LIST]\n");
    return 2;
  }
  const Report report =
      compare(argv[1], argv[2], argc == 4 ? read_list(argv[3]) : std::vector<std::string>{});
  for (const std::string& line : report.compared) fmt::print("{}\n", line);
  for (const std::string& line : report.faults) fmt::print("FAULT {}\n", line);
  fmt::print("{} figures alike, {} faults\n", report.compared.size(), report.faults.size());
  return report.faults.empty() ? 0 : 1;
} catch (const std::exception& e) {
  fmt::print(stderr, "figure_diff: {}\n", e.what());
  return 2;
}
