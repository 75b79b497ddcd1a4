#include <railbook/files/spool.hpp>

#include <catch2/catch.hpp>
#include <cerrno>
#include <numeric>
#include <utility>
#include <vector>

#include <railbook/files/outside.hpp>

#include "support/set_variable.hpp"

using namespace railbook;

TEST_CASE("files: files set aside are restored after a failure at any point") {
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
  errno = 0;
  CHECK_THROWS_WITH(moved.read(9950, back), "temporary file: cannot be read: Input/output error");
}

TEST_CASE("files: a folder for temporary files that is not there is reported") {
  const SetVariable tmpdir("TMPDIR");
  tmpdir.to("/nowhere");
  CHECK_THROWS_WITH(files::Spool{}, Catch::Contains("temporary file: cannot be made: No such"));
}
