// A chapter program: named tables and figures behind one command line.
//
//   int main(int argc, char** argv) {
//     report::Chapter chapter{{.id = RAILBOOK_CHAPTER, .name = "contact", .title = "...", .paper = "...",
//                              .sources = RAILBOOK_CHAPTER_DIR}};
//     chapter.table("table-2", "Hertz and COUNTACT", table_2);    // void table_2(report::Item&)
//     chapter.figure("fig-09", "Pressure along the axis", fig_09);
//     return chapter.run(argc, argv);
//   }
//
// Subcommands: reproduce (--only, --level, --out, --no-figures, --no-timings, --bite), list.
// Exit status: 0 all good, 1 a check failed, 2 bad input or usage.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/item.hpp"

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

  // Reads the command line and does what it says; returns the exit status. Items run with the
  // floating-point traps on.
  int run(int argc, char** argv);

 private:
  struct Entry {
    std::string id, kind, title;
    ItemFunction compute;
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
};

}  // namespace railbook::report
