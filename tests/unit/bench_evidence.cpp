#include "bench/evidence.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

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
  const auto broken = bench::worst_digits(
      {}, {1.0}, [](double) { return std::nan(""); }, [](double) { return 1.0L; });
  CHECK(std::isnan(broken.worst));
}

TEST_CASE("unit: the worst of random cases, the same on every machine") {
  const auto run = [](bench::Draw& draw) {
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
  const auto run = [&](bench::Draw&) {
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
        [least](bench::Draw& draw) {
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
      [](bench::Draw&) {
        return report::Found{"nothing", units::nan};
      },
      3);
  report::ChapterRecord record;
  item.finish(record);
  REQUIRE(record.stability.size() == 4);
  CHECK(record.stability[0].found == "holds");
  CHECK(record.stability[1].found == "refused");
  CHECK(record.stability[1].result.find("of 100 cases") != std::string::npos);
  CHECK(record.stability[2].found == "holds");
  CHECK(record.stability[3].found == "fails");
}
