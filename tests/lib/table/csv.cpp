#include <railbook/table/csv.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include <railbook/units/input_error.hpp>

using namespace railbook;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

struct File {
  fs::path path =
      fs::temp_directory_path() / ("railbook-csv-" + std::to_string(::getpid()) + ".csv");
  explicit File(const std::string& text) { std::ofstream{path, std::ios::binary} << text; }
  ~File() { fs::remove(path); }
};

const std::vector<table::ColumnWanted> track{{"distance", units::length},
                                             {"profile", units::length}};

}  // namespace

TEST_CASE("input: columns come in as SI, by name, in the order asked for") {
  const File f{"profile_mm,distance_m\r\n# a comment\r\n\r\n1.5,0\r\n-2,0.3048\r\n"};
  const auto columns = table::read_columns(f.path, track);
  CHECK(columns[0] == std::vector<double>{0, 0.3048});
  CHECK(columns[1][0] == Approx(0.0015));
}

TEST_CASE("input: a bad file is refused with its name, line and reason") {
  const auto refusal = [](const std::string& text) -> std::string {
    const File f{text};
    try {
      (void)table::read_columns(f.path, track);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(refusal(""), Contains("empty"));
  CHECK_THAT(refusal("distance_m\n1\n"), Contains("no column \"profile\""));
  CHECK_THAT(refusal("distance_m,profile_kN\n1,1\n"), Contains("unit"));
  CHECK_THAT(refusal("distance_m,profile\n1,1\n"), Contains("names no unit"));
  CHECK_THAT(refusal("distance_m,profile_mm\n1\n"), Contains("line 2"));
  CHECK_THAT(refusal("distance_m,profile_mm\n0,1\n1,x2\n"), Contains("line 3") && Contains("x2"));
  CHECK_THAT(refusal("distance_m,profile_mm\n0,NaN\n"), Contains("NaN"));
  CHECK_THAT(refusal("distance_m,profile_mm\n0,1e999\n"), Contains("finite"));
  CHECK_THAT(refusal("distance_m,distance_m,profile_mm\n"), Contains("twice"));
  CHECK_THAT(refusal("distance_m,\"profile_mm\n"), Contains("quote"));
  CHECK_THROWS_WITH(table::read_columns("/nowhere/track.csv", track),
                    Contains("/nowhere/track.csv"));
}

TEST_CASE("input: a table is asked by key or row, and column") {
  const File f{"key,text\r\na,first\nb,second\r\n"};
  const table::CsvTable table = table::read_table(f.path);
  CHECK(table.at("b", "text") == "second");
  CHECK(table.at(0, "text") == "first");
  CHECK_THROWS_AS(table.at("c", "text"), std::logic_error);
  CHECK_THROWS_AS(table.at("a", "word"), std::logic_error);
  CHECK_THROWS_AS(table.at(2, "text"), std::logic_error);
  CHECK(table::csv_number(1.0 / 3) == "0.333333333333");
  CHECK(table::csv_number(std::nan("")) == "nan");
  CHECK(table::csv_cell("in one word") == "in one word");
}

TEST_CASE("input: no message repeats a long cell or steers the terminal") {
  const auto refusal = [](const std::string& text) {
    const File f{text};
    try {
      (void)table::read_columns(f.path, track);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  const std::string esc = "\x1b]0;owned\x07", huge(4 << 20, 'z');
  for (const std::string& text :
       {"distance_m," + esc + "\n1,1\n", "distance_m," + huge + "\n1,1\n",
        "distance_m,profile_mm\n0," + esc + "\n", "distance_m,profile_mm\n0," + huge + "\n",
        "distance_m," + esc + "," + esc + "\n", "distance_m,profile_" + esc + "\n0,1\n"}) {
    const std::string said = refusal(text);
    CHECK(said.size() > 20);
    CHECK(said.size() < 1500);
    CHECK(said.find('\x1b') == std::string::npos);
  }
  CHECK_THAT(refusal("distance_m,profile_mm\n0,+-1\n"), Contains("allowed: a finite number"));
  CHECK_THAT(refusal("distance_m,profile_km\n0,1e308\n"), Contains("overflows"));
  CHECK_THAT(refusal("distance_m,profile_mm\n0,\"1\n" + std::string(500, '\n')),
             Contains("line 2") && Contains("a quote is not closed"));
  CHECK_THAT(refusal("distance_m,\"profile\"_mm\n"), Contains("text after a closing quote"));
}

TEST_CASE("input: a pipe is read like a file, a failing read is no end of file") {
  const fs::path pipe = fs::temp_directory_path() / ("railbook-fifo-" + std::to_string(::getpid()));
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread writer([&] { std::ofstream{pipe} << "distance_m,profile_mm\n0,1\n1,2\n"; });
  CHECK(table::read_columns(pipe, track)[0].size() == 2);
  writer.join();
  CHECK_THROWS_WITH(table::LineSource(pipe, std::chrono::milliseconds{20}),
                    Contains("nobody writes to (waited 0.02 s)"));
  fs::remove(pipe);
  CHECK_THROWS_WITH(table::read_columns("/", track), Contains("Is a directory"));
  CHECK_THROWS_WITH(table::read_columns("/proc/self/mem", track),
                    Contains("cannot be read further: Input/output error"));
}
