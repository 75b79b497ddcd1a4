#include "report/turn.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cstdlib>
#include <string>

namespace railbook::report {
namespace {

// Lock files: whoever wants `room` goes through `door` first, so that one who waits to have the room alone is not passed
// by those who come to share it. Without them the system refuses to lock, and nobody waits.
struct Locks {
  Locks() {
    const char* folder = std::getenv("RAILBOOK_TURNS");
    if (folder == nullptr || *folder == '\0') return;
    const auto file = [&](const char* name) {
      return open((std::string{folder} + name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    };
    door = file("/door");
    room = file("/room");
  }
  void enter(int how) const {
    flock(door, LOCK_EX);
    flock(room, how);
    flock(door, LOCK_UN);
  }
  void leave() const { flock(room, LOCK_UN); }
  int door = -1, room = -1;
};

const Locks& locks() {
  static const Locks all;
  return all;
}

bool working = false;

}  // namespace

WorkTurn::WorkTurn() {
  locks().enter(LOCK_SH);
  working = true;
}
WorkTurn::~WorkTurn() {
  working = false;
  locks().leave();
}

ClockTurn::ClockTurn() {
  locks().leave();
  locks().enter(LOCK_EX);
}
ClockTurn::~ClockTurn() {
  locks().leave();
  if (working) locks().enter(LOCK_SH);
}

}  // namespace railbook::report
