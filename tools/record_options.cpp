#include "record_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "tool/progress.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::tools {

void add_record_options(tool::Options& o, RecordWish& w) {
  o.records(w.batch);
  o.texts(
      "--column", w.columns,
      "columns of heights, by name (with or without the unit) or by number; several are read in "
      "one pass, and make a table: --column left,right");
  o.text("--unit", w.record.unit, "unit of the columns, if their headers name none");
  o.text("--distance", w.record.distance,
         "column of positions along the track, or two that add up: km+m");
  o.text("--distance-unit", w.record.distance_unit, "its unit, if its header names none");
  o.texts("--missing", w.record.missing, "values that stand for lost samples, as -9999");
  o.count("--skip", w.skip, "lines before the headers", 0, 10000);
  o.quantity("--spacing", w.record.spacing, units::length,
             "distance between samples, where there are no positions", {1e-4, 1e3});
  o.quantity("--bridge", w.bridge, units::number,
             "longest gap, in samples, to bridge by a straight line; left out: gaps of up to 1 m",
             {0, 1000});
}

const char* const record_help =
    "Files: a line of headers, then a row a sample. A header names its unit: profile_mm, \"Profile "
    "(mm)\",\n"
    "Distance [km]; or --unit and --distance-unit do. Positions ascend or descend, may be rounded, "
    "and may be\n"
    "written 12+345.6 (km and m); without a column of them, give --spacing. Empty cells, nan, NA "
    "and --missing\n"
    "are lost samples; other codes, outliers, stuck sensors and steps are found and told.";

spectra::RecordFile record_file(const RecordWish& wish, const std::filesystem::path& name) {
  spectra::RecordFile file = wish.record;
  file.file = name;
  file.column = wish.columns.front();
  file.skip = static_cast<std::size_t>(wish.skip);
  if (!wish.batch.many())
    file.progress = [bar = std::make_shared<tool::Progress>("per cent of the record", 100.0),
                     told = 0](double share) mutable {
      for (; told < static_cast<int>(100 * share); ++told) bar->step();
    };
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

void add_record(tool::Row& row, const spectra::RecordStream& r) {
  row.add("from_m", r.places().at(0));
  row.add("to_m", r.places().at(r.samples()));
  row.add("length_km", static_cast<double>(r.samples()) * r.spacing() / units::kilometre);
  row.add("spacing_m", r.spacing());
  row.add("samples", static_cast<double>(r.samples()));
  row.add("missing", static_cast<double>(r.missing()));
  row.add("bridged", static_cast<double>(r.bridged()));
  row.add("faulty", static_cast<double>(r.faulty()));
  for (const spectra::Doubt& doubt : r.doubts()) row.flag(doubt.key);
}

}  // namespace railbook::tools
