// Tables of cells with a separator: a strict reader with line numbers in its errors, and a writer.
//
// Dialect: UTF-8, or what the options say; cells are parted by commas, semicolons, tabs or strokes,
// whichever the header and the line after it agree on, or by blanks where there are none of them
// and the rows are numbers; the first line names the columns, unless all its cells are numbers:
// then the columns are called 1, 2 and so on. Cells in double quotes may hold separators, doubled
// quotes and line breaks, up to 100 of them and 1 MiB in a row; lines that start with # and lines
// of blanks and tabs alone are skipped, CR LF accepted. Blanks around a bare cell do not count.
// Where the separator is no comma, numbers may have a decimal comma (all of a file, or none). What
// LineSource unpacks is read as well.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <railbook/table/byte_source.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::table {

// The name and the unit in a column's header, as people write them: "distance_m", "Distance (m)",
// "Distance [km]", "Profile, mm", and units as "metres" or "inch". Without a unit, `unit_text` is
// empty and the unit the pure number.
units::Header parse_column(std::string_view header);

// What a file of text does not say of itself.
struct TextOptions {
  std::size_t skip = 0;          // lines before the headers
  std::size_t header_lines = 1;  // a column's header is what its cells in them hold, with blanks
  std::string encoding = {};     // that iconv knows; none: UTF-8, or UTF-16 with a byte order mark
  std::string sheet = {};        // of a workbook, by name or number; none: the first
  std::string dataset = {};      // of an HDF5 or MAT file; none: the only table in it
  char decimal = 0;              // the point or the comma of numbers; 0: as the file has them
};

// A column whose cells may be a whole number and a second one behind a plus, as 12+345.6.
struct TwoParts {
  std::size_t column = 0;
  double first = 0, second = 0;  // what they are multiplied by before they add up
  double alone = 0;              // the same of a number without a plus; 0: not allowed
};

// Reads a file, or a pipe, line by line in constant memory. Errors are InputError naming the file
// and the line; what the reading itself throws is LineSource's.
class CsvReader {
 public:
  // Opens the file, skips some lines, and reads its header. Throws when it is missing or empty.
  explicit CsvReader(const std::filesystem::path& file, const TextOptions& options = {});
  // The same of other bytes; `file` is their name in errors.
  CsvReader(const std::filesystem::path& file, std::unique_ptr<ByteSource> bytes,
            const TextOptions& options = {});

  const std::vector<std::string>& header() const { return header_; }

  // The index of a column, by its whole header or by its name without the unit ("distance" finds
  // "distance_m" and "Distance [km]"; case, blanks, dashes and underscores do not count where no
  // header fits exactly), or by its number, 3 or #3. Throws InputError listing the columns there
  // are, or when more than one fits; find() gives nothing instead of the first.
  std::size_t column(std::string_view name) const;
  std::optional<std::size_t> find(std::string_view name) const;
  std::string columns_there() const;  // "there are: a, b", for errors

  // The next row; false at the end. A row with another number of cells throws. Views hold until the
  // next call.
  bool next();
  std::string_view cell(std::size_t column) const { return cells_[column]; }

  // The numbers in some columns (ascending) of the rows that follow, without cells: of as many rows
  // as `values` has room for and are in memory, up to one that is not all plain (an empty cell, an
  // escaped quote, a decimal comma before the first one was seen); next() and number() then read
  // that row, or say what is wrong. Row r of the i-th column goes to values[i * rows + r], where
  // rows = values.size() / columns.size(). Returns how many rows were read.
  std::size_t numbers(std::span<const std::size_t> columns, std::span<double> values,
                      const TwoParts* parts = nullptr);

  // A cell as a number, rounded to the nearest double, of two to the even one. Empty, and "NaN" (as
  // C libraries write it, too), "NA", "N/A", "null" and dashes, are NaN; anything else throws, so
  // does a number that rounds to infinity, or to 0 without being it.
  double number(std::size_t column) const;
  [[noreturn]] void refuse_number(std::size_t column) const;

  std::size_t line() const { return line_; }  // where the last row began
  const std::filesystem::path& file() const { return source_.file(); }
  double share() const { return source_.share(); }  // LineSource's

 private:
  bool raw_line(std::string_view& text);
  bool record();
  bool split(std::string_view text);
  bool split_quoted(std::string text);
  void read_header(std::size_t lines, std::size_t columns);
  void join_headers(std::size_t lines, std::size_t columns);
  struct Name {
    std::string name, folded_name, folded_header;
  };
  const std::vector<Name>& names() const;
  double with_comma(std::size_t column) const;
  [[noreturn]] void refuse(const std::string& why) const;
  void require_column(std::size_t before) const;

  LineSource source_;
  std::size_t line_ = 0;
  char separator_ = ',';
  std::vector<std::string> header_;
  std::vector<std::string> ahead_;  // lines read to know the dialect; the next one last
  std::size_t first_ahead_ = 0;     // number of the next of them
  std::string kept_;                // one of them, in use
  std::vector<std::string_view> cells_;
  std::vector<std::string> quoted_;  // cells that are not as in the file
  mutable char decimal_ = 0;         // point or comma, once seen
  mutable std::vector<Name> names_;  // of the columns without units, once asked for
};

// A small table held as text: the paper's printed values.
struct CsvTable {
  std::filesystem::path file;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  // The cell in `column` of the row whose first cell is `key`; throws std::logic_error when there
  // is none.
  const std::string& at(std::string_view key, std::string_view column) const;
  const std::string& at(std::size_t row, std::string_view column) const;
};
CsvTable read_table(const std::filesystem::path& file);

// Numeric columns of a user's file as SI values, in the order of `names`. Each header must name a
// unit of the dimension wanted ("distance_m", "profile_mm"). NaN cells throw unless `allow_nan`.
// Result: [column][row], to 1e-15 of each value.
struct ColumnWanted {
  std::string name;
  units::Dimension dimension;
};
std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<ColumnWanted>& wanted,
                                              bool allow_nan = false);

// A number as CSV text: shortest form that keeps so many digits; NaN as "nan".
std::string csv_number(double value, int digits = 12);
// The same at the end of a text.
void append_number(std::string& text, double value, int digits);

// A cell, quoted where the dialect needs it: it reads back as the same text (but for zero bytes,
// and for an empty row of one column, which is a blank line).
std::string csv_cell(std::string_view text);

}  // namespace railbook::table
