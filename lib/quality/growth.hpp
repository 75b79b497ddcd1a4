// How the standard deviation of a section grows over the years, and where it was tamped.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <railbook/quality/runs.hpp>

namespace railbook::quality {

// A straight line by least squares through points of equal and unknown scatter. Its interval is
// Student's, with two degrees of freedom fewer than points: two points have none (NaN).
struct Trend {
  double slope = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();  // ends of the interval of the slope
  double high = std::numeric_limits<double>::quiet_NaN();
};

// To rounding. `confidence`: that the interval holds the slope, of normal scatter, 0 to 1. Throws
// InputError for fewer than two points, spans that differ, equal times, or another confidence.
Trend straight_line(std::span<const double> times, std::span<const double> values,
                    double confidence = 0.95);

struct GrowthOptions {
  double tamping_drop = 0.15;  // a larger relative fall of the deviation between two runs: tamped
  double most_jump = 2;        // m of offset near a section, beyond which it is misplaced
  double confidence = 0.95;
};

// Runs of a section between which nothing was done to the track.
struct Period {
  enum class Begin { first, tamped, unlike };  // unlike: the shape is another, but not smoother
  Begin begin = Begin::first;
  std::vector<std::size_t> runs;
  double drop = 0;  // relative fall of the deviation before it
  Trend growth;     // m a year; NaN for one run
};

// The relative fall of the deviation that is taken for tamping: the one of the options, or four
// times the scatter of the changes from run to run where that is more. The scatter is the median
// absolute deviation of ln(after/before) over the sections, 1.4826 of it, of the pair of runs in
// the middle: it holds as long as less than half of the line was tamped in half of the pairs.
double tamping_drop(std::span<const ComparedRun> runs, const GrowthOptions& options = {});

// The periods of a section in order; none where no run can be judged. `years`: time of each run,
// ascending; `drop` from tamping_drop. A run is left out of a section where too little is common
// to the runs, or its offset jumps. Throws InputError as straight_line does.
std::vector<Period> periods(std::span<const ComparedRun> runs, std::size_t section,
                            std::span<const double> years, double drop,
                            const GrowthOptions& options = {});

}  // namespace railbook::quality
