#include <catch2/catch.hpp>
#include <limits>

#include "units/input_error.hpp"
#include "units/quantity.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("input: a wrong, missing or unknown unit is refused by name") {
  CHECK_THROWS_WITH(units::parse_quantity("tie spacing", "19.5", units::length),
                    Contains("tie spacing") && Contains("19.5") && Contains("unit"));
  CHECK_THROWS_WITH(units::parse_quantity("tie spacing", "19.5kN", units::length),
                    Contains("tie spacing") && Contains("N"));
  CHECK_THROWS_WITH(units::parse_quantity("tie spacing", "19.5furlong", units::length),
                    Contains("furlong"));
  CHECK_THROWS_AS(units::parse_quantity("x", "", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "nan in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "inf in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "1e999in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "1 in in", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("x", "1in/", units::length), InputError);
  CHECK_THROWS_AS(units::parse_quantity("force, not mass", "80 lb", units::force), InputError);
}

TEST_CASE("input: range checks name the quantity, the value and the range") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(units::require_positive("stiffness", -3.5, "N/m"),
                    Contains("stiffness is -3.5 N/m") && Contains("greater than 0"));
  CHECK_THROWS_WITH(units::require_between("damping ratio", 1.5, 0, 1), Contains("from 0 to 1"));
  CHECK_THROWS_AS(units::require_positive("x", nan), InputError);
  CHECK_THROWS_AS(units::require_non_negative("x", nan), InputError);
  CHECK_THROWS_AS(units::require_between("x", nan, -units::no_limit, units::no_limit), InputError);
  CHECK(units::require_non_negative("x", 0.0) == 0.0);
}
