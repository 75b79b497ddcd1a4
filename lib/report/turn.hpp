// Chapters that run side by side take turns with the machine: as many work at a time as it has
// places, and who measures time does it while nobody works.
//
// The processes share the folder named by $RAILBOOK_TURNS, with an empty file place-1, place-2 ...
// for each place (cmake/reproduce.sh makes one); without it there is nobody to wait for. A process
// that is killed loses its turn.
#pragma once

namespace railbook::report {

// Held while an item is computed: any number of processes at once, or as many as there are places.
class WorkSlot {
 public:
  WorkSlot();
  ~WorkSlot();
  WorkSlot(const WorkSlot&) = delete;
  WorkSlot& operator=(const WorkSlot&) = delete;
};

// Held while time is measured: one process, and no other works. Inside a WorkTurn, which it
// suspends. It comes after work: who wants it waits until the others have nothing left to do, or
// want it, too; no place stays empty before that.
class TimingLock {
 public:
  TimingLock();
  ~TimingLock();
  TimingLock(const TimingLock&) = delete;
  TimingLock& operator=(const TimingLock&) = delete;
};

// Seconds that this process has waited for its turns.
double seconds_waited();

}  // namespace railbook::report
