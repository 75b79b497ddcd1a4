// Runs over one line at several times: where each section of the first is in the others, and how
// rough it is in each.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <railbook/quality/alignment.hpp>
#include <railbook/quality/sections.hpp>

namespace railbook::quality {

// The heights of a run (m; NaN: missing) by positions that ascend.
class LineRun {
 public:
  // `place`: the position of a sample, m.
  LineRun(std::vector<double> heights, std::function<double(std::size_t)> place);

  std::size_t size() const { return heights_.size(); }
  double at(std::size_t i) const { return place_(i); }  // m
  const std::vector<double>& heights() const { return heights_; }

  // The height at a position: by the cubic through two samples on either side, straight where one
  // of those is missing; NaN beyond the ends. A straight line takes 3 % off waves of 3 m in samples
  // 0.25 m apart, the cubic 0.2 %. Positions that follow each other are found at once.
  double at_place(double x);

 private:
  template <std::size_t n>
  double through(std::size_t first, double x) const;

  std::vector<double> heights_;
  std::function<double(std::size_t)> place_;
  std::size_t next_ = 0;
};

// A section of a run, beside the run before it.
struct RunSection {
  Section heights;  // of the samples that all runs compared there have
  double correlation = std::numeric_limits<double>::quiet_NaN();  // of the worst window found
  double offset = std::numeric_limits<double>::quiet_NaN();  // m, mean; NaN where none was found
  double jump = 0;  // m: by how much the offset changes from the window before to the one behind

  bool missing() const { return 2 * heights.missing > heights.samples; }
};

struct ComparedRun {
  std::vector<RunSection> sections;        // as many for each run; a first run has no offsets
  std::size_t windows = 0, ambiguous = 0;  // found; of them, those that fit elsewhere as well
  double other = 0;                        // m: how much further the first of those fits
};

// Each run is laid over the one before it (see align), on the samples of the first: track that was
// tamped once is unlike itself only once. Sections hold the samples that all runs have; a run that
// leaves less than half of a section to the others does not count there, unless there are only two.
// Memory: 8 bytes a sample of each run.
class RunSeries {
 public:
  // `section` > 0, m. Throws InputError as Sections and align do.
  RunSeries(LineRun first, double section, const AlignmentOptions& options = {});

  // The next run. Throws InputError where it is nowhere like the last one.
  void add(LineRun run);

  std::vector<ComparedRun> sections() const;

 private:
  LineRun first_;
  double section_;
  AlignmentOptions options_;
  std::vector<std::vector<double>> heights_;  // of the further runs, at the samples of the first
  std::vector<std::vector<Match>> matches_;
};

}  // namespace railbook::quality
