// Statements of data/claims.csv hold where the numbers found lie in their intervals, and all are
// made.
#include <railbook/report/claims.hpp>

#include <catch2/catch.hpp>

#include "support/sample_chapter.hpp"

using namespace railbook;

namespace {

const std::string header = "check,claim,outcome,holds,found,why\n";
const std::string two = header +
                        "t/low,it is low,confirmed,..2; 0.5..1.5,{:.1f} and {:.2f},\n"
                        "t/near,it is near,consistent,; 3..,{1:.0f} m,near has no measure\n";

// What a run of one item with these claims leaves.
struct Run {
  int status;
  nlohmann::json record;
};
Run with_claims(const std::string& claims, const report::ItemFunction& f) {
  const Sample s;
  s.at.write("data/claims.csv", claims);
  const int status = s.reproduce(one(f));
  return {status, std::filesystem::exists(s.at.path / "results/00-sample.json") ? s.record()
                                                                                : nlohmann::json{}};
}

Run both(double low, double second, double near) {
  return with_claims(two, [=](report::Item& item) {
    item.claims({{"low", {low, second}}, {"near", {0, near}}});
  });
}

}  // namespace

TEST_CASE("unit: a claim holds where its numbers lie in their intervals") {
  const Run run = both(2, 1, 4);
  CHECK(run.status == 0);
  const auto checks = run.record["checks"];
  CHECK(checks[0]["what"] == "it is low");
  CHECK(checks[0]["outcome"] == "confirmed");
  CHECK(checks[0]["computed"] == "2.0 and 1.00");
  CHECK(checks[1]["outcome"] == "consistent");
  CHECK(checks[1]["computed"] == "4 m");
  CHECK(checks[1]["why"] == "near has no measure");
  CHECK(both(2.1, 1, 4).status == 1);
  CHECK(both(2, 0.4, 4).status == 1);
  CHECK(both(2, 1.6, 4).status == 1);
  CHECK(both(2, 1, 2.9).status == 1);
  CHECK(both(units::nan, 1, 4).status == 1);
}

TEST_CASE("unit: a claim can hold on a condition of the program") {
  const auto judged = [](bool condition) {
    return with_claims(header + "t/a,they rise,consistent,,to {:.0f},the profiles are ours\n",
                       [=](report::Item& item) { item.claim_if("a", condition, {7}); });
  };
  const Run run = judged(true);
  CHECK(run.status == 0);
  CHECK(run.record["checks"][0]["outcome"] == "consistent");
  CHECK(run.record["checks"][0]["computed"] == "to 7");
  CHECK(run.record["checks"][0]["why"] == "the profiles are ours");
  CHECK(judged(false).status == 1);
}

TEST_CASE("unit: a verified statement names its method") {
  const Run run = with_claims(header + "t/a,it adds,verified,1..,{:.0f},our own estimate\n",
                              [](report::Item& item) {
                                item.claims({{"a", {1}}});
                              });
  CHECK(run.status == 0);
  CHECK(run.record["checks"][0]["source"] == "route");
  CHECK(run.record["checks"][0]["by"] == "our own estimate");
}

TEST_CASE("unit: claims.csv lists exactly the claims that the tests make") {
  const auto failure = [](const std::string& claims, const report::ItemFunction& f) {
    const Run run = with_claims(claims, f);
    CHECK(run.status == 1);
    return run.record["items"][0]["failure"].get<std::string>();
  };
  CHECK(failure(two, [](report::Item& item) {
          item.claims({{"low", {1, 1}}});
        }) == "1 claims made, data/claims.csv has 2");
  CHECK(failure(two, [](report::Item& item) {
          item.claims({{"other", {1}}});
        }) == "data/claims.csv has no row of the check t/other");
  CHECK(failure(two, [](report::Item& item) {
          item.claims({{"low", {1}}});
        }) == "t/low: 1 numbers for 2 intervals");
  CHECK(failure(header + "t/a,it is,confirmed,,{},\n", [](report::Item& item) {
          item.claims({{"a", {1}}});
        }) == "t/a: a claim without a bound and without a trial cannot fail");
}

TEST_CASE("input: a table of claims that is not of its form is refused when the chapter starts") {
  const auto status = [](const std::string& row) {
    return with_claims(header + row, [](report::Item&) {}).status;
  };
  CHECK(status("x/a,it is,confirmed,1..,{},\n") == 2);                       // no such item
  CHECK(status("t/a,it is,fitted,1..,{},why\n") == 2);                       // another outcome
  CHECK(status("t/a,it is,consistent,1..,{},\n") == 2);                      // no reason
  CHECK(status("t/a,it is,confirmed,1..,{},why\n") == 2);                    // a reason too much
  CHECK(status("t/a,it is,confirmed,2..1,{},\n") == 2);                      // from more to less
  CHECK(status("t/a,it is,confirmed,2,{},\n") == 2);                         // no interval
  CHECK(status("t/a,it is,confirmed,two..,{},\n") == 2);                     // no number
  CHECK(status("t/a,,confirmed,1..,{},\n") == 2);                            // no words
  CHECK(status("t/a,b,confirmed,1..,{},\nt/a,b,confirmed,1..,{},\n") == 2);  // twice
}
