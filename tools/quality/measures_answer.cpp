#include "quality/measures_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/warning.hpp>

#include "quality/column_names.hpp"
#include "quality/short_waves.hpp"

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
    if (!channel.content().band)
      warnings.push_back(
          {"filtered",
           fmt::format("column {} is filtered to {} already, by its name: in a band it is filtered "
                       "twice, and chords and classes see only what the filter has left; "
                       "--filtered by-name or --filtered {} takes it for what it is",
                       column.name, *band, *band)});
    else if (channel.content().band_name.starts_with("D") && *band != channel.content().band_name)
      warnings.push_back(
          {"filtered",
           fmt::format("column {} is filtered to {} by its name, and to {} by --filtered",
                       column.name, *band, channel.content().band_name)});
  } else if (const auto d1 = mean_square(channel, "D1"), d2 = mean_square(channel, "D2");
             d1 && d2) {
    if (const auto share = short_waves_alone(*d1, *d2))
      warnings.push_back(
          {"filtered",
           fmt::format(
               "column {} has hardly any waves longer than 25 m (D2 is {:.0f} % of D1): is it "
               "filtered to D1 already? Then say so: --filtered D1",
               column.name, 100 * *share)});
  }
  if (const auto longest = high_pass_in_name(header); longest && options.chord.empty())
    warnings.push_back(
        {"filtered",
         fmt::format("column {} has only waves shorter than {} m, by its name: no class is judged "
                     "by it",
                     column.name, *longest)});
  else if (options.chord.empty() && channel.content().offset)
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

// The length of which some limit could not be judged, m.
double not_evaluated(const Measured& m) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < m.channels.size(); ++i)
    if (const auto& watch = m.channels[i].watch())
      most = std::max(most, watch->not_evaluated(*m.records[i]));
  return static_cast<double>(most) * m.records.front()->spacing();
}

// Where a limit is left, in all columns.
struct Left {
  const Channel* channel;
  Exceedance exceedance;
  // How far it is beyond the limit.
  double beyond() const { return std::abs(exceedance.place.largest - exceedance.bound); }
};

std::vector<Left> all_exceedances(const Measured& m) {
  std::vector<Left> all;
  for (const Channel& channel : m.channels)
    if (channel.watch())
      for (const Exceedance& e : channel.watch()->exceedances()) all.push_back({&channel, e});
  return all;
}

}  // namespace

std::vector<tool::Row> rows_of(const MeasuresOptions& options, const Measured& m) {
  std::vector<tool::Row> rows(1);
  rows[0].add("kind", "record");
  tools::add_records(rows[0], m.names(), m.records);
  for (std::size_t i = 0; i < m.channels.size(); ++i)
    for (const auto& [key, text] : warnings_of(options, m.channels[i], m.records[i]->header()))
      rows[0].warn(key);
  if (!options.limits.empty()) {
    const auto n = static_cast<double>(all_exceedances(m).size());
    const double lost = not_evaluated(m);
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

std::string picture_of(const MeasuresOptions& options, const Measured& m) {
  std::string text;
  for (const Channel& channel : m.channels)
    for (const Kept& kept : channel.kept()) {
      const bool filtered = channel.column().kind <= Kind::alignment;
      const std::string& band =
          channel.content().band ? channel.content().band_name : options.bands.front();
      if (kept.name != (filtered ? band : "")) continue;
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

std::string exceptions_of(const Measured& m) {
  std::string text = "column,limit,class,from_m,to_m,largest,largest_at_m,bound,unit\n";
  for (const auto& [channel, e] : all_exceedances(m)) {
    const double unit = e.limit->unit();
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", table::csv_cell(channel->column().name),
                        table::csv_cell(e.limit->what), table::csv_cell(e.limit->track_class),
                        table::csv_number(e.place.from), table::csv_number(e.place.to),
                        table::csv_number(e.place.largest / unit), table::csv_number(e.place.at),
                        table::csv_number(e.bound / unit), e.limit->unit_name());
  }
  return text;
}

namespace {

// The measures that are judged, and those that are not: no such column, or none that shows them.
void add_judged(tool::Summary& s, const MeasuresOptions& options, const Measured& m) {
  std::vector<std::string> judged, not_judged;
  const auto add = [](std::vector<std::string>& all, const std::string& text) {
    if (std::ranges::find(all, text) == all.end()) all.push_back(text);
  };
  for (const Limit& limit : options.limits) {
    bool any = false;
    for (const Channel& channel : m.channels) {
      if (channel.column().kind != limit.channel) continue;
      any = true;
      const bool judges = channel.watch()->judges(limit);
      add(judges ? judged : not_judged,
          judges ? limit.what : fmt::format("{} of {}", limit.what, channel.column().name));
      if (!judges && limit.channel == Kind::gauge)
        s.warn("gauge",
               fmt::format("column {} is neither a gauge near {:.6g} mm nor a deviation from it: "
                           "not judged; --nominal-gauge takes another",
                           channel.column().name, options.nominal_gauge / mm));
    }
    if (!any) add(not_judged, limit.what);
  }
  s.add("judged", "  judged",
        judged.empty() ? "nothing" : fmt::format("{}", fmt::join(judged, ", ")));
  if (!not_judged.empty())
    s.add("not_judged", "  not judged", fmt::format("{}", fmt::join(not_judged, ", ")));
}

// Of a gauge a tenth of a millimetre, so that 1460.3 is not shown as its limit of 1460.
std::string beside_limit(double value) {
  return std::abs(value) >= 1000 ? fmt::format("{:.1f}", value) : tool::to_text(value);
}

// How often the limits are left; no zero where something could not be judged.
void add_exceptions(tool::Summary& s, const MeasuresOptions& options, const Measured& m) {
  const std::vector<Left> all = all_exceedances(m);
  const std::string what =
      options.fra_class > 0
          ? fmt::format("exceptions to FRA class {}", options.fra_class)
          : fmt::format("exceptions to {}", options.limits_file.filename().string());
  const double lost = not_evaluated(m);
  const bool any = std::ranges::any_of(options.limits, [&](const Limit& limit) {
    return std::ranges::any_of(
        m.channels, [&](const Channel& channel) { return channel.watch()->judges(limit); });
  });
  if (!any)
    s.absent("exceptions", what, "none of the columns can be judged");
  else if (all.empty() && lost > 0)
    s.absent("exceptions", what, fmt::format("none found, but {:.4g} m were not evaluated", lost));
  else
    s.add("exceptions", what, static_cast<double>(all.size()), "",
          lost > 0 ? "in what could be evaluated" : "");
  const auto name_of_limit = [&](const Limit& limit) {
    const bool without = options.fra_class > 0 || limit.track_class.empty();
    return limit.what + (without ? "" : " " + limit.track_class);
  };
  std::map<std::string, std::vector<const Left*>> by_limit;
  for (const Left& left : all) by_limit[name_of_limit(*left.exceedance.limit)].push_back(&left);
  for (const auto& [name, each] : by_limit) {
    const Left* const worst = *std::ranges::max_element(each, {}, &Left::beyond);
    const Limit& limit = *worst->exceedance.limit;
    std::string key = "exceptions " + name;
    std::ranges::replace(key, ' ', '_');
    const quality::Exception& e = worst->exceedance.place;
    s.add(key, "  " + name, static_cast<double>(each.size()), "",
          fmt::format("{} {} {} {} {:.7g} m, limit {}", worst->channel->column().name,
                      beside_limit(e.largest / limit.unit()), limit.unit_name(),
                      std::isnan(e.at) ? "from" : "at", std::isnan(e.at) ? e.from : e.at,
                      beside_limit(worst->exceedance.bound / limit.unit())));
  }
  add_judged(s, options, m);
  std::size_t reach = 0;
  for (const Channel& channel : m.channels) reach = std::max(reach, channel.watch()->reach());
  s.add("not_evaluated_m", "  not evaluated", lost, "m",
        fmt::format("missing, bridged or taken out, or near that; besides, up to {:.4g} m at each "
                    "end of the record",
                    static_cast<double>(reach) * m.records.front()->spacing()));
}

}  // namespace

tool::Summary summary_of(const MeasuresOptions& options, const Measured& m) {
  tool::Summary s{"measures of " + options.record.batch.only().string()};
  tools::add_records(s, m.names(), m.records);
  for (std::size_t i = 0; i < m.channels.size(); ++i)
    for (const auto& [key, text] : warnings_of(options, m.channels[i], m.records[i]->header()))
      s.warn(m.channels.size() > 1 ? fmt::format("{}_{}", m.channels[i].column().name, key) : key,
             text);
  s.add("section_m", "length of a section", options.section, "m");
  if (!options.limits.empty()) add_exceptions(s, options, m);
  s.add("passes", "band-pass, passes", static_cast<double>(options.passes), "");
  for (const Channel& channel : m.channels)
    for (const Kept& kept : channel.kept()) {
      if (kept.name.starts_with("chord") || kept.name == "warp") continue;
      if (kept.name.empty() && channel.content().band) continue;  // its band says the same
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

}  // namespace railbook::quality_tool
