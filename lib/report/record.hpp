// What a chapter leaves behind: plain records, written as JSON for the book, the tests and other readers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace railbook::report {

// One comparison. `status`: reproduced, explained, misprint, reconstructed or failed.
struct CheckRecord {
  std::string id;    // "table-2/p0"
  std::string item;  // "table-2"
  std::string what;
  std::string unit;
  std::string printed;        // the paper's text, or the reference of an independent method
  double computed = 0;        // NaN when the computed thing is a text
  std::string computed_text;  // as shown beside the printed text
  double allowed = 0;
  double error = 0;
  std::string kind;
  std::string why;
  std::string status;
  bool pass = false;
};

// A number that prose inserts as {{id}}.
struct ValueRecord {
  std::string id;
  std::string text;
  double value = 0;
  std::string unit;
};

// One point of an error-against-run-time study; `seconds` are 0 when timing is off.
struct WorkPrecision {
  std::string id;        // "cost"
  std::string quantity;  // "F"
  std::string method;
  std::string setting;
  double error = 0;  // relative to the reference
  double reference_uncertainty = 0;
  double seconds_min = 0;
  double seconds_median = 0;
  double noise = 0;  // (median - minimum)/minimum
  double work = 0;   // the method's own work count
  bool converged = true;
  std::string reason;
};

// One stiff or extreme case. `status`: holds, refused, degraded or fails.
struct Stability {
  std::string id;
  std::string case_;
  std::string stress;
  std::string result;
  double error = 0;  // NaN when there is none
  std::string status;
};

// A table, figure or group of checks. `verdict`: reproduced, explained, reconstructed, sketch,
// not-reproducible or failed.
struct ItemRecord {
  std::string id;
  std::string kind;  // "table" or "figure"
  std::string title;
  std::string verdict;
  std::string reason;
  std::string png;               // file name in figures/<chapter>/, empty without a figure
  std::vector<std::string> csv;  // file names in results/<chapter>/
  std::string script;            // gnuplot script beside the chapter's sources
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  double seconds = 0;
};

struct ChapterRecord {
  std::string chapter;  // "01-contact"
  std::string title;
  std::string paper;
  std::string level;  // "quick" or "full"
  double seconds = 0;
  std::vector<std::string> only;  // the items asked for; empty: all
  std::vector<CheckRecord> checks;
  std::vector<ItemRecord> items;
  std::vector<ValueRecord> values;
  std::vector<WorkPrecision> work_precision;
  std::vector<Stability> stability;
};

// Writes the record as JSON, at once and whole. NaN and infinity become null.
void write_record(const ChapterRecord& record, const std::filesystem::path& file);

// The checks of a record as CSV text: id, what, unit, printed, computed, error, allowed, kind, status.
std::string checks_csv(const ChapterRecord& record);

}  // namespace railbook::report
