#include "psd/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "units/input_error.hpp"

namespace railbook::psd_tool {
namespace {

constexpr double usual_length = 1250;       // m: 4096 ft
constexpr std::size_t fewest_segments = 4;  // for a scatter that means something
constexpr double enough = 0.6;              // of the record in segments

std::vector<std::size_t> segments_for(double spacing) {
  const double base = std::clamp(std::exp2(std::round(std::log2(usual_length / spacing))), 512.0,
                                 static_cast<double>(1 << 18));
  std::vector<std::size_t> sizes;
  for (int i = 0; i < 4; ++i) sizes.push_back(static_cast<std::size_t>(base) >> i);
  return sizes;
}

// The longest that leaves enough of the record, else the one that leaves the most.
std::size_t best(const std::vector<spectra::Welch>& all, std::size_t present) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t used = all[i].used_samples();
    if (all[i].segments() >= fewest_segments &&
        static_cast<double>(used) >= enough * static_cast<double>(present))
      return i;
    if (used > all[most].used_samples()) most = i;
  }
  return most;
}

}  // namespace

Measured measure(const spectra::RecordFile& file, std::optional<std::size_t> segment,
                 spectra::Window window) {
  // At unit spacing while the record streams by; its true spacing is known at the end.
  std::vector<spectra::Welch> all;
  const auto record = [&](std::span<const double> piece, double spacing) {
    if (all.empty())
      for (const std::size_t size : segment ? std::vector{*segment} : segments_for(spacing))
        all.emplace_back(1.0, spectra::WelchOptions{.segment = size, .window = window});
    for (spectra::Welch& welch : all) welch.push(piece);
  };
  Measured result{spectra::read_record(file, record), {}, 0, false};
  const std::size_t present = result.record->samples() - result.record->missing();
  const std::size_t chosen = best(all, present);
  result.segment = segment ? *segment : segments_for(result.record->spacing())[chosen];
  if (all[chosen].segments() == 0)
    throw InputError{fmt::format(
        "the record has {} samples, {} of them missing; allowed: {} in a row without a gap "
        "(--segment for shorter ones, --bridge for gaps)",
        result.record->samples(), result.record->missing(), result.segment)};
  result.spectrum = spectra::respaced(all[chosen].spectrum(), result.record->spacing());
  result.shortened = chosen > 0;
  return result;
}

}  // namespace railbook::psd_tool
