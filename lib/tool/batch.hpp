// One question to many records: a table with a row for each, made by several processes, taken up again where it was left.
//
//   o.records(wish.batch);                               // "record ...", --manifest, --jobs, --shard
//   ...
//   if (wish.batch.many()) return tool::run_batch(wish.batch, wish.out, "classify", [&](const auto& file) { return rows; });
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tool/options.hpp"

namespace railbook::tool {

// What is known of a record, or of a section or column of it, in the order of the table's columns.
class Row {
 public:
  void add(std::string key, double value);  // NaN: nothing
  void add(std::string key, std::string text);
  // Doubts, as Summary's flags: in the column "flags", joined by semicolons.
  void flag(const std::string& key);

  struct Cell {
    std::string key, text;
    double value = 0;
    bool is_text = false;
  };
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  std::vector<Cell> cells_;
};

using RecordRows = std::function<std::vector<Row>(const std::filesystem::path& record)>;

// Answers all records, or the shard asked for, with `jobs` processes, and prints what came of it. With --out DIR:
//   DIR/NAME-table.csv and .jsonl  one row an answer: record, status (ok, refused, failed), reason, then the rows' own columns
//   DIR/NAME-2-of-4.jsonl          what the shard 2/4 did; the table is made of all of them by a run without --shard
// A record that is refused, or whose process fails, is a row with the reason. What DIR holds of an earlier run, of the same
// files with the same options, is not done again, so that an interrupted run goes on. Throws InputError when no record could be
// answered, files::OutsideError when the files cannot be written.
void run_batch(const BatchWish& wish, const Destination& out, const std::string& name,
               const RecordRows& rows);

}  // namespace railbook::tool
