// Long work is never silent: what is done and what is still to do, on standard error, so that answers stay clean.
#pragma once

#include <chrono>
#include <string>

namespace railbook::tool {

// Counts the steps of some work. When two seconds have passed and ten more are expected, says so in a line; on a terminal
// already where one more is expected, and there the line keeps up with the work and is removed at its end.
class Progress {
 public:
  // `what`: the steps in the plural, "points".
  Progress(std::string what, double steps);
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();
  // Removes the line from the terminal; before the answer is printed.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  double steps_ = 0, done_ = 0;
  Clock::time_point begin_ = Clock::now(), shown_ = begin_;
  bool said_ = false, terminal_ = false;
};

// The line: "points: 12 of 40, about 90 s to go".
std::string progress_line(const std::string& what, double done, double steps, double seconds);

// Whether work has taken more than two seconds, and more than `enough` seconds are to go at the pace so far.
bool worth_saying(double done, double steps, double seconds, double enough);

}  // namespace railbook::tool
