#include <catch2/catch.hpp>
#include <cmath>
#include <span>
#include <vector>

#include <railbook/records/record.hpp>

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a record with a gap is put on an even grid") {
  const auto read_height = [](int i) { return 0.01 * std::sin(0.3 * i); };
  // example
  // a height each 25 cm, with two samples lost: gaps of up to 1 m are bridged, and counted
  std::vector<double> heights;  // m
  records::RecordStream record({.bridge_length = 1}, [&](std::span<const double> piece) {
    heights.insert(heights.end(), piece.begin(), piece.end());
  });
  for (int i = 0; i < 1000; ++i)
    if (i != 400 && i != 401) record.add(0.25 * i, read_height(i));  // position and height [m]
  record.finish();
  const double spacing = record.spacing();       // m
  const std::size_t bridged = record.bridged();  // samples
  const auto warnings = record.warnings();       // what to know before trusting the heights
  // end
  CHECK(heights.size() == 1000);
  CHECK(spacing == Approx(0.25));
  CHECK(bridged == 2);
  CHECK(heights[399] == read_height(399));
  CHECK(heights[400] == Approx((2 * read_height(399) + read_height(402)) / 3));
}
