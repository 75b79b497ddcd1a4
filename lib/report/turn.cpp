#include <railbook/report/turn.hpp>

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <railbook/num/stopwatch.hpp>

namespace railbook::report {
namespace {

// Lock files. Who works, or waits for a place to, is in the room with others; who measures time is
// in it alone. Without the files the system refuses to lock, and nobody waits.
struct Locks {
  Locks() {
    const char* folder = std::getenv("RAILBOOK_TURNS");
    if (folder == nullptr || *folder == '\0') return;
    const std::string within = std::string{folder} + "/";
    room = open((within + "room").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    for (int place = 0; place >= 0;) {
      place =
          open((within + "place-" + std::to_string(places.size() + 1)).c_str(), O_RDWR | O_CLOEXEC);
      if (place >= 0) places.push_back(place);
    }
  }
  int room = -1;
  std::vector<int> places;
};

const Locks& locks() {
  static const Locks all;
  return all;
}

bool working = false;
int taken = -1;  // the place
double waited = 0;

void begin_work() {
  const num::Stopwatch watch;
  flock(locks().room, LOCK_SH);
  while (taken < 0 && !locks().places.empty()) {
    for (const int place : locks().places) {
      if (flock(place, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) continue;
      taken = place;
      break;
    }
    // The system cannot wait for whichever of several files comes first.
    if (taken < 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  waited += watch.seconds();
}

void end_work() {
  if (taken >= 0) flock(taken, LOCK_UN);
  taken = -1;
  flock(locks().room, LOCK_UN);
}

}  // namespace

WorkSlot::WorkSlot() {
  begin_work();
  working = true;
}
WorkSlot::~WorkSlot() {
  working = false;
  end_work();
}

TimingLock::TimingLock() {
  if (working) end_work();
  const num::Stopwatch watch;
  flock(locks().room, LOCK_EX);
  waited += watch.seconds();
}
TimingLock::~TimingLock() {
  flock(locks().room, LOCK_UN);
  if (working) begin_work();
}

double seconds_waited() {
  return waited;
}

}  // namespace railbook::report
