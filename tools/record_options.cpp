#include "record_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::tools {

void add_record_options(tool::Options& o, RecordWish& w) {
  o.file("record", w.record.file, "CSV file with a column of heights");
  o.required();
  o.text("--column", w.record.column, "name of that column, with or without its unit");
  o.text("--unit", w.record.unit, "unit of the column, if its header names none");
  o.text("--distance", w.record.distance, "column of positions along the track");
  o.quantity("--spacing", w.record.spacing, units::length,
             "distance between samples, where there are no positions", {1e-4, 1e3});
  o.quantity("--bridge", w.bridge, units::number,
             "longest gap, in samples, to bridge by a straight line; left out: gaps of up to 1 m",
             {0, 1000});
}

spectra::RecordFile record_file(const RecordWish& wish) {
  spectra::RecordFile file = wish.record;
  if (!wish.bridge) return file;
  if (*wish.bridge != std::floor(*wish.bridge))
    throw InputError{fmt::format("bridge is {:g}; allowed: a whole number", *wish.bridge)};
  file.bridge = static_cast<std::size_t>(*wish.bridge);
  return file;
}

void add_record(tool::Summary& s, const spectra::RecordStream& r) {
  for (const spectra::Doubt& doubt : r.doubts()) s.flag(doubt.key, doubt.text);
  s.add("length_km", "length", static_cast<double>(r.samples()) * r.spacing() / units::kilometre,
        "km",
        fmt::format("{} samples, {} missing, {} bridged", r.samples(), r.missing(), r.bridged()));
  s.add("spacing_m", "spacing", r.spacing(), "m");
  s.add("missing", "samples missing", static_cast<double>(r.missing()), "");
  s.add("bridged", "samples bridged", static_cast<double>(r.bridged()), "");
  s.add("faulty", "samples taken out", static_cast<double>(r.faulty()), "");
}

}  // namespace railbook::tools
