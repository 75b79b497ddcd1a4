/* ### `quality index`

The descriptor of a record of your own, at the posted speed and for your car:

    quality index track.csv --speed 100km/h --car chapters/06-quality/examples/freight.toml --out mine
    quality index chapters/06-quality/examples/track.csv --speed 64km/h --column crosslevel

The record is a CSV file with a column of positions and one of heights, units in their headers (`distance_m,profile_mm`). It is read once and held in memory, 8 bytes
a sample. Empty cells and `nan` are gaps: those of up to 1 m are bridged (`--bridge` says otherwise), others divide the record. Codes for lost samples, outliers, stuck sensors and steps of the datum are found, taken out
as gaps and told above the answer as doubtful, and so are a spacing that changes (places stay true to a sample) and heights in another unit than said. The answer names each place where the magnitude of the descriptor passes `--threshold`, the paper's $T_2$, with the
wavelength there, twice the distance of the neighbouring zeros, and the limit that counts at that wavelength. Places within a resonant wavelength of an end or of a gap are marked: there the filter had to guess.
For the planner the record is cut at multiples of `--segment`, each piece with an index of its own and a class: *accept* below $T_1$ (`--accept`), *repair* above $T_2$, *watch* between them, and *unsure* where it passes $T_2$ only where the filter had to guess. The
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
#include "table/csv.hpp"
#include "tool/out_folder.hpp"
#include "tools.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::quality_tool {

namespace {

constexpr std::size_t most_samples = 100'000'000;

// The record in memory, so that the file is read once.
struct Track {
  std::unique_ptr<const spectra::RecordStream> record;
  std::vector<double> heights;
};
Track read(const spectra::RecordFile& file) {
  Track track;
  track.record = spectra::read_record(file, [&](std::span<const double> piece, double) {
    if (track.heights.size() + piece.size() > most_samples)
      throw InputError{
          fmt::format("the record has over {:g} samples; allowed: as many, which take "
                      "800 MB; cut it",
                      static_cast<double>(most_samples))};
    track.heights.insert(track.heights.end(), piece.begin(), piece.end());
  });
  return track;
}

/* The channel is written as it comes; the figure keeps the extremes of a thousand pieces. */
class Channel {
 public:
  Channel(tool::OutFolder& out, const spectra::RecordStream& record)
      : record_(record), low_(pieces, 0.0), high_(pieces, 0.0) {
    if (!out) return;
    file_ = &out.stream("channel.csv");
    file_->write("distance_m,descriptor\n");
  }

  void push(std::span<const double> p) {
    for (const double value : p) {
      const std::size_t piece = at_ * pieces / record_.samples();
      if (!std::isnan(value)) {
        low_[piece] = std::min(low_[piece], value);
        high_[piece] = std::max(high_[piece], value);
      }
      if (file_ != nullptr)
        file_->write(fmt::format("{},{}\n", table::csv_number(record_.places().at(at_)),
                                 table::csv_number(value)));
      ++at_;
    }
  }

  std::string extremes() const {
    std::string text = "distance_km,low,high\n";
    for (std::size_t i = 0; i < std::min<std::size_t>(pieces, record_.samples()); ++i)
      text += fmt::format("{:.8g},{:.6g},{:.6g}\n",
                          record_.places().at(i * record_.samples() / pieces) / units::kilometre,
                          low_[i], high_[i]);
    return text;
  }

 private:
  static constexpr std::size_t pieces = 1000;
  const spectra::RecordStream& record_;
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
  const Track track = read(tools::record_file(wish.record));
  const spectra::RecordStream& record = *track.record;
  const double shortest = shortest_wave(wish, d, record.spacing());
  const auto taps = quality::design_filter(quality::Envelope{d},
                                           {.spacing = record.spacing(), .shortest = shortest});
  quality::IndexBuilder builder{{.spacing = record.spacing(),
                                 .threshold = wish.threshold,
                                 .place = [&](std::size_t i) { return record.places().at(i); },
                                 .segment = wish.segment,
                                 .margin = resonant_wave(d)}};
  Channel channel{out, record};
  quality::FilterStream stream{taps, [&](std::span<const double> p) {
                                 builder.push(p);
                                 channel.push(p);
                               }};
  stream.push(track.heights);
  stream.finish();
  builder.finish();
  const auto found = places(builder, record, d);
  const IndexAnswer answer{wish, d, record, taps, shortest, builder, found};
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
            tools::add_record_options(o, wish->record);
            add_car_options(o, wish->car);
            o.quantity("--shortest", wish->shortest, units::length,
                       "waves below this are left out; without it 1 m with wheel force, 0 without",
                       tool::non_negative);
            o.quantity("--threshold", wish->threshold, units::number,
                       "T_2, above which a place is listed", tool::positive);
            o.quantity("--accept", wish->accept, units::number,
                       "T_1, below which a segment is as good as new", tool::positive);
            o.quantity("--segment", wish->segment, units::length,
                       "length of the pieces that have an index of their own", {1, 1e6});
            o.out(wish->out);
            return [wish] { index_track(*wish); };
          }};
}

}  // namespace railbook::quality_tool
