// What a chapter leaves behind: plain records, written as JSON for the book, the tests and other
// readers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace railbook::report {

// What was varied before a verdict against the paper, and where the result came out
// (report/trial.hpp); all as the reader sees it.
struct TrialRecord {
  struct Varied {
    std::string choice;
    std::vector<std::string> settings, results;
    std::string range;  // of the results of this choice
  };
  std::string quantity, range;
  std::vector<Varied> varied;
};

// One comparison.
struct CheckRecord {
  std::string id;    // "table-2/p0"
  std::string item;  // "table-2"
  std::string what;
  std::string unit;
  std::string source;   // print, claim, publication or route
  std::string outcome;  // see Outcome; "failed" when it does not pass
  std::string place;    // where in the paper, from the inventory; print and claim only
  std::string by;  // the work or the method that the reference is of; publication and route only
  std::string reference;      // the paper's text, or the number of `by`
  double computed = 0;        // NaN when the computed thing is a text
  std::string computed_text;  // as shown beside the printed text
  double allowed = 0;
  double error = 0;
  std::string kind;
  std::string why;
  bool pass = false;
  TrialRecord trial = {};  // nothing varied: none
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
  double seconds_q1 = 0;  // quartiles of the samples
  double seconds_median = 0;
  double seconds_q3 = 0;
  int samples = 0;
  double work = 0;        // the method's own work count
  std::string work_unit;  // of what: "cell pairs"
  bool converged = true;
  std::string reason;
};

// One stiff or extreme case: what is expected to become of it, and what was found.
struct Stability {
  std::string id;
  std::string case_;
  std::string stress;
  std::string result;
  std::string reference;      // what the error is against
  double error = 0;           // NaN when there is none
  double allowed = 0;         // NaN when there is none
  std::string expect, found;  // holds, degrades or refused; found also: fails
  double seconds = 0;
  bool pass = false;
};

// A table, figure or group of checks.
struct ItemRecord {
  std::string id;
  std::string kind;  // "table" or "figure"
  std::string title;
  std::string page = "paper";    // or "study"
  std::string input = "paper";   // paper, rebuilt, added, sketch or lost
  std::string reason;            // for another input than the paper's
  std::string failure;           // why the item failed, empty if it did not
  std::string png;               // file name in figures/<chapter>/, empty without a figure
  std::string not_drawn;         // why this build draws no picture of it
  std::vector<std::string> csv;  // file names in results/<chapter>/
  std::string script;            // gnuplot script beside the chapter's sources
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  double seconds = 0;
};

// A row of the chapter's inventory (report/detail/inventory.hpp).
struct InventoryRow {
  std::string place, kind, number, what;
  std::vector<std::string> treated;
  std::string symbol, test, reason;
};

struct ChapterRecord {
  std::string chapter;  // "01-contact"
  std::string title;
  std::string paper;
  std::string doi;
  std::string level;  // "quick" or "full"
  double seconds = 0;
  std::vector<std::string> only;  // the items asked for; empty: all
  std::vector<CheckRecord> checks;
  std::vector<ItemRecord> items;
  std::vector<ValueRecord> values;
  std::vector<WorkPrecision> work_precision;
  std::vector<Stability> stability;
  std::vector<InventoryRow> inventory;
  std::vector<std::string> problems;  // of the inventory
};

// Writes the record as JSON, at once and whole. NaN and infinity become null.
void write_record(const ChapterRecord& record, const std::filesystem::path& file);

// The checks of a record as CSV text; the column "printed" holds the paper's text and nothing else.
std::string checks_csv(const ChapterRecord& record);

}  // namespace railbook::report
