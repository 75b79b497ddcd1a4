// The settled motions of a body with stops whose stroke reaches a limit, and the least track
// amplitude at which each of them exists.
#pragma once

#include <vector>

#include <railbook/quality/steady_motion.hpp>

namespace railbook::quality_chapter {

// A stable motion that repeats after `order` waves; order 0: one that has found no period of up to
// eight waves.
struct LargeMotion {
  int order = 0;
  quality::Wave wave;
  quality::Motion start;  // when the wave begins
  double largest = 0;     // stroke, m
};

// The motions with a stroke of `limit` or more on which starts end on this wave. The starts are a
// grid of `side` strokes up to the limit by `side` rates up to that of a free motion at the limit.
std::vector<LargeMotion> find_large_motions(const quality::StoppedBody& body, double limit,
                                            const quality::Wave& wave, int side);

// Followed down in track amplitude until it is no longer stable or no longer reaches the limit.
LargeMotion least_amplitude(const quality::StoppedBody& body, double limit, LargeMotion motion);

struct Range {
  double low = 0, high = 0;  // frequencies, Hz
  double amplitude = 0;      // the highest of interest, m
};
// The same at neighbouring frequencies within a range, from low to high, as far as the motion
// exists; in steps of half a per cent or less.
std::vector<LargeMotion> least_amplitudes(const quality::StoppedBody& body, double limit,
                                          const LargeMotion& motion, const Range& range);

// Where and how densely to look.
struct Search {
  double low = 0, high = 0;             // frequencies, Hz
  double ratio = 1.08;                  // of neighbouring frequencies
  int side = 7;                         // starts: side times side
  std::vector<double> fractions{0.97};  // of the least amplitude so far, that are tried
};
// From low to high frequencies, the motions that exist at a lower track amplitude than all those at
// lower frequencies: the envelope over all speeds, as far as it is found.
std::vector<LargeMotion> lowest_motions(const quality::StoppedBody& body, double limit,
                                        const Search& search);

// The free motion without damping at a stroke above the gap, and the amplitude of a track wave of
// `order` times its frequency that can make up for what the damper takes from it.
struct EnergyBalance {
  double frequency = 0;  // of the wave, Hz
  double amplitude = 0;  // m
};
EnergyBalance energy_balance(const quality::StoppedBody& body, double stroke, int order);

}  // namespace railbook::quality_chapter
