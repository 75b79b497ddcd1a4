// The answer of two runs without dates.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/units/constants.hpp>

#include "quality/compare.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {

namespace {

constexpr double mm = units::millimetre;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Growth {
  double from = 0, before = nan, after = nan, growth = nan;  // m
  const char* reason = "";                                   // why there is none
};

std::vector<Growth> growths(const CompareOptions& options, const ComparedColumn& c) {
  std::vector<Growth> all;
  for (std::size_t i = 0; i < c.runs[1].sections.size(); ++i) {
    const quality::RunSection& second = c.runs[1].sections[i];
    Growth g{.from = second.heights.from};
    g.before = c.runs[0].sections[i].heights.deviation().value_or(nan);
    g.after = second.heights.deviation().value_or(nan);
    g.reason = second.missing()                         ? "too little is in both runs"
               : std::isnan(second.correlation)         ? "not like the first run"
               : second.jump > options.growth.most_jump ? "the offset jumps"
                                                        : "";
    if (*g.reason == 0) g.growth = g.after - g.before;
    all.push_back(g);
  }
  return all;
}

// The sections without a growth: how many for each reason, and the first of them.
void flag_not_judged(tool::Summary& s, const std::vector<Growth>& all, const std::string& before,
                     const std::string& key) {
  std::string text;
  std::size_t lost = 0;
  for (const Growth& g : all) {
    if (*g.reason == 0) continue;
    if (++lost > 5) continue;
    text += fmt::format("{}from {:g} m ({}{})", lost > 1 ? ", " : "", g.from, g.reason,
                        std::isnan(g.before) || std::isnan(g.after)
                            ? ""
                            : fmt::format(", {:.2f} and {:.2f} mm", g.before / mm, g.after / mm));
  }
  if (lost > 0)
    s.warn(key, fmt::format("{}{} of {} sections could not be judged: {}{}; tamped track is not "
                            "like what it was",
                            before, lost, all.size(), text, lost > 5 ? " ..." : ""));
}

void add_column(tool::Summary& s, const CompareOptions& options, const ComparedColumn& c,
                bool several) {
  const std::string before = several ? c.name + ": " : "";
  const auto key = [&](const std::string& text) { return tools::key_of(c.name, text, several); };
  const quality::ComparedRun& second = c.runs[1];
  std::vector<Growth> all = growths(options, c);
  flag_not_judged(s, all, before, key("not-found"));
  if (second.ambiguous > 0)
    s.warn(
        key("ambiguous"),
        fmt::format("{}{} of {} windows fit as well {:.4g} m further: the record repeats itself, "
                    "and the offset may be another",
                    before, second.ambiguous, second.windows, second.other));
  s.add(key("second_missing"), before + "samples missing in the second run",
        static_cast<double>(c.records[1]->missing()), "");
  s.add(key("sections"), "sections", static_cast<double>(second.sections.size()), "",
        fmt::format("of {:g} m", options.section));
  std::erase_if(all, [](const Growth& g) { return std::isnan(g.growth); });
  s.add(key("compared"), "  found in both runs", static_cast<double>(all.size()), "");
  double low = 0, high = 0;
  bool any = false;
  for (const quality::RunSection& section : second.sections)
    if (!std::isnan(section.offset)) {
      low = any ? std::min(low, section.offset) : section.offset;
      high = any ? std::max(high, section.offset) : section.offset;
      any = true;
    }
  s.add(key("offset_from_m"), "offset of the second run, from", low, "m");
  s.add(key("offset_to_m"), "  to", high, "m");
  if (all.empty()) return;
  std::sort(all.begin(), all.end(),
            [](const Growth& x, const Growth& y) { return x.growth > y.growth; });
  s.add(key("median_growth_mm"), before + "median growth of the deviation in D1",
        all[all.size() / 2].growth / mm, "mm");
  for (std::size_t i = 0; i < std::min<std::size_t>(5, all.size()); ++i)
    s.add(key(fmt::format("largest_{}_mm", i + 1)), i == 0 ? before + "largest growth" : "",
          all[i].growth / mm, "mm",
          fmt::format("from {:g} m: {} to {} mm", all[i].from, tool::to_text(all[i].before / mm),
                      tool::to_text(all[i].after / mm)));
}

tool::Summary summary_of(const CompareOptions& options, const ComparedColumns& columns) {
  const auto& files = options.record.batch.files;
  tool::Summary s{fmt::format("growth from {} to {}", files[0].string(), files[1].string())};
  add_runs(s, columns);
  for (const ComparedColumn& column : columns) add_column(s, options, column, columns.size() > 1);
  return s;
}

std::string table_of(const CompareOptions& options, const ComparedColumns& columns) {
  std::string text =
      "from_m,to_m,before_mm,after_mm,growth_mm,offset_m,correlation,missing,column,not_judged\n";
  for (const ComparedColumn& c : columns) {
    const auto all = growths(options, c);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Growth& g = all[i];
      const quality::RunSection& second = c.runs[1].sections[i];
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{}\n", table::csv_number(g.from),
                      table::csv_number(g.from + options.section), table::csv_number(g.before / mm),
                      table::csv_number(g.after / mm), table::csv_number(g.growth / mm),
                      table::csv_number(second.offset), table::csv_number(second.correlation),
                      second.heights.missing, table::csv_cell(c.name), g.reason);
    }
  }
  return text;
}

}  // namespace

void answer_pair(const CompareOptions& options, const ComparedColumns& columns,
                 tool::OutFolder& out) {
  const tool::Summary summary = summary_of(options, columns);
  summary.print();
  if (!out) return;
  out.add("compare.csv", table_of(options, columns));
  add_files(out, options, columns, summary, {"first run", "second run"});
}

}  // namespace railbook::quality_tool
