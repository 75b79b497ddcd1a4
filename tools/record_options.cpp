#include <fmt/format.h>

#include <cmath>
#include <memory>

#include <railbook/table/csv.hpp>
#include <railbook/tool/progress.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>

#include "record_options.hpp"

namespace railbook::tools {

void add_record_options(tool::OptionParser& o, TrackRecordOptions& w) {
  o.records(w.batch);
  o.texts(
      "--column", w.columns,
      "columns of heights, by name (with or without the unit) or by number; several are read in "
      "one pass, and make a table: --column left,right");
  o.text("--unit", w.record.unit, "unit of the columns, if their headers name none");
  o.text("--distance", w.record.distance,
         "column of positions along the track, or two that add up: km+m; none, with --spacing, "
         "counts samples");
  o.text("--distance-unit", w.record.distance_unit,
         "its unit, if its header names none; mi+ft, mi+yd or km+m for cells such as 87+0500; "
         "mi.yd for miles and yards as 12.0440");
  o.texts("--missing", w.record.missing, "values that stand for lost samples, as -9999");
  o.texts("--where", w.record.where,
          "rows to read, of a table of several rails or runs, as rail=left");
  o.texts(
      "--screen", w.screen,
      "what is taken out: codes (and values that no track can have), outliers, stuck, steps; or "
      "none, or all");
  o.choice("--resync", w.resync, {"refuse", "cut", "count"},
           "where positions turn back, repeat or leave their grid: cut the record there, or count "
           "on in steps of the spacing");
  o.count("--skip", w.skip, "lines before the headers", 0, 10000);
  o.count("--header-lines", w.header_lines,
          "lines of headers: a column's name is what they hold over it, as \"Left Profile mm\"", 1,
          10);
  o.text(
      "--encoding", w.record.encoding,
      "encoding of the text, as cp1252, GBK or Shift-JIS; left out: UTF-8, or UTF-16 by its mark");
  o.text("--sheet", w.record.sheet,
         "sheet of a workbook (.xlsx), by name or number; left out: the first");
  o.text("--dataset", w.record.dataset,
         "data set or group of an HDF5 or MAT file, as run/1, or several with commas: "
         "x,run/1/left; left out: the only table there is");
  o.choice(
      "--decimal", w.decimal, {"either", "point", "comma"},
      "what parts the decimals of numbers; comma also where quoted cells stand between commas");
  o.quantity("--resample", w.record.resample, units::length,
             "spacing of a grid on which samples at uneven positions are interpolated",
             {1e-4, 1e3});
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
    "are lost samples. Codes and values that no track can have are taken out; outliers, stuck "
    "sensors and steps\n"
    "are kept, unless --screen names them, and reported: they may be defects. Each place is a row "
    "of "
    "warnings.csv\n"
    "(with --out): its column, the kind, from_m and to_m, samples, size_mm (how far off, or by how "
    "much a level or a\n"
    "position jumps; of codes and stuck values the value), taken_out (yes or no), and the option "
    "that changes that. Positions count as in the file;\n"
    "heights keep their sign: up is positive "
    "where it is so in the file.";

namespace {

records::Screening screening_of(const std::vector<std::string>& wanted) {
  records::Screening screening{false, false, false, false};
  for (const std::string& name : wanted) {
    const bool all = name == "all";
    if (!all && name != "codes" && name != "outliers" && name != "stuck" && name != "steps" &&
        (name != "none" || wanted.size() > 1))
      throw InputError{fmt::format(
          "screen is \"{}\"; allowed: codes, outliers, stuck, steps; or all, or none alone", name)};
    screening.outliers = screening.outliers || all || name == "outliers";
    screening.stuck = screening.stuck || all || name == "stuck";
    screening.steps = screening.steps || all || name == "steps";
  }
  screening.codes = wanted != std::vector<std::string>{"none"};  // what none asks for
  return screening;
}

}  // namespace

records::RecordFile record_file(const TrackRecordOptions& options,
                                const std::filesystem::path& name) {
  records::RecordFile file = options.record;
  file.file = name;
  file.column = options.columns.front();
  file.skip = static_cast<std::size_t>(options.skip);
  file.header_lines = static_cast<std::size_t>(options.header_lines);
  file.decimal = options.decimal == "point" ? '.' : options.decimal == "comma" ? ',' : '\0';
  file.screening = screening_of(options.screen);
  file.resync = options.resync == "cut"     ? records::Resync::cut
                : options.resync == "count" ? records::Resync::count
                                            : records::Resync::refuse;
  if (!options.batch.many())
    file.progress = [bar = std::make_shared<tool::Progress>("per cent of the record", 100.0),
                     shown = 0](double share) mutable {
      for (; shown < static_cast<int>(100 * share); ++shown) bar->step();
    };
  if (!options.bridge) return file;
  if (*options.bridge != std::floor(*options.bridge))
    throw InputError{fmt::format("bridge is {:g}; allowed: a whole number", *options.bridge)};
  file.bridge = static_cast<std::size_t>(*options.bridge);
  return file;
}

std::string key_of(const std::string& column, const std::string& warning, bool several) {
  return several ? column + "_" + warning : warning;
}

void add_record(tool::Summary& s, const records::RecordStream& r) {
  add_warnings(s, r, "", false);
  s.add("length_km", "length", static_cast<double>(r.samples()) * r.spacing() / units::kilometre,
        "km",
        fmt::format("{} samples, {} missing, {} bridged", r.samples(), r.missing(), r.bridged()));
  s.add("spacing_m", "spacing", r.spacing(), "m");
  s.add("missing", "samples missing", static_cast<double>(r.missing()), "");
  s.add("bridged", "samples bridged", static_cast<double>(r.bridged()), "");
  s.add("faulty", "samples taken out", static_cast<double>(r.faulty()), "");
}

void add_warnings(tool::Summary& s, const records::RecordStream& r, const std::string& column,
                  bool several) {
  for (const units::Warning& warning : r.warnings())
    s.warn(key_of(column, warning.key, several),
           several ? column + ": " + warning.text : warning.text);
}

void add_record(tool::Row& row, const records::RecordStream& r) {
  row.add("from_m", r.places().at(0));
  row.add("to_m", r.places().at(r.samples()));
  row.add("length_km", static_cast<double>(r.samples()) * r.spacing() / units::kilometre);
  row.add("spacing_m", r.spacing());
  row.add("samples", static_cast<double>(r.samples()));
  row.add("missing", static_cast<double>(r.missing()));
  row.add("bridged", static_cast<double>(r.bridged()));
  row.add("faulty", static_cast<double>(r.faulty()));
  for (const units::Warning& warning : r.warnings()) row.warn(warning.key);
}

namespace {

struct Losses {
  double missing = 0, bridged = 0, faulty = 0;
};

Losses losses_of(const Records& records) {
  Losses sum;
  for (const auto& r : records) {
    sum.missing += static_cast<double>(r->missing());
    sum.bridged += static_cast<double>(r->bridged());
    sum.faulty += static_cast<double>(r->faulty());
  }
  return sum;
}

}  // namespace

void add_records(tool::Summary& s, const std::vector<std::string>& columns,
                 const Records& records) {
  if (records.size() == 1) return add_record(s, *records.front());
  for (std::size_t i = 0; i < records.size(); ++i) add_warnings(s, *records[i], columns[i], true);
  const records::RecordStream& r = *records.front();
  s.add("length_km", "length", static_cast<double>(r.samples()) * r.spacing() / units::kilometre,
        "km", fmt::format("{} samples of {} columns", r.samples(), records.size()));
  s.add("spacing_m", "spacing", r.spacing(), "m");
  const Losses sum = losses_of(records);
  const auto each = [&](std::size_t (records::RecordStream::*count)() const) {
    std::string text;
    for (std::size_t i = 0; i < records.size(); ++i)
      if (const std::size_t n = ((*records[i]).*count)(); n > 0)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", columns[i], n);
    return text;
  };
  s.add("missing", "samples missing", sum.missing, "", each(&records::RecordStream::missing));
  s.add("bridged", "samples bridged", sum.bridged, "", each(&records::RecordStream::bridged));
  s.add("faulty", "samples taken out", sum.faulty, "", each(&records::RecordStream::faulty));
}

void add_records(tool::Row& row, const std::vector<std::string>& columns, const Records& records) {
  if (records.size() == 1) return add_record(row, *records.front());
  const records::RecordStream& r = *records.front();
  row.add("from_m", r.places().at(0));
  row.add("to_m", r.places().at(r.samples()));
  row.add("length_km", static_cast<double>(r.samples()) * r.spacing() / units::kilometre);
  row.add("spacing_m", r.spacing());
  row.add("samples", static_cast<double>(r.samples()));
  const Losses sum = losses_of(records);
  row.add("missing", sum.missing);
  row.add("bridged", sum.bridged);
  row.add("faulty", sum.faulty);
  for (std::size_t i = 0; i < records.size(); ++i)
    for (const units::Warning& warning : records[i]->warnings())
      row.warn(key_of(columns[i], warning.key, true));
}

std::string warnings_of(const std::vector<std::string>& columns, const Records& records) {
  std::string text = warnings_header;
  for (std::size_t i = 0; i < records.size(); ++i) text += warning_rows(columns[i], *records[i]);
  return text;
}

const char* const warnings_header = "column,warning,from_m,to_m,samples,size_mm,taken_out,option\n";

std::string warning_rows(const std::string& column, const records::RecordStream& record,
                         const std::string& before, double unit) {
  std::string text;
  for (const records::SuspectPlace& w : record.suspect_places())
    text += before + fmt::format("{},{},{},{},{},{},{},{}\n", table::csv_cell(column), w.key,
                                 table::csv_number(w.from), table::csv_number(w.to), w.samples,
                                 table::csv_number(w.size / unit), w.taken_out ? "yes" : "no",
                                 w.option);
  return text;
}

}  // namespace railbook::tools
