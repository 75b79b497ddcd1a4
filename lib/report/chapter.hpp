// A chapter program: named tables and figures behind one command line.
//
//   const report::Section example_1{report::figure("fig-06", fig_06),
//                                   report::table("table-2", table_2)};
//
//   int main(int argc, char** argv) {
//     return report::run(argc, argv,
//                        {.id = RAILBOOK_CHAPTER, .name = "contact", .title = "...", .paper =
//                        "...",
//                         .sources = RAILBOOK_CHAPTER_DIR},
//                        {method, example_1}, {cost, extremes});
//   }
//
// Subcommands: reproduce (--only, --level, --out, --no-figures, --no-timings, --progress) and list.
// Exit status: 0 all good, 1 a check failed, 2 bad input or usage.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <railbook/report/item.hpp>

namespace railbook::report {

struct ChapterInfo {
  std::string id;     // "01-contact"
  std::string name;   // the program's name, "contact"
  std::string title;  // of the page
  std::string paper;  // full citation
  std::filesystem::path sources;
  std::string doi = {};
};

using ItemFunction = std::function<void(Item&)>;

struct Entry {
  std::string id, kind, title;
  ItemFunction compute;
};
// The caption of an item stands in data/captions.csv, under `item` and `caption`, or here as
// `title`.
Entry table(std::string id, ItemFunction compute);
Entry table(std::string id, std::string title, ItemFunction compute);
Entry figure(std::string id, ItemFunction compute);
Entry figure(std::string id, std::string title, ItemFunction compute);

// The items of one file, in reading order. A costly result that several share belongs in a
// function-local static, so that it is computed once, by the first that needs it.
using Section = std::vector<Entry>;

// Reads the command line and does what it says; returns the exit status. `paper` is the chapter's
// first page, `study` its second: error against run time, and stability. Items run in this order;
// one whose arithmetic divides by zero or is invalid fails.
int run(int argc, char** argv, const ChapterInfo& info, const std::vector<Section>& paper,
        const std::vector<Section>& study = {});

}  // namespace railbook::report
