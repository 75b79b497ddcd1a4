// Chapters that run side by side measure time one after the other, while no other computes. What
// they share is a lock on their folder of results; the system frees it with a process that ends.
#pragma once

#include <filesystem>

namespace railbook::report {

// The folder by which the processes know each other, for the rest of the program. Without this call
// there is nobody to wait for.
void share_machine(const std::filesystem::path& folder);

// Held while an item is computed, by any number of processes at once.
class WorkSlot {
 public:
  WorkSlot();
  ~WorkSlot();
  WorkSlot(const WorkSlot&) = delete;
  WorkSlot& operator=(const WorkSlot&) = delete;
};

// Held while time is measured, by one process while none holds a WorkSlot. It suspends this
// process's own.
class TimingLock {
 public:
  TimingLock();
  ~TimingLock();
  TimingLock(const TimingLock&) = delete;
  TimingLock& operator=(const TimingLock&) = delete;
};

// How long this process has waited for either.
double seconds_waited();

}  // namespace railbook::report
