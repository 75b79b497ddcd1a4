// From a record in a file to a spectrum and its fit.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/records/record_file.hpp>
#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/welch.hpp>

#include "record_options.hpp"

namespace railbook::psd_tool {

// A stretch of a record with a spectrum of its own, at the spacing known so far. `spectrum` is missing where gaps leave no
// segment.
struct Section {
  std::size_t first = 0, count = 0, missing = 0;  // samples
  std::optional<spectra::Spectrum> spectrum;
};
using SectionSink = std::function<void(std::size_t column, const Section& section)>;

struct Measured {
  std::unique_ptr<const records::RecordStream> record;
  spectra::Spectrum spectrum;
  std::size_t segment = 0;  // samples
  bool shortened = false;   // than the one that a record without gaps would have
};

// The spectra of columns of a file by segments of so many samples; without, of about 1250 m, or of a half, a quarter or an eighth of that where gaps leave too
// little of the record in longer ones. Throws InputError when there is not one segment without a gap.
// With a length (m) of sections, each is handed to `sink` as it ends, its segments about a third of it.
struct MeasureOptions {
  std::vector<std::string> columns;
  std::optional<std::size_t> segment;
  spectra::Window window = spectra::Window::hann;
  std::optional<double> section = {};  // m
};
std::vector<Measured> measure(const records::RecordFile& file, const MeasureOptions& options,
                              const SectionSink& sink = {});

}  // namespace railbook::psd_tool
