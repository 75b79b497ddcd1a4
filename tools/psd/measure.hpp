// From a record in a file to a spectrum and its fit.
#pragma once

#include <memory>
#include <optional>

#include "record_options.hpp"
#include "spectra/record_file.hpp"
#include "spectra/spectrum_fit.hpp"
#include "spectra/welch.hpp"

namespace railbook::psd_tool {

struct Measured {
  std::unique_ptr<const spectra::RecordStream> record;
  spectra::Spectrum spectrum;
  std::size_t segment = 0;  // samples
  bool shortened = false;   // than the one that a record without gaps would have
};

// The spectrum by segments of so many samples; without, of about 1250 m, or of a half, a quarter or an eighth of that where gaps leave too
// little of the record in longer ones. Throws InputError when there is not one segment without a gap.
Measured measure(const spectra::RecordFile& file, std::optional<std::size_t> segment,
                 spectra::Window window);

}  // namespace railbook::psd_tool
