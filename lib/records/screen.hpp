// What a track seldom does: codes for lost samples, outliers, stuck sensors and steps of the datum,
// found in a stream of heights. What no track can do is taken out of it; the rest only where it is
// asked for, since it may be a defect.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace railbook::records {

inline constexpr double lost =
    std::numeric_limits<double>::quiet_NaN();  // a sample that is not there

enum class Fault {
  outlier,  // samples far off that come back
  code,     // the same value far off, two times or more: -9999 for a lost sample
  stuck,    // equal values in a row, more than rounding explains
  step,  // the level changes for good; taken out, it is one sample, so that the record is cut there
  jump,  // the level changes and comes back within 20 m: never taken out
  cut    // the record goes on at another place; see cut()
};

// A stretch of samples that are suspected, or taken out.
struct FaultyStretch {
  Fault fault = Fault::outlier;
  std::size_t first = 0, count = 0;  // samples
  double value = 0;  // m: the first sample, the height of the step, the largest of the jump
  bool taken_out = true;
  double off = 0;  // m: of outliers, the farthest from the good value before
};

// What is taken out. `codes`: values as far off as no track can be (by over 0.1 m from one sample
// to the next, at a slope of over 0.3), and values that come twice in a row, far off, and are
// written 999, 99.9, 32767 and so on.
struct Screening {
  bool codes = true, outliers = true, stuck = true, steps = true;
};

// Hands on the samples it is given, those taken out as NaN, some thousand samples later.
//
// Sizes are judged by the median step from sample to sample (where it is not zero), of the block of
// 16384 samples around or of the record so far, whichever is larger: far off is 12 median steps and
// four times the steps just before, 3 more for each sample missing in between. For Gaussian steps
// that is eight standard deviations, so that a clean record is spared (tests: fewer than 1 in 1000
// of records, with joints, waves, noise and rounding). A wave is no outlier however high, unless it
// begins abruptly and has fewer than about 12 samples. Records of fewer than 50 steps are not
// judged. Equal values are a stuck sensor from 20 on, and from eight times the number of samples on
// in which the record usually moves by five of its smallest steps.
class Screen {
 public:
  explicit Screen(std::function<void(std::span<const double>)> sink, Screening screening = {})
      : sink_(std::move(sink)), screening_(screening) {
    v_.reserve(2 * block);
  }
  // m, before the first sample: between samples, and of one in the file's numbers. Without, any
  // slope is possible.
  void set_scale(double spacing, double unit) { spacing_ = spacing, unit_ = unit; }
  void push(std::span<const double> values);  // m; NaN for a missing sample
  // A missing sample behind which the record goes on elsewhere: what is there is not compared with
  // what was before.
  void cut(double jump);
  void finish();

  const std::vector<FaultyStretch>& faults() const { return faults_; }
  // After finish(): a stretch of equal values that was not taken out, since only what came after it
  // showed how the record moves.
  std::optional<FaultyStretch> still() const;

 private:
  static constexpr std::size_t block = 8192;
  void judge(std::size_t upto);
  void measure();
  std::size_t pass(std::size_t i, std::size_t upto);
  std::size_t judge_at(std::size_t i);
  std::size_t judge_first(std::size_t i);
  std::size_t judge_far(std::size_t i);
  std::size_t judge_excursion(std::size_t i);
  std::size_t judge_level(std::size_t i);
  std::size_t end_of_jump(std::size_t i) const;
  bool impossible(double jump, std::size_t slots) const;
  bool is_code(double value) const;
  std::size_t accept(std::size_t i);
  void step(double size);
  std::size_t report(std::size_t from, std::size_t to, Fault fault, double value, bool taken_out,
                     double off = 0);
  double limit(std::size_t i) const;
  std::size_t equal_until(std::size_t i, bool over_gaps) const;

  std::function<void(std::span<const double>)> sink_;
  Screening screening_;
  double spacing_ = 0, unit_ = 1;                     // m
  std::vector<std::pair<std::size_t, double>> cuts_;  // samples and jumps still to come, in order
  std::vector<double> v_;                             // not handed on
  std::size_t base_ = 0;                              // the first of them
  std::size_t next_ = 0;                              // the first of them not judged
  std::size_t seen_ = 0;                              // the first whose step to the next is new
  bool last_ = false;                                 // no more will come
  std::vector<FaultyStretch> faults_;

  static constexpr std::size_t lags = 11;
  double median_step_ = 0, mean_step_ = 0;                    // of the block, of the record so far
  double quantum_ = std::numeric_limits<double>::infinity();  // smallest step that is not zero
  std::array<double, lags> mean_move_{};                      // over 2^i samples, so far
  std::size_t blocks_ = 0, stuck_from_ = 0;
  bool judged_ = false;  // there are steps enough

  std::optional<double> good_;      // the last good value
  std::ptrdiff_t good_at_ = 0;      // from the start of v_
  std::array<double, 3> recent_{};  // steps between good values
  std::optional<double> constant_;  // a stuck or coded value that has not ended yet
  std::size_t run_ = 0;             // of equal good values
  FaultyStretch still_;             // the longest
};

}  // namespace railbook::records
