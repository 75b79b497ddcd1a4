// Comma-separated tables: a strict reader with line numbers in its errors, and a writer.
//
// Dialect: UTF-8, the first line names the columns, cells in double quotes may hold commas, doubled quotes and up to 100
// line breaks; lines that start with # and blank lines are skipped, CR LF accepted. Blanks around a bare cell do not count.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "table/line_source.hpp"
#include "units/quantity.hpp"

namespace railbook::table {

// Reads a file, or a pipe, line by line in constant memory. Errors are InputError naming the file and the line; what the
// reading itself throws is LineSource's.
class CsvReader {
 public:
  // Opens the file and reads its header. Throws when it is missing, empty, or names a column twice.
  explicit CsvReader(const std::filesystem::path& file);

  const std::vector<std::string>& header() const { return header_; }

  // The index of a column, by its whole header or by its name without the unit ("distance" finds "distance_m").
  // Throws InputError listing the columns there are.
  std::size_t column(std::string_view name) const;

  // The next row into `cells` (one a column); false at the end. A row with another number of cells throws.
  bool next(std::vector<std::string>& cells);

  // A cell as a number. Empty, "NaN" and "nan" are NaN; anything else that is no number throws.
  double number(const std::vector<std::string>& cells, std::size_t column) const;

  std::size_t line() const { return line_; }  // where the last row began
  const std::filesystem::path& file() const { return source_.file(); }

 private:
  bool raw_line(std::string& text);
  bool record(std::vector<std::string>& cells);
  [[noreturn]] void refuse(const std::string& why) const;

  LineSource source_;
  std::size_t line_ = 0;
  std::vector<std::string> header_;
  std::string text_;
};

// A small table held as text: the paper's printed values.
struct CsvTable {
  std::filesystem::path file;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  // The cell in `column` of the row whose first cell is `key`; throws std::logic_error when there is none.
  const std::string& at(std::string_view key, std::string_view column) const;
  const std::string& at(std::size_t row, std::string_view column) const;
};
CsvTable read_table(const std::filesystem::path& file);

// Numeric columns of a user's file as SI values, in the order of `names`. Each header must name a unit of the
// dimension wanted ("distance_m", "profile_mm"). NaN cells throw unless `allow_nan`. Result: [column][row].
struct ColumnWanted {
  std::string name;
  units::Dimension dimension;
};
std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<ColumnWanted>& wanted,
                                              bool allow_nan = false);

// A number as CSV text: shortest form that keeps 12 digits; NaN as "nan".
std::string csv_number(double value);

// A cell, quoted where the dialect needs it: it reads back as the same text (but for zero bytes, and for an empty row of one
// column, which is a blank line).
std::string csv_cell(std::string_view text);

}  // namespace railbook::table
