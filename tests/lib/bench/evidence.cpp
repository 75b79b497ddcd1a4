#include <railbook/bench/evidence.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "support/sample_chapter.hpp"

using namespace railbook;

TEST_CASE("unit: the share of covered estimates") {
  CHECK(bench::covered({{"a", 2, 1}, {"b", 1, 1}, {"c", 1, 1.1}, {"d", 0, 0}}) == 0.75);
  CHECK(std::isnan(bench::covered({})));
}

TEST_CASE("unit: digits are compared in extended precision") {
  // exp(x) - 1 by subtraction loses all digits as x tends to 0.
  const auto row = bench::worst_digits(
      {"expm1", "exp(x) - 1", "1e-10 to 1", "expm1l", 1e-15}, {1, 1e-3, 1e-10},
      [](double x) { return std::exp(x) - 1; },
      [](double x) { return std::expm1(static_cast<long double>(x)); });
  CHECK(row.at == 1e-10);
  CHECK(row.worst == Approx(8.3e-8).epsilon(0.05));
  const auto below = bench::worst_digits(
      {}, {-1.0, -4.0}, [](double x) { return x < -2 ? 1.01 * x : x; },
      [](double x) { return static_cast<long double>(x); });
  CHECK(below.at == -4);
  CHECK(below.worst == Approx(0.01));
  const auto broken = bench::worst_digits(
      {}, {1.0}, [](double) { return std::nan(""); }, [](double) { return 1.0L; });
  CHECK(std::isnan(broken.worst));
}

TEST_CASE("unit: the worst of random cases, the same on every machine") {
  const auto run = [](bench::RandomStream& draw) {
    const double x = draw(0, 1);
    const double y = draw.decades(1e-3, 1e3);
    CHECK((y >= 1e-3 && y <= 1e3));
    if (x < 0.1) throw report::NoAnswer{"too small"};
    return report::Found{"x", x};
  };
  const bench::Worst worst = bench::worst_of(200, 5, run);
  CHECK(worst.cases == 200);
  CHECK(worst.unanswered > 5);
  CHECK(worst.unanswered < 45);
  CHECK(worst.found.error > 0.95);
  CHECK(worst.found.error == bench::worst_of(200, 5, run).found.error);
}

TEST_CASE("unit: NaN without a word is the worst case, wherever it stands") {
  int k = 0;
  const auto run = [&](bench::RandomStream&) {
    ++k;
    return report::Found{std::to_string(k), k == 3 ? units::nan : 1.0 * k};
  };
  const bench::Worst worst = bench::worst_of(10, 5, run);
  CHECK(std::isinf(worst.found.error));
  CHECK(worst.found.text == "3");
  CHECK(worst.unanswered == 0);
}

TEST_CASE("unit: a row refuses cases without an answer unless it says how many are allowed") {
  report::Item item{"sweep", "table", "sweep", {}};
  const auto row = [&](double least, int may_refuse) {
    bench::worst_row(
        item, {.id = "r", .what = "row", .stress = "chance", .allowed = 1}, 100, 5,
        [least](bench::RandomStream& draw) {
          const double x = draw(0, 1);
          if (x < least) throw report::NoAnswer{"too small"};
          return report::Found{"x", x > 0.99 * least ? x : 2};
        },
        may_refuse);
  };
  row(0, 0);
  row(0.5, 0);
  row(0.5, 99);
  bench::worst_row(
      item, {.id = "nan", .what = "row", .stress = "NaN", .allowed = 1}, 3, 5,
      [](bench::RandomStream&) {
        return report::Found{"nothing", units::nan};
      },
      3);
  report::ChapterRecord record;
  item.finish(record);
  REQUIRE(record.stability.size() == 4);
  CHECK(record.stability[0].found == "holds");
  CHECK(record.stability[1].found == "refused");
  CHECK(record.stability[2].found == "holds");
  CHECK(record.stability[3].found == "fails");
  int below = 0;  // of the draws, those without an answer
  for (std::uint64_t k = 0; k < 100; ++k) below += bench::RandomStream{5, k}(0, 1) < 0.5;
  const std::string none = std::to_string(below);
  CHECK(record.stability[0].result == "worst of 100: x");
  CHECK(record.stability[1].result == none + " of 100 cases without an answer; allowed: 0");
  CHECK(record.stability[2].result ==
        "worst of 100: x; " + none + " said that they have no answer");
  CHECK(record.stability[3].result == "worst of 3: nothing");
}

TEST_CASE("unit: estimates stand beside the truth, an exact one at the end of a logarithmic axis") {
  const Sample s;
  const auto with = [&](std::vector<bench::Estimate> runs, double least) {
    return s.reproduce({report::figure("e", "E",
                                       [&](report::Item& item) {
                                         item.expect_checks(1);
                                         bench::estimates_against_truth(item, runs, least);
                                       })},
                       {"--no-timings", "--no-figures"});
  };
  CHECK(with({{"a", 2e-3, 1e-3},
              {"b", 5e-3, 1e-3},
              {"c", 8e-3, 1e-3},
              {"d", 1e-3, 2e-3},
              {"e", 1e-17, 0},
              {"f", 0, 2e-18}},
             0.66) == 0);
  CHECK(s.at.read("results/00-sample/e.csv") ==
        "case,stated,truth,covered\na,0.002,0.001,1\nb,0.005,0.001,1\nc,0.008,0.001,1\nd,0.001,0."
        "002,0\n"
        "e,1e-17,1e-17,1\nf,1e-17,1e-17,0\n"
        "# holds to relative 0.9, absolute 1e-12 in *: differences of nearly equal numbers\n");
  auto r = s.record();
  CHECK(r["values"][0]["text"] == "67 % of 6");
  CHECK(r["values"][1]["text"] == "2");  // of 0.5, 1, 1, 2, 5, 8
  CHECK(r["checks"][0]["computed_text"] == "0.6667");
  CHECK(r["items"][0]["script"] == "estimates.gp");
  CHECK(with({{"a", 2e-3, 1e-3}, {"b", 1e-3, 2e-3}}, 0.51) == 1);
  CHECK(with({}, 0.5) == 1);  // no runs show nothing
}

TEST_CASE("unit: the digits that a function loses are counted from a double's rounding") {
  const Sample s;
  const double worst[] = {0, 1e-16, 1.2e-16, 1.1e-13, 1.2e-13};
  REQUIRE(s.reproduce(one([&](report::Item& item) {
    item.expect_checks(5);
    std::vector<bench::Digits> rows;
    for (const double w : worst)
      rows.push_back(
          {"d" + std::to_string(rows.size()), "K(m)", "0 <= m < 1", "series", 1e-12, w, 0});
    bench::digits_table(item, rows);
  })) == 0);
  const auto r = s.record();
  CHECK(r["items"][0]["columns"].dump() ==
        R"(["function","range","largest relative error","digits lost","against"])");
  const char* below[] = {"below 1e-16", "below 1e-16", "below 1e-15", "below 1e-12", "below 1e-12"};
  const char* lost[] = {"0", "0", "1", "3", "4"};
  for (std::size_t k = 0; k < 5; ++k)
    CHECK(r["items"][0]["rows"][k] ==
          nlohmann::json{"K(m)", "0 <= m < 1", below[k], lost[k], "series"});
  CHECK(r["checks"][4]["what"] == "largest relative error of K(m)");
  CHECK(r["checks"][4]["kind"] == "at_most");
}
