// Two runs over one line: where a place of the first is in the second.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace railbook::quality {

struct AlignmentOptions {
  double window = 200;  // m of the first run that are looked for in the second
  double reach = 20;    // m to either side
  double least =
      0.7;  // correlation below which a window is not found: strangers reach 0.6 by chance
};

// A window of the first run, found in the second.
struct Match {
  std::size_t centre = 0;  // sample of the first run
  double offset = 0;       // m: what lies at x in the first run is at x + offset in the second
  double correlation = 0;  // of the window with its like, -1 to 1
  bool found = false;
  double other =
      0;  // m: another offset at which it correlates as well, to 5 %; 0 where there is none
};

// The heights of a run from a sample on, as many as are asked for; NaN where a sample is missing,
// before the first and behind the last.
using Heights = std::function<void(std::ptrdiff_t from, std::span<double> to)>;

// Both runs on grids of the same spacing (m), sample i of each at the same nominal place; the first
// has `samples`. Each window is laid where its correlation is largest, to a tenth of a spacing by a
// parabola where waves are eight spacings and longer; an offset that leaves the median of five
// neighbours by over two metres is not found. Of offsets that correlate alike, to half a per cent,
// as those of a wave do, the smallest is taken. The memory is that of a window, and a match each
// half window. Throws InputError for options that are not positive, a window below 16 samples or
// above the record.
std::vector<Match> align(std::size_t samples, const Heights& first, const Heights& second,
                         double spacing, const AlignmentOptions& options = {});
std::vector<Match> align(std::span<const double> first, std::span<const double> second,
                         double spacing, const AlignmentOptions& options = {});

// The offset (m) at a sample: linear between the windows found, level beyond them; 0 where none is.
double offset_at(std::span<const Match> matches, double sample);

}  // namespace railbook::quality
