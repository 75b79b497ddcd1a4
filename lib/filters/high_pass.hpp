// High-pass of zero phase that takes the long waves out of a profile, and the same divided by the
// short chord: the pseudo space curve. The paper shows a response without saying what makes it;
// this one is ours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace railbook::filters {

// (1 - b^p)^stages, b the centred mean over M samples. The default passes 0.993 of 200 ft, 1.000 of
// 150 ft at a sample a foot, and -3 dB at 361 ft. Each stage has a double zero at DC: one stage
// takes a constant acceleration out of a chord, but leaves it in a space curve; two take it out of
// both.
struct HighPass {
  int length = 151;  // M, odd
  int passes = 4;    // p
  int stages = 1;
};

// Throws InputError unless M is odd, 3 <= M <= 10001, 1 <= p <= 8, 1 <= stages <= 2 and M^p < 2^53.
void require_valid(const HighPass& filter);

// Samples that count on each side of an output: of the high-pass, and one less of the space curve.
// Throws InputError as require_valid does.
std::size_t reach(const HighPass& filter);

// Gain at theta radians a sample; relative accuracy 1e-14, without cancellation at long waves.
double high_pass_gain(const HighPass& filter, double theta);

// The space curve from the short chord, (high-pass)/(1 - cos theta), as weights: 2 reach - 1
// numerators over M^p for one stage, centred, exact modulo 2^64. The quotient has no remainder.
std::vector<std::int64_t> space_curve_integers(const HighPass& filter);

}  // namespace railbook::filters
