/* ### `quality index`

The descriptor of a record of your own, at the posted speed and for your car:

    quality index track.csv --speed 100km/h --car examples/quality/freight.toml --out mine
    quality index examples/quality/track.csv --speed 64km/h --column crosslevel

The record is a CSV file with a column of positions and one of heights, units in their headers (`distance_m,profile_mm`). It is read once, in constant memory. Empty cells and `nan` are gaps: those of up to 1 m are bridged (`--bridge` says otherwise), others divide the record. Codes for lost samples and heights that no track can have are taken out as gaps; outliers, stuck sensors and steps of the datum may be defects, are kept unless `--screen` names them,
and are named in warnings above the answer, and so are a spacing that changes (places stay true to a sample) and heights in another unit than said. The answer names each place where the magnitude of the descriptor passes `--threshold`, the paper's $T_2$, with the
wavelength there, twice the distance of the neighbouring zeros, and the limit that counts at that wavelength. Places within a resonant wavelength of an end or of a gap are marked: there the filter had to guess.
For the planner the record is cut at multiples of `--segment`, each piece with an index of its own and a class: *accept* below $T_1$ (`--accept`), *repair* above $T_2$, *watch* between them, *unsure* where it passes $T_2$ only where the filter had to guess, *missing* where half of it and more was not measured and the rest does not pass $T_2$, and *incomplete*, without an index, where anything else in it is missing, bridged or taken out. The
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

#include <railbook/filters/fir_filter.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/tool/batch.hpp>
#include <railbook/tool/out_folder.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "quality/index_parts.hpp"
#include "quality/short_waves.hpp"
#include "tools.hpp"

namespace railbook::quality_tool {

namespace {

/* The channel is written as it comes; the figure keeps the extremes of some thousand pieces, which grow with the record. */
class Channel {
 public:
  explicit Channel(tool::OutFolder* out) {
    if (out == nullptr || !*out) return;
    file_ = &out->stream("channel.csv");
    file_->write("distance_m,descriptor\n");
  }

  void push(std::span<const double> p, const records::PlaceMap& places) {
    if (file_ == nullptr) return;
    for (const double value : p) {
      if (at_ % per_piece_ == 0) pieces_.push_back({places.at(at_), 0, 0});
      if (!std::isnan(value)) {
        pieces_.back().low = std::min(pieces_.back().low, value);
        pieces_.back().high = std::max(pieces_.back().high, value);
      }
      file_->write(
          fmt::format("{},{}\n", table::csv_number(places.at(at_)), table::csv_number(value)));
      ++at_;
      if (pieces_.size() == most && at_ % per_piece_ == 0) halve();
    }
  }

  std::string extremes() const {
    std::string text = "distance_km,low,high\n";
    for (const Piece& piece : pieces_)
      text += fmt::format("{:.8g},{:.6g},{:.6g}\n", piece.from / units::kilometre, piece.low,
                          piece.high);
    return text;
  }

 private:
  struct Piece {
    double from, low, high;
  };
  void halve() {
    for (std::size_t i = 0; i < most / 2; ++i)
      pieces_[i] = {pieces_[2 * i].from, std::min(pieces_[2 * i].low, pieces_[2 * i + 1].low),
                    std::max(pieces_[2 * i].high, pieces_[2 * i + 1].high)};
    pieces_.resize(most / 2);
    per_piece_ *= 2;
  }

  static constexpr std::size_t most = 2000;
  std::vector<Piece> pieces_;
  std::size_t at_ = 0, per_piece_ = 1;
  files::OutFile* file_ = nullptr;
};

// The force grows with the square of the wavenumber: it needs a shortest wave.
double shortest_wave(const IndexOptions& options, const quality::Descriptor& d, double spacing) {
  return options.shortest.value_or(d.force ? std::max(1.0, 2.5 * spacing) : 0);
}

// All that is made of one record as it streams by, at the spacing that its first positions show.
struct Run {
  std::unique_ptr<const records::RecordStream> record;
  double spacing = 0, shortest = 0, margin = 0;
  filters::FilterTaps taps;
  std::optional<quality::IndexBuilder> builder;
  ShortWaves short_waves;
};

Run run_record(const IndexOptions& options, const quality::Descriptor& d,
               const std::filesystem::path& file, Channel& channel) {
  Run run;
  const records::RecordStream* known = nullptr;
  std::optional<filters::FilterStream> stream;
  const auto begin = [&] {
    run.spacing = known->spacing();
    run.shortest = shortest_wave(options, d, run.spacing);
    run.taps = quality::design_filter(quality::Envelope{d},
                                      {.spacing = run.spacing, .shortest = run.shortest});
    run.margin = unsure_margin(d, run.taps);
    run.builder.emplace(
        quality::IndexOptions{.spacing = run.spacing,
                              .threshold = options.threshold,
                              .place = [&known](std::size_t i) { return known->places().at(i); },
                              .segment = options.segment,
                              .margin = run.margin});
    stream.emplace(run.taps, [&](std::span<const double> p) {
      run.builder->push(p);
      channel.push(p, known->places());
    });
  };
  run.record =
      records::read_record(tools::record_file(options.record, file),
                           [&](std::span<const double> piece, const records::RecordStream& record) {
                             known = &record;
                             if (!stream) begin();
                             stream->push(piece);
                             run.short_waves.push(piece, run.spacing);
                           });
  known = run.record.get();
  stream->finish();
  run.builder->finish();
  run.short_waves.finish();
  return run;
}

std::vector<tool::Row> rows_of(const IndexOptions& options, const quality::Descriptor& d,
                               const std::filesystem::path& file) {
  std::vector<tool::Row> rows;
  for (const std::string& column : options.record.columns) {
    IndexOptions one = options;
    one.record.columns = {column};
    Channel none{nullptr};
    const Run run = run_record(one, d, file, none);
    const auto found = places(*run.builder, *run.record, d, run.spacing, run.margin);
    add_rows(
        rows,
        {one, d, *run.record, run.taps, run.shortest, *run.builder, found, run.short_waves.alone()},
        column);
  }
  return rows;
}

void index_track(const IndexOptions& options) {
  if (options.accept > options.threshold)
    throw InputError{fmt::format("accept is {:g}; allowed: at most the threshold, {:g}",
                                 options.accept, options.threshold)};
  const quality::Descriptor d = descriptor(options.car);
  if (options.record.batch.many() || options.record.columns.size() > 1)
    return tool::run_batch(options.record.batch, options.out, "index",
                           [&](const auto& file) { return rows_of(options, d, file); });
  tool::OutFolder out(options.out,
                      {"channel.csv", "exceedances.csv", "histogram.csv", "segments.csv",
                       "threshold.csv", "extremes.csv", "warnings.csv", "index.json", "index.png"});
  Channel channel{&out};
  const Run run = run_record(options, d, options.record.batch.only(), channel);
  const records::RecordStream& record = *run.record;
  const auto found = places(*run.builder, record, d, run.spacing, run.margin);
  const IndexAnswer answer{
      options, d, record, run.taps, run.shortest, *run.builder, found, run.short_waves.alone()};
  const tool::Summary summary = summary_of(answer);
  summary.print();
  if (out) {
    write_lists(out, answer);
    out.add("extremes.csv", channel.extremes());
    out.add("warnings.csv",
            tools::warnings_header + tools::warning_rows(options.record.columns.front(), record));
    out.add("index.json", summary.json());
    out.figure(tools::scripts("quality") / "index.gp",
               {"extremes.csv", "exceedances.csv", "histogram.csv", "threshold.csv"}, "index.png");
  }
  out.commit();
}

}  // namespace

tool::Tool index_tool() {
  return {
      "index", "descriptor, exceedances and index of a track record", [](tool::OptionParser& o) {
        auto options = std::make_shared<IndexOptions>();
        tools::add_record_options(o, options->record);
        add_car_options(o, options->car);
        o.quantity("--shortest", options->shortest, units::length,
                   "waves below this are left out; without it 1 m with wheel force, 0 without",
                   tool::non_negative);
        o.quantity("--threshold", options->threshold, units::number,
                   "T_2, above which a place is listed", tool::positive);
        o.quantity("--accept", options->accept, units::number,
                   "T_1, below which a segment is as good as new", tool::positive);
        o.quantity("--segment", options->segment, units::length,
                   "length of the pieces that have an index of their own", {1, 1e6});
        o.quantity("--section", options->segment, units::length, "the same", {1, 1e6});
        o.out(options->out);
        o.help(
            std::string{tools::record_help} +
            "\n\nThe descriptor is 1 where the car reaches its limit (suspension stroke or wheel "
            "force) on such a wave. In\n"
            "channel.csv and exceedances.csv it has the sign of the filtered column: positive "
            "over what is higher than\n"
            "around it, where up is positive in the file. mean, deviation, rms and largest are "
            "of its magnitude (rms of the\n"
            "value); above_per_km counts samples above the threshold. segments.csv has a row a "
            "segment with its class.\n"
            "segments.csv: faulty counts samples taken out. exceedances.csv: wavelength_m of the "
            "wave "
            "at each place, and unsure, whether\n"
            "it is passed only where the filter had to guess. extremes.csv: low and high, the "
            "least "
            "and the largest value of a\n"
            "piece for the figure; threshold.csv: places, how many pass each threshold. "
            "warnings.csv: column, warning, place, size.\n"
            "\nExample: railbook quality index track.csv --speed 100km/h --column profile "
            "--out mine\n         railbook quality index runs/*.csv --speed 100km/h --section "
            "200m --out mine");
        return [options] { index_track(*options); };
      }};
}

}  // namespace railbook::quality_tool
