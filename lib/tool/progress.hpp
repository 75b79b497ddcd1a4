// Long work is never silent: what is done and what is still to do, on standard error, so that
// answers stay clean.
#pragma once

#include <functional>
#include <string>

namespace railbook::tool {

// Counts the steps of some work. When two seconds have passed and ten more are expected, says so in
// a line; on a terminal already where one more is expected, and there the line keeps up with the
// work and is removed at its end.
class Progress {
 public:
  // `what`: the steps in the plural, "points".
  Progress(std::string what, double steps);
  // With another terminal and clock than those of the process; `seconds` have passed since some
  // begin.
  Progress(std::string what, double steps, bool terminal, std::function<double()> seconds);
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();
  // Removes the line from the terminal; before the answer is printed.
  void end();

 private:
  std::string what_;
  double steps_ = 0, done_ = 0;
  bool said_ = false, terminal_ = false;
  std::function<double()> seconds_;
  double begin_ = 0, shown_ = 0;
};

// The line: "points: 12 of 40, about 90 s to go".
std::string progress_line(const std::string& what, double done, double steps, double seconds);

// Whether work has taken more than two seconds, and more than `enough` seconds are to go at the
// pace so far.
bool should_report(double done, double steps, double seconds, double enough);

}  // namespace railbook::tool
