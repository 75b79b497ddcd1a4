#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <railbook/records/detail/cells.hpp>
#include <railbook/records/record_file.hpp>
#include <railbook/table/csv.hpp>

namespace railbook::records {

// The columns of positions: one, or two that add up; what the two parts of 12+345.6 are in one
// column.
struct Positions {
  std::vector<std::size_t> columns;
  std::vector<double> metre;
  double major = 0, minor = 0;  // m; 0: not known
  bool in_two = false;          // all cells must be written so
  bool yards = false;           // 12.0440: miles, and yards behind the point

  // Metres of a plain number of column i; NaN where it is no such position.
  double metres(std::size_t i, double number) const;
  // One column that may hold 12+345.6, for a reader of many rows.
  std::optional<table::TwoParts> two_parts() const;
};

// Where the positions of a file stand; `below` is the row of units under its headers. Nothing where
// there are none, and a spacing.
std::optional<Positions> positions_of(const RecordFile& source, const table::CsvReader& reader,
                                      const std::vector<std::string>& below);

// The position (m) in the row last read; NaN where it is missing.
double read_position(const Positions& positions, const table::CsvReader& reader,
                     const Cells& cells);

}  // namespace railbook::records
