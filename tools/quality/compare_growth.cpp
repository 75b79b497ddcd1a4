// The answer of runs with dates.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/units/constants.hpp>

#include "quality/compare.hpp"

namespace railbook::quality_tool {

namespace {

constexpr double mm = units::millimetre;
using Begin = quality::Period::Begin;

// A column with the periods of its sections.
struct Grown {
  const ComparedColumn& column;
  double drop = 0;
  std::vector<std::vector<quality::Period>> sections;

  double from(std::size_t i) const { return column.runs.front().sections[i].heights.from; }
  // The period of a section that goes on, if it has a growth.
  const quality::Period* last(std::size_t i) const {
    const auto& all = sections[i];
    return all.empty() || std::isnan(all.back().growth.slope) ? nullptr : &all.back();
  }
};

Grown grown(const CompareOptions& options, const ComparedColumn& column,
            const std::vector<double>& years) {
  Grown g{column, quality::tamping_drop(column.runs, options.growth), {}};
  for (std::size_t i = 0; i < column.runs.front().sections.size(); ++i)
    g.sections.push_back(quality::periods(column.runs, i, years, g.drop, options.growth));
  return g;
}

// How many periods begin so, and the first places.
std::string places_of(const Grown& g, const CompareOptions& options, Begin begin,
                      std::size_t& count) {
  std::string text;
  for (std::size_t i = 0; i < g.sections.size(); ++i)
    for (const quality::Period& period : g.sections[i]) {
      if (period.begin != begin) continue;
      if (++count <= 5)
        text += fmt::format("{}from {:g} m before {}", count > 1 ? ", " : "", g.from(i),
                            options.dates[period.runs.front()]);
    }
  return count > 5 ? text + " ..." : text;
}

void add_column(tool::Summary& s, const CompareOptions& options, const Grown& g, bool several) {
  const std::string& name = g.column.name;
  const std::string before = several ? name + ": " : "";
  const auto key = [&](const std::string& text) { return tools::key_of(name, text, several); };
  for (std::size_t k = 1; k < g.column.runs.size(); ++k)
    if (const quality::ComparedRun& run = g.column.runs[k]; run.ambiguous > 0)
      s.warn(key("ambiguous-" + options.dates[k]),
             fmt::format("{}{} of {} windows of the run of {} fit as well {:.4g} m further: the "
                         "record repeats itself, and the offset may be another",
                         before, run.ambiguous, run.windows, options.dates[k], run.other));
  std::size_t unlike = 0, tamped = 0;
  if (const std::string text = places_of(g, options, Begin::unlike, unlike); unlike > 0)
    s.warn(key("unlike"),
           fmt::format("{}{} times a section is unlike the run before it, but not smoother; its "
                       "growth begins anew there: {}",
                       before, unlike, text));
  const std::string tampings = places_of(g, options, Begin::tamped, tamped);
  std::vector<std::size_t> judged;
  bool error = false;
  std::size_t growing = 0;
  for (std::size_t i = 0; i < g.sections.size(); ++i)
    if (const quality::Period* last = g.last(i)) {
      judged.push_back(i);
      error = error || last->runs.size() > 2;
      growing += last->growth.low > 0 ? 1 : 0;
    }
  s.add(key("sections"), before + "sections", static_cast<double>(g.sections.size()), "",
        fmt::format("of {:g} m", options.section));
  s.add(key("tamping_drop"), "  tamped where the deviation falls by", 100 * g.drop, "%",
        g.drop > options.growth.tamping_drop ? "four times the scatter of the runs" : "");
  s.add(key("tamped"), "  tamped", static_cast<double>(tamped), "", tampings);
  s.add(key("judged"), "  with a growth since then", static_cast<double>(judged.size()), "");
  if (judged.empty()) return;
  const auto slope = [&](std::size_t i) { return g.last(i)->growth.slope; };
  std::sort(judged.begin(), judged.end(),
            [&](std::size_t i, std::size_t k) { return slope(i) > slope(k); });
  s.add(key("median_growth_mm_per_year"), before + "median growth of the deviation in D1",
        slope(judged[judged.size() / 2]) / mm, "mm/year",
        error ? "" : "two runs a section: no standard error");
  // Where some have a standard error, those without are no news.
  if (error) {
    std::erase_if(judged, [&](std::size_t i) { return g.last(i)->runs.size() < 3; });
    s.add(key("growing"), "  above zero with 95 %", static_cast<double>(growing), "",
          fmt::format("of {} with three runs or more", judged.size()));
  }
  for (std::size_t k = 0; k < std::min<std::size_t>(5, judged.size()); ++k) {
    const std::size_t i = judged[k];
    const quality::Period& last = *g.last(i);
    const std::string large = key(fmt::format("largest_{}_mm_per_year", k + 1));
    const std::string what = k == 0 ? before + "largest growth" : "";
    const std::string where = fmt::format("from {:g} m, {} runs from {}", g.from(i),
                                          last.runs.size(), options.dates[last.runs.front()]);
    if (last.runs.size() < 3)
      s.add(large, what, last.growth.slope / mm, "mm/year", where);
    else
      s.add(large, what, tool::Estimate{last.growth.slope / mm, last.growth.standard_error / mm},
            "mm/year",
            fmt::format("{}; 95 %: {:.3g} to {:.3g}", where, last.growth.low / mm,
                        last.growth.high / mm));
  }
}

std::string growth_table(const CompareOptions& options, const std::vector<Grown>& columns) {
  std::string text =
      "from_m,to_m,column,begins,drop,since,until,runs,growth_mm_per_year,standard_error,low,"
      "high\n";
  for (const Grown& g : columns)
    for (std::size_t i = 0; i < g.sections.size(); ++i)
      for (const quality::Period& p : g.sections[i])
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{}\n", table::csv_number(g.from(i)),
            table::csv_number(g.from(i) + options.section), table::csv_cell(g.column.name),
            p.begin == Begin::first    ? "first"
            : p.begin == Begin::tamped ? "tamped"
                                       : "unlike",
            table::csv_number(p.drop), options.dates[p.runs.front()], options.dates[p.runs.back()],
            p.runs.size(), table::csv_number(p.growth.slope / mm),
            table::csv_number(p.growth.standard_error / mm), table::csv_number(p.growth.low / mm),
            table::csv_number(p.growth.high / mm));
  return text;
}

std::string deviation_table(const CompareOptions& options, const std::vector<Grown>& columns) {
  std::string text = "from_m,to_m,column,date,deviation_mm,offset_m,correlation,missing,left_out\n";
  for (const Grown& g : columns)
    for (std::size_t i = 0; i < g.sections.size(); ++i)
      for (std::size_t k = 0; k < options.dates.size(); ++k) {
        const quality::RunSection& section = g.column.runs[k].sections[i];
        text +=
            fmt::format("{},{},{},{},{},{},{},{},{}\n", table::csv_number(g.from(i)),
                        table::csv_number(g.from(i) + options.section),
                        table::csv_cell(g.column.name), options.dates[k],
                        table::csv_number(section.heights.deviation().value_or(units::nan) / mm),
                        table::csv_number(section.offset), table::csv_number(section.correlation),
                        section.heights.missing,
                        section.missing()                         ? "too little is in all runs"
                        : section.jump > options.growth.most_jump ? "the offset jumps"
                                                                  : "");
      }
  return text;
}

}  // namespace

void answer_growth(const CompareOptions& options, const ComparedColumns& columns,
                   const std::vector<double>& years, tool::OutFolder& out) {
  std::vector<Grown> all;
  for (const ComparedColumn& column : columns) all.push_back(grown(options, column, years));
  tool::Summary s{fmt::format("growth a year of {} runs, {} to {}", years.size(),
                              options.dates.front(), options.dates.back())};
  add_runs(s, columns);
  for (const Grown& g : all) add_column(s, options, g, all.size() > 1);
  s.print();
  if (!out) return;
  out.add("growth.csv", growth_table(options, all));
  out.add("deviations.csv", deviation_table(options, all));
  add_files(out, options, columns, s, options.dates);
}

}  // namespace railbook::quality_tool
