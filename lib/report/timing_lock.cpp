#include <railbook/report/timing_lock.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <railbook/num/stopwatch.hpp>

namespace railbook::report {
namespace {

int folder = -1;  // nobody to wait for: the system refuses to lock
bool working = false;
double waited = 0;

void lock(int how) {
  const num::Stopwatch watch;
  flock(folder, how);
  waited += watch.seconds();
}

}  // namespace

void share_machine(const std::filesystem::path& name) {
  if (folder >= 0) close(folder);
  folder = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

WorkSlot::WorkSlot() {
  lock(LOCK_SH);
  working = true;
}
WorkSlot::~WorkSlot() {
  working = false;
  flock(folder, LOCK_UN);
}

TimingLock::TimingLock() {
  flock(folder, LOCK_UN);  // two that measure would otherwise wait for each other
  lock(LOCK_EX);
}
TimingLock::~TimingLock() {
  flock(folder, LOCK_UN);
  if (working) lock(LOCK_SH);
}

double seconds_waited() {
  return waited;
}

}  // namespace railbook::report
