// What a record stream has to say of the record.
#include <algorithm>
#include <cmath>
#include <string>

#include "spectra/number_text.hpp"
#include "spectra/record.hpp"
#include "units/constants.hpp"

namespace railbook::spectra {
namespace {

constexpr double spacing_doubted = 0.003, bridged_doubted = 0.05;
constexpr double smoothest = 1e-10, roughest = 1e-4;  // m^2 cycle/m: no track is beyond
constexpr std::size_t fewest_moves = 100;

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// All stretches of one kind: how many samples, and the longest of them.
struct Found {
  std::size_t samples = 0, stretches = 0;
  FaultyStretch longest;
};

Found find(const std::vector<FaultyStretch>& faults, Fault fault) {
  Found found;
  for (const FaultyStretch& f : faults) {
    if (f.fault != fault) continue;
    found.samples += f.count;
    ++found.stretches;
    const bool larger = fault == Fault::outlier || fault == Fault::step
                            ? std::abs(f.value) > std::abs(found.longest.value)
                            : f.count > found.longest.count;
    if (larger) found.longest = f;
  }
  return found;
}

std::string samples_text(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " sample" : " samples");
}

}  // namespace

double RecordStream::roughness() const {
  if (moves_ < fewest_moves) return 0;
  const double reach = 0.5 * static_cast<double>(past_.size()) * spacing_;
  return moved_ / static_cast<double>(moves_) / (units::pi * units::pi * reach);  // equation (8)
}

std::vector<Doubt> RecordStream::doubts() const {
  std::vector<Doubt> result;
  const auto where = [&](const Found& f) {
    return number_text(places_.at(f.longest.first)) + " m";
  };
  if (const Found f = find(faults(), Fault::code); f.samples > 0)
    result.push_back({"codes", samples_text(f.samples) + " far off with one value, such as " +
                                   short_text(f.longest.value) + " m at " + where(f) +
                                   ": codes of lost samples? Taken as missing"});
  if (const Found f = find(faults(), Fault::outlier); f.samples > 0)
    result.push_back({"outliers", samples_text(f.samples) + " far off what is around, such as " +
                                      short_text(f.longest.value) + " m at " + where(f) +
                                      ": taken as missing"});
  if (const Found f = find(faults(), Fault::stuck); f.samples > 0)
    result.push_back({"stuck", samples_text(f.samples) + " repeat the one before, " +
                                   std::to_string(f.longest.count) + " of them from " + where(f) +
                                   " on: a sensor that stuck? Taken as missing"});
  if (const auto still = screen_.still())
    result.push_back({"still", std::to_string(still->count) + " samples in a row are equal, from " +
                                   number_text(places_.at(still->first)) +
                                   " m on: a sensor that stuck? They are not taken out"});
  if (const Found f = find(faults(), Fault::step); f.samples > 0)
    result.push_back({"steps", "the level steps at " + std::to_string(f.samples) +
                                   (f.samples == 1 ? " place, by " : " places, such as by ") +
                                   short_text(f.longest.value) + " m at " + where(f) +
                                   ": a change of datum? The record is cut there"});
  if (static_cast<double>(bridged_) > bridged_doubted * static_cast<double>(samples_))
    result.push_back({"bridged", short_text(100 * static_cast<double>(bridged_) /
                                            static_cast<double>(samples_)) +
                                     " % of the samples are bridged by straight lines: short waves "
                                     "come out too low"});
  if (const auto u = places_.unevenness(); u.share > spacing_doubted)
    result.push_back({"spacing", "the spacing changes: " + short_text(u.spacing) + " m from " +
                                     number_text(u.from) + " m to " + number_text(u.to) + " m, " +
                                     short_text(u.overall) + " m in the whole record"});
  const double A = roughness();
  if (A > 0 && !(A >= smoothest && A <= roughest))
    result.push_back(
        {"unit",
         "heights leave the chord of " + short_text(static_cast<double>(past_.size()) * spacing_) +
             " m by " +
             short_text(std::sqrt(moved_ / static_cast<double>(moves_)) / units::millimetre) +
             " mm (rms), as no track's do: is the unit right?"});
  return result;
}

}  // namespace railbook::spectra
