// How far a bitten value is moved, kind by kind, and what a tolerance of each kind keeps.
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include <railbook/report/expectation.hpp>
#include <railbook/report/tolerance.hpp>

using namespace railbook::report;

TEST_CASE("unit: a bite is two tolerances, away from the printed value, whatever its sign") {
  CHECK(beyond_tolerance("-2", -1.9, relative(0.1, "r")) == Approx(-1.5));
  CHECK(beyond_tolerance("-2", -2.1, relative(0.1, "r")) == Approx(-2.5));
  CHECK(beyond_tolerance("2", 1.9, relative(0.1, "r")) == Approx(1.5));
  CHECK(beyond_tolerance("2", 2.0, absolute(0.1, "r")) == Approx(2.2));
  CHECK(beyond_tolerance("2.0", 1.99, last_digit()) == Approx(1.89));
  CHECK(beyond_tolerance("2", 2.1, digitised(0.1, 5, "r")) == Approx(3.1));
  CHECK(beyond_tolerance("9", -4.1, misprint(-4, 0.05, "r")) == Approx(-4.5));
  CHECK(beyond_tolerance("9", -3.9, misprint(-4, 0.05, "r")) == Approx(-3.5));
  // Across the bound, as far as it lies inside, or a billionth of the bound or of one.
  CHECK(beyond_tolerance("5", 3, at_most("r")) == 7);
  CHECK(beyond_tolerance("5", 8, at_least("r")) == 2);
  CHECK(beyond_tolerance("5000", 5000, at_most("r")) - 5000 == Approx(5e-6).epsilon(1e-3));
  CHECK(beyond_tolerance("5000", 5000, at_least("r")) - 5000 == Approx(-5e-6).epsilon(1e-3));
  CHECK(beyond_tolerance("-5000", -5000, at_most("r")) + 5000 == Approx(5e-6).epsilon(1e-3));
  CHECK(beyond_tolerance("-5000", -5000, at_least("r")) + 5000 == Approx(-5e-6).epsilon(1e-3));
  CHECK(beyond_tolerance("0.001", 0.001, at_most("r")) - 0.001 == Approx(1e-9).epsilon(1e-3));
  CHECK(beyond_tolerance("0.001", 0.001, at_least("r")) - 0.001 == Approx(-1e-9).epsilon(1e-3));
  CHECK(std::isnan(beyond_tolerance("1", 1, {ToleranceKind::exact, 0, ""})));
  CHECK_THROWS_AS(compare("1", 1, Tolerance{ToleranceKind::exact, 0, ""}), std::logic_error);
}

TEST_CASE("unit: a comparison says its error and what was allowed") {
  const auto is = [](const Verdict& v, bool pass, double error, double allowed) {
    CHECK(v.pass == pass);
    CHECK(v.error == Approx(error));
    CHECK(v.allowed == Approx(allowed));
  };
  is(compare("-2", -2.1, relative(0.1, "r")), true, 0.05, 0.1);
  is(compare("-2", -2.3, relative(0.1, "r")), false, 0.15, 0.1);
  is(compare("-2", -2.3, absolute(0.4, "r")), true, 0.3, 0.4);
  is(compare("2", 2.3, digitised(0.1, 4, "r")), true, 0.075, 0.1);
  is(compare("2", 1.0, at_most("r")), true, 1, 2);
  is(compare("2", 2.1, at_most("r")), false, 2.1, 2);
  is(compare("2", 2.0, at_most("r")), true, 2, 2);
  is(compare("-2", -2.0, at_most("r")), true, -2, -2);
  is(compare("-2", -1.9, at_most("r")), false, -1.9, -2);
  // The last bits of a value that is just allowed: a millionth of a millionth.
  CHECK(compare("1", 1 + 5e-13, at_most("r")).pass);
  CHECK_FALSE(compare("1", 1 + 1.005e-12, at_most("r")).pass);
  CHECK_FALSE(compare("1", 1 - 5e-13, at_least("r")).pass);
  is(compare("806.2", 505, misprint(606, 0.1, "r")), false, 101. / 606, 0.1);
  is(compare("806.2", 606.2, misprint(-606.16, 3, "r")), true, 1212.36 / 606.16, 3);
  is(compare("2", 2.0, at_least("r")), true, 2, 2);
  is(compare("2", 1.9, at_least("r")), false, 1.9, 2);
  is(compare("2.50", 2.505, last_digit()), true, 0.005, 0.005);
  is(compare("2.50", 2.5051, last_digit()), false, 0.0051, 0.005);
}

TEST_CASE("unit: an outcome has its reason, and the tolerance's behind it") {
  CHECK(Expectation(last_digit()).outcome == Outcome::confirmed);
  CHECK(Expectation(relative(0.1, "r")).outcome == Outcome::consistent);
  CHECK(fitted("chosen").tolerance.why == "chosen");
  CHECK(fitted("chosen").outcome == Outcome::fitted);
  CHECK(fitted("chosen", relative(0.1, "rough")).tolerance.why == "chosen; rough");
  CHECK(restored("torn", relative(0.1, "rough")).tolerance.why == "torn; rough");
  CHECK(restored("torn").outcome == Outcome::restored);
  const Trial trial("speed", "{}", misses("1"), {{"t/a", "mesh", "mm", {"4", "2"}}});
  CHECK(corrected(3, 0.1, "sign", trial).outcome == Outcome::corrected);
  CHECK(corrected(3, 0.1, "sign", trial).tolerance.span == 3);
  CHECK(not_confirmed("no", trial).outcome == Outcome::not_confirmed);
  CHECK_THROWS_AS(Trial("speed", "{}", misses("1"), {}), std::logic_error);
  CHECK_THROWS_AS(fitted(""), std::logic_error);
  CHECK_THROWS_AS(restored("", relative(0.1, "r")), std::logic_error);
}
