// A record of the car's sensors from a CSV file.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <railbook/geometry_car/stretches.hpp>
#include <railbook/table/csv.hpp>

namespace railbook::filters_tool {

// What no sensor of this car can say, SI. A spike is a displacement that differs by more than this,
// and in the same sense, from the one before it and the one behind it.
struct Plausible {
  double acceleration = 20, rate = 1, displacement = 1, spike = 0.05;
};

// What the record lacks or does wrong, besides what Measurement says.
struct Faults {
  std::vector<std::string> absent, unused;
  std::size_t beyond = 0, spikes = 0;  // values masked
  std::vector<std::string> beyond_in;  // columns where more than one value in a hundred was
};

// Reads the file row by row in constant memory; `sample` (m) is the distance between rows. Throws
// InputError naming the column or the line that cannot be used.
class SensorFile {
 public:
  SensorFile(const std::filesystem::path& file, double sample, const Plausible& plausible);
  bool next(geometry_car::Row& row);

  const Faults& faults() const { return faults_; }       // beyond_in: at the end of the file
  double first() const { return first_ ? *first_ : 0; }  // m, of mark 0
  double share() const { return reader_.share(); }

 private:
  static constexpr std::size_t most_rows = 256;  // read at once
  bool read(geometry_car::Row& row);
  bool next_row();
  double number(std::size_t column) const {  // of the row last read
    return block_ == 0 ? reader_.number(column) : numbers_[place_[column] * most_rows + in_block_];
  }
  std::size_t line() const { return reader_.line() - (block_ > 0 ? block_ - 1 - in_block_ : 0); }

  table::CsvReader reader_;
  std::vector<std::size_t> columns_;      // that are read, ascending
  std::vector<std::size_t> place_;        // of each column of the file among them
  std::vector<double> numbers_;           // in them of some rows, column by column
  std::size_t block_ = 0, in_block_ = 0;  // rows there; the one last read
  double sample_;
  Faults faults_;
  std::optional<std::size_t> elapsed_, distance_;
  double second_ = 1, metre_ = 1;
  std::array<std::optional<std::size_t>, geometry_car::channels> column_;
  std::array<double, geometry_car::channels> unit_{}, range_{}, spike_{};
  std::array<double, geometry_car::channels> before_{};  // as masked
  std::array<std::size_t, geometry_car::channels> beyond_{};
  std::optional<double> first_;
  std::optional<geometry_car::Row> ahead_;  // read to know whether the row before it is a spike
  std::size_t rows_ = 0;
  long mark_ = 0;
};

}  // namespace railbook::filters_tool
