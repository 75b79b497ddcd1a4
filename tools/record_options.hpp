// The options of a record of track, shared by the tools that read one.
#pragma once

#include <optional>

#include "spectra/record_file.hpp"
#include "tool/batch.hpp"
#include "tool/options.hpp"
#include "tool/summary.hpp"

namespace railbook::tools {

// The option --bridge is kept apart until record_file(): a file has a number of samples or none.
struct RecordWish {
  tool::BatchWish batch;
  spectra::RecordFile record;
  std::vector<std::string> columns{"profile"};
  std::optional<double> bridge, section;  // samples, m
  long skip = 0;
};

void add_record_options(tool::Options& options, RecordWish& wish);

// What was asked for of one file; what is read of it is told as progress. Throws InputError when the gap to bridge is no
// whole number.
spectra::RecordFile record_file(const RecordWish& wish, const std::filesystem::path& file);

// What --help says of the files.
extern const char* const record_help;

// Length, spacing and samples of the record as lines of the answer, and its doubts as flags.
void add_record(tool::Summary& answer, const spectra::RecordStream& record);
void add_record(tool::Row& row, const spectra::RecordStream& record);

}  // namespace railbook::tools
