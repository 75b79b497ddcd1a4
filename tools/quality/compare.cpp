/* ### `quality compare`

Two runs over one line, and what has grown between them:

    quality compare spring.csv autumn.csv --column profile --section 200m --out mine

Both runs are brought to the grid of the first and filtered to the band D1; windows of 200 m of the first are looked for within 20 m of their place in the second, by correlation, and the
offsets found are joined by straight lines (recorders count differently). For each section of the first run there are the standard deviations of both runs, the growth from one to the other, and how well the
runs agree. A section without a window that was found says so and has no growth. Both runs are held in memory, 8 bytes a sample.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measures/alignment.hpp"
#include "measures/band.hpp"
#include "measures/sections.hpp"
#include "record_options.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tool/summary.hpp"
#include "tools.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::quality_tool {

namespace {

namespace ms = railbook::measures;
constexpr double mm = units::millimetre;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct CompareWish {
  tools::RecordWish record;
  ms::AlignmentOptions alignment;
  double section = 200;
  tool::Destination out;
};

// A run in the band D1, by ascending positions.
struct Run {
  std::unique_ptr<const spectra::RecordStream> record;
  std::vector<double> z, at;  // m
};

Run read(const CompareWish& wish, const std::filesystem::path& file) {
  Run run;
  std::optional<quality::FilterStream> filter;
  const auto keep = [&](std::span<const double> p) {
    run.z.insert(run.z.end(), p.begin(), p.end());
  };
  run.record = spectra::read_record(
      tools::record_file(wish.record, file),
      [&](std::span<const double> piece, const spectra::RecordStream& record) {
        if (!filter) filter.emplace(ms::band_taps(ms::bands[1], 2, record.spacing()), keep);
        filter->push(piece);
      });
  filter->finish();
  for (std::size_t i = 0; i < run.z.size(); ++i) run.at.push_back(run.record->places().at(i));
  if (run.at.size() > 1 && run.at.back() < run.at.front()) {
    std::reverse(run.z.begin(), run.z.end());
    std::reverse(run.at.begin(), run.at.end());
  }
  return run;
}

// The run at a place between its samples, straight between them; NaN beyond its ends.
double value_at(const Run& run, double x) {
  const auto next = std::upper_bound(run.at.begin(), run.at.end(), x);
  if (next == run.at.begin() || next == run.at.end()) return nan;
  const auto i = static_cast<std::size_t>(next - run.at.begin());
  const double share = (x - run.at[i - 1]) / (run.at[i] - run.at[i - 1]);
  return (1 - share) * run.z[i - 1] + share * run.z[i];
}

struct Compared {
  std::vector<ms::Section> first, second;
  std::vector<double> correlation, offset;  // of a section; NaN where no window was found
};

Compared compare(const CompareWish& wish, const Run& a, const Run& b) {
  const double h = a.record->spacing();
  std::vector<double> other;
  for (const double x : a.at) other.push_back(value_at(b, x));
  const auto matches = ms::align(a.z, other, h, wish.alignment);
  if (std::none_of(matches.begin(), matches.end(), [](const ms::Match& m) { return m.found; }))
    throw InputError{
        fmt::format("the second run is nowhere like the first within {:g} m of its place; allowed: "
                    "two runs over one "
                    "line (--reach for larger offsets)",
                    wish.alignment.reach)};
  const auto place = [&](std::size_t i) { return a.at[i]; };
  ms::Sections first{wish.section, place}, second{wish.section, place};
  std::vector<double> moved;
  for (std::size_t i = 0; i < a.at.size(); ++i)
    moved.push_back(value_at(b, a.at[i] + ms::offset_at(matches, static_cast<double>(i))));
  first.push(a.z);
  second.push(moved);
  Compared result{first.all(), second.all(), {}, {}};
  for (const ms::Section& section : result.first) {
    double worst = 1, sum = 0, n = 0;
    for (const ms::Match& m : matches) {
      const double x = a.at[m.centre];
      if (!m.found || x < section.from || x >= section.from + wish.section) continue;
      worst = std::min(worst, m.correlation);
      sum += m.offset;
      ++n;
    }
    result.correlation.push_back(n > 0 ? worst : nan);
    result.offset.push_back(n > 0 ? sum / n : nan);
  }
  return result;
}

struct Growth {
  double from = 0, before = nan, after = nan, growth = nan;  // m
};

std::vector<Growth> growths(const Compared& c) {
  std::vector<Growth> all;
  for (std::size_t i = 0; i < c.first.size(); ++i) {
    Growth g{.from = c.first[i].from};
    if (const auto sd = c.first[i].deviation()) g.before = *sd;
    if (const auto sd = c.second[i].deviation()) g.after = *sd;
    if (!std::isnan(c.correlation[i])) g.growth = g.after - g.before;
    all.push_back(g);
  }
  return all;
}

tool::Summary summary_of(const CompareWish& wish, const Run& a, const Compared& c) {
  const auto& files = wish.record.batch.files;
  tool::Summary s{fmt::format("growth from {} to {}", files[0].string(), files[1].string())};
  tools::add_record(s, *a.record);
  s.add("sections", "sections", static_cast<double>(c.first.size()), "",
        fmt::format("of {:g} m", wish.section));
  std::vector<Growth> all = growths(c);
  std::erase_if(all, [](const Growth& g) { return std::isnan(g.growth); });
  const std::size_t lost = c.first.size() - all.size();
  if (4 * lost > c.first.size())
    s.flag("not-found",
           fmt::format("{} of {} sections were not found in the second run", lost, c.first.size()));
  s.add("compared", "  found in both runs", static_cast<double>(all.size()), "");
  double low = 0, high = 0;
  bool any = false;
  for (const double offset : c.offset)
    if (!std::isnan(offset)) {
      low = any ? std::min(low, offset) : offset;
      high = any ? std::max(high, offset) : offset;
      any = true;
    }
  s.add("offset_from_m", "offset of the second run, from", low, "m");
  s.add("offset_to_m", "  to", high, "m");
  if (all.empty()) return s;
  std::sort(all.begin(), all.end(),
            [](const Growth& x, const Growth& y) { return x.growth > y.growth; });
  s.add("median_growth_mm", "median growth of the deviation in D1", all[all.size() / 2].growth / mm,
        "mm");
  for (std::size_t i = 0; i < std::min<std::size_t>(5, all.size()); ++i)
    s.add(fmt::format("largest_{}_mm", i + 1), i == 0 ? "largest growth" : "", all[i].growth / mm,
          "mm",
          fmt::format("from {:g} m: {:.3f} to {:.3f} mm", all[i].from, all[i].before / mm,
                      all[i].after / mm));
  return s;
}

std::string table_of(const CompareWish& wish, const Compared& c) {
  std::string text = "from_m,to_m,before_mm,after_mm,growth_mm,offset_m,correlation\n";
  const auto all = growths(c);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Growth& g = all[i];
    text += fmt::format("{},{},{},{},{},{},{}\n", table::csv_number(g.from),
                        table::csv_number(g.from + wish.section), table::csv_number(g.before / mm),
                        table::csv_number(g.after / mm), table::csv_number(g.growth / mm),
                        table::csv_number(c.offset[i]), table::csv_number(c.correlation[i]));
  }
  return text;
}

void compare_runs(const CompareWish& wish) {
  if (wish.record.batch.files.size() != 2)
    throw InputError{fmt::format("{} records are given; allowed: 2, the earlier run first",
                                 wish.record.batch.files.size())};
  tool::OutFolder out(wish.out, {"compare.csv", "compare.json", "compare.png"});
  const Run a = read(wish, wish.record.batch.files[0]), b = read(wish, wish.record.batch.files[1]);
  const Compared c = compare(wish, a, b);
  const tool::Summary summary = summary_of(wish, a, c);
  summary.print();
  if (out) {
    out.add("compare.csv", table_of(wish, c));
    out.add("compare.json", summary.json());
    out.figure(tools::scripts("quality") / "compare.gp", {"compare.csv"}, "compare.png");
  }
  out.commit();
}

}  // namespace

tool::Tool compare_tool() {
  return {"compare", "two runs over one line: offsets, and growth of each section",
          [](tool::Options& o) {
            auto wish = std::make_shared<CompareWish>();
            tools::add_record_options(o, wish->record);
            o.quantity("--section", wish->section, units::length, "length of a section", {1, 1e6});
            o.quantity("--window", wish->alignment.window, units::length,
                       "of the first run that is looked for in the second", {10, 1e4});
            o.quantity("--reach", wish->alignment.reach, units::length,
                       "to either side of its place", {1, 1e3});
            o.out(wish->out);
            o.help(std::string{tools::record_help} +
                   "\n\nExample: railbook quality compare spring.csv autumn.csv --column profile "
                   "--out mine");
            return [wish] { compare_runs(*wish); };
          }};
}

}  // namespace railbook::quality_tool
