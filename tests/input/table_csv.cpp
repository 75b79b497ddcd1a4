#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "table/csv.hpp"
#include "units/input_error.hpp"

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

TEST_CASE("property: a written table reads back the same") {
  const File f{"key,text\n" + table::csv_cell("a") + "," + table::csv_cell("say \"x, y\" # z") +
               "\n"};
  CHECK(table::read_table(f.path).at("a", "text") == "say \"x, y\" # z");
  CHECK(std::stod(table::csv_number(1.0 / 3)) == Approx(1.0 / 3).epsilon(1e-12));
}
