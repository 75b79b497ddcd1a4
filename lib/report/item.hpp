// One table or figure, while it is being computed.
//
//   void table_2(report::Item& item) {
//     const table::CsvTable printed = item.printed("table-2.csv");  // key,what,unit,hertz,countact
//     item.expect_checks(4);
//     const auto hertz = contact::hertz(...);
//     const report::Row row = item.row(printed, "p0");
//     row.print("hertz", hertz.p0 / units::psi);                                    // to the
//     printed digits row.print("countact", p0 / units::psi, report::relative(0.005,
//     "constant-pressure cells, 9 columns")); item.claim("inside", "the contact lies inside the
//     interpenetration curve", inside); item.agree("force", "force", "lbf", F, exact, 1e-6, "Hertz
//     in closed form"); item.value("p0-hertz", hertz.p0 / units::psi, "psi", "{:.0f}"); //
//     {{p0-hertz}} in the prose
//   }
//
//   void fig_09(report::Item& item) {
//     report::Data& curve = item.data({"x_in", "p_psi"});   // results/<chapter>/fig-09.csv, ARG1
//     of fig-09.gp curve.add(x / units::inch, p / units::psi); report::Data& points =
//     item.data("printed", {"x_in", "p_psi"});  // fig-09-printed.csv, ARG3 item.rebuilt("the paper
//     does not give the radii; those used are stated above");
//   }
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/report/claims.hpp>
#include <railbook/report/expectation.hpp>
#include <railbook/report/record.hpp>
#include <railbook/report/run_folder.hpp>
#include <railbook/report/trial.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

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

  // The committed figures' data are compared on every machine, to 1e-6 of a value or 1e-9 of the
  // largest in its column. A column ("*": all) whose digits are determined less well holds to a
  // relative or an absolute difference of its own, for a reason: it is cancellation, a round-off
  // floor, a motion that forgets its start. Nothing of a column is compared where units::no_limit
  // is allowed: a time.
  Data& holds_to(std::string_view column, double relative, double absolute, std::string_view why);
  // Data that no two runs share, such as times, and the picture drawn from them.
  Data& not_compared(std::string_view why);

  const std::string& file() const { return file_; }
  // The file: header, rows, and what was said about their accuracy as lines that begin with #.
  std::string text() const { return text_ + notes_; }

 private:
  static std::string cell(double value) { return table::csv_number(value, 8); }
  static std::string cell(const std::string& text) { return table::csv_cell(text); }
  static std::string cell(const char* text) { return table::csv_cell(text); }
  void add_row(std::initializer_list<std::string> cells);

  std::string file_;
  std::size_t columns_;
  std::string text_, notes_;
};

// "below 1e-14": the decade of an error that is rounding, whose digits are others on another
// machine.
std::string below(double error);

class Item;

// A row of the paper's printed values: checks one column each. The id of a check is
// "<key>-<column>"; the optional columns "what" and "unit" of the table describe it.
class Row {
 public:
  void print(std::string_view column, double computed,
             const Expectation& expectation = last_digit()) const;
  // The row's numbers are those of another work, named: "Kalker 1967, Table 1".
  void publication(std::string_view column, double computed, const Tolerance& tolerance,
                   const std::string& work) const;
  const std::string& printed(std::string_view column) const { return table_->at(key_, column); }

 private:
  friend class Item;
  struct About {
    std::string id, what, unit;
  };
  Row(Item& item, const table::CsvTable& table, std::string key)
      : item_(&item), table_(&table), key_(std::move(key)) {}
  About about(std::string_view column) const;
  Item* item_;
  const table::CsvTable* table_;
  std::string key_;
};

// A column of a display table, and how its numbers are written: {"error, mm", "{:.4f}"}.
struct Heading {
  Heading(const char* t) : text(t) {}             // NOLINT(google-explicit-constructor)
  Heading(std::string t) : text(std::move(t)) {}  // NOLINT(google-explicit-constructor)
  Heading(std::string t, std::string f) : text(std::move(t)), format(std::move(f)) {}
  std::string text;
  std::string format = "{:.4g}";
};

// A cell: a text, or a number in its column's format (NaN: a dash).
struct Cell {
  Cell(const char* t) : text(t) {}                // NOLINT(google-explicit-constructor)
  Cell(std::string t) : text(std::move(t)) {}     // NOLINT(google-explicit-constructor)
  Cell(double n) : number(n), is_number(true) {}  // NOLINT(google-explicit-constructor)
  std::string text;
  double number = 0;
  bool is_number = false;
};

// What becomes of a stiff or extreme case.
enum class Expected {
  accurate,  // the error stays within `allowed`
  degraded,  // the answer loses accuracy, in a known way: the loss is measured and stays within
             // `allowed`
  refused,   // InputError, or a result that says it did not converge
};
inline constexpr Expected accurate = Expected::accurate, degraded = Expected::degraded,
                          refused = Expected::refused;

struct StabilityCase {
  std::string id;
  std::string what;    // the case: "b/a = 1e-6"
  std::string stress;  // what is strained: "near line contact"
  Expected expect = accurate;
  double allowed = units::nan;  // bound of the error, set beforehand; none for refused
  std::string reference = {};   // what the error is against
};

struct Found {
  std::string text;           // what came out, for the reader
  double error = units::nan;  // compared with `allowed`
};

// Thrown by a case whose solver said that it did not converge: found is then "refused".
class NoAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RunSettings {
  RunFolder* folder = nullptr;        // notified of each file before it is written
  std::filesystem::path sources;      // the chapter's folder: data/, scripts
  std::filesystem::path results;      // results/<chapter>
  std::filesystem::path figures;      // figures/<chapter>
  bool full = false;                  // --level full
  bool draw = true;                   // not --no-figures
  bool timings = true;                // not --no-timings
  std::vector<TrialRow> trials = {};  // the chapter's data/trials.csv
  std::vector<ClaimRow> claims = {};  // and its data/claims.csv
};

class Item {
 public:
  Item(std::string id, std::string kind, std::string title, const RunSettings& settings);

  const std::string& id() const { return record_.id; }
  bool full() const { return settings_.full; }
  bool timings() const { return settings_.timings; }
  const std::filesystem::path& sources() const { return settings_.sources; }

  // Checks. The number of checks must be announced, so that a loop over nothing is a failure;
  // stability cases are not counted, and claims.csv announces its own rows. An id is written out
  // where the check is made, so that it can be searched for.
  void expect_checks(int count) { expected_checks_ = count; }
  // A table of printed values from the chapter's data folder; it must outlive the rows taken from
  // it.
  table::CsvTable printed(std::string_view file) const;
  Row row(const table::CsvTable& table, std::string key) { return {*this, table, std::move(key)}; }
  // source print: `printed` is the paper's text; `computed` in the same unit.
  void print(std::string_view id, std::string_view what, std::string_view unit,
             std::string_view printed, double computed,
             const Expectation& expectation = last_digit());
  // source print: a word of the paper, a class or a name.
  void print_text(std::string_view id, std::string_view what, std::string_view printed,
                  std::string_view computed);
  // The statements that data/claims.csv has of this item, in words, from the numbers found.
  void claims(const std::vector<FoundClaim>& found);
  // One of them that holds on a condition which is no interval of a number; the row has none then.
  void claim_if(std::string_view id, bool it_holds, std::vector<double> numbers = {});
  // source claim: a statement of the paper in words; `measured` says what was found.
  void claim(std::string_view id, std::string_view what, bool it_holds, std::string measured = "");
  // The same, and it must hold in each variation: the claim's own condition is its trial.
  void claim(std::string_view id, std::string_view what, const Trial& trial, std::string measured);
  // source claim, consistent: compatible with the paper under assumptions of ours; `why` names
  // them.
  void consistent(std::string_view id, std::string_view what, bool it_holds, std::string measured,
                  std::string why);
  // The same, and it must hold in each variation.
  void consistent(std::string_view id, std::string_view what, const Trial& trial,
                  std::string measured, std::string why);
  // source claim, not confirmed: `instead` is what holds, in each variation of the trial.
  void refute(std::string_view id, std::string_view what, const Trial& trial, std::string instead);
  // source route: a statement on our own program or model, none of the paper's.
  void verify(std::string_view id, std::string_view what, bool it_holds, std::string measured,
              const std::string& method);
  // The trial of the check with this id: what is varied comes from data/trials.csv.
  Trial trial(std::string_view id, std::string quantity, std::string format,
              Trial::Expected stands) const;
  // source publication: `reference` is the text of another work.
  void publication(std::string_view id, std::string_view what, std::string_view unit,
                   std::string_view reference, double computed, const Tolerance& tolerance,
                   const std::string& work);
  // source route: the value against the `reference` of an independent `method`, relative to the
  // reference.
  void agree(std::string_view id, std::string_view what, std::string_view unit, double computed,
             double reference, double allowed, const std::string& method);
  // source route: a bound of our own, with its reason.
  void at_most(std::string_view id, std::string_view what, std::string_view unit, double computed,
               double bound, const std::string& why);
  void at_least(std::string_view id, std::string_view what, std::string_view unit, double computed,
                double bound, const std::string& why);

  // Numbers and texts for the prose: {{id}}. `format` is an fmt format of one double; the unit
  // follows it.
  void value(std::string_view id, double number, std::string_view unit = "",
             std::string_view format = "{:.6g}");
  void value(std::string_view id, std::string_view text);

  // A display table: headings once, then a cell for each.
  void columns(std::vector<Heading> headings);
  template <class... Cells>
  void add_row(const Cells&... cells) {
    add_cells({Cell(cells)...});
  }
  void add_row(const std::vector<std::string>& cells);

  // Data of a figure: the first is ARG1 (<id>.csv), each named one a further ARG (<id>-<name>.csv,
  // from ARG3 on).
  Data& data(const std::vector<std::string>& columns) { return data("", columns); }
  Data& data(std::string_view name, const std::vector<std::string>& columns);
  // Another gnuplot script than <id>.gp; relative to the chapter's folder.
  void script(std::filesystem::path file) { script_ = std::move(file); }
  // Draws without gnuplot: `write` makes the PNG under the name it is given, or throws
  // std::system_error with std::errc::function_not_supported: then the item has no picture and says
  // why, and is judged by its checks.
  void image(std::function<void(const std::filesystem::path&)> write) { image_ = std::move(write); }

  // What the item is computed from, where it is not the paper's data.
  void rebuilt(std::string why) { from("rebuilt", std::move(why)); }  // ours, documented
  void added(std::string why) { from("added", std::move(why)); }      // not in the paper
  void sketch(std::string why = "drawing, nothing computed") { from("sketch", std::move(why)); }
  void lost(std::string why) { from("lost", std::move(why)); }  // the paper's is not to be had

  void add(std::vector<WorkPrecision> points);
  // Runs a stiff or extreme case and judges it. InputError and NoAnswer are "refused", other
  // exceptions "fails".
  void stability(const StabilityCase& c, const std::function<Found()>& run);

  // For the chapter: writes the CSV files, draws, judges, and hands everything over to the record.
  void finish(ChapterRecord& record);
  // For the chapter: an exception ended the item.
  void fail(std::string why, ChapterRecord& record);

 private:
  friend class Row;
  struct About {
    std::string_view id, what, unit;
  };
  CheckRecord& add_check(const About& about, Source source, Outcome outcome);
  void compare_with(const About& about, std::string_view reference, double computed, Source source,
                    const Expectation& expectation, const std::string& by);
  CheckRecord& judge_claim(std::string_view id, std::string_view what, bool pass, Outcome outcome,
                           std::string measured);
  void judge_row(const FoundClaim& found, std::optional<bool> condition = {});
  void add_cells(std::initializer_list<Cell> cells);
  void from(std::string input, std::string why);
  void draw();
  std::string failure() const;

  RunSettings settings_;
  ItemRecord record_;
  std::vector<std::string> formats_;
  std::vector<CheckRecord> checks_;
  std::vector<ValueRecord> values_;
  std::vector<WorkPrecision> work_precision_;
  std::vector<Stability> stability_;
  std::vector<std::unique_ptr<Data>> data_;
  std::filesystem::path script_;
  std::function<void(const std::filesystem::path&)> image_;
  int expected_checks_ = 0, checked_claims_ = 0;
};

}  // namespace railbook::report
