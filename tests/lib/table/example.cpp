#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/table/csv.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;

// The example of this room on the book's page of the library.
TEST_CASE("example: a column of a recorder's file") {
  const TemporaryFolder at("example");
  const auto file = at.write("track.csv", "Distance [km];Profile (mm)\n0,000;1,5\n0,001;-2,5\n");
  // example
  // separators, decimal commas and the spelling of headers are found out
  table::CsvReader reader(file);
  const std::size_t profile = reader.column("profile");
  const double unit = table::parse_column(reader.header()[profile]).unit.si;  // m
  double lowest = 0;
  while (reader.next()) lowest = std::min(lowest, reader.number(profile) * unit);
  // end
  CHECK(std::abs(lowest + 2.5e-3) < 1e-15);
}
