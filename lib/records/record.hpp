// A track record on its way from a file into an estimate: placed, judged, gaps marked or bridged.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <railbook/records/places.hpp>
#include <railbook/records/screen.hpp>
#include <railbook/units/warning.hpp>

namespace railbook::records {

// Where positions turn back, repeat, or leave their grid: the record is refused, goes on behind a
// gap of one sample, or its samples are counted on as if the spacing held.
enum class Resync { refuse, cut, count };

struct RecordOptions {
  std::optional<double> spacing = {};  // m; without it, from the positions
  // Gaps of up to so many samples, or of up to this length, are bridged by a straight line; longer
  // ones are NaN.
  std::size_t bridge = 0;
  double bridge_length = 0;  // m
  Screening screening = {};
  double unit = 1;  // m, of one in the file's numbers: codes are known by their digits
  Resync resync = Resync::refuse;
  std::string header = {};  // of its column in a file
  std::string si = "m";     // SI unit of the values, for warnings; only heights are judged as track
};

// A place that a warning is about.
struct SuspectPlace {
  std::string key;          // of the warning
  double from = 0, to = 0;  // m
  std::size_t samples = 0;
  // m, or the SI unit of the values: the value, the height of a step, the jump of a position (m);
  // NaN for none
  double size = 0;
  bool taken_out = false;
  std::string option;  // that takes it out, or keeps it
};

struct Stretch {
  std::size_t first = 0, count = 0;  // samples
};

// Takes samples, with their positions or without, and hands an evenly spaced record on to `sink` in
// pieces. Positions ascend or descend. One must come a whole number of spacings after the last (to
// a quarter of one); more than one leaves a gap. Where the recorder rounds positions to more than a
// twentieth of a spacing (to .1 m, to whole metres; not to nearly a spacing, which looks like
// samples lost), they are met by the even grid through those before them. Samples taken out (see
// Screen) are gaps, too; warnings() and suspect_places() list them and what is only suspected. A
// sample without a position is left out. The memory is some thousand samples, and a few words for
// each suspected stretch, gap and change of spacing.
class RecordStream {
 public:
  // Throws InputError when a given spacing is not positive.
  RecordStream(const RecordOptions& options, std::function<void(std::span<const double>)> sink);
  RecordStream(const RecordStream&) = delete;
  RecordStream& operator=(const RecordStream&) = delete;

  // The next samples; NaN where one is missing. Either all samples have a position or none. Throws
  // InputError naming the sample when a value is beyond 10^6 m, and, unless `resync` goes on there,
  // when positions turn back, repeat or are not even, or when gaps come to more than 10^6 spacings
  // and twenty times the samples there are. Throws as well when each position comes several times
  // with heights of several records, and no spacing is given that says otherwise.
  void add(std::span<const double> values);
  void add(std::span<const double> positions, std::span<const double> values);  // as many
  void add(double value) { add({&value, 1}); }
  void add(double position, double value) { add({&position, 1}, {&value, 1}); }

  // Hands on what is left. Throws InputError when the spacing is unknown (no positions and none
  // given), when the positions' own differs by over 0.5 % from the one given or changes by over 2 %
  // on the way, when no sample is finite, or when all finite ones are equal.
  void finish();

  const std::string& header() const { return options_.header; }
  double spacing() const { return spacing_; }       // m; the positions' own where there are any
  std::size_t samples() const { return samples_; }  // handed on
  std::size_t missing() const { return missing_; }  // of them NaN: not there, or taken out
  std::size_t faulty() const { return faulty_; }    // taken out, see faults()
  std::size_t bridged() const { return bridged_; }  // not there or taken out, and bridged
  const std::vector<FaultyStretch>& faults() const { return screen_.faults(); }
  // Samples not as they were read: missing, bridged or taken out; in order.
  const std::vector<Stretch>& unread() const { return unread_; }
  // How many samples of [first, first + count) have one of them within `reach` samples.
  std::size_t unread(std::size_t first, std::size_t count, std::size_t reach = 0) const;
  bool resynced() const { return cuts_ + counted_ > 0; }
  const PlaceMap& places() const { return places_; }

  // The roughness A (m^2 cycle/m) of a profile S = A/phi^2 that leaves a chord of 20 m as much:
  // whether the unit can be right. 0 where fewer than 100 offsets are known.
  double roughness() const;

  // After finish(): what was found, each kind once; spacing that changes by over 0.3 %; a roughness
  // no track has.
  std::vector<units::Warning> warnings() const;
  // One more, of what was done before the samples came.
  void note(units::Warning warning) { notes_.push_back(std::move(warning)); }
  std::vector<SuspectPlace> suspect_places() const;

 private:
  struct Sample {
    double position, value;
  };
  void settle_spacing();
  void refuse_several_records(const std::vector<double>& steps) const;
  void fit_grid();
  void resync(const Sample& sample, const std::string& why);
  std::size_t go_on(std::span<const double> positions);
  void place(const Sample& sample);
  void take(std::span<const double> values);
  void join(std::span<const double> values);
  void close_gap(double value);
  void put(double value) { put({&value, 1}); }
  void put(std::span<const double> values);
  void compare(std::span<const double> values);

  RecordOptions options_;
  std::function<void(std::span<const double>)> sink_;
  Screen screen_;
  PlaceMap places_;
  double spacing_ = 0;
  std::vector<Sample> first_;  // until the spacing is known
  std::vector<double> ready_;  // to be handed on
  std::size_t taken_ = 0;      // samples added
  std::size_t placed_ = 0;     // of them, not waiting for the spacing
  std::size_t steps_ = 0;      // spacings from the first position to the last
  bool settled_ = false, positions_ = false;
  double first_position_ = 0, last_position_ = 0;  // as all inside, in the direction of travel
  std::size_t first_step_ = 0;                     // of the part since the last cut
  std::vector<units::Warning> notes_;
  double length_ = 0;        // m, of the parts before it
  std::size_t lengths_ = 0;  // their steps
  bool fresh_ = false;       // the next sample tells the part's direction
  std::size_t cuts_ = 0, counted_ = 0, unplaced_ = 0;
  std::vector<SuspectPlace> counts_;
  std::optional<double> whole_kilometre_;  // where a gap ends at one
  double direction_ = 1;                   // -1: positions descend
  double rounding_ = 0,
         grid_ = 0;  // of positions, m, where it matters; the place of the last sample
  bool any_ = false, varies_ = false;  // finite samples; they differ
  double first_value_ = 0;

  std::size_t gap_ = 0;  // missing or faulty samples since the last good one
  bool begun_ = false;   // a good sample has come
  bool cut_ = false;     // the level steps in the gap
  std::size_t joined_ = 0, fault_ = 0;
  double last_value_ = 0;  // the last good one
  std::size_t samples_ = 0, missing_ = 0, bridged_ = 0, faulty_ = 0;
  std::vector<Stretch> unread_;
  std::vector<double> past_;  // 20 m of samples, behind some that are older
  std::size_t reach_ = 0;     // how many samples these are
  double moved_ = 0;          // sum of squared offsets of their middle
  double moved_inner_ = 0;    // the same of a chord of 11.6 m: a wave may vanish in one of them
  std::size_t moves_ = 0;
};

}  // namespace railbook::records
