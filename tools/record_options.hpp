// The options of a record of track, shared by the tools that read one.
#pragma once

#include <optional>

#include "spectra/record_file.hpp"
#include "tool/options.hpp"
#include "tool/summary.hpp"

namespace railbook::tools {

// The option --bridge is kept apart until record_file(): a file has a number of samples or none.
struct RecordWish {
  spectra::RecordFile record;
  std::optional<double> bridge;
};

void add_record_options(tool::Options& options, RecordWish& wish);

// What was asked for. Throws InputError when the gap to bridge is no whole number.
spectra::RecordFile record_file(const RecordWish& wish);

// Length, spacing and samples of the record as lines of the answer, and its doubts as flags.
void add_record(tool::Summary& answer, const spectra::RecordStream& record);

}  // namespace railbook::tools
