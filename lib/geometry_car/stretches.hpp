// A record of any length, row by row, in the memory of one stretch of it.
//
//   Stretches stretches{processing, [&](const Stretch& s) { for (auto i = s.from; i < s.to; ++i)
//   write(s.m, i); }}; while (...) stretches.push(row); stretches.finish();
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include <railbook/geometry_car/health.hpp>
#include <railbook/geometry_car/reconstruct.hpp>
#include <railbook/geometry_car/record.hpp>

namespace railbook::geometry_car {

struct Row {
  double elapsed = 0;  // as in Record
  long mark = 0;
  std::array<double, channels> values{};
};

// Examined, reconstructed and judged. Only the rows [from, to) are the stretch's own: those about
// them are shared with its neighbours.
struct Stretch {
  std::size_t first = 0, from = 0, to = 0;  // row `from` is row `first` of the record
  Measurement m;
  std::array<std::vector<Quality>, parameters> quality;
};

// A record of up to `rows` rows is one stretch, and gives what examine() and reconstruct() give. A
// longer one is cut; the rows shared on either side hold all windows twice over, and let the
// filters that remember settle, so that values do not depend on the cut (tests: to 1e-9 of the
// parameter's size). Sensors are judged stretch by stretch: one that is a factor off is not trusted
// in the stretch where that shows; a zero that has moved, and a speed that leapt, are remembered as
// long as the run goes on.
class Stretches {
 public:
  using Sink = std::function<void(const Stretch&)>;

  // Throws InputError on a processing that does not make sense.
  Stretches(const Processing& processing, Sink sink, std::size_t rows = 32768);

  void push(const Row& row);
  // Throws InputError where no run of the record is long enough, as reconstruct().
  void finish();

  std::size_t rows() const { return base_ + record_.size(); }  // pushed so far
  std::size_t held() const { return record_.size(); }          // of them in memory
  std::size_t rejected() const { return rejected_; }  // as in Measurement, of the stretches done
  std::size_t runs() const { return runs_; }
  // Each kind once, of the stretch where it concerns most rows.
  std::vector<Finding> findings() const;

 private:
  struct Found {
    Finding finding;
    std::size_t stretches = 1, last = 0;  // the last of them
  };
  void judge(std::size_t to);
  void keep(Finding finding);

  Processing processing_;
  Sink sink_;
  std::size_t own_, shared_;
  Record record_;
  std::size_t base_ = 0, done_ = 0;  // rows of the record: the first held, the first not handed on
  ChannelOffsets carried_;
  std::vector<Found> found_;
  std::size_t rejected_ = 0, runs_ = 0, longest_ = 0, stretches_ = 0;
};

}  // namespace railbook::geometry_car
