/* What the tool says of a record: the numbers, the worst places, the segments. */
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <railbook/filters/fir_filter.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/digits.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/warning.hpp>

#include "quality/column_names.hpp"
#include "quality/index_parts.hpp"

namespace railbook::quality_tool {

double unsure_margin(const quality::Descriptor& d, const filters::FilterTaps& taps) {
  const auto& own = d.stroke ? d.stroke->suspension : suspension(d.force->car);
  return std::max(d.speed / own.frequency, quality::end_effect(taps, quality::Envelope{d}));
}

std::vector<Place> places(const quality::IndexBuilder& builder, const records::RecordStream& record,
                          const quality::Descriptor& d, double spacing, double margin) {
  std::vector<Place> result;
  for (const quality::Exceedance& e : builder.exceedances()) {
    const double phi = 1 / std::max(e.wavelength, e.length);  // a lone sample has no wavelength
    const bool force = d.force && (!d.stroke || severity(*d.force, d.speed, phi) >
                                                    severity(*d.stroke, d.speed, phi));
    result.push_back({e, record.places().at(static_cast<std::size_t>(std::lround(e.at / spacing))),
                      e.cut || e.clear < margin, force ? "wheel force" : "stroke"});
  }
  return result;
}

namespace {

struct Class {
  const quality::Segment* segment;
  std::size_t faulty = 0;  // samples taken out
  bool whole = true;       // none is missing, bridged or taken out
  const char* name = "";
};

// accept below T_1, repair above T_2, unsure where T_2 is passed only near an end or a gap; what
// has not been measured whole cannot be accepted or watched.
std::vector<Class> classes(const IndexAnswer& a) {
  std::vector<Class> result;
  const std::vector<records::FaultyStretch>& faults = a.record.faults();
  auto fault = faults.begin();
  auto place = a.found.begin();
  std::size_t first = 0;
  for (const quality::Segment& s : a.builder.segments()) {
    const auto here = [&](const Place& p) {
      return s.from ==
             a.options.segment * std::floor((p.at + 1e-6 * a.record.spacing()) / a.options.segment);
    };
    const bool above = s.sums.largest > a.options.threshold;
    bool none = true, sure = false;
    for (; place != a.found.end() && here(*place); ++place)
      none = false, sure = sure || !place->unsure;
    if (none)  // the wave has its peak in a neighbour
      sure = (place != a.found.begin() && !std::prev(place)->unsure) ||
             (place != a.found.end() && !place->unsure);
    Class c{&s};
    c.whole = a.record.unread(first, s.sums.samples) == 0;
    c.name = above                                  ? (sure ? "repair" : "unsure")
             : 2 * s.sums.missing >= s.sums.samples ? "missing"
             : !c.whole                             ? "incomplete"
             : s.sums.largest > a.options.accept    ? "watch"
                                                    : "accept";
    const std::size_t end = first + s.sums.samples;
    while (fault != faults.end() && fault->first + fault->count <= first) ++fault;
    for (auto f = fault; f != faults.end() && f->first < end; ++f)
      if (f->taken_out) c.faulty += std::min(end, f->first + f->count) - std::max(first, f->first);
    first = end;
    result.push_back(c);
  }
  return result;
}

void add_segments(tool::Summary& s, const IndexAnswer& a) {
  const std::vector<Class> all = classes(a);
  const auto add = [&](const char* name, const std::string& note) {
    const auto count = std::count_if(all.begin(), all.end(),
                                     [&](const Class& c) { return std::string{c.name} == name; });
    s.add(fmt::format("segments_{}", name), fmt::format("  {}", name), static_cast<double>(count),
          "", note);
  };
  s.add("segments", "segments", static_cast<double>(all.size()), "",
        fmt::format("of {:g} m", a.options.segment));
  add("watch", fmt::format("beyond {:g}", a.options.accept));
  add("repair", fmt::format("beyond {:g}", a.options.threshold));
  add("unsure", "beyond it near an end or a gap only");
  add("missing", "half of it and more was not measured");
  add("incomplete", "something in it is missing, bridged or taken out, and the rest is not beyond");
}

void add_worst(tool::Summary& s, std::vector<Place> found) {
  std::sort(found.begin(), found.end(),
            [](const Place& a, const Place& b) { return std::abs(a.e.peak) > std::abs(b.e.peak); });
  for (std::size_t i = 0; i < std::min<std::size_t>(5, found.size()); ++i)
    s.add(
        fmt::format("worst_{}", i + 1), i == 0 ? "worst" : "",
        fmt::format("{:+.3f} at {:.1f} m, wavelength {:.1f} m, {}{}", found[i].e.peak, found[i].at,
                    found[i].e.wavelength, found[i].limit, found[i].unsure ? ", unsure" : ""));
}

// Of a column that does not hold the heights of the rail, all waves of them.
std::vector<units::Warning> content_warnings(const IndexAnswer& a) {
  const std::string& column = a.options.record.columns.front();
  const std::string& header = a.record.header();
  const auto low = [&](const std::string& what) {
    return std::vector<units::Warning>{
        {"filtered",
         fmt::format("column {} {}: the descriptor needs the heights of the rail as they "
                     "are, and comes out too low",
                     column, what)}};
  };
  if (const auto band = band_in_name(header))
    return low("is filtered to " + *band + ", by its name");
  if (const auto longest = high_pass_in_name(header))
    return low(fmt::format("has only waves shorter than {} m, by its name", *longest));
  if (is_offset_by_name(header))
    return {
        {"offset", fmt::format("column {} is the offset of a chord, by its name: the descriptor "
                               "needs the heights of the rail, and is wrong",
                               column)}};
  if (a.short_waves)
    return low(
        fmt::format("has hardly any waves longer than 25 m (D2 is {:.0f} % of D1), as one "
                    "that is filtered to D1",
                    100 * *a.short_waves));
  return {};
}

// No index is stated for a segment that was not read whole; its largest value is what was seen.
quality::QualityIndex index_of(const Class& c, quality::QualityIndex q) {
  if (!c.whole) q.mean = q.deviation = q.rms = q.above_per_km = std::nan("");
  return q;
}

}  // namespace

tool::Summary summary_of(const IndexAnswer& answer) {
  const auto& [options, d, record, taps, shortest, builder, found, short_waves] = answer;
  const quality::QualityIndex q = builder.index();
  tool::Summary s{"track quality of " + options.record.batch.only().string()};
  add_car(s, d);
  tools::add_record(s, record);
  for (const auto& [key, text] : content_warnings(answer)) s.warn(key, text);
  s.add("shortest_m", "shortest wavelength", shortest, "m");
  s.add_error("gain_error", "filter gain wrong by at most", taps.gain_error, "",
              fmt::format("at {:.3g} m", taps.worst_at));
  s.add("unsure", "fraction near an end or a gap", builder.unsure(), "", "");
  if (builder.unsure() > 0.5)
    s.warn("guessed",
           "the descriptor is mostly guessed: the record is near an end or a gap nearly "
           "everywhere");
  s.add("mean", "mean of the magnitude", q.mean, "");
  s.add("deviation", "standard deviation", q.deviation, "");
  s.add("rms", "rms of the descriptor", q.rms, "");
  s.add("largest", "largest", q.largest, "");
  if (q.largest > 50)
    s.warn("largest",
           fmt::format("the descriptor reaches {:.3g} times the limit: is the unit of the "
                       "column right?",
                       q.largest));
  if (std::isfinite(q.margin)) s.add("n", "n of threshold = mean + n deviation", q.margin, "");
  s.add("above_per_km", "values above the threshold", q.above_per_km, "1/km",
        fmt::format("threshold {:g}", options.threshold));
  s.add("exceedances", "exceedances", static_cast<double>(found.size()), "",
        tool::to_text(q.exceedances_per_km) + " per km");
  add_segments(s, answer);
  add_worst(s, found);
  return s;
}

void add_rows(std::vector<tool::Row>& rows, const IndexAnswer& a, const std::string& column) {
  const auto add_index = [&](tool::Row& row, const quality::QualityIndex& q, std::size_t places) {
    row.add("mean", q.mean);
    row.add("deviation", q.deviation);
    row.add("rms", q.rms);
    row.add("largest", q.largest);
    row.add("above_per_km", q.above_per_km);
    row.add("exceedances", static_cast<double>(places));
  };
  tool::Row& record = rows.emplace_back();
  record.add("kind", "record");
  record.add("column", column);
  tools::add_record(record, a.record);
  for (const auto& [key, text] : content_warnings(a)) record.warn(key);
  add_index(record, a.builder.index(), a.found.size());
  record.add("unsure", a.builder.unsure());
  for (const Class& c : classes(a)) {
    tool::Row& row = rows.emplace_back();
    const quality::QualityIndex q = c.segment->sums.index(a.record.spacing(), a.options.threshold);
    row.add("kind", "section");
    row.add("column", column);
    row.add("from_m", c.segment->from);
    row.add("to_m", c.segment->from + a.options.segment);
    row.add("samples", static_cast<double>(q.samples));
    row.add("missing", static_cast<double>(q.missing));
    row.add("faulty", static_cast<double>(c.faulty));
    add_index(row, index_of(c, q), c.segment->sums.exceedances);
    row.add("class", c.name);
  }
}

namespace {

void write_segments(tool::OutFolder& out, const IndexAnswer& a) {
  std::string text =
      "from_m,to_m,samples,missing,faulty,mean,deviation,rms,largest,above_per_km,exceedances,"
      "class\n";
  for (const Class& c : classes(a)) {
    const quality::QualityIndex q =
        index_of(c, c.segment->sums.index(a.record.spacing(), a.options.threshold));
    text += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n",
                        table::csv_number(c.segment->from),
                        table::csv_number(c.segment->from + a.options.segment), q.samples,
                        q.missing, c.faulty, q.mean, q.deviation, q.rms, q.largest, q.above_per_km,
                        c.segment->sums.exceedances, c.name);
  }
  out.add("segments.csv", text);
}

}  // namespace

void write_lists(tool::OutFolder& out, const IndexAnswer& answer) {
  std::string list = "distance_m,descriptor,wavelength_m,length_m,limit,unsure\n";
  for (const Place& p : answer.found)
    list += fmt::format("{},{:.6g},{:.6g},{:.6g},{},{}\n", table::csv_number(p.at), p.e.peak,
                        p.e.wavelength, p.e.length, p.limit, p.unsure ? "yes" : "no");
  out.add("exceedances.csv", list);
  std::string bars = "descriptor,samples\n";
  for (std::size_t i = 0; i < answer.builder.histogram().size(); ++i)
    bars += fmt::format("{:.2f},{}\n", (static_cast<double>(i) + 0.5) * quality::IndexBuilder::bin,
                        answer.builder.histogram()[i]);
  out.add("histogram.csv", bars);
  write_segments(out, answer);
  out.add("threshold.csv",
          fmt::format("threshold,shortest_m,places\n{:g},{:g},{}\n", answer.options.threshold,
                      answer.shortest, answer.found.size()));
}

}  // namespace railbook::quality_tool
