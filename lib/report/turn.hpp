// Chapters that run side by side take turns with the clock: while one measures time, the others wait.
//
// The processes share the folder named by $RAILBOOK_TURNS (cmake/reproduce.sh gives one); without it there is nobody to
// wait for. A process that is killed loses its turn.
#pragma once

namespace railbook::report {

// Held while an item is computed: any number of processes at once.
class WorkTurn {
 public:
  WorkTurn();
  ~WorkTurn();
  WorkTurn(const WorkTurn&) = delete;
  WorkTurn& operator=(const WorkTurn&) = delete;
};

// Held while time is measured: one process, and no other works. Inside a WorkTurn, which it suspends.
class ClockTurn {
 public:
  ClockTurn();
  ~ClockTurn();
  ClockTurn(const ClockTurn&) = delete;
  ClockTurn& operator=(const ClockTurn&) = delete;
};

}  // namespace railbook::report
