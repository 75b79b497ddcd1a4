#include <railbook/tool/progress.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

namespace railbook::tool {

std::string progress_line(const std::string& what, double done, double steps, double seconds) {
  const double left = done > 0 ? std::max(0.0, steps - done) * seconds / done : 0;
  const std::string time = left < 100    ? fmt::format("{:.0f} s", left)
                           : left < 6000 ? fmt::format("{:.0f} min", left / 60)
                                         : fmt::format("{:.0f} h", left / 3600);
  return fmt::format("{}: {:.0f} of {:.0f}, about {} to go", what, done, std::max(done, steps),
                     time);
}

bool should_report(double done, double steps, double seconds, double enough) {
  return seconds > 2 && (steps - done) * seconds > enough * done;
}

Progress::Progress(std::string what, double steps)
    : Progress(std::move(what), steps, isatty(STDERR_FILENO) != 0, [] {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration<double>(now).count();
      }) {}

Progress::Progress(std::string what, double steps, bool terminal, std::function<double()> seconds)
    : what_(std::move(what)),
      steps_(steps),
      terminal_(terminal),
      seconds_(std::move(seconds)),
      begin_(seconds_()) {}

void Progress::end() {
  if (said_ && terminal_) fmt::print(stderr, "\r\x1b[K");
  said_ = false;
}

void Progress::step() {
  ++done_;
  const double now = seconds_();
  const bool first = !said_ && should_report(done_, steps_, now - begin_, terminal_ ? 1 : 10);
  if (!first && !(said_ && terminal_ && now - shown_ > 0.5)) return;
  said_ = true;
  shown_ = now;
  const std::string line = progress_line(what_, done_, steps_, now - begin_);
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r" : "", line, terminal_ ? "\x1b[K" : "\n");
}

}  // namespace railbook::tool
