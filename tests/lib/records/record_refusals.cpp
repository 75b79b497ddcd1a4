#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/records/record.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;

namespace {

void read(const std::vector<double>& positions, const records::RecordOptions& options = {}) {
  records::RecordStream stream{options, [](std::span<const double>) {}};
  for (std::size_t i = 0; i < positions.size(); ++i)
    stream.add(positions[i], static_cast<double>(i % 5));
  stream.finish();
}

std::vector<double> even(std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 0.5 * static_cast<double>(i);
  return x;
}

}  // namespace

TEST_CASE("input: positions that do not ascend evenly are refused, early or late in the record") {
  for (const std::size_t place : {5U, 1500U}) {
    auto x = even(2000);
    CHECK_NOTHROW(read(x));
    x[place] = x[place - 1];
    CHECK_THROWS_WITH(read(x), Catch::Contains("do not ascend"));
    x[place] = x[place - 1] - 3;
    CHECK_THROWS_WITH(read(x), Catch::Contains("do not ascend"));
    x[place] = x[place - 1] + 0.7;
    CHECK_THROWS_WITH(read(x), Catch::Contains("not evenly spaced"));
    x[place] = 1e9;
    CHECK_THROWS_WITH(read(x), Catch::Contains("jump too far"));
    x[place] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(read(x), Catch::Contains("position of sample"));
    x[place] = std::numeric_limits<double>::quiet_NaN();  // a lost sample
    CHECK_NOTHROW(read(x));
  }
}

TEST_CASE("input: jumps that add up, and a spacing that changes, are refused wherever they are") {
  std::vector<double> jumps;
  for (int i = 0; i < 4500; ++i) jumps.push_back(i < 1500 ? i : 9e6 * i);
  CHECK_THROWS_WITH(read(jumps), Catch::Contains("jump too far"));
  std::vector<double> many;
  for (int i = 0; i < 200000; ++i) many.push_back(i < 1500 ? i : 40.0 * i);
  CHECK_THROWS_WITH(read(many), Catch::Contains("jump too far"));
  for (const int from : {40, 900, 20000, 39000, 39950})
    for (const double change : {0.8, 0.9, 1.05, 1.2192}) {
      std::vector<double> x{0};
      for (int i = 1; i < 40000; ++i) x.push_back(x.back() + 0.25 * (i < from ? 1 : change));
      CAPTURE(from, change);
      if ((from == 40 || from == 39950) && change == 1.05) continue;  // two samples off
      CHECK_THROWS_WITH(read(x), Catch::Contains("not evenly spaced"));
    }
}

TEST_CASE("input: turning, unknown and contradictory spacings are refused") {
  CHECK_NOTHROW(read({3, 2, 1, 0}));
  CHECK_THROWS_WITH(read({3, 2, 1, 2, 0}), Catch::Contains("do not descend"));
  CHECK_THROWS_WITH(read({3}), Catch::Contains("needs two"));
  CHECK_THROWS_WITH(read(even(2000), {.spacing = 0.3048}), Catch::Contains("0.5"));
  CHECK_THROWS_AS(read(even(10), {.spacing = -1}), InputError);
  records::RecordStream stream{{}, [](std::span<const double>) {}};
  stream.add(1);
  CHECK_THROWS_WITH(stream.finish(), Catch::Contains("spacing"));
}

TEST_CASE("input: a record that is empty, missing, constant or out of this world is refused") {
  const auto finish = [](const std::vector<double>& values) {
    records::RecordStream stream{{.spacing = 1}, [](std::span<const double>) {}};
    for (const double value : values) stream.add(value);
    stream.finish();
  };
  const double nan = std::nan("");
  CHECK_THROWS_WITH(finish({}), Catch::Contains("no finite sample"));
  CHECK_THROWS_WITH(finish({nan, nan}), Catch::Contains("no finite sample"));
  CHECK_THROWS_WITH(finish({2.5, 2.5, nan, 2.5}), Catch::Contains("constant signal"));
  CHECK_NOTHROW(finish({1, 2}));
  CHECK_NOTHROW(finish({1, -1e6}));
  CHECK_THROWS_WITH(finish({1, nan, 1e100}),
                    Catch::Contains("sample 3") && Catch::Contains("1e+100"));
  CHECK_THROWS_WITH(finish({-1e200}), Catch::Contains("from -1000000 to 1000000"));
}
