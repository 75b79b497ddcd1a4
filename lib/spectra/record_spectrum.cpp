#include <railbook/spectra/record_spectrum.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include <railbook/units/input_error.hpp>

namespace railbook::spectra {
namespace {

constexpr double usual_length = 1250;       // m: 4096 ft
constexpr std::size_t fewest_segments = 4;  // for a scatter that means something
constexpr double enough = 0.95;             // of the record in segments, its end aside
constexpr std::size_t without_gap = 32;     // segments: then shorter ones are hardly needed

std::vector<std::size_t> segments_for(double spacing) {
  const double base = std::clamp(std::exp2(std::round(std::log2(usual_length / spacing))), 512.0,
                                 static_cast<double>(1 << 18));
  const auto longest = static_cast<std::size_t>(base);
  return {longest, longest / 2, longest / 4, longest / 8};
}

bool leaves_enough(const Welch& welch, std::size_t present) {
  return welch.segments() >= fewest_segments &&
         static_cast<double>(welch.used_samples()) >=
             enough * static_cast<double>(present - welch.ahead());
}

std::size_t present(const records::RecordStream& record) {
  return record.samples() - record.missing();
}

// The longest that leaves enough of the record, else the one that leaves the most.
std::size_t best(const std::vector<Welch>& all, std::size_t present) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (leaves_enough(all[i], present)) return i;
    if (all[i].used_samples() > all[most].used_samples()) most = i;
  }
  return most;
}

// Cuts a column into sections as it streams by.
class SectionCutter {
 public:
  SectionCutter(const RecordSpectrumOptions& options, std::size_t column,
                const SpectrumSectionSink& sink)
      : wanted_(options), column_(column), sink_(sink) {}

  void push(std::span<const double> piece, double spacing) {
    if (!wanted_.section) return;
    if (!welch_) begin(spacing);
    while (!piece.empty()) {
      const auto part = piece.first(std::min(piece.size(), length_ - section_.count));
      welch_->push(part);
      section_.count += part.size();
      piece = piece.subspan(part.size());
      if (section_.count == length_) end();
    }
  }

  // What is left is a section when it is half as long as one.
  void finish() {
    if (welch_ && 2 * section_.count >= length_) end();
  }

 private:
  void begin(double spacing) {
    length_ = static_cast<std::size_t>(std::lround(*wanted_.section / spacing));
    if (length_ < 3 * fewest_samples)
      throw InputError{fmt::format("section is {:.6g} m, {} samples; allowed: from {:.6g} m",
                                   *wanted_.section, length_, 3 * fewest_samples * spacing)};
    const double segment = std::exp2(std::floor(std::log2(static_cast<double>(length_) / 3)));
    options_ = {
        .segment = std::min<std::size_t>(std::size_t(1) << 18, static_cast<std::size_t>(segment)),
        .window = wanted_.window};
    spacing_ = spacing;
    welch_.emplace(spacing_, options_);
  }

  void end() {
    section_.missing = welch_->gap_samples();
    if (welch_->segments() > 0) section_.spectrum = welch_->spectrum();
    sink_(column_, section_);
    section_ = {section_.first + section_.count, 0, 0, {}};
    welch_.emplace(spacing_, options_);
  }

  static constexpr std::size_t fewest_samples = 64;  // of a segment
  const RecordSpectrumOptions& wanted_;
  std::size_t column_;
  const SpectrumSectionSink& sink_;
  std::size_t length_ = 0;
  double spacing_ = 0;
  WelchOptions options_;
  std::optional<Welch> welch_;
  SpectrumSection section_;
};

}  // namespace

std::vector<RecordSpectrum> record_spectra(const records::RecordFile& file,
                                           const RecordSpectrumOptions& options,
                                           const SpectrumSectionSink& sink) {
  // At unit spacing while the record streams by; its true spacing is known at the end. Where the
  // file can be read again, shorter segments are given up after a long way without a gap.
  std::vector<std::vector<Welch>> all(options.columns.size());
  std::vector<SectionCutter> sections;
  for (std::size_t i = 0; i < options.columns.size(); ++i) sections.emplace_back(options, i, sink);
  const auto read = [&](bool give_up, bool again) {
    std::vector<records::RecordSink> sinks;
    for (std::size_t i = 0; i < options.columns.size(); ++i)
      sinks.push_back([&, i, give_up, again](std::span<const double> piece,
                                             const records::RecordStream& record) {
        const double spacing = record.spacing();
        if (all[i].empty())
          for (const std::size_t size :
               options.segment ? std::vector{*options.segment} : segments_for(spacing))
            all[i].emplace_back(1.0, WelchOptions{.segment = size, .window = options.window});
        for (Welch& welch : all[i]) welch.push(piece);
        const Welch& longest = all[i].front();
        if (give_up && longest.gap_samples() == 0 && longest.segments() >= without_gap)
          while (all[i].size() > 1) all[i].pop_back();
        if (!again) sections[i].push(piece, spacing);
      });
    return records::read_records(file, options.columns, sinks);
  };
  const bool twice = file.file != "-" && std::filesystem::is_regular_file(file.file);
  auto records = read(twice, false);
  bool missed = false;
  for (std::size_t i = 0; i < records.size() && !options.segment; ++i)
    missed = missed || (all[i].size() == 1 && !leaves_enough(all[i][0], present(*records[i])));
  if (missed) {
    for (std::vector<Welch>& lengths : all) lengths.clear();
    records = read(false, true);
  }
  std::vector<RecordSpectrum> results;
  results.reserve(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    sections[i].finish();
    RecordSpectrum& result = results.emplace_back();
    result.record = std::move(records[i]);
    const std::size_t chosen = best(all[i], present(*result.record));
    result.segment =
        options.segment ? *options.segment : segments_for(result.record->spacing())[chosen];
    if (all[i][chosen].segments() == 0)
      throw InputError{fmt::format(
          "the record has {} samples, {} of them missing; allowed: {} in a row without a gap "
          "(--segment for shorter ones, --bridge for gaps)",
          result.record->samples(), result.record->missing(), result.segment)};
    result.spectrum = respaced(all[i][chosen].spectrum(), result.record->spacing());
    result.shortened = chosen > 0;
  }
  return results;
}

}  // namespace railbook::spectra
