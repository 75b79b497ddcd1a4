/* ### `quality measures`

The measures that networks keep of a record of track geometry, for each section of 200 m:

    railbook quality measures track.csv --column left,right --alignment aleft,aright --gauge gauge --crosslevel cant --out mine

standard deviation and largest value of longitudinal level and alignment in the bands of EN 13848 (D1 and D2; `--bands` names others) with the place of the largest, the standard deviations of gauge, cross level
and twist, the combined standard deviation (weights 1), China's index where all seven parameters are there, and the highest FRA class (1 to 5) that the columns given allow on tangent track: profile and alinement by the 62-ft chord, gauge, cross level, and warp, the difference of cross level within 62 ft; `--chords 31ft 124ft` adds what other chords read. `--fra-class 4` lists every place where
one of them leaves the limit of that class (exceptions.csv); of classes 6 to 9 alinement only, by its deviation from uniformity on chords of 31, 62
and 124 ft. A class or an index is not stated for a section of which something was missing, bridged or taken out within the reach of the chord; how much of it is in `not_evaluated_m`. Nothing is said where a chord reaches over an end of the record or a gap, nor of a band nearer to one than its longest wave. The band-pass has four poles an edge and no phase; it counts as run forward and backward (half the gain at the edges), `--passes 1` takes the root of that. Limits and class
tables that could not be checked in two sources are left out: the classes A to E of EN 13848-6, the limits for action of EN 13848-5, the surface of FRA
classes 6 to 9.
*/
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/fra_limits.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>

#include "quality/column_names.hpp"
#include "quality/exceptions.hpp"
#include "quality/measured_record.hpp"
#include "record_options.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {

namespace {

constexpr double mm = units::millimetre;

// The deviations of a channel in a band, over its sections.
std::optional<double> mean_square(const Channel& channel, std::string_view band) {
  double sum = 0, n = 0;
  for (const Kept& kept : channel.kept())
    if (kept.name == band)
      for (const quality::Section& section : kept.sections.all())
        if (const auto sd = section.deviation()) sum += *sd * *sd, n += 1;
  return n > 0 ? std::optional{sum / n} : std::nullopt;
}

// Warnings of taking a level or an alignment for a whole one.
std::vector<units::Warning> warnings_of(const MeasuresOptions& options, const Channel& channel,
                                        const std::string& header) {
  std::vector<units::Warning> warnings;
  const Column& column = channel.column();
  if (column.kind > Kind::alignment) return warnings;
  if (const auto band = band_in_name(header)) {
    warnings.push_back(
        {"filtered", fmt::format("column {} is filtered to {} already, by its name: its deviation "
                                 "there is the one without a band; in a band it is filtered twice, "
                                 "and chords and classes see only what the filter has left",
                                 column.name, *band)});
  } else if (const auto d1 = mean_square(channel, "D1"), d2 = mean_square(channel, "D2");
             d1 && d2 && d2.value() < 0.0625 * d1.value() && d2.value() > 9e-4 * d1.value()) {
    // A third of this is what the two filters leave between them; of a line alone nothing is left.
    warnings.push_back(
        {"filtered",
         fmt::format(
             "column {} has hardly any waves longer than 25 m (D2 is {:.0f} % of D1): is it "
             "filtered to D1 already? Then its deviation there is the one without a band",
             column.name, 100 * std::sqrt(*d2 / *d1))});
  }
  if (!options.chord && is_offset_by_name(header))
    warnings.push_back(
        {"offset",
         fmt::format("column {} is the offset of a chord, by its name: no class is judged "
                     "by it; --chord says of which, and one of 62 ft is held against the "
                     "limits as it is",
                     column.name)});
  return warnings;
}

// "left", "left D1", "twist".
std::string name_of(const Channel& channel, const Kept& kept, const char* between) {
  if (kept.name.empty()) return channel.column().name;
  if (kept.name == "twist" || kept.name == "warp") return kept.name;
  return fmt::format("{}{}{}", channel.column().name, between, kept.name);
}

tool::Row row_of_section(const MeasuresOptions& options, const Measured& m, std::size_t at,
                         std::size_t begin) {
  tool::Row row;
  const quality::Section& first = m.channels.front().kept().front().sections.all()[at];
  row.add("kind", "section");
  row.add("from_m", first.from);
  row.add("to_m", first.from + options.section);
  row.add("samples", static_cast<double>(first.samples));
  std::size_t missing = 0, unread = 0, not_evaluated = 0;  // of all columns; near the section too
  double fra = std::nan("");                               // where nothing could be judged
  for (std::size_t i = 0; i < m.channels.size(); ++i) {
    const records::RecordStream& record = *m.records[i];
    missing += m.channels[i].kept().front().sections.all()[at].missing;
    unread += record.unread(begin, first.samples);
    const auto reach =
        static_cast<std::size_t>(std::ceil(m.channels[i].reach() / record.spacing()));
    not_evaluated = std::max(not_evaluated, record.unread(begin, first.samples, reach));
    fra = std::fmin(fra, m.channels[i].fra_class(at));
  }
  row.add("missing", static_cast<double>(missing));
  row.add("unread", static_cast<double>(unread));
  Deviations banded, plain;
  for (const Channel& channel : m.channels) {
    const Kind kind = channel.column().kind;
    for (const Kept& kept : channel.kept()) {
      const quality::Section& s = kept.sections.all()[at];
      const bool twist = kept.name == "twist", warp = kept.name == "warp";
      const double unit = twist ? 1e-3 : mm;
      const std::string name = name_of(channel, kept, "_");
      const auto key = [&](const char* what) {
        return fmt::format("{}_{}_{}", name, what, twist ? "mm_per_m" : "mm");
      };
      const auto sd = s.deviation();
      if (!kept.name.starts_with("chord") && !warp)
        row.add(key("sd"), sd ? *sd / unit : std::nan(""));
      if (sd && kept.name.empty()) plain.add(kind, *sd);
      if (sd && twist) plain.add_twist(*sd * options.twist_base);
      if (sd && (kept.name == "D1" || (kept.name.empty() && kind >= Kind::gauge)))
        banded.add(kind, *sd);
      if (kept.name.empty() && kind != Kind::crosslevel) {
        if (kind != Kind::gauge) continue;
        row.add(key("lowest"), sd ? s.lowest / unit : std::nan(""));
        row.add(name + "_lowest_at_m", sd ? s.lowest_at : std::nan(""));
        row.add(key("highest"), sd ? s.highest / unit : std::nan(""));
        row.add(name + "_highest_at_m", sd ? s.highest_at : std::nan(""));
        continue;
      }
      const bool low = std::abs(s.lowest) > std::abs(s.highest);
      row.add(key("largest"), sd ? (low ? s.lowest : s.highest) / unit : std::nan(""));
      row.add(name + "_largest_at_m", sd ? (low ? s.lowest_at : s.highest_at) : std::nan(""));
    }
  }
  // The same columns in each section, also where something is missing; no index and no class there.
  const bool all =
      !options.alignment.empty() && !options.gauge.empty() && !options.crosslevel.empty();
  const double nothing = std::nan("");
  if (all)
    row.add("combined_sd_mm", unread > 0 ? nothing : banded.combined().value_or(nothing) / mm);
  if (all && options.record.columns.size() == 2 && options.alignment.size() == 2)
    row.add("tqi_mm", unread > 0 ? nothing : plain.tqi().value_or(nothing) / mm);
  row.add("fra_class", not_evaluated > 0 ? nothing : fra);
  row.add("not_evaluated_m", static_cast<double>(not_evaluated) * m.records.front()->spacing());
  return row;
}

// The length of which some limit of the class could not be judged, m.
double not_evaluated(const Measured& m) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < m.channels.size(); ++i)
    if (const auto& watch = m.channels[i].watch())
      most = std::max(most, watch->not_evaluated(*m.records[i]));
  return static_cast<double>(most) * m.records.front()->spacing();
}

std::vector<tool::Row> rows_of(const MeasuresOptions& options, const Measured& m) {
  std::vector<tool::Row> rows(1);
  rows[0].add("kind", "record");
  tools::add_records(rows[0], m.names(), m.records);
  for (std::size_t i = 0; i < m.channels.size(); ++i)
    for (const auto& [key, text] : warnings_of(options, m.channels[i], m.records[i]->header()))
      rows[0].warn(key);
  if (options.fra_class > 0) {
    const double n = m.exceptions(), lost = not_evaluated(m);
    rows[0].add("exceptions", n > 0 || lost == 0 ? n : std::nan(""));
    rows[0].add("not_evaluated_m", lost);
  }
  std::size_t begin = 0;
  const auto& sections = m.channels.front().kept().front().sections.all();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    rows.push_back(row_of_section(options, m, i, begin));
    begin += sections[i].samples;
  }
  return rows;
}

std::string table_of(const std::vector<tool::Row>& sections) {
  std::string text;
  for (const tool::Row& row : sections) {
    const bool first = text.empty();
    std::string head, line;
    for (const tool::Row::Cell& cell : row.cells()) {
      if (cell.key == "kind") continue;
      const char* const comma = head.empty() ? "" : ",";
      head += comma + table::csv_cell(cell.key);
      line += comma + table::csv_number(cell.value);
    }
    text += (first ? head + "\n" : "") + line + "\n";
  }
  return text;
}

// What the picture shows: the deviations in the first band, and of all that has no band.
std::string picture_of(const MeasuresOptions& options, const Measured& m) {
  std::string text;
  for (const Channel& channel : m.channels)
    for (const Kept& kept : channel.kept()) {
      const bool filtered = channel.column().kind <= Kind::alignment;
      if (kept.name != (filtered ? options.bands.front() : "")) continue;
      if (!text.empty()) text += "\n\n";
      text += fmt::format("distance_km,deviation_mm,{}\n",
                          table::csv_cell(name_of(channel, kept, " ")));
      for (const quality::Section& s : kept.sections.all()) {
        const auto sd = s.deviation();
        for (const double at : {s.from, s.from + options.section})
          text += fmt::format("{:.8g},{},\n", at / units::kilometre,
                              table::csv_number(sd ? *sd / mm : std::nan("")));
      }
    }
  return text + "\n";
}

// What is judged, and how often it leaves the limits; no zero where something could not be judged.
void add_exceptions(tool::Summary& s, const MeasuresOptions& options, const Measured& m) {
  std::vector<std::string> judged, not_judged;
  const auto sort = [&](const char* what, Kind kind) {
    bool any = false;
    for (const Channel& channel : m.channels)
      any = any || (channel.column().kind == kind && channel.watch() && channel.watch()->judged());
    (any ? judged : not_judged).emplace_back(what);
  };
  sort("profile", Kind::level);
  sort("alinement", Kind::alignment);
  sort("gauge", Kind::gauge);
  sort("cross level and warp", Kind::crosslevel);
  const std::string what = fmt::format("exceptions to FRA class {}", options.fra_class);
  const double n = m.exceptions(), lost = not_evaluated(m);
  if (judged.empty())
    s.absent("exceptions", what, "none of the columns can be judged");
  else if (n == 0 && lost > 0)
    s.absent("exceptions", what, fmt::format("none found, but {:.4g} m were not evaluated", lost));
  else
    s.add("exceptions", what, n, "", lost > 0 ? "in what could be evaluated" : "");
  s.add("judged", "  judged",
        judged.empty() ? "nothing" : fmt::format("{}", fmt::join(judged, ", ")));
  if (!not_judged.empty())
    s.add("not_judged", "  not judged", fmt::format("{}", fmt::join(not_judged, ", ")));
  for (const Channel& channel : m.channels)
    if (channel.column().kind == Kind::gauge && options.fra_class <= quality::fra_classes &&
        !channel.watch()->judged())
      s.warn("gauge", "column " + channel.column().name +
                          " is neither a gauge near 1435 mm nor a deviation from it: not judged");
  s.add("not_evaluated_m", "  not evaluated", lost, "m",
        "missing, bridged or taken out, or a chord over it");
}

tool::Summary summary_of(const MeasuresOptions& options, const Measured& m) {
  tool::Summary s{"measures of " + options.record.batch.only().string()};
  tools::add_records(s, m.names(), m.records);
  for (std::size_t i = 0; i < m.channels.size(); ++i)
    for (const auto& [key, text] : warnings_of(options, m.channels[i], m.records[i]->header()))
      s.warn(m.channels.size() > 1 ? fmt::format("{}_{}", m.channels[i].column().name, key) : key,
             text);
  s.add("section_m", "length of a section", options.section, "m");
  if (options.fra_class > 0) add_exceptions(s, options, m);
  s.add("passes", "band-pass, passes", static_cast<double>(options.passes), "");
  for (const Channel& channel : m.channels)
    for (const Kept& kept : channel.kept()) {
      if (kept.name.starts_with("chord") || kept.name == "warp") continue;
      const bool twist = kept.name == "twist";
      std::vector<std::pair<double, double>> all;  // deviation, from
      for (const quality::Section& section : kept.sections.all())
        if (const auto sd = section.deviation()) all.emplace_back(*sd, section.from);
      if (all.empty()) continue;
      std::sort(all.begin(), all.end());
      const double unit = twist ? 1e-3 : mm;
      const char* const name_of_unit = twist ? "mm/m" : "mm";
      const std::string name = name_of(channel, kept, " ");
      std::string key = name;
      std::replace(key.begin(), key.end(), ' ', '_');
      s.add(key + "_median_sd", name + ", median deviation", all[all.size() / 2].first / unit,
            name_of_unit);
      s.add(key + "_worst_sd", "  worst section", all.back().first / unit, name_of_unit,
            fmt::format("from {:g} m", all.back().second));
    }
  return s;
}

void measure_track(const MeasuresOptions& options) {
  (void)bands_of(options);
  if (options.fra_class > quality::fra_classes && options.alignment.empty())
    throw InputError{
        fmt::format("fra class is {}, whose limits are known for alinement only; allowed: 1 to 5, "
                    "or --alignment",
                    options.fra_class)};
  if (options.record.batch.many())
    return tool::run_batch(options.record.batch, options.out, "measures", [&](const auto& file) {
      return rows_of(options, measure_record(options, file));
    });
  tool::OutFolder out(options.out, {"measures.csv", "measures.json", "exceptions.csv",
                                    "warnings.csv", "measures.png"});
  const Measured m = measure_record(options, options.record.batch.only());
  const tool::Summary summary = summary_of(options, m);
  summary.print();
  if (out) {
    const auto rows = rows_of(options, m);
    out.add("measures.csv", table_of({rows.begin() + 1, rows.end()}));
    out.add("measures.json", summary.json());
    if (options.fra_class > 0) {
      std::string text = FraWatch::header;
      for (const Channel& channel : m.channels)
        if (channel.watch()) text += channel.watch()->rows();
      out.add("exceptions.csv", text);
    }
    out.add("warnings.csv", tools::warnings_of(m.names(), m.records));
    out.scratch("picture.csv", picture_of(options, m));
    out.figure(tools::scripts("quality") / "measures.gp", {"picture.csv"}, "measures.png");
  }
  out.commit();
}

}  // namespace

tool::Tool measures_tool() {
  return {
      "measures", "standard deviations, chords, twist and indices of sections",
      [](tool::OptionParser& o) {
        auto options = std::make_shared<MeasuresOptions>();
        tools::add_record_options(o, options->record);
        o.texts("--alignment", options->alignment, "columns of alignment");
        o.text("--gauge", options->gauge, "column of gauge, or of its deviation from 56.5 in");
        o.text("--crosslevel", options->crosslevel, "column of cross level, a height");
        o.texts("--bands", options->bands,
                "bands of EN 13848 for level and alignment, of D0, D1, D2, D3");
        o.count("--passes", options->passes,
                "of the band-pass: 2, half the gain at its edges, or 1", 1, 2);
        o.quantities("--chords", options->chords, units::length, "more chords, besides 62 ft",
                     {0.5, 1e3});
        o.quantity("--chord", options->chord, units::length,
                   "the columns of level and alignment are the mid-chord offsets of this chord",
                   {0.1, 1e3});
        o.count("--fra-class", options->fra_class,
                "list where this class's limits are left: profile, alinement, gauge, cross level "
                "and warp on tangent track; of classes 6 to 9, alinement",
                1, 9);
        o.quantity("--twist-base", options->twist_base, units::length, "base of twist", {0.5, 30});
        o.quantity("--section", options->section, units::length, "length of a section", {1, 1e6});
        o.out(options->out);
        o.help(
            std::string{tools::record_help} +
            "\n\nmeasures.csv has a row a section. NAME_sd is a standard deviation about the "
            "mean; NAME_largest the value\n"
            "farthest from zero, with its sign, and NAME_largest_at_m its place. NAME_D1_sd, "
            "NAME_D1_largest and NAME_D1_largest_at_m are those of the column in that band and\n"
            "have the column's sign. NAME_chord_largest is of the column at the middle of a 62-ft "
            "chord less "
            "the mean of its ends: a\n"
            "hollow is negative where up is positive; of columns that are offsets of such a chord "
            "already (--chord 62ft)\n"
            "it is the column. twist (mm/m) is the cross level less that "
            "a twist base before, over\n"
            "the base; warp the cross level less the one within 62 ft before that differs most. "
            "Both are positive where\n"
            "cross level grows in the order of the rows. Gauge is whole or as given. missing "
            "counts samples of all\n"
            "columns that are not there; unread those missing, bridged or taken out. "
            "combined_sd, tqi and fra_class are\n"
            "empty where any is: for fra_class also within the reach of its chord "
            "(not_evaluated_m). fra_class is the\n"
            "highest of classes 1 to 5 that all columns given keep on tangent track, 0 where "
            "they keep none. In\n"
            "exceptions.csv, largest_mm is the value farthest beyond the limit. warnings.csv: "
            "column, warning, place and size.\n"
            "\nExample: railbook quality measures track.csv --column left,right --gauge gauge "
            "--crosslevel cant --out mine\n"
            "         railbook quality measures track.csv --chords 31ft 124ft --fra-class 4 "
            "--out mine");
        return [options] { measure_track(*options); };
      }};
}

}  // namespace railbook::quality_tool
