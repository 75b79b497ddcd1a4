/* ### `quality index`

The descriptor of a record of your own, at the posted speed and for your car:

    quality index track.csv --speed 100km/h --car chapters/06-quality/examples/freight.toml --out mine
    quality index chapters/06-quality/examples/track.csv --speed 64km/h --column crosslevel

The record is a CSV file with a column of positions and one of heights, units in their headers (`distance_m,profile_mm`). It is read twice, once to check all of it and to learn its spacing, once to filter; memory
grows with the places and segments found only. Empty cells and `nan` are gaps: short ones may be bridged (`--bridge 5`), others divide the record. The answer names each place where the magnitude of the descriptor passes `--threshold`, the paper's $T_2$, with the
wavelength there, twice the distance of the neighbouring zeros, and the limit that counts at that wavelength. Places within a resonant wavelength of an end or of a gap are marked: there the filter had to guess.
For the planner the record is cut at multiples of `--segment`, each piece with an index of its own and a class: *accept* below $T_1$ (`--accept`), *repair* above $T_2$, *watch* between them. The
paper prints no thresholds; ours are 0.5 and 1. With `--out` come the channel, the list of places, the segments, the histogram, a figure, and the index as JSON.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quality/index_parts.hpp"
#include "spectra/record.hpp"
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tools.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::quality_tool {

namespace {

// A column that must be a length, and what one of its unit is in metres.
struct Column {
  std::size_t index;
  double metre;
};
Column length_column(const table::CsvReader& reader, const std::string& name) {
  const std::size_t index = reader.column(name);
  const units::Header header = units::parse_header(reader.header()[index]);
  if (header.unit_text.empty() || !(header.unit.dimension == units::length))
    throw InputError{fmt::format("column \"{}\" names no length; allowed: a header such as {}_mm",
                                 reader.header()[index], name)};
  return {index, header.unit.si};
}

// The whole file through the checks of a record stream.
Reading read(const IndexWish& wish, std::function<void(std::span<const double>)> sink) {
  table::CsvReader reader{wish.file};
  const Column column = length_column(reader, wish.column);
  std::optional<Column> positions;
  if (!wish.spacing) positions = length_column(reader, wish.distance);
  spectra::RecordStream record{
      {.spacing = wish.spacing, .bridge = static_cast<std::size_t>(wish.bridge)}, std::move(sink)};
  Reading result;
  std::vector<std::string> cells;
  for (bool first = true; reader.next(cells); first = false) {
    const double value = reader.number(cells, column.index) * column.metre;
    if (!positions) {
      record.add(value);
      continue;
    }
    const double at = reader.number(cells, positions->index) * positions->metre;
    if (first) result.first = at;
    record.add(at, value);
  }
  record.finish();
  result.spacing = record.spacing();
  result.samples = record.samples();
  result.missing = record.missing();
  result.bridged = record.bridged();
  return result;
}

/* The channel is written as it comes; the figure keeps the extremes of a thousand pieces. */
class Channel {
 public:
  Channel(tool::OutFolder& out, const Reading& reading)
      : reading_(reading), low_(pieces, 0.0), high_(pieces, 0.0) {
    if (!out) return;
    file_ = &out.stream("channel.csv");
    file_->write("distance_m,descriptor\n");
  }

  void push(std::span<const double> p) {
    for (const double value : p) {
      const std::size_t piece = at_ * pieces / reading_.samples;
      if (!std::isnan(value)) {
        low_[piece] = std::min(low_[piece], value);
        high_[piece] = std::max(high_[piece], value);
      }
      if (file_ != nullptr)
        file_->write(fmt::format(
            "{},{}\n",
            table::csv_number(reading_.first + static_cast<double>(at_) * reading_.spacing),
            table::csv_number(value)));
      ++at_;
    }
  }

  std::string extremes() const {
    std::string text = "distance_km,low,high\n";
    const double step = reading_.spacing * static_cast<double>(reading_.samples) / pieces;
    for (std::size_t i = 0; i < std::min<std::size_t>(pieces, reading_.samples); ++i)
      text += fmt::format("{:.8g},{:.6g},{:.6g}\n",
                          (reading_.first + step * static_cast<double>(i)) / units::kilometre,
                          low_[i], high_[i]);
    return text;
  }

 private:
  static constexpr std::size_t pieces = 1000;
  Reading reading_;
  std::vector<double> low_, high_;
  files::OutFile* file_ = nullptr;
  std::size_t at_ = 0;
};

// The force grows with the square of the wavenumber: it needs a shortest wave.
double shortest_wave(const IndexWish& wish, const quality::Descriptor& d, double spacing) {
  return wish.shortest.value_or(d.force ? std::max(1.0, 2.5 * spacing) : 0);
}

void index_track(const IndexWish& wish) {
  tool::OutFolder out(wish.out, {"channel.csv", "exceedances.csv", "histogram.csv", "segments.csv",
                                 "threshold.csv", "extremes.csv", "index.json", "index.png"});
  if (wish.accept > wish.threshold)
    throw InputError{fmt::format("accept is {:g}; allowed: at most the threshold, {:g}",
                                 wish.accept, wish.threshold)};
  const quality::Descriptor d = descriptor(wish.car);
  const Reading reading = read(wish, [](std::span<const double>) {});
  const double shortest = shortest_wave(wish, d, reading.spacing);
  const auto taps = quality::design_filter(quality::Envelope{d},
                                           {.spacing = reading.spacing, .shortest = shortest});
  quality::IndexBuilder builder{{.spacing = reading.spacing,
                                 .threshold = wish.threshold,
                                 .origin = reading.first,
                                 .segment = wish.segment,
                                 .margin = resonant_wave(d)}};
  Channel channel{out, reading};
  quality::FilterStream stream{taps, [&](std::span<const double> p) {
                                 builder.push(p);
                                 channel.push(p);
                               }};
  read(wish, [&](std::span<const double> piece) { stream.push(piece); });
  stream.finish();
  builder.finish();
  const auto found = places(builder, reading.first, d);
  const IndexAnswer answer{wish, d, reading, taps, shortest, builder, found};
  const tool::Summary summary = summary_of(answer);
  summary.print();
  if (out) {
    write_lists(out, answer);
    out.add("extremes.csv", channel.extremes());
    out.add("index.json", summary.json());
    out.figure(tools::scripts("quality") / "index.gp",
               {"extremes.csv", "exceedances.csv", "histogram.csv", "threshold.csv"}, "index.png");
  }
  out.commit();
}

}  // namespace

tool::Tool index_tool() {
  return {"index", "descriptor, exceedances and index of a track record", [](tool::Options& o) {
            auto wish = std::make_shared<IndexWish>();
            o.file("record", wish->file, "CSV file with a column of heights");
            o.required();
            add_car_options(o, wish->car);
            o.text("--column", wish->column, "name of that column, with or without its unit");
            o.text("--distance", wish->distance, "column of positions along the track");
            o.quantity("--spacing", wish->spacing, units::length,
                       "distance between samples, instead of positions", tool::positive);
            o.quantity("--shortest", wish->shortest, units::length,
                       "waves below this are left out; without it 1 m with wheel force, 0 without",
                       tool::non_negative);
            o.quantity("--threshold", wish->threshold, units::number,
                       "T_2, above which a place is listed", tool::positive);
            o.quantity("--accept", wish->accept, units::number,
                       "T_1, below which a segment is as good as new", tool::positive);
            o.quantity("--segment", wish->segment, units::length,
                       "length of the pieces that have an index of their own", {1, 1e6});
            o.count("--bridge", wish->bridge,
                    "longest gap, in samples, to bridge by a straight line", 0, 1000);
            o.out(wish->out);
            return [wish] { index_track(*wish); };
          }};
}

}  // namespace railbook::quality_tool
