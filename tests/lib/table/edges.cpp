// Where a file begins and ends: the line that is named, and how far a reader has come.
#include <unistd.h>

#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include <railbook/table/csv.hpp>
#include <railbook/table/line_source.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("input: an empty file is reported at its first line, too many lines to skip as well") {
  const TemporaryFolder at("edges");
  for (const char* text : {"", "# only\n# remarks\n"})
    CHECK_THROWS_WITH(table::CsvReader(at.write("a.csv", text)),
                      Contains("line 1: empty; allowed: a header line and rows"));
  CHECK_THROWS_WITH(table::CsvReader(at.write("a.csv", "a\nb\n"), {.skip = 3}),
                    Contains("has no more lines than are to be skipped"));
  table::CsvReader reader(at.write("a.csv", "logger 7\n\na,b\n1,2\n\n# x\n\"3\",4\n"), {.skip = 1});
  CHECK(reader.header() == std::vector<std::string>{"a", "b"});
  REQUIRE(reader.next());
  CHECK(reader.line() == 4);
  REQUIRE(reader.next());
  CHECK(reader.line() == 7);
  CHECK(reader.cell(0) == "3");
  CHECK_FALSE(reader.next());
}

TEST_CASE("input: a file of another kind is refused by its name, with what makes it a table") {
  const TemporaryFolder at("foreign");
  const std::pair<std::string, std::string> files[] = {
      {std::string{"\x89HDF\r\n\x1a\n\0\0", 10}, "HDF5 file"},  // damaged, or no reader built
      {"MATLAB 5.0 MAT-file, Platform: GLNXA64" + std::string(9, '\0'), "MAT file"},
      {std::string{"PK\x03\x04\x14\0\x06\0", 8}, "the zip archive is damaged or cut off"},
      {"%PDF-1.7\n1 0 obj\n", "this is a PDF file"},
      {std::string{"CDF\1\0\0\0\0", 8}, "a netCDF-3 file; nccopy"},
      {std::string{"\x28\xB5\x2F\xFD\x04\0", 6}, "packed by zstd"},
      {std::string{"TDSm\x0E\0\0\0", 8}, "a TDMS file"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "by git lfs pull"},
      {"<!DOCTYPE HTML>\n<html>\n", "this is a web page"},
      {"\xEF\xBB\xBF<?xml version='1.0'?>\n", "this is an XML file"},
      {"{\"rows\": [1, 2]}\n", "this is a JSON file"},
      {"[{\"a\": 1}]\n", "this is a JSON file"},
  };
  for (const auto& [text, why] : files)
    CHECK_THROWS_WITH(table::CsvReader(at.write("a.csv", text)), Contains(why));
  // What a table may begin with.
  for (const char* text :
       {"[m],b\n1,2\n", "a,b\r\n1,2\r\n", "\"a\rb\",c\n1,2\n", "version,b\n1,2\n"})
    CHECK(table::CsvReader(at.write("a.csv", text)).next());
}

TEST_CASE("input: the share that was read, where the size is known") {
  const TemporaryFolder at("share");
  std::string text = "a\n";
  for (int i = 0; i < 200000; ++i) text += "1.5\n";
  table::LineSource file(at.write("a.csv", text));
  std::string_view line;
  double before = file.share();
  CHECK(before >= 0);
  CHECK(before < 0.7);
  bool back = false;
  while (file.next(line)) {
    back |= file.share() < before;
    before = file.share();
  }
  CHECK_FALSE(back);
  CHECK(file.share() == 1);
  CHECK(file.line() == 200001);

  int ends[2];
  REQUIRE(pipe(ends) == 0);
  REQUIRE(write(ends[1], "a\n1\n", 4) == 4);
  close(ends[1]);
  const int kept = dup(0);
  dup2(ends[0], 0);
  {
    table::LineSource piped("-");
    CHECK(piped.share() == -1);
    REQUIRE(piped.next(line));
    CHECK(piped.share() == -1);
  }
  dup2(kept, 0);
  close(kept);
  close(ends[0]);
}
