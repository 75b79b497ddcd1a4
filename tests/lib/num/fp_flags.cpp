#include <railbook/num/fp_flags.hpp>

#include <catch2/catch.hpp>
#include <limits>

using namespace railbook;

namespace {

volatile double zero = 0;
volatile double sink = 0;

}  // namespace

TEST_CASE("extreme: a floating-point exception is reported by name and does not stop the program") {
  const num::FpFlags flags;
  CHECK(flags.raised().empty());
  sink = 1.0 / zero;
  CHECK(flags.raised() == "a division by zero");
  sink = zero / zero;
  CHECK(flags.raised() == "an invalid operation and a division by zero");
  CHECK(sink != sink);
}

TEST_CASE("extreme: a guard sees what it encloses, and tells the guards around it") {
  const num::FpFlags outer;
  sink = 1.0 / zero;
  {
    const num::FpFlags inner;
    CHECK(inner.raised().empty());
    sink = zero / zero;
    CHECK(inner.raised() == "an invalid operation");
  }
  CHECK(outer.raised() == "an invalid operation and a division by zero");
}

TEST_CASE("extreme: exceptions set aside leave no flag, and earlier flags are kept") {
  const num::FpFlags flags;
  {
    const num::FpFlagsAside aside;
    sink = zero / zero;
  }
  CHECK(flags.raised().empty());
  sink = 1.0 / zero;
  {
    const num::FpFlagsAside aside;
    sink = zero / zero;
  }
  CHECK(flags.raised() == "a division by zero");
}

TEST_CASE("extreme: a number that underflows or is rounded raises nothing") {
  const num::FpFlags flags;
  sink = std::numeric_limits<double>::min();
  sink = sink * sink;
  sink = 1.0 / 3.0;
  CHECK(flags.raised().empty());
}
