// How long calls take on a machine that does other things, too.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace railbook::bench {

// Seconds a call, over the samples taken: the least, the quartiles and their number.
struct Timing {
  double min = 0, q1 = 0, median = 0, q3 = 0;
  int samples = 0;
};

// Of one or more samples.
Timing summary(std::vector<double> times);

double seconds_of(const std::function<void()>& call);

// Times one call: batches of at least 1 ms, up to 21 samples but at most about `budget` seconds.
Timing time_call(const std::function<void()>& call, double budget = 0.5);

// Times several, one sample of each in turn. `first` is what a first, unwarmed call of each took;
// the time of an empty function is that.
std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& calls,
                                     const std::vector<double>& first, double budget);

// "1.2 ms", "35 us", "4.1 s".
std::string duration(double seconds);

}  // namespace railbook::bench
