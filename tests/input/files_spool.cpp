#include <catch2/catch.hpp>
#include <cstdlib>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "files/outside.hpp"
#include "files/spool.hpp"

using namespace railbook;

TEST_CASE("files: what is set aside comes back from any place") {
  files::Spool spool;
  std::vector<double> values(10000);
  std::iota(values.begin(), values.end(), 0.0);
  spool.append(std::span{values}.first(4000));
  spool.append(std::span{values}.subspan(4000));
  files::Spool moved = std::move(spool);
  CHECK(moved.size() == 10000);
  std::vector<double> back(100);
  moved.read(3950, back);
  CHECK(back.front() == 3950);
  CHECK(back.back() == 4049);
  CHECK_THROWS_AS(moved.read(9950, back), files::OutsideError);
}

TEST_CASE("files: a folder for temporary files that is not there is told") {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/nowhere", 1);
  CHECK_THROWS_WITH(files::Spool{}, Catch::Contains("temporary file: cannot be made: No such"));
  if (before != nullptr)
    ::setenv("TMPDIR", kept.c_str(), 1);
  else
    ::unsetenv("TMPDIR");
}
