/* ### `quality measures`

The measures that networks keep of a record of track geometry, for each section of 200 m:

    railbook quality measures track.csv --column left,right --alignment aleft,aright --gauge gauge --crosslevel cant --out mine

standard deviation and largest value of longitudinal level and alignment in the bands of EN 13848 (D1 and D2; `--bands` names others) with the place of the largest, the standard deviations of gauge, cross level
and twist, the combined standard deviation (weights 1), China's index where all seven parameters are there, and what a 62-ft chord reads with the highest FRA class (1 to 5) that allows it; `--chords 31ft 124ft` adds what other chords read. `--fra-class 4` lists every place where
profile or alinement leaves the limit of that class (exceptions.csv): classes 1 to 5 by the 62-ft chord, classes 6 to 9 alinement only, by its deviation from uniformity on chords of 31, 62
and 124 ft. Nothing is said where a chord reaches over an end of the record or a gap, nor of a band nearer to one than its longest wave. The band-pass has four poles an edge and no phase; it counts as run forward and backward (half the gain at the edges), `--passes 1` takes the root of that. Limits and class
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

#include "measures/band.hpp"
#include "measures/fra_limits.hpp"
#include "measures/inner_filter.hpp"
#include "measures/sections.hpp"
#include "quality/deviations.hpp"
#include "quality/exceptions.hpp"
#include "record_options.hpp"
#include "table/csv.hpp"
#include "tool/batch.hpp"
#include "tool/out_folder.hpp"
#include "tool/summary.hpp"
#include "tools.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::quality_tool {

namespace {

constexpr double mm = units::millimetre;
namespace ms = railbook::measures;

struct MeasuresWish {
  tools::RecordWish record;
  std::vector<std::string> alignment, bands{"D1", "D2"};
  std::string gauge, crosslevel;
  double section = 200, twist_base = 3;
  std::vector<double> chords;
  long passes = 2, fra_class = 0;  // 0: none asked for
  tool::Destination out;
};

struct Column {
  std::string name;
  Kind kind;
};

std::vector<Column> columns_of(const MeasuresWish& wish) {
  std::vector<Column> columns;
  for (const std::string& name : wish.record.columns) columns.push_back({name, Kind::level});
  for (const std::string& name : wish.alignment) columns.push_back({name, Kind::alignment});
  if (!wish.gauge.empty()) columns.push_back({wish.gauge, Kind::gauge});
  if (!wish.crosslevel.empty()) columns.push_back({wish.crosslevel, Kind::crosslevel});
  return columns;
}

std::vector<ms::Band> bands_of(const MeasuresWish& wish) {
  std::vector<ms::Band> chosen;
  for (const std::string& name : wish.bands) {
    const auto at = std::find_if(ms::bands.begin(), ms::bands.end(),
                                 [&](const ms::Band& b) { return b.name == name; });
    if (at == ms::bands.end())
      throw InputError{fmt::format("bands: \"{}\"; allowed: D0, D1, D2, D3", name)};
    chosen.push_back(*at);
  }
  return chosen;
}

// What is kept of a column: the channel itself or a filtered one, section by section.
struct Kept {
  std::string name;  // "D1"; empty for the channel as it is
  ms::Sections sections;
  std::unique_ptr<ms::InnerFilter> filter;
};

// A column on its way: each sample goes to all that is kept of it.
std::string name_of_chord(double chord) {
  const double feet = chord / units::foot;
  return std::abs(feet - std::round(feet)) < 1e-6 ? fmt::format("chord_{:g}ft", feet)
                                                  : fmt::format("chord_{:g}m", chord);
}

class Channel {
 public:
  Channel(const MeasuresWish& wish, const Column& column) : wish_(wish), column_(column) {}

  void push(std::span<const double> piece, const spectra::RecordStream& record) {
    if (kept_.empty()) begin(record);
    if (watch_) watch_->push(piece);
    for (Kept& kept : kept_) {
      if (kept.filter)
        kept.filter->push(piece);
      else if (kept.name.empty())
        kept.sections.push(piece);
    }
    if (!twist_) return;
    std::vector<double> twist;
    for (const double value : piece) twist.push_back(twist_->push(value));
    kept_.back().sections.push(twist);
  }

  void finish() {
    for (Kept& kept : kept_)
      if (kept.filter) kept.filter->finish();
    if (watch_) watch_->finish();
  }

  const Column& column() const { return column_; }
  const std::deque<Kept>& kept() const { return kept_; }
  const std::optional<FraWatch>& watch() const { return watch_; }

 private:
  void begin(const spectra::RecordStream& record) {
    const auto place = [&record](std::size_t i) { return record.places().at(i); };
    const auto keep = [&](const std::string& name) -> Kept& {
      return kept_.emplace_back(Kept{name, ms::Sections{wish_.section, place}, {}});
    };
    const auto filter = [&](const std::string& name, const quality::FilterTaps& taps,
                            std::size_t margin) {
      Kept& kept = keep(name);
      kept.filter = std::make_unique<ms::InnerFilter>(
          taps, margin, [&kept](std::span<const double> p) { kept.sections.push(p); });
    };
    const auto chord = [&](const std::string& name, double length) {
      const quality::FilterTaps taps = ms::chord_taps(length, record.spacing());
      filter(name, taps, taps.half.size() - 1);
    };
    keep("");
    if (column_.kind == Kind::level || column_.kind == Kind::alignment) {
      for (const ms::Band& band : bands_of(wish_))
        filter(std::string{band.name},
               ms::band_taps(band, static_cast<int>(wish_.passes), record.spacing()),
               ms::band_margin(band, record.spacing()));
      chord("chord", ms::fra::profile.chord);
      for (const double length : wish_.chords) chord(name_of_chord(length), length);
      if (wish_.fra_class > 0)
        watch_.emplace(column_.name, column_.kind == Kind::alignment,
                       static_cast<int>(wish_.fra_class), record);
    }
    if (column_.kind == Kind::crosslevel) {
      twist_.emplace(wish_.twist_base, record.spacing());
      keep("twist");
    }
  }

  const MeasuresWish& wish_;
  Column column_;
  std::deque<Kept> kept_;  // references to them are kept
  std::optional<ms::Twist> twist_;
  std::optional<FraWatch> watch_;
};

struct Measured {
  std::vector<std::unique_ptr<const spectra::RecordStream>> records;
  std::deque<Channel> channels;

  double exceptions() const {
    std::size_t n = 0;
    for (const Channel& channel : channels) n += channel.watch() ? channel.watch()->count() : 0;
    return static_cast<double>(n);
  }
};

Measured measure_record(const MeasuresWish& wish, const std::filesystem::path& file) {
  Measured m;
  std::vector<std::string> names;
  std::vector<spectra::RecordSink> sinks;
  for (const Column& column : columns_of(wish)) {
    names.push_back(column.name);
    Channel& channel = m.channels.emplace_back(wish, column);
    sinks.emplace_back([&channel](std::span<const double> piece, const spectra::RecordStream& r) {
      channel.push(piece, r);
    });
  }
  m.records = spectra::read_records(tools::record_file(wish.record, file), names, sinks);
  for (Channel& channel : m.channels) channel.finish();
  return m;
}

// "left", "left D1", "twist".
std::string name_of(const Channel& channel, const Kept& kept, const char* between) {
  if (kept.name.empty()) return channel.column().name;
  if (kept.name == "twist") return kept.name;
  return fmt::format("{}{}{}", channel.column().name, between, kept.name);
}

tool::Row row_of_section(const MeasuresWish& wish, const Measured& m, std::size_t at) {
  tool::Row row;
  const ms::Section& first = m.channels.front().kept().front().sections.all()[at];
  row.add("kind", "section");
  row.add("from_m", first.from);
  row.add("to_m", first.from + wish.section);
  row.add("samples", static_cast<double>(first.samples));
  row.add("missing", static_cast<double>(first.missing));
  Deviations banded, plain;
  double fra = std::nan("");  // where no chord could be read
  for (const Channel& channel : m.channels) {
    const Kind kind = channel.column().kind;
    for (const Kept& kept : channel.kept()) {
      if (at >= kept.sections.all().size()) continue;
      const ms::Section& s = kept.sections.all()[at];
      const bool twist = kept.name == "twist", chord = kept.name.starts_with("chord");
      const double unit = twist ? 1e-3 : mm;
      const std::string name = name_of(channel, kept, "_");
      const auto key = [&](const char* what) {
        return fmt::format("{}_{}_{}", name, what, twist ? "mm_per_m" : "mm");
      };
      const auto sd = s.deviation();
      if (!chord) row.add(key("sd"), sd ? *sd / unit : std::nan(""));
      if (sd && kept.name.empty()) plain.add(kind, *sd);
      if (sd && twist) plain.add_twist(*sd * wish.twist_base);
      if (sd && (kept.name == "D1" || (kept.name.empty() && kind >= Kind::gauge)))
        banded.add(kind, *sd);
      if (kept.name.empty()) continue;
      const bool low = std::abs(s.lowest) > std::abs(s.highest);
      row.add(key("largest"), sd ? (low ? s.lowest : s.highest) / unit : std::nan(""));
      row.add(name + "_largest_at_m", sd ? (low ? s.lowest_at : s.highest_at) : std::nan(""));
      if (kept.name == "chord" && sd)
        fra = std::fmin(fra,
                        ms::fra_class(kind == Kind::level ? ms::fra::profile : ms::fra::alinement,
                                      s.largest()));
    }
  }
  // The same columns in each section, also where something is missing.
  const bool all = !wish.alignment.empty() && !wish.gauge.empty() && !wish.crosslevel.empty();
  const double nothing = std::nan("");
  if (all) row.add("combined_sd_mm", banded.combined().value_or(nothing) / mm);
  if (all && wish.record.columns.size() == 2 && wish.alignment.size() == 2)
    row.add("tqi_mm", plain.tqi().value_or(nothing) / mm);
  row.add("fra_class", fra);
  return row;
}

std::vector<tool::Row> rows_of(const MeasuresWish& wish, const Measured& m) {
  std::vector<tool::Row> rows(1);
  rows[0].add("kind", "record");
  tools::add_record(rows[0], *m.records.front());
  if (wish.fra_class > 0) rows[0].add("exceptions", m.exceptions());
  const std::size_t sections = m.channels.front().kept().front().sections.all().size();
  for (std::size_t i = 0; i < sections; ++i) rows.push_back(row_of_section(wish, m, i));
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
std::string picture_of(const MeasuresWish& wish, const Measured& m) {
  std::string text;
  for (const Channel& channel : m.channels)
    for (const Kept& kept : channel.kept()) {
      const bool filtered = channel.column().kind <= Kind::alignment;
      if (kept.name != (filtered ? wish.bands.front() : "")) continue;
      if (!text.empty()) text += "\n\n";
      text += fmt::format("distance_km,deviation_mm,{}\n",
                          table::csv_cell(name_of(channel, kept, " ")));
      for (const ms::Section& s : kept.sections.all()) {
        const auto sd = s.deviation();
        for (const double at : {s.from, s.from + wish.section})
          text += fmt::format("{:.8g},{},\n", at / units::kilometre,
                              table::csv_number(sd ? *sd / mm : std::nan("")));
      }
    }
  return text + "\n";
}

tool::Summary summary_of(const MeasuresWish& wish, const Measured& m) {
  tool::Summary s{"measures of " + wish.record.batch.only().string()};
  tools::add_record(s, *m.records.front());
  s.add("section_m", "length of a section", wish.section, "m");
  if (wish.fra_class > 0)
    s.add("exceptions", fmt::format("exceptions to FRA class {}", wish.fra_class), m.exceptions(),
          "", wish.fra_class > ms::fra_classes ? "of alinement; surface is not watched" : "");
  s.add("passes", "band-pass, passes", static_cast<double>(wish.passes), "");
  for (const Channel& channel : m.channels)
    for (const Kept& kept : channel.kept()) {
      if (kept.name.starts_with("chord")) continue;
      const bool twist = kept.name == "twist";
      std::vector<std::pair<double, double>> all;  // deviation, from
      for (const ms::Section& section : kept.sections.all())
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

void measure_track(const MeasuresWish& wish) {
  (void)bands_of(wish);
  if (wish.fra_class > ms::fra_classes && wish.alignment.empty())
    throw InputError{
        fmt::format("fra class is {}, whose limits are known for alinement only; allowed: 1 to 5, "
                    "or --alignment",
                    wish.fra_class)};
  if (wish.record.batch.many())
    return tool::run_batch(wish.record.batch, wish.out, "measures", [&](const auto& file) {
      return rows_of(wish, measure_record(wish, file));
    });
  tool::OutFolder out(wish.out,
                      {"measures.csv", "measures.json", "exceptions.csv", "measures.png"});
  const Measured m = measure_record(wish, wish.record.batch.only());
  const tool::Summary summary = summary_of(wish, m);
  summary.print();
  if (out) {
    const auto rows = rows_of(wish, m);
    out.add("measures.csv", table_of({rows.begin() + 1, rows.end()}));
    out.add("measures.json", summary.json());
    if (wish.fra_class > 0) {
      std::string text = FraWatch::header();
      for (const Channel& channel : m.channels)
        if (channel.watch()) text += channel.watch()->rows();
      out.add("exceptions.csv", text);
    }
    out.scratch("picture.csv", picture_of(wish, m));
    out.figure(tools::scripts("quality") / "measures.gp", {"picture.csv"}, "measures.png");
  }
  out.commit();
}

}  // namespace

tool::Tool measures_tool() {
  return {
      "measures", "standard deviations, chords, twist and indices of sections",
      [](tool::Options& o) {
        auto wish = std::make_shared<MeasuresWish>();
        tools::add_record_options(o, wish->record);
        o.texts("--alignment", wish->alignment, "columns of alignment");
        o.text("--gauge", wish->gauge, "column of gauge");
        o.text("--crosslevel", wish->crosslevel, "column of cross level, a height");
        o.texts("--bands", wish->bands,
                "bands of EN 13848 for level and alignment, of D0, D1, D2, D3");
        o.count("--passes", wish->passes, "of the band-pass: 2, half the gain at its edges, or 1",
                1, 2);
        o.quantities("--chords", wish->chords, units::length, "more chords, besides 62 ft",
                     {0.5, 1e3});
        o.count("--fra-class", wish->fra_class, "list where this class's limits are left", 1, 9);
        o.quantity("--twist-base", wish->twist_base, units::length, "base of twist", {0.5, 30});
        o.quantity("--section", wish->section, units::length, "length of a section", {1, 1e6});
        o.out(wish->out);
        o.help(std::string{tools::record_help} +
               "\n\nExample: railbook quality measures track.csv --column left,right --gauge gauge "
               "--crosslevel cant --out mine\n"
               "         railbook quality measures track.csv --chords 31ft 124ft --fra-class 4 "
               "--out mine");
        return [wish] { measure_track(*wish); };
      }};
}

}  // namespace railbook::quality_tool
