// What a record stream warns of, and where.
#include <algorithm>
#include <cmath>
#include <string>

#include <railbook/records/record.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/number_text.hpp>
#include <railbook/units/warning.hpp>

namespace railbook::records {
namespace {

constexpr double uneven_spacing = 0.003, much_bridged = 0.05;
constexpr double smoothest = 1e-10, roughest = 1e-4;  // m^2 cycle/m: no track is beyond
constexpr std::size_t fewest_moves = 100;

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// All stretches of one kind, taken out or not: how many samples, and the longest or largest of
// them.
struct Found {
  std::size_t samples = 0, stretches = 0;
  FaultyStretch longest;
};

Found find(const std::vector<FaultyStretch>& faults, Fault fault, bool taken_out) {
  Found found;
  for (const FaultyStretch& f : faults) {
    if (f.fault != fault || f.taken_out != taken_out) continue;
    found.samples += f.count;
    const bool by_value = fault == Fault::outlier || fault >= Fault::step;
    const double size = f.fault == Fault::outlier ? f.off : f.value,
                 most = f.fault == Fault::outlier ? found.longest.off : found.longest.value;
    const bool larger = by_value ? std::abs(size) > std::abs(most) : f.count > found.longest.count;
    if (larger || found.stretches == 0) found.longest = f;
    ++found.stretches;
  }
  return found;
}

// Its key in the answer, and what it is called where it is listed.
const char* key_of(Fault fault) {
  switch (fault) {
    case Fault::outlier:
      return "outliers";
    case Fault::code:
      return "codes";
    case Fault::stuck:
      return "stuck";
    case Fault::step:
      return "steps";
    case Fault::jump:
      return "jumps";
    case Fault::cut:
      return "cuts";
  }
  return "";
}

const char* option_of(const FaultyStretch& f) {
  if (f.fault == Fault::jump) return "";
  if (f.fault == Fault::cut) return "--resync";
  if (f.taken_out) return "--screen none";
  return f.fault == Fault::step    ? "--screen steps"
         : f.fault == Fault::stuck ? "--screen stuck"
                                   : "--screen outliers";
}

std::string places_text(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " place" : " places");
}

std::string samples_text(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " sample" : " samples");
}

}  // namespace

double RecordStream::roughness() const {
  if (moves_ < fewest_moves) return 0;
  const double reach = 0.5 * static_cast<double>(reach_) * spacing_;
  return moved_ / static_cast<double>(moves_) / (units::pi * units::pi * reach);  // equation (8)
}

std::vector<units::Warning> RecordStream::warnings() const {
  std::vector<units::Warning> result = notes_;
  const std::string si = " " + options_.si + " at ";
  const auto add = [&](Fault fault, bool taken_out, const auto& text) {
    const Found f = find(faults(), fault, taken_out);
    if (f.samples == 0) return;
    const bool both = !taken_out && find(faults(), fault, true).samples > 0;
    const FaultyStretch& l = f.longest;
    const std::string at =
        units::number_text(places_.at(l.first)) + " m" +
        (l.count > 1 ? " to " + units::number_text(places_.at(l.first + l.count - 1)) + " m" : "");
    result.push_back({std::string{key_of(fault)} + (both ? "_kept" : ""), text(f, at)});
  };
  for (const bool out : {true, false}) {
    add(Fault::code, out, [&](const Found& f, const std::string& at) {
      return samples_text(f.samples) + " far off with one value, such as " +
             short_text(f.longest.value) + si + at + ": a code for a lost sample? " +
             (out ? std::string{"Taken out (--screen none keeps them)"}
                  : "They are kept (--missing " + short_text(f.longest.value / options_.unit) +
                        " takes them out)");
    });
    add(Fault::outlier, out, [&](const Found& f, const std::string& at) {
      return samples_text(f.samples) + " in " + places_text(f.stretches) +
             " far off, the largest by " + short_text(f.longest.off) + si + at +
             ": a defect, or a fault of the recorder? " +
             (out ? "Taken out (--screen none keeps them)"
                  : "They are kept (--screen outliers takes them out)");
    });
    add(Fault::stuck, out, [&](const Found& f, const std::string& at) {
      return samples_text(f.samples) + " repeat the one before, " +
             std::to_string(f.longest.count) + " of them from " + at + ": a sensor that stuck? " +
             (out ? "Taken out" : "They are kept (--screen stuck takes them out)");
    });
    add(Fault::step, out, [&](const Found& f, const std::string& at) {
      return "the level steps at " + places_text(f.stretches) + ", the largest by " +
             short_text(f.longest.value) + si + at + ": a defect, or a change of datum? " +
             (out ? "The record is cut there"
                  : "It is kept (--screen steps cuts the record there)");
    });
  }
  add(Fault::jump, false, [&](const Found& f, const std::string& at) {
    return "the level jumps and comes back at " + places_text(f.stretches) + ", the largest by " +
           short_text(f.longest.value) + si + at +
           ": a defect of the track, or a fault of the recorder? Nothing is taken out";
  });
  add(Fault::cut, false, [&](const Found& f, const std::string& at) {
    return "positions turn back, repeat or leave their grid at " + places_text(f.stretches) +
           ", such as by " + short_text(f.longest.value) + " m at " + at +
           ": the record is cut there";
  });
  if (counted_ > 0)
    result.push_back(
        {"counted",
         "positions turn back, repeat, leave their grid or skip to a whole kilometre at " +
             places_text(counted_) + ", such as from " + units::number_text(counts_[0].from) +
             " m to " + units::number_text(counts_[0].to) +
             " m: samples are counted on there, and no gap is seen"});
  if (unplaced_ > 0)
    result.push_back({"unplaced", samples_text(unplaced_) + " without a position: left out"});
  if (whole_kilometre_)
    result.push_back({"kilometre", "a gap ends at the whole kilometre " +
                                       units::number_text(*whole_kilometre_) +
                                       " m: a kilometre of another length? Its samples count as "
                                       "missing (--resync count goes on without a gap)"});
  if (const auto still = screen_.still())
    result.push_back({"still", std::to_string(still->count) + " samples in a row are equal, from " +
                                   units::number_text(places_.at(still->first)) +
                                   " m on: a sensor that stuck? They are not taken out"});
  if (static_cast<double>(bridged_) > much_bridged * static_cast<double>(samples_))
    result.push_back({"bridged", short_text(100 * static_cast<double>(bridged_) /
                                            static_cast<double>(samples_)) +
                                     " % of the samples are bridged by straight lines: short waves "
                                     "come out too low"});
  if (const auto u = places_.unevenness(); u.share > uneven_spacing)
    result.push_back({"spacing", "the spacing changes: " + short_text(u.spacing) + " m from " +
                                     units::number_text(u.from) + " m to " +
                                     units::number_text(u.to) + " m, " + short_text(u.overall) +
                                     " m in the whole record"});
  const double A = roughness();
  const double inner = A * (moved_ > 0 ? moved_inner_ / moved_ / 0.58 : 0);
  const bool periodic = A < smoothest && inner >= smoothest;
  // Samples millimetres apart are of a rail's running surface.
  if (options_.si == "m" && spacing_ > 0.02 && A > 0 && !(A >= smoothest && A <= roughest) &&
      !periodic)
    result.push_back({"unit", "heights leave the chord of " +
                                  short_text(static_cast<double>(reach_) * spacing_) + " m by " +
                                  short_text(std::sqrt(moved_ / static_cast<double>(moves_)) /
                                             units::millimetre) +
                                  " mm (rms), as no track's do: is the unit right?"});
  return result;
}

std::vector<SuspectPlace> RecordStream::suspect_places() const {
  std::vector<SuspectPlace> result;
  for (const FaultyStretch& f : faults())
    result.push_back({key_of(f.fault), places_.at(f.first), places_.at(f.first + f.count - 1),
                      f.count, f.fault == Fault::outlier ? f.off : f.value, f.taken_out,
                      option_of(f)});
  result.insert(result.end(), counts_.begin(), counts_.end());
  for (const units::Warning& warning : warnings()) {
    const bool listed = std::any_of(result.begin(), result.end(), [&](const SuspectPlace& p) {
      return warning.key == p.key || warning.key == p.key + "_kept";
    });
    if (!listed)
      result.push_back(
          {warning.key, places_.at(0), places_.at(samples_ - 1), samples_, lost, false, ""});
  }
  return result;
}

}  // namespace railbook::records
