// Floating-point traps: an invalid operation or a division by zero stops the program where it happens.
#pragma once

#include <fenv.h>

namespace railbook::num {

// Turns the traps for FE_INVALID and FE_DIVBYZERO on for its lifetime, then restores what was set before.
// Glibc only; a trap raises SIGFPE. Quiet NaNs that are only passed along do not trap, comparisons do.
class FpTraps {
 public:
  FpTraps() : before_(fegetexcept()) {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO);
  }
  ~FpTraps() { restore(before_); }
  FpTraps(const FpTraps&) = delete;
  FpTraps& operator=(const FpTraps&) = delete;

 private:
  friend class FpTrapsOff;
  static void restore(int traps) {
    feclearexcept(FE_ALL_EXCEPT);
    fedisableexcept(FE_ALL_EXCEPT);
    feenableexcept(traps);
  }
  int before_;
};

// Turns all traps off for its lifetime: for code of others (drawing, parsing) that divides by zero on purpose.
class FpTrapsOff {
 public:
  FpTrapsOff() : before_(fedisableexcept(FE_ALL_EXCEPT)) {}
  ~FpTrapsOff() { FpTraps::restore(before_); }
  FpTrapsOff(const FpTrapsOff&) = delete;
  FpTrapsOff& operator=(const FpTrapsOff&) = delete;

 private:
  int before_;
};

}  // namespace railbook::num
