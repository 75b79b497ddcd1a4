// Floating-point flags: an invalid operation (0/0, infinity less infinity, a comparison with NaN)
// or a division by zero leaves a mark, which is read at stated places. Nothing is ever stopped by
// it: a program ends with a message, never with SIGFPE.
#pragma once

#include <cfenv>
#include <string_view>

namespace railbook::num {

// What this thread has raised since it was made. Guards nest: at its end one leaves to those around
// it what it has seen.
class FpFlags {
 public:
  FpFlags() : before_(std::fetestexcept(watched)) { std::feclearexcept(watched); }
  ~FpFlags() { std::feraiseexcept(before_); }
  FpFlags(const FpFlags&) = delete;
  FpFlags& operator=(const FpFlags&) = delete;

  // "an invalid operation", "a division by zero", both, or nothing.
  static std::string_view raised() {
    const int flags = std::fetestexcept(watched);
    if (flags == watched) return "an invalid operation and a division by zero";
    if (flags == 0) return "";
    return flags == FE_INVALID ? "an invalid operation" : "a division by zero";
  }

 private:
  static constexpr int watched = FE_INVALID | FE_DIVBYZERO;
  int before_;
};

// Forgets at its end what was raised since it was made: for code of others (drawing, parsing) that
// divides by zero on purpose, and for our own that means infinity.
class FpFlagsAside {
 public:
  FpFlagsAside() { std::fegetexceptflag(&before_, FE_ALL_EXCEPT); }
  ~FpFlagsAside() { std::fesetexceptflag(&before_, FE_ALL_EXCEPT); }
  FpFlagsAside(const FpFlagsAside&) = delete;
  FpFlagsAside& operator=(const FpFlagsAside&) = delete;

 private:
  std::fexcept_t before_;
};

}  // namespace railbook::num
