/* ### `quality compare`

Two runs over one line, and what has grown between them:

    quality compare spring.csv autumn.csv --column profile --section 200m --out mine

Both runs are brought to the grid of the first and filtered to the band D1; windows of 200 m of the first are looked for within 20 m of their place in the second, by correlation, and the
offsets found are joined by straight lines (recorders count differently). For each section of the first run there are the standard deviations of both runs, the growth from one to the other, and how well the
runs agree. Deviations are those of the samples that both runs have, 25 m and more from an end or a gap; where these are less than half of a section, no window was found (tamped track is not like what it was), or the offset jumps by over 2 m, there is no growth: such sections are named. Several columns are compared one after the other. Where a window
fits as well at another offset, as on a wave, the smallest offset is taken and the answer says so. Runs with `--resync` count their positions from the first on. The filtered runs are held in memory (8 bytes a sample each: 32 MB for 1000 km at 0.25 m).
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <railbook/filters/inner_filter.hpp>
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/quality/alignment.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>

#include "record_options.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {

namespace {

constexpr double mm = units::millimetre;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double offset_jumps = 2;  // m

struct CompareOptions {
  tools::TrackRecordOptions record;
  quality::AlignmentOptions alignment;
  double section = 200;
  tool::Destination out;
};

// A run in the band D1, by ascending positions.
class Run {
 public:
  Run(const CompareOptions& options, const std::filesystem::path& file, const std::string& column) {
    std::optional<filters::InnerFilter> filter;
    const auto keep = [&](std::span<const double> p) {
      samples_.insert(samples_.end(), p.begin(), p.end());
    };
    records::RecordFile read = tools::record_file(options.record, file);
    read.column = column;
    record_ = records::read_record(
        read, [&](std::span<const double> piece, const records::RecordStream& record) {
          if (!filter)
            filter.emplace(filters::band_taps(filters::bands[1], 2, record.spacing()),
                           filters::band_margin(filters::bands[1], record.spacing()), keep);
          filter->push(piece);
        });
    filter->finish();
    turned_ = size() > 1 && place(size() - 1) < place(0);
  }

  const records::RecordStream& record() const { return *record_; }
  std::size_t size() const { return samples_.size(); }
  double at(std::size_t i) const { return place(own(i)); }  // m

  double operator[](std::size_t i) const { return samples_[own(i)]; }

  // Between the samples by the cubic through the two on either side, straight where one of those is missing; NaN beyond the
  // ends. A straight line takes 3 % off waves of 3 m in samples 0.25 m apart, the cubic 0.2 %. Places that follow each other are
  // found at once.
  double at_place(double x) {
    while (next_ < size() && at(next_) <= x) ++next_;
    while (next_ > 0 && at(next_ - 1) > x) --next_;
    if (next_ == 0 || next_ == size()) return nan;
    const double cubic = next_ > 1 && next_ + 1 < size() ? through<4>(next_ - 2, x) : nan;
    return std::isfinite(cubic) ? cubic : through<2>(next_ - 1, x);
  }

 private:
  // Lagrange's polynomial through n samples.
  template <std::size_t n>
  double through(std::size_t first, double x) {
    double sum = 0;
    for (std::size_t i = first; i < first + n; ++i) {
      double weight = 1;
      for (std::size_t k = first; k < first + n; ++k)
        if (k != i) weight *= (x - at(k)) / (at(i) - at(k));
      sum += weight * (*this)[i];
    }
    return sum;
  }

  // Positions that jump are counted on instead.
  double place(std::size_t k) const {
    const records::PlaceMap& places = record_->places();
    if (!record_->resynced()) return places.at(k);
    const double way = places.at(1) < places.at(0) ? -1 : 1;
    return places.at(0) + way * record_->spacing() * static_cast<double>(k);
  }
  std::size_t own(std::size_t i) const { return turned_ ? size() - 1 - i : i; }

  std::unique_ptr<const records::RecordStream> record_;
  std::vector<double> samples_;
  bool turned_ = false;
  std::size_t next_ = 0;
};

struct Compared {
  std::string column;
  std::vector<quality::Section> first, second;
  std::vector<double> correlation, offset;  // of a section; NaN where no window was found
  std::vector<double> jump;                 // m: how much the offset changes near a section
  std::size_t windows = 0, ambiguous = 0;
  double other = 0;  // m: what an offset may be off by
};

Compared compare(const CompareOptions& options, Run& a, Run& b) {
  const auto each = [&](std::ptrdiff_t from, std::span<double> to, const auto& value) {
    for (double& z : to) {
      const bool there = from >= 0 && from < static_cast<std::ptrdiff_t>(a.size());
      z = there ? value(static_cast<std::size_t>(from)) : nan;
      ++from;
    }
  };
  const auto matches = quality::align(
      a.size(),
      [&](std::ptrdiff_t from, std::span<double> to) {
        each(from, to, [&](std::size_t i) { return a[i]; });
      },
      [&](std::ptrdiff_t from, std::span<double> to) {
        each(from, to, [&](std::size_t i) { return b.at_place(a.at(i)); });
      },
      a.record().spacing(), options.alignment);
  if (std::none_of(matches.begin(), matches.end(), [](const quality::Match& m) { return m.found; }))
    throw InputError{
        fmt::format("the second run is nowhere like the first within {:g} m of its place; allowed: "
                    "two runs over one "
                    "line (--reach for larger offsets)",
                    options.alignment.reach)};
  // Windows that fit elsewhere as well.
  Compared result;
  for (const quality::Match& m : matches) {
    result.windows += m.found ? 1 : 0;
    if (!m.found || m.other == 0) continue;
    if (result.ambiguous++ == 0) result.other = std::abs(m.other - m.offset);
  }
  const auto place = [&](std::size_t i) { return a.at(i); };
  quality::Sections first{options.section, place}, second{options.section, place};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double here = a[i];
    const double there = b.at_place(a.at(i) + quality::offset_at(matches, static_cast<double>(i)));
    const bool both = std::isfinite(here) && std::isfinite(there);
    first.push({both ? &here : &nan, 1});
    second.push({both ? &there : &nan, 1});
  }
  result.first = first.all();
  result.second = second.all();
  auto match = matches.begin();
  for (const quality::Section& section : result.first) {
    double worst = 1, sum = 0, n = 0, low = inf, high = -inf;
    const auto see = [&](const quality::Match& m) {
      low = std::min(low, m.offset);
      high = std::max(high, m.offset);
    };
    for (auto before = match; before != matches.begin();)
      if ((--before)->found) {
        see(*before);
        break;
      }
    for (; match != matches.end() && a.at(match->centre) < section.from + options.section;
         ++match) {
      if (!match->found || a.at(match->centre) < section.from) continue;
      worst = std::min(worst, match->correlation);
      sum += match->offset;
      ++n;
      see(*match);
    }
    if (const auto after =
            std::find_if(match, matches.end(), [](const auto& m) { return m.found; });
        after != matches.end())
      see(*after);
    result.jump.push_back(std::max(0.0, high - low));
    result.correlation.push_back(n > 0 ? worst : nan);
    result.offset.push_back(n > 0 ? sum / n : nan);
  }
  return result;
}

struct Growth {
  double from = 0, before = nan, after = nan, growth = nan;  // m
  const char* reason = "";                                   // why there is none
};

std::vector<Growth> growths(const Compared& c) {
  std::vector<Growth> all;
  for (std::size_t i = 0; i < c.first.size(); ++i) {
    Growth g{.from = c.first[i].from};
    if (const auto sd = c.first[i].deviation()) g.before = *sd;
    if (const auto sd = c.second[i].deviation()) g.after = *sd;
    g.reason = 2 * c.first[i].missing > c.first[i].samples ? "too little is in both runs"
               : std::isnan(c.correlation[i])              ? "not like the first run"
               : c.jump[i] > offset_jumps                  ? "the offset jumps"
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

struct Pair {
  Run first, second;
  Compared compared;
};

void add_column(tool::Summary& s, const CompareOptions& options, const Pair& pair, bool several) {
  const Compared& c = pair.compared;
  const std::string before = several ? c.column + ": " : "";
  const auto key = [&](const std::string& text) { return tools::key_of(c.column, text, several); };
  std::vector<Growth> all = growths(c);
  flag_not_judged(s, all, before, key("not-found"));
  if (c.ambiguous > 0)
    s.warn(
        key("ambiguous"),
        fmt::format("{}{} of {} windows fit as well {:.4g} m further: the record repeats itself, "
                    "and the offset may be another",
                    before, c.ambiguous, c.windows, c.other));
  s.add(key("second_missing"), before + "samples missing in the second run",
        static_cast<double>(pair.second.record().missing()), "");
  s.add(key("sections"), "sections", static_cast<double>(c.first.size()), "",
        fmt::format("of {:g} m", options.section));
  std::erase_if(all, [](const Growth& g) { return std::isnan(g.growth); });
  s.add(key("compared"), "  found in both runs", static_cast<double>(all.size()), "");
  double low = 0, high = 0;
  bool any = false;
  for (const double offset : c.offset)
    if (!std::isnan(offset)) {
      low = any ? std::min(low, offset) : offset;
      high = any ? std::max(high, offset) : offset;
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

tool::Summary summary_of(const CompareOptions& options, const std::deque<Pair>& pairs) {
  const auto& files = options.record.batch.files;
  tool::Summary s{fmt::format("growth from {} to {}", files[0].string(), files[1].string())};
  const bool several = pairs.size() > 1;
  tools::add_record(s, pairs.front().first.record());
  for (const Pair& pair : pairs) {
    if (&pair != &pairs.front())
      tools::add_warnings(s, pair.first.record(), pair.compared.column, several);
    for (const units::Warning& warning : pair.second.record().warnings())
      s.warn(tools::key_of(pair.compared.column, "second-" + warning.key, several),
             "the second run: " + (several ? pair.compared.column + ": " : "") + warning.text);
  }
  for (const Pair& pair : pairs) add_column(s, options, pair, several);
  return s;
}

std::string table_of(const CompareOptions& options, const std::deque<Pair>& pairs) {
  std::string text =
      "from_m,to_m,before_mm,after_mm,growth_mm,offset_m,correlation,missing,column,not_judged\n";
  for (const Pair& pair : pairs) {
    const Compared& c = pair.compared;
    const auto all = growths(c);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Growth& g = all[i];
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{}\n", table::csv_number(g.from),
                      table::csv_number(g.from + options.section), table::csv_number(g.before / mm),
                      table::csv_number(g.after / mm), table::csv_number(g.growth / mm),
                      table::csv_number(c.offset[i]), table::csv_number(c.correlation[i]),
                      c.first[i].missing, table::csv_cell(c.column), g.reason);
    }
  }
  return text;
}

// Both runs of each column, section by section.
std::string picture_of(const CompareOptions& options, const std::deque<Pair>& pairs) {
  std::string text;
  for (const Pair& pair : pairs)
    for (const bool second : {false, true}) {
      if (!text.empty()) text += "\n\n";
      text += fmt::format(
          "distance_km,deviation_mm,{}\n",
          table::csv_cell(pair.compared.column + (second ? ", second run" : ", first run")));
      for (const Growth& g : growths(pair.compared))
        for (const double at : {g.from, g.from + options.section})
          text += fmt::format("{:.8g},{},\n", at / units::kilometre,
                              table::csv_number((second ? g.after : g.before) / mm));
    }
  return text + "\n";
}

void compare_runs(const CompareOptions& options) {
  const auto& files = options.record.batch.files;
  if (files.size() != 2)
    throw InputError{
        fmt::format("{} records are given; allowed: 2, the earlier run first", files.size())};
  tool::OutFolder out(options.out, {"compare.csv", "warnings.csv", "compare.json", "compare.png"});
  std::deque<Pair> pairs;
  for (const std::string& column : options.record.columns) {
    pairs.push_back({{options, files[0], column}, {options, files[1], column}, {}});
    pairs.back().compared = compare(options, pairs.back().first, pairs.back().second);
    pairs.back().compared.column = column;
  }
  const tool::Summary summary = summary_of(options, pairs);
  summary.print();
  if (out) {
    std::string warnings = std::string{"run,"} + tools::warnings_header;
    for (const Pair& pair : pairs) {
      warnings += tools::warning_rows(pair.compared.column, pair.first.record(), "1,");
      warnings += tools::warning_rows(pair.compared.column, pair.second.record(), "2,");
    }
    out.add("warnings.csv", warnings);
    out.add("compare.csv", table_of(options, pairs));
    out.add("compare.json", summary.json());
    out.scratch("picture.csv", picture_of(options, pairs));
    out.figure(tools::scripts("quality") / "measures.gp", {"picture.csv"}, "compare.png");
  }
  out.commit();
}

}  // namespace

tool::Tool compare_tool() {
  return {
      "compare", "two runs over one line: offsets, and growth of each section",
      [](tool::OptionParser& o) {
        auto options = std::make_shared<CompareOptions>();
        tools::add_record_options(o, options->record);
        o.quantity("--section", options->section, units::length, "length of a section", {1, 1e6});
        o.quantity("--window", options->alignment.window, units::length,
                   "of the first run that is looked for in the second", {10, 1e4});
        o.quantity("--reach", options->alignment.reach, units::length,
                   "to either side of its place", {1, 1e3});
        o.out(options->out);
        o.help(std::string{tools::record_help} +
               "\n\ncompare.csv has a row a section of the first run: before_mm and after_mm are "
               "its standard deviations in D1 (3 to 25 m)\n"
               "in the first and the second run, growth_mm the second less the first. offset_m "
               "is positive where the second run\n"
               "gives the same track a larger position. correlation is that of the worst window "
               "(1: alike); missing counts samples\n"
               "that one of the runs lacks; not_judged says why there is no growth."
               "\n\nExample: railbook quality compare spring.csv autumn.csv --column profile "
               "--out mine");
        return [options] { compare_runs(*options); };
      }};
}

}  // namespace railbook::quality_tool
