// One table or figure of a paper, while it is being computed.
//
//   void table_2(report::Item& item) {
//     const table::CsvTable printed = item.printed("table-2.csv");  // key,what,unit,hertz,countact
//     item.expect_checks(2);
//     const auto hertz = contact::hertz(...);
//     const report::Row row = item.row(printed, "p0");
//     row.check("hertz", hertz.p0 / units::psi);                                    // to the printed digits
//     row.check("countact", p0 / units::psi, report::relative(0.005, "constant-pressure cells, 9 columns"));
//     item.value("p0-hertz", hertz.p0 / units::psi, "psi", "{:.0f}");               // {{p0-hertz}} in the prose
//   }
//
//   void fig_09(report::Item& item) {
//     report::Data& curve = item.data({"x_in", "p_psi"});   // results/<chapter>/fig-09.csv, ARG1 of fig-09.gp
//     curve.add(x / units::inch, p / units::psi);
//     report::Data& points = item.data("printed", {"x_in", "p_psi"});  // fig-09-printed.csv, ARG3
//     item.reconstructed("the paper does not give the radii; ours are stated above");
//   }
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "report/record.hpp"
#include "report/tolerance.hpp"
#include "table/csv.hpp"

namespace railbook::report {

// The rows of one CSV file of a figure. A header names the unit after an underscore: "p_psi".
class Data {
 public:
  Data(std::string file, const std::vector<std::string>& columns);

  // One row: a number or text a column; another count of cells throws std::logic_error.
  template <class... Cells>
  void add(const Cells&... cells) {
    add_row({cell(cells)...});
  }
  // An empty line: gnuplot lifts the pen.
  void gap() { text_ += "\n"; }

  // The committed figures' data are compared on every machine, to 1e-6 of a value or 1e-9 of the largest in its column.
  // A column ("*": all) whose digits are determined less well holds to a relative or an absolute difference of its own, for
  // a reason: it is cancellation, a round-off floor, a motion that forgets its start.
  Data& holds_to(std::string_view column, double relative, double absolute, std::string_view why);
  // Data that no two runs share, such as times, and the picture drawn from them.
  Data& not_compared(std::string_view why);

  const std::string& file() const { return file_; }
  // The file: header, rows, and what was said about their accuracy as lines that begin with #.
  std::string text() const { return text_ + notes_; }

 private:
  static std::string cell(double value) { return table::csv_number(value); }
  static std::string cell(const std::string& text) { return table::csv_cell(text); }
  static std::string cell(const char* text) { return table::csv_cell(text); }
  void add_row(std::initializer_list<std::string> cells);

  std::string file_;
  std::size_t columns_;
  std::string text_, notes_;
};

class Item;

// A row of printed values: checks one column each. The id of a check is "<key>-<column>"; the optional columns
// "what" and "unit" of the table describe it.
class Row {
 public:
  void check(std::string_view column, double computed,
             const Tolerance& tolerance = last_digit()) const;
  const std::string& printed(std::string_view column) const { return table_->at(key_, column); }

 private:
  friend class Item;
  Row(Item& item, const table::CsvTable& table, std::string key)
      : item_(&item), table_(&table), key_(std::move(key)) {}
  Item* item_;
  const table::CsvTable* table_;
  std::string key_;
};

struct RunSettings {
  std::filesystem::path sources;  // the chapter's folder: data/, scripts
  std::filesystem::path results;  // results/<chapter>
  std::filesystem::path figures;  // figures/<chapter>
  bool full = false;              // --level full
  bool draw = true;               // not --no-figures
  bool timings = true;            // not --no-timings
  bool bite = false;              // shift every computed value by twice its tolerance
};

class Item {
 public:
  Item(std::string id, std::string kind, std::string title, const RunSettings& settings);

  bool full() const { return settings_.full; }
  bool timings() const { return settings_.timings; }
  const std::filesystem::path& sources() const { return settings_.sources; }

  // Checks. The number of checks must be announced, so that a loop over nothing is a failure.
  void expect_checks(int count) { expected_checks_ = count; }
  // A table of printed values from the chapter's data folder; it must outlive the rows taken from it.
  table::CsvTable printed(std::string_view file) const;
  Row row(const table::CsvTable& table, std::string key) { return {*this, table, std::move(key)}; }
  // `printed` is the paper's text; `computed` in the same unit.
  void check(std::string_view id, std::string_view what, std::string_view unit,
             std::string_view printed, double computed, const Tolerance& tolerance = last_digit());
  void check_text(std::string_view id, std::string_view what, std::string_view printed,
                  std::string_view computed);
  // Our value against the `reference` of an independent `method`, relative to the reference.
  void agree(std::string_view id, std::string_view what, std::string_view unit, double computed,
             double reference, double allowed, const std::string& method);

  // Numbers and texts for the prose: {{id}}. `format` is an fmt format of one double; the unit follows it.
  void value(std::string_view id, double number, std::string_view unit = "",
             std::string_view format = "{:.6g}");
  void value(std::string_view id, std::string_view text);

  // A display table: headings once, then rows of text (numbers formatted by the caller with fmt).
  void columns(std::vector<std::string> headings);
  void add_row(std::vector<std::string> cells);

  // Data of a figure: the first is ARG1 (<id>.csv), each named one a further ARG (<id>-<name>.csv, from ARG3 on).
  Data& data(const std::vector<std::string>& columns) { return data("", columns); }
  Data& data(std::string_view name, const std::vector<std::string>& columns);
  // Another gnuplot script than <id>.gp; relative to the chapter's folder.
  void script(std::filesystem::path file) { script_ = std::move(file); }
  // Draws without gnuplot: `write` makes the PNG under the name it is given.
  void image(std::function<void(const std::filesystem::path&)> write) { image_ = std::move(write); }

  // What the item is, where it is not a reproduction checked against print.
  void reconstructed(std::string why) { declare("reconstructed", std::move(why)); }
  void explained(std::string why) { declare("explained", std::move(why)); }
  void sketch(std::string why = "drawing, nothing computed") { declare("sketch", std::move(why)); }
  void not_reproducible(std::string why) { declare("not-reproducible", std::move(why)); }

  void add(std::vector<WorkPrecision> points);
  // `status`: holds, refused, degraded or fails; NaN for `error` where there is none.
  void stability(std::string_view id, std::string_view case_, std::string_view stress,
                 std::string_view result, double error, std::string_view status);

  // For Chapter: writes the CSV files, draws, settles the verdict, and hands everything over to the record.
  void finish(ChapterRecord& record);
  // For Chapter: an exception ended the item.
  void fail(std::string why, ChapterRecord& record);

 private:
  void declare(std::string verdict, std::string why);
  void draw();
  void settle();

  RunSettings settings_;
  ItemRecord record_;
  std::vector<CheckRecord> checks_;
  std::vector<ValueRecord> values_;
  std::vector<WorkPrecision> work_precision_;
  std::vector<Stability> stability_;
  std::vector<std::unique_ptr<Data>> data_;
  std::filesystem::path script_;
  std::function<void(const std::filesystem::path&)> image_;
  int expected_checks_ = -1;
};

}  // namespace railbook::report
