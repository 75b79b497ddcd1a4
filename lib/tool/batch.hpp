// One question to many records, one after the other: a table with a row or more for each.
//
//   o.records(input.batch);                               // "record ..." and --manifest
//   ...
//   if (input.batch.many()) return tool::run_batch(input.batch, input.out, "classify", [&](const
//   auto& file) { return rows; });
//
// To use several processors or machines, run the command several times (xargs -P, GNU parallel, a
// job array) and join what
// --json prints.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>

namespace railbook::tool {

// What is known of a record, or of a section or column of it, in the order of the table's columns.
class Row {
 public:
  void add(std::string key, double value);  // NaN: nothing
  void add(std::string key, std::string text);
  // Warnings, as Summary's: in the column "warnings", joined by semicolons.
  void warn(const std::string& key);
  // Gives this row of a record the status "refused" and a reason; the record's other rows stand.
  void refuse(std::string reason) { reason_ = std::move(reason); }
  const std::optional<std::string>& refused() const { return reason_; }

  struct Cell {
    std::string key, text;
    double value = 0;
    bool is_text = false;
  };
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  std::vector<Cell> cells_;
  std::optional<std::string> reason_;
};

// An answer as a row: its numbers and texts by their keys, errors as KEY_error, and its warnings.
Row row_of(const Summary& answer);

using RecordRows = std::function<std::vector<Row>(const std::filesystem::path& record)>;

// Answers all records, on `threads` threads, and prints what came of them; with --json, a line for
// each row as soon as its record is answered. With --out DIR: DIR/NAME-table.csv and .jsonl, one
// row an answer: record, status (ok, refused, failed), reason, then the rows' own columns. A record
// that is refused or that fails is a row with its reason, and the others are answered; a record of
// which a row is refused counts as refused. Then throws
// files::OutsideError when a record failed, else InputError when one was refused: not all of them
// are answered, and the exit status says so.
void run_batch(const RecordFiles& records, const Destination& out, const std::string& name,
               const RecordRows& rows, int threads = 1);

}  // namespace railbook::tool
