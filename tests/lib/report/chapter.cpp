#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <railbook/report/values.hpp>

#include "support/sample_chapter.hpp"

using namespace railbook;

TEST_CASE("unit: a chapter checks printed rows and leaves a record") {
  const Sample s;
  s.at.write("data/t.csv",
             "key,what,unit,printed\np0,peak pressure,psi,39 240\nm,moment,N.m,806.2\n");
  s.at.write("data/trials.csv",
             "check,choice,unit,settings\ntable-1/m-printed,rounding,,606.1; 606.3\n");
  const report::Section paper{
      report::table(
          "table-1", "One",
          [](report::Item& item) {
            const auto t = item.printed("t.csv");
            item.expect_checks(2);
            item.row(t, "p0").print("printed", 39315.4, report::relative(0.006, "coarse cells"));
            report::Trial trial =
                item.trial("m-printed", "moment", "{:.1f} N.m", report::misses("806.2"));
            trial.vary("rounding", [](const report::Setting& setting) { return setting.number; });
            item.row(t, "m").print("printed", 606.2,
                                   report::corrected(606.16, 1e-3, "5365 in.lbf", trial));
            item.value("p0", 39315.4, "psi", "{:.0f}");
          }),
      report::figure("fig-1", "Two", [](report::Item& item) {
        item.data({"x_m", "y"}).add(1.0, "a,b");
        item.sketch();
      })};
  REQUIRE(s.reproduce(paper, {"--no-figures"}) == 0);
  const auto r = s.record();
  CHECK(r["checks"][0]["id"] == "table-1/p0-printed");
  CHECK(r["checks"][0]["source"] == "print");
  CHECK(r["checks"][0]["outcome"] == "consistent");
  CHECK(r["checks"][0]["what"] == "peak pressure");
  CHECK(r["checks"][0]["printed"] == "39 240");
  CHECK(r["checks"][1]["outcome"] == "corrected");
  CHECK(r["items"][0]["input"] == "paper");
  CHECK(r["items"][1]["input"] == "sketch");
  CHECK(r["values"][0]["text"] == "39315 psi");
  std::ifstream csv{s.at.path / "results/00-sample/fig-1.csv"};
  CHECK(std::string{std::istreambuf_iterator<char>{csv}, {}} == "x_m,y\n1,\"a,b\"\n");
}

TEST_CASE("unit: each item has one caption in data/captions.csv, or its title in the code") {
  const auto nothing = [](report::Item& item) { item.sketch(); };
  const auto run_with = [&](const std::string& rows) {
    const Sample s;
    s.at.write("data/captions.csv", "item,caption\n" + rows);
    const int status = s.reproduce({report::table("t", nothing), report::table("u", "U", nothing)});
    return std::pair{status, status == 0 ? s.record()["items"][0]["title"].dump() : ""};
  };
  CHECK(run_with("t,\"What, and how\"\n") == std::pair{0, std::string{"\"What, and how\""}});
  for (const char* bad : {"", "t,\n", "t,T\nt,T\n", "t,T\nu,U\n", "t,T\nv,V\n"})
    CHECK(run_with(bad).first == 2);
}

TEST_CASE("unit: a check says what it is about and what came of it") {
  const Sample s;
  REQUIRE(s.reproduce(one([](report::Item& i) {
    i.expect_checks(8);
    i.print("a", "a", "m", "1.0", 1.04);
    i.print("b", "b", "m", "1.0", 1.04, report::fitted("the damper was chosen for it"));
    i.print("c", "c", "m", "12.3", 12.3, report::restored("the scan reads J2.3"));
    i.print_text("e", "e", "class 5", "class 5");
    i.claim("f", "it converges", true, "in 3 steps");
    i.publication("h", "h", "m", "2", 2.001, report::relative(0.01, "a table"), "A. Nobody");
    i.agree("i", "i", "m", 2.0, 2.0 + 1e-13, 1e-12, "a closed form");
    i.at_most("j", "j", "m", 0.1, 0.2, "the accuracy asked for");
  })) == 0);
  const auto checks = s.record()["checks"];
  const char* expected[][2] = {{"print", "confirmed"}, {"print", "fitted"},
                               {"print", "restored"},  {"print", "confirmed"},
                               {"claim", "confirmed"}, {"publication", "verified"},
                               {"route", "verified"},  {"route", "verified"}};
  REQUIRE(checks.size() == std::size(expected));
  for (std::size_t i = 0; i < checks.size(); ++i) {
    CHECK(checks[i]["source"] == expected[i][0]);
    CHECK(checks[i]["outcome"] == expected[i][1]);
    CHECK(checks[i].contains("printed") == (checks[i]["source"] == "print"));
  }
  CHECK(checks[5]["by"] == "A. Nobody");
  CHECK(checks[4]["id"] == "t/f");
  CHECK(checks[4]["what"] == "it converges");
  CHECK(checks[4]["allowed"] == 0);  // of a claim nothing is
  // Nothing but the paper's text stands under "printed".
  std::ifstream csv{s.at.path / "results/00-sample/checks.csv"};
  const std::string text{std::istreambuf_iterator<char>{csv}, {}};
  CHECK(text.find("t/h,,publication,verified,h,m,,2,A. Nobody,") != std::string::npos);
  CHECK(text.find("t/a,,print,confirmed,a,m,1.0,,,") != std::string::npos);
}

TEST_CASE("extreme: NaN, an empty loop and a missing count fail the chapter") {
  const double nan = units::nan;
  CHECK(status([](report::Item& i) { i.expect_checks(1), i.print("a", "a", "", "1.0", 1.04); }) ==
        0);
  CHECK(status([=](report::Item& i) { i.expect_checks(1), i.print("a", "a", "", "1.0", nan); }) ==
        1);
  CHECK(status([](report::Item& i) { i.expect_checks(1); }) == 1);  // loop over nothing
  CHECK(status([](report::Item& i) { i.print("a", "a", "", "1.0", 1.0); }) ==
        1);                                  // count not announced
  CHECK(status([](report::Item&) {}) == 1);  // says nothing
  CHECK(status([](report::Item&) { throw std::runtime_error{"no"}; }) == 1);
  CHECK(status([](report::Item& i) { i.expect_checks(0), i.rebuilt("inputs are ours"); }) == 0);
  CHECK(status([](report::Item& i) {
          i.expect_checks(1), i.print("a", "a", "", "1", 1, report::relative(1, ""));
        }) == 1);
  CHECK(status([](report::Item& i) {
          i.expect_checks(1), i.print("a", "a", "", "1", 1, report::fitted(""));
        }) == 1);
  CHECK(status([](report::Item& i) { i.expect_checks(1), i.claim("a", "a", false); }) == 1);
}

TEST_CASE("unit: data that hold to less than their digits say why") {
  const auto accurate = [](const char* why) {
    return status([why](report::Item& i) {
      i.expect_checks(1);
      i.data({"x"}).holds_to("x", 1e-3, 0, why);
      i.claim("a", "a", true);
    });
  };
  CHECK(accurate("ill-conditioned") == 0);
  CHECK(accurate("") == 1);
  CHECK_FALSE(report::RunSettings{}.full);
}

TEST_CASE("unit: a stability case fails when something else is found than expected") {
  const auto with = [](report::Expected expect, double allowed,
                       const std::function<report::Found()>& f) {
    return status([=](report::Item& i) {
      i.stability({.id = "s", .what = "w", .stress = "x", .expect = expect, .allowed = allowed}, f);
    });
  };
  const auto found = [](double error) { return [=] { return report::Found{"found", error}; }; };
  const auto throws = []() -> report::Found { throw InputError{"too slender"}; };
  const auto gives_up = []() -> report::Found { throw report::NoAnswer{"did not converge"}; };
  CHECK(with(report::accurate, 1e-3, found(1e-4)) == 0);
  CHECK(with(report::accurate, 1e-3, found(1e-3)) == 0);  // the bound itself is allowed
  CHECK(with(report::accurate, 1e-3, found(std::nextafter(1e-3, 1))) == 1);
  CHECK(with(report::accurate, 1e-3, found(units::nan)) == 1);
  CHECK(with(report::accurate, 1e-3, throws) == 1);
  CHECK(with(report::degraded, 0.2, found(0.1)) == 0);
  CHECK(with(report::degraded, 0.2, found(0.3)) == 1);
  CHECK(with(report::refused, units::nan, throws) == 0);
  CHECK(with(report::refused, units::nan, gives_up) == 0);
  CHECK(with(report::refused, units::nan, found(0)) == 1);
  for (const double none : {units::nan, 0.0, -1.0, std::numeric_limits<double>::infinity()})
    CHECK(with(report::accurate, none, found(0)) == 1);  // no bound set
  CHECK(with(report::accurate, 1e-3, found(-2e-3)) == 1);
  CHECK(with(report::refused, 1, found(0)) == 1);
}

TEST_CASE("unit: an item whose arithmetic is invalid fails, and the others go on") {
  volatile double zero = 0;
  volatile double unused = 0;
  const Sample s;
  CHECK(s.reproduce(one([&](report::Item& item) {
    item.sketch();
    unused = 1 / zero;
  })) == 1);
  CHECK(s.record()["items"][0]["failure"] == "a division by zero in its arithmetic");
  CHECK(s.reproduce(one([](report::Item& item) { item.sketch(); })) == 0);
}

TEST_CASE(
    "unit: texts have no more digits than their tolerance, and rounding is reported by its "
    "decade") {
  CHECK(report::below(5.8e-15) == "below 1e-14");
  CHECK(report::below(-7.1e-15) == "below 1e-14");
  CHECK(report::below(0) == "below 1e-16");
  CHECK(report::below(0.5) == "below 1e+00");
  CHECK(report::below(1.001e-16) == "below 1e-15");
  CHECK(report::below(-0.002) == "below 1e-02");
  CHECK(report::below(INFINITY) == "inf");
  const Sample s;
  CHECK(s.reproduce(one([](report::Item& item) {
    item.expect_checks(6);
    item.agree("a", "a", "", 0.40084984, 0.40084, 1e-4, "another method");
    item.agree("d", "d", "", 0.400849, 0.4008412, 3e-4, "another method");
    item.agree("e", "e", "", 0.40321, 0.41234, 0.5, "another method");
    item.agree("f", "f", "", 0.400849840084, 0.400849840085, 1e-11, "another method");
    item.at_most("b", "b", "", 5.8e-15, 1e-12, "rounding");
    item.at_most("c", "c", "", 2.5399999, 2.54, "the limit");
  })) == 0);
  const auto checks = s.record()["checks"];
  CHECK(checks[0]["computed_text"] == "0.40085");
  CHECK(checks[0]["reference"] == "0.40084");
  CHECK(checks[1]["computed_text"] == "0.40085");  // no whole power of ten: a digit more
  CHECK(checks[2]["computed_text"] == "0.403");
  CHECK(checks[2]["reference"] == "0.412");
  CHECK(checks[3]["computed_text"] == "0.4008498401");
  CHECK(checks[4]["computed_text"] == "below 1e-14");
  CHECK(checks[5]["computed_text"] == "2.54");
}

TEST_CASE("unit: a check that cannot fail has failed") {
  const auto agree_with = [](double reference) {
    return one([=](report::Item& item) {
      item.expect_checks(1);
      item.agree("c", "c", "", reference, reference, 1e-12, "another method");
    });
  };
  CHECK(Sample{}.reproduce(agree_with(2)) == 0);
  const Sample toothless;  // a share of nothing is nothing
  CHECK(toothless.reproduce(agree_with(0)) == 1);
  CHECK(toothless.record()["checks"][0]["outcome"] == "failed");
  CHECK(toothless.record()["checks"][0]["kind"] ==
        "agrees_with, which passes shifted by twice its tolerance, too");
}

TEST_CASE("unit: the inventory and the checks name each other") {
  const auto section = one([](report::Item& i) {
    i.expect_checks(2);
    i.print("a", "a", "", "1.0", 1.04);
    i.claim("b", "b", true);
  });
  const auto with = [&](const std::string& rows) {
    const Sample s;
    s.at.write("data/inventory.csv", "place,kind,number,what,treated,symbol,test,reason\n" + rows);
    const int result = s.reproduce(section);
    if (result == 0) CHECK(s.record()["checks"][0]["place"] == "p. 1, Table 2");
    return result;
  };
  const std::string a = "p. 1,number,Table 2,a,t/a,,,\n", b = "p. 2,claim,,b,t/b,,,\n";
  CHECK(with(a + b) == 0);
  CHECK(with(a + "p. 2,claim,,b,t/*,,,\n") == 0);
  CHECK(with(a + b + "p. 3,figure,Fig. 1,drawing,t,,,\n") == 0);
  CHECK(with(a + b + "p. 3,claim,,cost,,,,not testable: the machine is gone\n") == 0);
  CHECK(with(a) == 1);                                           // a check without a place
  CHECK(with(a + b + "p. 3,number,,c,t/c,,,\n") == 1);           // an id that is not there
  CHECK(with(a + b + "p. 3,number,,c,,,,\n") == 1);              // left out without a reason
  CHECK(with(a + b + "p. 3,picture,,c,,,,not treated\n") == 2);  // no such kind
}

TEST_CASE("unit: the study is a page of its own") {
  const Sample s;
  const report::Section study{
      report::table("u", "U", [](report::Item& item) { item.added("a study"); })};
  REQUIRE(s.reproduce(one([](report::Item& item) { item.sketch(); }), {}, study) == 0);
  const auto items = s.record()["items"];
  CHECK(items[0]["id"] == "t");
  CHECK(items[0]["page"] == "paper");
  CHECK(items[1]["id"] == "u");
  CHECK(items[1]["page"] == "study");
}

TEST_CASE("unit: a display table writes its numbers as its headings say") {
  const Sample s;
  REQUIRE(s.reproduce(one([](report::Item& item) {
    item.sketch();
    item.columns({"what", {"error, mm", "{:.2f}"}, "n"});
    item.add_row("a", 1.234, "7");
    item.add_row("b", units::nan, 3.14159);
  })) == 0);
  CHECK(s.record()["items"][0]["columns"].dump() == R"(["what","error, mm","n"])");
  CHECK(s.record()["items"][0]["rows"].dump() == R"([["a","1.23","7"],["b","–","3.142"]])");
}

TEST_CASE("unit: values of one unit and format in a call are those of one call each") {
  const Sample s;
  REQUIRE(s.reproduce(one([](report::Item& i) {
    i.sketch();
    report::values(i, "mm", "{:.1f}", "low", 1.04, "high", 2);
  })) == 0);
  const auto r = s.record();
  CHECK(r["values"].size() == 2);
  CHECK(r["values"][0]["text"] == "1.0 mm");
  CHECK(r["values"][1]["text"] == "2.0 mm");
}
