// A chapter program: named tables and figures, and tools for a user's own data, behind one command line.
//
//   int main(int argc, char** argv) {
//     report::Chapter chapter{{.id = RAILBOOK_CHAPTER, .name = "contact", .title = "...", .paper = "...",
//                              .sources = RAILBOOK_CHAPTER_DIR}};
//     chapter.table("table-2", "Hertz and COUNTACT", table_2);    // void table_2(report::Item&)
//     chapter.figure("fig-09", "Pressure along the axis", fig_09);
//     chapter.tool("solve", "normal contact of your own bodies", solve_tool);
//     return chapter.run(argc, argv);
//   }
//
// Subcommands: reproduce (--only, --level, --out, --no-figures, --no-timings, --bite), list, and the tools.
// Exit status: 0 all good, 1 a check failed, 2 bad input or usage.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/item.hpp"
#include "report/options.hpp"

namespace railbook::report {

struct ChapterInfo {
  std::string id;     // "01-contact"
  std::string name;   // the program's name, "contact"
  std::string title;  // of the page
  std::string paper;  // full citation
  std::filesystem::path sources;
};

class Chapter {
 public:
  using ItemFunction = std::function<void(Item&)>;

  explicit Chapter(ChapterInfo info) : info_(std::move(info)) {}

  // Items run in the order they are added. A costly result that several share belongs in a function-local static,
  // so that it is computed once, by the first that needs it.
  void table(std::string id, std::string title, ItemFunction compute);
  void figure(std::string id, std::string title, ItemFunction compute);
  void tool(std::string name, std::string help, ToolSetup setup);

  // Reads the command line and does what it says; returns the exit status. Items and tools run with the
  // floating-point traps on.
  int run(int argc, char** argv);

 private:
  struct Entry {
    std::string id, kind, title;
    ItemFunction compute;
  };
  struct Tool {
    std::string name, help;
    ToolSetup setup;
  };
  struct Reproduce {
    std::vector<std::string> only;
    std::string level = "quick";
    std::string out;
    bool no_figures = false;
    bool no_timings = false;
    bool bite = false;
  };

  void add(std::string id, std::string kind, std::string title, ItemFunction compute);
  int reproduce(const Reproduce& wish) const;
  void list() const;

  ChapterInfo info_;
  std::vector<Entry> entries_;
  std::vector<Tool> tools_;
};

}  // namespace railbook::report
