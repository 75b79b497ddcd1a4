#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

#include "support/packed.hpp"

using namespace railbook;
using Catch::Matchers::Contains;
using namespace railbook::tests;
namespace fs = std::filesystem;

namespace {

struct File {
  fs::path path = fs::temp_directory_path() / ("railbook-dialect-" + std::to_string(::getpid()));
  explicit File(const std::string& text) { std::ofstream{path, std::ios::binary} << text; }
  ~File() { fs::remove(path); }
};

const std::vector<table::ColumnWanted> track{{"distance", units::length},
                                             {"profile", units::length}};

}  // namespace

TEST_CASE("input: commas, semicolons and tabs; decimal commas; headers in many spellings") {
  for (const std::string text :
       {"distance_m,profile_mm\n0.25,-1.5\n0.5,2\n",
        "Distance (m),Profile (mm)\n0.25,-1.5\n0.5,2\n",
        "distance [m];profile [mm]\n0,25;-1,5\n0,5;2\n",
        "DISTANCE, m;PROFILE, mm\n0,25;-1,5\n0,5;2\n",
        "Distance [km]\tProfile (um)\n0.00025\t-1500\n0.0005\t2000\n",
        "\xEF\xBB\xBF\"Distance (metres)\";\"Profile (MM)\"\r\n\"0,25\";-1,5\r\n0,5;2\r\n",
        "# a recorder\n\nDistance in metres;Profile in mm\n# units above\n0.25;-1.5\n0.5;2\n",
        "Profile_mm;;distance_m\n-1,5;;0,25\n2;x;0,5\n"}) {
    CAPTURE(text);
    const File f{text};
    const auto columns = table::read_columns(f.path, track);
    REQUIRE(columns[0].size() == 2);
    CHECK(columns[0][0] == Approx(0.25));
    CHECK(columns[0][1] == Approx(0.5));
    CHECK(columns[1][0] == Approx(-1.5e-3));
    CHECK(columns[1][1] == Approx(2e-3));
  }
}

TEST_CASE("input: where header and row agree on no separator it is the header's own") {
  const File f{"distance [m];profile [mm];note, short\n0.25;1\n"};
  CHECK_THROWS_WITH(table::read_columns(f.path, track), Contains("2 cells; allowed: 3"));
  const File g{"distance [m],profile [mm],note; short\n0.25,1\n"};
  CHECK_THROWS_WITH(table::read_columns(g.path, track), Contains("2 cells; allowed: 3"));
}

TEST_CASE("input: units in headers") {
  const auto unit = [](const char* header) { return table::parse_column(header).unit_text; };
  const auto name = [](const char* header) { return table::parse_column(header).name; };
  CHECK(unit("Gauge (inches)") == "in");
  CHECK(name("Gauge (inches)") == "Gauge");
  CHECK(unit("a_m_per_s2") == "m/s2");
  CHECK(unit("Acceleration [m/s\xC2\xB2]") == "m/s^2");
  CHECK(unit("Speed [km/h]") == "kmh");
  CHECK(unit("level left (D1)").empty());
  CHECK(unit("profile").empty());
  CHECK(unit("(mm)").empty());
  CHECK(unit("").empty());
  CHECK(unit("Rail 2").empty());
}

TEST_CASE("input: columns by number, and a file without headers") {
  const File f{"0.25;1,5\n0.5;2\n"};
  table::CsvReader reader{f.path};
  CHECK(reader.header() == std::vector<std::string>{"1", "2"});
  CHECK(reader.column("#2") == 1);
  REQUIRE(reader.next());
  CHECK(reader.line() == 1);
  CHECK(reader.number(0) == 0.25);
  CHECK_THROWS_WITH(reader.number(1), Contains("with a decimal point as before"));
  const File equal{"a,b;c\n1\n"};
  CHECK(table::CsvReader{equal.path}.header() == std::vector<std::string>{"a", "b;c"});
  const File commas{"a;b\n0,5;1\n1;0.25\n"};
  table::CsvReader comma{commas.path};
  REQUIRE(comma.next());
  CHECK(comma.number(0) == 0.5);
  REQUIRE(comma.next());
  CHECK_THROWS_WITH(comma.number(1), Contains("with a decimal comma as before"));
  const File twice{"x_m,z_mm,z_mm\n1,2,3\n"};
  table::CsvReader other{twice.path};
  CHECK_THROWS_WITH(other.column("z"), Contains("twice") && Contains("number 2 and 3"));
  CHECK(other.column("3") == 2);
  CHECK_THROWS_WITH(other.column("4"), Contains("no column \"4\"; there are: x_m, z_mm, z_mm"));
  CHECK_THROWS_WITH(table::CsvReader(twice.path, {.skip = 9}), Contains("no more lines"));
}

TEST_CASE("input: cells that stand for nothing") {
  const File f{"a_m,b_m\n,NaN\nNA,n/a\n-,null\n-nan,-nan(ind)\n1.#QNAN,-1.#IND\n#,NV\n"};
  table::CsvReader reader{f.path};
  for (int i = 0; i < 5; ++i) {
    REQUIRE(reader.next());
    CHECK(std::isnan(reader.number(0)));
    CHECK(std::isnan(reader.number(1)));
  }
  CHECK_FALSE(reader.next());  // "#,NV" is a comment
}

TEST_CASE("input: gzip is unpacked as it is read; what is cut off or damaged is reported") {
  std::string text = "distance_m,profile_mm\n";
  for (int i = 0; i < 50000; ++i) text += std::to_string(i) + "," + std::to_string(i % 17) + "\n";
  const std::string whole = packed(text);
  const File f{whole};
  CHECK(table::read_columns(f.path, track)[0].size() == 50000);
  const File two{packed(text.substr(0, 22)) + packed(text.substr(22))};
  CHECK(table::read_columns(two.path, track)[0].size() == 50000);
  const File cut{whole.substr(0, whole.size() / 2)};
  CHECK_THROWS_WITH(table::read_columns(cut.path, track), Contains("the gzip data are cut off"));
  std::string bad = whole;
  for (std::size_t i = bad.size() / 2; i < bad.size() / 2 + 40; ++i) bad[i] = '\x55';
  const File damaged{bad};
  CHECK_THROWS_WITH(table::read_columns(damaged.path, track),
                    Contains("damaged") || Contains("cells") || Contains("finite"));
  const File mark{"\x1f\x8b"};
  CHECK_THROWS_AS(table::read_columns(mark.path, track), InputError);
}

TEST_CASE("property: a row read at once is the row read cell by cell, its refusals too") {
  std::mt19937_64 random{3};
  const auto one_of = [&](const auto& list) { return list[random() % std::size(list)]; };
  const std::array usual{"1.5",
                         "-0.25",
                         "17",
                         "0.1",
                         "-42.7096805635",
                         "99999999.99",
                         "0",
                         "-0",
                         "3.00000000001",
                         "123456789012345",
                         "1e-3",
                         "2E5",
                         ".5",
                         "5.",
                         "0.000000000000001",
                         " 8 ",
                         "1e400",
                         "-.5",
                         "9007199254740993"};
  const std::array odd{"+3",  "nan",   "",    "\"4\"", "x", "--1",      "1.5.2",
                       "inf", "0x1p3", "1,5", "#",     "-", "\"a\nb\"", "1 2"};
  int refused = 0, at_once_read = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::string separator = one_of(std::array{",", ";", "\t", " "});
    const bool commas = separator != "," && random() % 3 == 0;
    const unsigned quotes = random() % 3 == 0 ? 2 : 0;  // of three cells
    const std::string ending = one_of(std::array{"\n", "\r\n"});
    std::string text = "a_m" + separator + "b_m" + separator + "c_m" + ending;
    for (int row = 0; row < 6; ++row) {
      for (int cell = 0; cell < 3; ++cell) {
        std::string one = random() % 40 == 0 ? one_of(odd) : one_of(usual);
        if (commas) std::replace(one.begin(), one.end(), '.', ',');
        if (random() % 3 < quotes) one = '"' + one + '"';
        text += one;
        if (cell < 2 || random() % 100 == 0) text += separator;
      }
      if (row < 5 || random() % 2 == 0) text += ending;
      if (random() % 40 == 0) text += one_of(std::array{"\n", "# remark\n", " \n"});
    }
    const File file{text};
    const auto read = [&](std::size_t at_once) {  // rows
      std::string told;
      try {
        table::CsvReader reader{file.path};
        std::vector<std::size_t> columns{0, 2};
        if (round % 2 == 0) columns.insert(columns.begin() + 1, 1);
        const std::size_t room = std::max<std::size_t>(at_once, 1);
        std::vector<double> v(columns.size() * room);
        while (true) {
          std::size_t rows = at_once > 0 ? reader.numbers(columns, v) : 0;
          at_once_read += static_cast<int>(rows);
          if (rows == 0) {
            if (!reader.next()) break;
            for (std::size_t i = 0; i < columns.size(); ++i)
              v[i * room] = reader.number(columns[i]);
            rows = 1;
          }
          for (std::size_t r = 0; r < rows; ++r) {
            std::array<char, 80> line{};
            for (std::size_t i = 0; i < columns.size(); ++i) {
              std::snprintf(line.data(), line.size(), "%zu %a\n", reader.line() + 1 + r - rows,
                            v[i * room + r]);
              told += line.data();
            }
          }
        }
      } catch (const InputError& error) {
        told += error.what();
        ++refused;
      }
      return told;
    };
    const std::string by_cell = read(0);
    for (const std::size_t rows : {1U, 3U, 1000U}) REQUIRE(read(rows) == by_cell);
  }
  CHECK(refused > 500);
  CHECK(at_once_read > 3000);
}

TEST_CASE("input: a row with one empty cell too many is refused, at once as cell by cell") {
  for (const char* row : {"1,2,,\n", "1,2,3,,\n", "1,2,,,\n"}) {
    const File file{std::string("a,b,c\n") + row + "4,5,6\n"};
    for (const std::array<std::size_t, 2>& columns : {std::array<std::size_t, 2>{0, 1}, {0, 2}}) {
      table::CsvReader reader{file.path};
      std::array<double, 8> values{};
      CHECK(reader.numbers(columns, values) == 0);
      CHECK_THROWS_AS(reader.next(), InputError);
    }
  }
}

TEST_CASE("input: a number with a zero byte behind it is refused, at once as cell by cell") {
  using std::string_literals::operator""s;
  for (const char decimal : {'.', ','}) {
    const File file{"a,b\n1,2\n3,4\n5,6\n7,8\n9\0,10\n"s};
    table::CsvReader reader{file.path, {.decimal = decimal}};
    const std::array<std::size_t, 2> columns{0, 1};
    std::array<double, 32> values{};
    const auto read = [&] {
      while (reader.next()) reader.numbers(columns, values);
    };
    CHECK_THROWS_WITH(read(), Contains("line 6: holds a zero byte"));
  }
}

TEST_CASE("input: a comma in quotation marks is no decimal comma where commas are between cells") {
  const File file{"a,b\n\"1,5\",2\n"};
  table::CsvReader reader{file.path};
  REQUIRE(reader.next());
  CHECK_THROWS_WITH(reader.number(0), Contains("column \"a\" is \"1,5\"; allowed: a finite"));
  CHECK(reader.number(1) == 2);
}
