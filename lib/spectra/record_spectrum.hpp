// The spectra of a record in a file: how long their segments are, and at which spacing.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/records/record_file.hpp>
#include <railbook/spectra/welch.hpp>

namespace railbook::spectra {

// A section of a record with a spectrum of its own, at the spacing known so far; none where gaps
// leave no segment.
struct SpectrumSection {
  std::size_t first = 0, count = 0, missing = 0;  // samples
  std::optional<Spectrum> spectrum;
};
using SpectrumSectionSink = std::function<void(std::size_t column, const SpectrumSection& section)>;

struct RecordSpectrum {
  std::unique_ptr<const records::RecordStream> record;
  Spectrum spectrum;
  std::size_t segment = 0;  // samples
  bool shortened = false;   // than the one that a record without gaps would have
};

// The spectra of columns of a file by segments of so many samples; without a number, of about
// 1250 m, or of a half, a quarter or an eighth of that where gaps leave too little of the record in
// longer ones. Throws InputError when there is not one segment without a gap.
//
// With a length of sections (m), each section is handed to the sink as it ends; its segments are
// about a third of it. What is left at the end of the record is a section when it is half as long
// as one.
struct RecordSpectrumOptions {
  std::vector<std::string> columns;
  std::optional<std::size_t> segment = {};
  Window window = Window::hann;
  std::optional<double> section = {};  // m
};
std::vector<RecordSpectrum> record_spectra(const records::RecordFile& file,
                                           const RecordSpectrumOptions& options,
                                           const SpectrumSectionSink& sink = {});

}  // namespace railbook::spectra
