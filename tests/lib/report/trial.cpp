// A verdict against the paper stands whatever is varied, or its check fails.
#include <railbook/report/trial.hpp>

#include <catch2/catch.hpp>

#include "support/sample_chapter.hpp"

using namespace railbook;
using report::Setting;

namespace {

const std::string declared =
    "check,choice,unit,settings\n"
    "t/stable,mesh,mm,4; 2; 1\n"
    "t/stable,orientation,,along; across\n"
    "t/m,start,,low; high\n";

// What a run of one item with these trials leaves.
struct Run {
  int status;
  nlohmann::json record;
};
Run with_trials(const std::string& trials, const report::ItemFunction& f) {
  const Sample s;
  s.at.write("data/trials.csv", trials);
  const int status = s.reproduce(one(f));
  return {status, std::filesystem::exists(s.at.path / "results/00-sample.json") ? s.record()
                                                                                : nlohmann::json{}};
}

report::Trial stable(report::Item& item) {
  return item.trial("stable", "speed", "{:.0f} m/s", [](double v) { return v < 10; });
}
void vary_m(report::Item& item, double low, double high) {
  report::Trial trial = item.trial("m", "moment", "{:.1f} N.m", report::misses("806.2"));
  trial.vary("start", [&](const Setting& s) { return s.text == "low" ? low : high; });
  item.print("m", "moment", "N.m", "806.2", 606.2,
             report::corrected(606.16, 1e-3, "5365 in.lbf", trial));
}

}  // namespace

TEST_CASE("unit: a trial computes the result for each declared setting and leaves its record") {
  const Run run = with_trials(declared, [](report::Item& item) {
    item.expect_checks(2);
    report::Trial trial = stable(item);
    trial.vary("mesh", [](const Setting& s) { return 5 + s.number; });
    trial.vary("orientation", [](const Setting& s) { return s.index == 1 ? 9.5 : 6; });
    item.refute("stable", "it is stable to 12 m/s", trial, "it ends at " + trial.range());
    item.value("range", trial.range());
    vary_m(item, 606.1, 606.9);
  });
  REQUIRE(run.status == 0);
  const auto claim = run.record["checks"][0], print = run.record["checks"][1];
  CHECK(claim["outcome"] == "not confirmed");
  CHECK(claim["trial"] == nlohmann::json::parse(R"({
    "quantity": "speed", "range": "6 to 10 m/s",
    "varied": [{"choice": "mesh", "settings": ["4 mm", "2 mm", "1 mm"],
                "results": ["9 m/s", "7 m/s", "6 m/s"], "range": "6 to 9 m/s"},
               {"choice": "orientation", "settings": ["along", "across"],
                "results": ["6 m/s", "10 m/s"], "range": "6 to 10 m/s"}]})"));
  CHECK(run.record["values"][0]["text"] == "6 to 10 m/s");
  // Print against computation, beside what the rounding of the print allows.
  CHECK(print["error"].get<double>() == Approx(200 / 806.2));
  CHECK(print["allowed"].get<double>() == Approx(0.05 / 806.2));
  CHECK(print["trial"]["range"] == "606.1 to 606.9 N.m");
}

TEST_CASE("unit: a verdict that one of the tried choices reverses fails, and says which") {
  const auto reversed_by = [](const std::function<double(const Setting&)>& mesh) {
    return with_trials("check,choice,unit,settings\nt/stable,mesh,mm,4; 2; 1\n",
                       [&](report::Item& item) {
                         item.expect_checks(1);
                         report::Trial trial = stable(item);
                         trial.vary("mesh", mesh);
                         item.refute("stable", "it is stable", trial, "it is not");
                       });
  };
  const Run run = reversed_by([](const Setting& s) { return s.number == 2 ? 11 : 5; });
  CHECK(run.status == 1);
  CHECK(run.record["checks"][0]["outcome"] == "failed");
  CHECK(run.record["checks"][0]["kind"] == "exact, which its trial reverses: mesh 2 mm: 11 m/s");
  const Run none = reversed_by([](const Setting& s) { return s.index == 0 ? units::nan : 5; });
  CHECK(none.record["checks"][0]["kind"] ==
        "exact, which its trial reverses: mesh 4 mm: no result");
  CHECK(none.status == 1);
}

TEST_CASE("unit: a printed number that a setting rounds to is no misprint") {
  const std::string rows = "check,choice,unit,settings\nt/m,start,,low; high\n";
  const auto with = [&](double high) {
    return with_trials(rows,
                       [=](report::Item& item) {
                         item.expect_checks(1);
                         vary_m(item, 606.1, high);
                       })
        .status;
  };
  CHECK(with(806.14) == 0);
  CHECK(with(806.24) == 1);
}

TEST_CASE("unit: a print that is not confirmed differs from what is computed") {
  const auto with = [](double computed) {
    return with_trials("check,choice,unit,settings\nt/m,start,,low; high\n",
                       [=](report::Item& item) {
                         item.expect_checks(1);
                         report::Trial trial =
                             item.trial("m", "moment", "{:.1f}", report::misses("8.1"));
                         trial.vary("start", [](const Setting&) { return 6; });
                         item.print("m", "m", "", "8.1", computed,
                                    report::not_confirmed("another mode", trial));
                       })
        .status;
  };
  CHECK(with(6) == 0);
  CHECK(with(8.14) == 1);
  CHECK(with(units::nan) == 1);
}

TEST_CASE("unit: a claim may carry its condition, and it holds in each variation") {
  const auto with = [](double worst) {
    return with_trials("check,choice,unit,settings\nt/stable,mesh,mm,2; 1\n",
                       [=](report::Item& item) {
                         item.expect_checks(1);
                         report::Trial trial = stable(item);
                         trial.vary("mesh", [=](const Setting& s) { return worst - s.number; });
                         item.claim("stable", "it is slow", trial, trial.range());
                       });
  };
  CHECK(with(9).status == 0);
  CHECK(with(9).record["checks"][0]["outcome"] == "confirmed");
  CHECK(with(11).status == 1);
}

TEST_CASE("unit: consistent claims say why, and checks of our own software are routes") {
  const Sample s;
  REQUIRE(s.reproduce(one([](report::Item& item) {
    item.expect_checks(2);
    item.consistent("a", "it is stiff", true, "15 % high", "an estimate of Rayleigh's kind");
    item.verify("b", "the filter is stable", true, "poles inside", "its poles");
  })) == 0);
  const auto checks = s.record()["checks"];
  CHECK(checks[0]["outcome"] == "consistent");
  CHECK(checks[0]["why"] == "an estimate of Rayleigh's kind");
  CHECK(checks[1]["source"] == "route");
  CHECK(checks[1]["by"] == "its poles");
  CHECK(status([](report::Item& item) {
          item.expect_checks(1), item.consistent("a", "a", true, "b", "");
        }) == 1);
  CHECK(status([](report::Item& item) {
          item.expect_checks(1), item.verify("a", "a", false, "b", "c");
        }) == 1);
}

TEST_CASE("unit: a trial varies exactly the parameters that it declares") {
  const auto failure = [](const report::ItemFunction& f) {
    const Run run = with_trials(declared, f);
    CHECK(run.status == 1);
    return run.record["items"][0]["failure"].get<std::string>();
  };
  CHECK(failure([](report::Item& item) {
          item.trial("other", "speed", "{}", [](double) { return true; });
        }) == "data/trials.csv has no row of the check t/other");
  CHECK(failure([](report::Item& item) {
          stable(item).vary("friction", [](const Setting&) { return 1; });
        }) == "data/trials.csv does not declare \"friction\"");
  CHECK(failure([](report::Item& item) {
          report::Trial trial = stable(item);
          for (int i = 0; i < 2; ++i) trial.vary("mesh", [](const Setting&) { return 1; });
        }) == "\"mesh\" is varied twice");
  // A declared choice that the code leaves out, and declared checks that are never made.
  const Run run = with_trials(declared, [](report::Item& item) {
    item.expect_checks(1);
    report::Trial trial = stable(item);
    trial.vary("mesh", [](const Setting&) { return 1; });
    item.refute("stable", "it is stable", trial, "it is not");
  });
  CHECK(run.record["checks"][0]["kind"] ==
        "exact, which its trial reverses: orientation was not varied");
  CHECK(run.record["problems"] == nlohmann::json{"data/trials.csv: no check t/m varies \"start\""});
}

TEST_CASE("input: a trial without variation is refused when the chapter starts") {
  const auto refused = [](const std::string& row) {
    const Run run = with_trials("check,choice,unit,settings\n" + row + "\n",
                                [](report::Item&) { FAIL("nothing is computed"); });
    CHECK(run.record.is_null());
    return run.status;
  };
  CHECK(refused("t/stable,mesh,mm,4") == 2);
  CHECK(refused("t/stable,mesh,mm,") == 2);
  CHECK(refused("t/stable,mesh,mm,4;") == 2);
  CHECK(refused("t/stable,mesh,mm,4; 4") == 2);
  CHECK(refused("t/stable,,mm,4; 2") == 2);
  CHECK(refused("elsewhere/stable,mesh,mm,4; 2") == 2);
  CHECK(refused("t/stable,mesh,mm,4; 2\nt/stable,mesh,mm,8; 6") == 2);
  CHECK_THROWS_WITH(
      [] {
        const TemporaryFolder at("trials");
        report::read_trials(at.write("t.csv", "check,choice,unit,settings\nt/a,mesh,mm,4\n"),
                            {"t"});
      }(),
      Catch::Contains("row 1: settings has one only; allowed: two or more, with semicolons"));
}
