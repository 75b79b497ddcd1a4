#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <railbook/records/record_file.hpp>
#include <railbook/table/csv.hpp>

namespace railbook::records {

// Cells as numbers, or as lost where they hold what stands for that.
class Cells {
 public:
  Cells(const RecordFile& source, const table::CsvReader& reader);

  // The number in the row last read; of a height also lost where it is one of those missing.
  double number(std::size_t column) const;
  double height(std::size_t column) const { return unless_missing(number(column)); }

  double unless_missing(double value) const {
    return numbers_.empty() || std::find(numbers_.begin(), numbers_.end(), value) == numbers_.end()
               ? value
               : lost;
  }

 private:
  const table::CsvReader& reader_;
  std::vector<double> numbers_;
  std::vector<std::string> texts_;
};

// Which rows of a table of several records are read.
class Where {
 public:
  Where(const std::vector<std::string>& wanted, const table::CsvReader& reader);

  bool all() const { return columns_.empty(); }
  bool fits();                 // the row last read
  void require_found() const;  // throws InputError where no row did

 private:
  const table::CsvReader& reader_;
  std::vector<std::size_t> columns_;
  std::vector<std::string> values_, seen_;
  bool found_ = false;
};

}  // namespace railbook::records
