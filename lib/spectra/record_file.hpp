// A record in a CSV file: which of its columns, in which units.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "spectra/record.hpp"

namespace railbook::spectra {

struct RecordFile {
  std::filesystem::path file;
  std::string column = "profile";          // with or without its unit
  std::string unit = {};                   // if the header of the column names none
  std::string distance = "distance";       // column of positions; read where there is one
  std::optional<double> spacing = {};      // m; needed where there is none
  std::optional<std::size_t> bridge = {};  // samples; without it, gaps of up to 1 m are bridged
};

// Takes the record in pieces; their spacing (m) is known to the rounding of the first thousand positions.
using RecordSink = std::function<void(std::span<const double> piece, double spacing)>;

// Reads the file once through a RecordStream into `sink` and returns the stream, finished. Throws InputError naming
// file, line and column on what cannot be read, a column without a unit or with one that is no length, units that
// contradict each other, no positions and no spacing, and as RecordStream does.
std::unique_ptr<const RecordStream> read_record(const RecordFile& wish, const RecordSink& sink);

}  // namespace railbook::spectra
