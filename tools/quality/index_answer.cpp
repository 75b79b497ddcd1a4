/* What the tool says of a record: the numbers, the worst places, the segments. */
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quality/index_parts.hpp"
#include "table/csv.hpp"
#include "units/constants.hpp"

namespace railbook::quality_tool {

double resonant_wave(const quality::Descriptor& d) {
  return d.speed / (d.stroke ? d.stroke->suspension.frequency : suspension(d.force->car).frequency);
}

std::vector<Place> places(const quality::IndexBuilder& builder, double first,
                          const quality::Descriptor& d) {
  std::vector<Place> result;
  for (const quality::Exceedance& e : builder.exceedances()) {
    const double phi = 1 / std::max(e.wavelength, e.length);  // a lone sample has no wavelength
    const bool force = d.force && (!d.stroke || severity(*d.force, d.speed, phi) >
                                                    severity(*d.stroke, d.speed, phi));
    result.push_back(
        {e, first + e.at, e.cut || e.clear < resonant_wave(d), force ? "wheel force" : "stroke"});
  }
  return result;
}

namespace {

// accept below T_1, repair above T_2.
const char* class_of(const IndexWish& wish, double largest) {
  return largest > wish.threshold ? "repair" : largest > wish.accept ? "watch" : "accept";
}

void add_segments(tool::Summary& s, const IndexWish& wish, const quality::IndexBuilder& builder) {
  long watch = 0, repair = 0;
  for (const quality::Segment& segment : builder.segments()) {
    const std::string name = class_of(wish, segment.sums.largest);
    watch += name == "watch" ? 1 : 0;
    repair += name == "repair" ? 1 : 0;
  }
  s.add("segments", "segments", static_cast<double>(builder.segments().size()), "",
        fmt::format("of {:g} m", wish.segment));
  s.add("segments_watch", "  to watch", static_cast<double>(watch), "",
        fmt::format("beyond {:g}", wish.accept));
  s.add("segments_repair", "  to repair", static_cast<double>(repair), "",
        fmt::format("beyond {:g}", wish.threshold));
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

}  // namespace

tool::Summary summary_of(const IndexAnswer& answer) {
  const auto& [wish, d, r, taps, shortest, builder, found] = answer;
  const quality::QualityIndex q = builder.index();
  tool::Summary s{"track quality of " + wish.file.string()};
  add_car(s, d);
  s.add("length_km", "length", static_cast<double>(r.samples) * r.spacing / units::kilometre, "km",
        fmt::format("{} samples, {} missing, {} bridged", r.samples, r.missing, r.bridged));
  s.add("spacing_m", "spacing", r.spacing, "m");
  s.add("shortest_m", "shortest wavelength", shortest, "m");
  s.add("gain_error", "filter gain wrong by at most", taps.gain_error, "",
        fmt::format("at {:.3g} m", taps.worst_at));
  s.add("unsure", "share near an end or a gap", builder.unsure(), "",
        builder.unsure() > 0.5 ? "the descriptor is mostly guessed" : "");
  s.add("mean", "mean of the magnitude", q.mean, "");
  s.add("deviation", "standard deviation", q.deviation, "");
  s.add("rms", "rms of the descriptor", q.rms, "");
  s.add("largest", "largest", q.largest, "",
        q.largest > 50 ? "is the unit of the column right?" : "");
  if (std::isfinite(q.margin)) s.add("n", "n of threshold = mean + n deviation", q.margin, "");
  s.add("above_per_km", "values above the threshold", q.above_per_km, "1/km",
        fmt::format("threshold {:g}", wish.threshold));
  s.add("exceedances", "exceedances", static_cast<double>(found.size()), "",
        fmt::format("{:.3g} per km", q.exceedances_per_km));
  add_segments(s, wish, builder);
  add_worst(s, found);
  return s;
}

namespace {

void write_segments(tool::OutFolder& out, const IndexWish& wish, double spacing,
                    const quality::IndexBuilder& builder) {
  std::string text =
      "from_m,to_m,samples,missing,mean,deviation,rms,largest,above_per_km,exceedances,class\n";
  for (const quality::Segment& segment : builder.segments()) {
    const quality::QualityIndex q = segment.sums.index(spacing, wish.threshold);
    text += fmt::format(
        "{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n", table::csv_number(segment.from),
        table::csv_number(segment.from + wish.segment), q.samples, q.missing, q.mean, q.deviation,
        q.rms, q.largest, q.above_per_km, segment.sums.exceedances,
        q.missing == q.samples ? "missing" : class_of(wish, q.largest));
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
  write_segments(out, answer.wish, answer.reading.spacing, answer.builder);
  out.add("threshold.csv",
          fmt::format("threshold,shortest_m,places\n{:g},{:g},{}\n", answer.wish.threshold,
                      answer.shortest, answer.found.size()));
}

}  // namespace railbook::quality_tool
