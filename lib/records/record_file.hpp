// A record in a file: which of its columns, in which units.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/units/quantity.hpp>

namespace railbook::records {

struct RecordFile {
  std::filesystem::path file = {};                // - is standard input
  std::string column = "profile";                 // by name, with or without its unit, or by number
  std::string unit = {};                          // if the header of the column names none
  std::vector<units::Dimension> dimensions = {};  // of the columns read; left out: lengths
  std::string distance =
      "distance";  // column of positions, or two that add up, "km+m"; read where they are
  std::string distance_unit = {};          // if its header names none; "km+m" for two
  std::optional<double> spacing = {};      // m; needed where there is none
  std::optional<std::size_t> bridge = {};  // samples; without it, gaps of up to 1 m are bridged
  std::vector<std::string> missing =
      {};                // cells that stand for lost samples, "-9999", besides those of CsvReader
  std::size_t skip = 0;  // lines before the header
  std::size_t header_lines = 1;
  std::string encoding = {};  // as TextOptions has them
  std::string sheet = {}, dataset = {};
  char decimal = 0;
  std::optional<double> resample = {};  // m: uneven samples are put on such a grid
  std::vector<std::string> where =
      {};  // "rail=left": rows of which a column holds this, of a table of several records
  Screening screening{.outliers = false, .stuck = false, .steps = false};
  Resync resync = Resync::refuse;
  std::function<void(double share)> progress =
      {};  // called now and then with the fraction read, 0 to 1, where that is known
};

// Takes the record in pieces, with what is known of it so far: the spacing is known to the rounding
// of the first thousand positions, the places are those up to the piece.
using RecordSink = std::function<void(std::span<const double> piece, const RecordStream& record)>;

// Reads the file once through a RecordStream into `sink` and returns the stream, finished. Where
// there is no column `distance`, one called position, chainage, mileage or kilometre is taken. A
// position may be written 12+345.6: kilometres and metres where the unit is m, km or km+m, stations
// of 100 ft where it is ft, miles and feet or yards where it is mi+ft or mi+yd; or 12K345.6M. Where
// the unit is mi.yd, 12.0440 is 12 miles and 440 yards. A first row of units is read as that. Rows
// of empty cells are lost samples where rows follow, else nothing. A length with a number before
// it, "profile_62_ft", is a chord or a wave and no unit. Throws InputError naming file, line and
// column on what cannot be read, a column without a unit or with one that is no length, units that
// contradict each other, no positions and no spacing, and as RecordStream does.
std::unique_ptr<const RecordStream> read_record(const RecordFile& source, const RecordSink& sink);

// Several columns of one file in one pass: a stream and a sink each. `input.column` does not count.
std::vector<std::unique_ptr<const RecordStream>> read_records(
    const RecordFile& source, const std::vector<std::string>& columns,
    const std::vector<RecordSink>& sinks);

}  // namespace railbook::records
