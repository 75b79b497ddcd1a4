#include <railbook/report/tolerance.hpp>

#include <catch2/catch.hpp>
#include <limits>

using namespace railbook::report;

TEST_CASE("unit: half a unit of the last printed digit") {
  CHECK(half_last_digit("39240") == 0.5);
  CHECK(half_last_digit(".15935") == Approx(0.000005));
  CHECK(half_last_digit("1.7e-7") == Approx(0.05e-7));
  CHECK(half_last_digit("-5 365") == 0.5);
  CHECK(half_last_digit("+1,234.5E+3") == 50);
  CHECK(last_decade("39240") == 0);
  CHECK(last_decade("-1.75e-7") == -9);
  CHECK(printed_number("+1,234.5E+3") == 1234.5e3);
  CHECK(std::isnan(printed_number("1e999")));
  CHECK(printed_number("-5 365") == -5365);
  CHECK(printed_number(".0767") == 0.0767);
  CHECK(std::isnan(printed_number("6?.5")));
  CHECK(std::isnan(printed_number("")));
}

TEST_CASE("unit: a value passes when it rounds to the printed text, and only then") {
  CHECK(compare("0.95", 0.9485, last_digit()).pass);
  CHECK(compare("0.95", 0.955, last_digit()).pass);
  CHECK_FALSE(compare("0.95", 0.9551, last_digit()).pass);
  CHECK(compare("1006.6", 1006.649, last_digit()).pass);
  CHECK_FALSE(compare("1006.6", 999.34, last_digit()).pass);
}

TEST_CASE("unit: each kind measures its own error") {
  CHECK(compare("200", 201, relative(0.006, "r")).pass);
  CHECK_FALSE(compare("200", 201.3, relative(0.006, "r")).pass);
  CHECK(compare("0", 0.4, absolute(0.5, "r")).pass);
  CHECK_FALSE(compare("0", 0.1, relative(0.5, "r")).pass);
  CHECK(compare("0", 0, relative(0.5, "r")).pass);
  CHECK_FALSE(compare("0", 1, relative(0.5, "r")).pass);
  CHECK(compare("3", 3.4, digitised(0.05, 10, "r")).pass);
  CHECK_FALSE(compare("3", 3.6, digitised(0.05, 10, "r")).pass);
  CHECK(compare("3", 2.687, at_most("r")).pass);
  CHECK_FALSE(compare("3", 3.01, at_most("r")).pass);
  CHECK(compare("3", 3.01, at_least("r")).pass);
}

TEST_CASE("unit: a misprint needs the corrected value and a wrong printed one") {
  const Tolerance t = misprint(606.16, 1e-3, "5365 in.lbf");
  CHECK(compare("806.2", 606.2, t).pass);
  CHECK_FALSE(compare("806.2", 806.2, t).pass);
  CHECK_FALSE(compare("606.2", 606.2, t).pass);  // the print is right: no misprint
}

TEST_CASE("extreme: NaN and infinity never pass") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Tolerance& t : {last_digit(), relative(1e9, "r"), absolute(1e9, "r"), at_most("r"),
                             at_least("r"), misprint(2, 1e9, "r")}) {
    CHECK_FALSE(compare("1", nan, t).pass);
    CHECK_FALSE(compare("1", inf, t).pass);
    CHECK_FALSE(compare("1", -inf, t).pass);
  }
}

TEST_CASE("input: an unsound tolerance is a programming error") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Tolerance& t : {relative(0.1, ""), absolute(0.1, ""), digitised(0.1, 1, ""),
                             misprint(2, 0.1, ""), at_most(""), at_least("")})
    CHECK_THROWS_WITH(compare("1", 1, t),
                      std::string{name(t.kind)} + " tolerance without a reason");
  for (const double none : {-0.1, 0.0, inf, std::nan("")})
    CHECK_THROWS_WITH(compare("1", 1, relative(none, "r")),
                      "relative tolerance is not a positive number");
  CHECK_THROWS_WITH(compare("one", 1, last_digit()), "printed text \"one\" is not a number");
}

TEST_CASE("property: every check that passes would fail on a wrong value") {
  for (double computed : {0.955, 0.9485, 0.95, 0.945001}) {
    const Tolerance t = last_digit();
    CHECK_FALSE(compare("0.95", beyond_tolerance("0.95", computed, t), t).pass);
  }
  for (const Tolerance& t : {relative(0.01, "r"), absolute(0.02, "r"), digitised(0.01, 3, "r"),
                             at_most("r"), misprint(1.99, 0.01, "r")}) {
    CHECK_FALSE(compare("2", beyond_tolerance("2", 1.99, t), t).pass);
  }
  CHECK_FALSE(compare("2", beyond_tolerance("2", 2.5, at_least("r")), at_least("r")).pass);
  CHECK_FALSE(compare("2", beyond_tolerance("2", 2.0, at_least("r")), at_least("r")).pass);
  CHECK_FALSE(compare("0", beyond_tolerance("0", 0.0, at_most("r")), at_most("r")).pass);
}
