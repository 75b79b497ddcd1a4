// Numbers stand with the digits that their error leaves, or with four.
#include <railbook/tool/digits.hpp>

#include <catch2/catch.hpp>
#include <limits>

using namespace railbook::tool;

TEST_CASE("unit: a number with an error ends where the error begins") {
  CHECK(with_error(144.5387, 0.0213) == "144.54 +- 0.02");
  CHECK(with_error(-33817.5, 338) == "-33800 +- 300");
  CHECK(with_error(5.102885e-7, 1.348e-8) == "5.1e-07 +- 1e-08");
  CHECK(with_error(0.99962, 0.00048) == "0.9996 +- 0.0005");
  CHECK(with_error(39.49758123456, 7e-8) == "39.49758 +- 7e-08");
  CHECK(with_error(7.6, 20) == "8 +- 20");
  CHECK(with_error(0, 0.1) == "0 +- 0.1");
}

TEST_CASE("unit: an error and a number that round up to another power of ten keep their places") {
  CHECK(with_error(9.97, 0.1) == "10.0 +- 0.1");
  CHECK(with_error(99.96, 0.1) == "100.0 +- 0.1");
  CHECK(with_error(12.34, 0.096) == "12.3 +- 0.1");
  CHECK(to_digits_of(9999999.7, 1) == "1.000000e+07");
}

TEST_CASE("unit: a number without an error has four digits, and a whole one all of its own") {
  CHECK(to_text(147.00970) == "147.0");
  CHECK(to_text(12.7) == "12.7");
  CHECK(to_text(0.0127 / 1e-3) == "12.7");
  CHECK(to_text(44.80857) == "44.81");
  CHECK(to_text(634522.8) == "634500");
  CHECK(to_text(10331330.4) == "1.033e+07");
  CHECK(to_text(0.00012864) == "0.0001286");
  CHECK(to_text(0.000012864) == "1.286e-05");
  CHECK(to_text(0.3048) == "0.3048");
  CHECK(to_text(9999.96) == "10000");
  CHECK(to_text(65616) == "65616");
  CHECK(to_text(-0.0) == "0");
  CHECK(to_text(1e-300) == "1e-300");
  CHECK(to_text(12698123) == "12698123");
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(with_error(2025.4, infinity) == "2025");
  CHECK(with_error(2025.4, 0) == "2025");
  CHECK(to_text(std::numeric_limits<double>::max()) == "1.798e+308");
}

TEST_CASE("unit: an error stands with two digits") {
  CHECK(to_significant(0.03570888, 2) == "0.036");
  CHECK(to_significant(1.3308e-7, 2) == "1.3e-07");
  CHECK(to_significant(0.2, 2) == "0.2");
  CHECK(to_significant(2e-8, 2) == "2e-08");
}
