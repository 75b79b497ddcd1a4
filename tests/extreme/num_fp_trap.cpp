#include <catch2/catch.hpp>
#include <csetjmp>
#include <csignal>

#include "num/fp_trap.hpp"

using namespace railbook;

TEST_CASE("extreme: traps are restored when their guard ends") {
  const int before = fegetexcept();
  {
    const num::FpTraps on;
    CHECK((fegetexcept() & (FE_INVALID | FE_DIVBYZERO)) == (FE_INVALID | FE_DIVBYZERO));
    {
      const num::FpTrapsOff off;
      CHECK(fegetexcept() == 0);
      volatile double zero = 0;
      CHECK(1.0 / zero > 0);  // infinity, quietly
    }
    CHECK((fegetexcept() & FE_DIVBYZERO) == FE_DIVBYZERO);
  }
  CHECK(fegetexcept() == before);
}

namespace {
sigjmp_buf back;
void jump(int) {
  siglongjmp(back, 1);
}
}  // namespace

TEST_CASE("extreme: a division by zero under traps raises SIGFPE") {
  auto* const old = std::signal(SIGFPE, jump);
  bool trapped = false;
  if (sigsetjmp(back, 1) == 0) {
    feenableexcept(FE_DIVBYZERO);
    volatile double zero = 0;
    volatile double result = 1.0 / zero;
    (void)result;
  } else {
    trapped = true;
  }
  feclearexcept(FE_ALL_EXCEPT);
  fedisableexcept(FE_ALL_EXCEPT);
  std::signal(SIGFPE, old);
  CHECK(trapped);
}
