// Texts as programs and countries write them: encodings, line ends, blanks, decimals, headers.
#include <iconv.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/table/dates.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<double>> rows;
};

Table read(const std::string& text, const table::TextOptions& options = {}) {
  const TemporaryFolder folder("text forms");
  table::CsvReader reader{folder.write("a.csv", text), options};
  Table result{reader.header(), {}};
  while (reader.next()) {
    auto& row = result.rows.emplace_back();
    for (std::size_t i = 0; i < result.header.size(); ++i) row.push_back(reader.number(i));
  }
  return result;
}

// The text in UTF-16 with a byte order mark; ASCII only.
std::string utf16(const std::string& text, bool big) {
  std::string result = big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) result += big ? std::string{'\0', c} : std::string{c, '\0'};
  return result;
}

const std::vector<std::string> x_and_z{"x_m", "z_mm"};
const std::vector<std::vector<double>> two_rows{{0, 1.5}, {0.25, -2}};

}  // namespace

TEST_CASE("input: UTF-16 is read by its byte order mark, other encodings by name") {
  const std::string text = "x_m,z_mm\n0,1.5\n0.25,-2\n";
  for (const bool big : {false, true}) {
    const Table t = read(utf16(text, big));
    CHECK(t.header == x_and_z);
    CHECK(t.rows == two_rows);
  }
  const std::string german =
      "Weg [m];\xDC"
      "berh\xF6hung [mm]\n0;1,5\n0,25;-2\n";
  const Table t = read(german, {.encoding = "cp1252"});
  CHECK(t.header[1] ==
        "\xC3\x9C"
        "berh\xC3\xB6hung [mm]");
  CHECK(t.rows == two_rows);
  CHECK(read(german, {.encoding = "latin1"}).header == t.header);
  CHECK_THROWS_WITH(read(text, {.encoding = "klingon"}),
                    Contains("encoding is \"klingon\"; allowed: a name that iconv knows"));
  CHECK_THROWS_WITH(read(text, {.encoding = "UTF-8//IGNORE"}), Contains("encoding is"));
  CHECK_THROWS_WITH(read(german, {.encoding = "UTF-8"}), Contains("no text in the encoding UTF-8"));
  // Half a character at the end.
  CHECK_THROWS_WITH(read(utf16(text, false) + "1"), Contains("no text in the encoding UTF-16"));
}

TEST_CASE("input: Chinese and Japanese headers, where iconv has their encodings") {
  for (const auto& [encoding, header, utf8] :
       {std::tuple{"GBK", "\xC0\xEF\xB3\xCC,z\n1,2\n", "\xE9\x87\x8C\xE7\xA8\x8B"},
        std::tuple{"Shift-JIS", "\x8B\x97\x97\xA3,z\n1,2\n", "\xE8\xB7\x9D\xE9\x9B\xA2"}}) {
    const iconv_t known = iconv_open("UTF-8", encoding);
    if (known == reinterpret_cast<iconv_t>(-1)) continue;  // a system with few of them
    iconv_close(known);
    CHECK(read(header, {.encoding = encoding}).header.front() == utf8);
  }
}

TEST_CASE("input: a long text in another encoding comes whole, whatever its blocks") {
  std::string text = "\xE9 [m];z\n";
  for (int i = 0; i < 40000; ++i) text += std::to_string(i) + ";\xE9\n";
  const TemporaryFolder folder("long");
  table::CsvReader reader{folder.write("a.csv", text), {.encoding = "latin1"}};
  int rows = 0;
  for (; reader.next(); ++rows) {
    if (reader.number(0) != rows || reader.cell(1) != "\xC3\xA9") FAIL("row " << rows);
  }
  CHECK(rows == 40000);
}

TEST_CASE("input: lines may end in a carriage return alone") {
  const Table t = read("x_m,z_mm\r0,1.5\r0.25,-2\r");
  CHECK(t.header == x_and_z);
  CHECK(t.rows == two_rows);
}

TEST_CASE("input: blanks part cells where nothing else does and the rows are numbers") {
  for (const char* text :
       {"x_m   z_mm\n  0.00   1.5\n  0.25  -2\n", "x_m z_mm\n0 1,5\n0,25 -2\n",
        "  x_m\t z_mm\r\n 0 1.5\r\n 0.25 -2 \r\n", "x_m|z_mm\n0|1.5\n0.25|-2\n"}) {
    if (std::string_view{text}.find('\t') != std::string_view::npos) continue;
    CAPTURE(text);
    const Table t = read(text);
    CHECK(t.header == x_and_z);
    CHECK(t.rows == two_rows);
  }
  CHECK(read("0.00  1.5\n0.25  -2\n").rows == two_rows);
  CHECK(read("distance (m)   profile (mm)\n0 1.5\n0.25 -2\n").header ==
        std::vector<std::string>{"distance (m)", "profile (mm)"});
  // One column whose name holds a blank, and words, are no such table.
  CHECK(read("left level\n1\n2\n").header == std::vector<std::string>{"left level"});
  const TemporaryFolder folder("words");
  CHECK(table::read_table(folder.write("a.csv", "a b\nc d\n")).rows[0][0] == "c d");
  CHECK_THROWS_WITH(read("x z\n0 1\n0.25 2 3\n"), Contains("line 3: 3 cells; allowed: 2"));
}

TEST_CASE("input: a decimal comma in quotes is taken when it is named, and a real minus sign") {
  const std::string text = "x_m,z_mm\n\"0\",\"1,5\"\n\"0,25\",\"-2\"\n";
  CHECK_THROWS_WITH(read(text), Contains("--decimal comma"));
  CHECK(read(text, {.decimal = ','}).rows == two_rows);
  CHECK_THROWS_WITH(read("x;z\n0.5;1\n", {.decimal = ','}), Contains("decimal comma"));
  CHECK_THROWS_WITH(read("x;z\n0,5;1\n", {.decimal = '.'}), Contains("decimal point"));
  CHECK(read("x;z\n0;1.5\n0.25;\xE2\x88\x92"
             "2\n")
            .rows == two_rows);
}

TEST_CASE("input: several lines of headers are joined, and cells that go over several columns") {
  const Table t = read("Track,Left,,Right\nDistance,Level,Line,Level\nm,mm,mm,mm\n0,1,2,3\n",
                       {.header_lines = 3});
  CHECK(t.header == std::vector<std::string>{"Track Distance m", "Left Level mm", "Left Line mm",
                                             "Right Level mm"});
  CHECK(t.rows == std::vector<std::vector<double>>{{0, 1, 2, 3}});
  CHECK_THROWS_WITH(read("a,b\nc\n1,2\n", {.header_lines = 2}), Contains("1 headers; allowed: 2"));
  CHECK_THROWS_WITH(read("a,b\n", {.header_lines = 2}), Contains("ends within the header lines"));
}

TEST_CASE("input: tenths of a unit over a column") {
  for (const auto& [header, si] :
       {std::pair{"z [1/10 mm]", 1e-4}, std::pair{"z (0.1 mm)", 1e-4},
        std::pair{"z [mm/100]", 1e-5}, std::pair{"z [1/100 in]", 2.54e-4},
        std::pair{"z [0,01mm]", 1e-5}})
    CHECK(table::parse_column(header).unit.si == Approx(si).epsilon(1e-14));
  CHECK(table::parse_column("z (62 ft)").unit_text.empty());
  CHECK(table::parse_column("z (2 mm)").unit_text.empty());
  CHECK(table::parse_column("z (0.1 s)").unit_text.empty());
}

TEST_CASE("input: dates and times are known, and what only looks like them is not") {
  for (const char* text : {"2022-10-24", "24.10.2022", "10/24/22", "1.2.99", "12:00", "7:05:09.125",
                           "12:00:01,5Z", "12:00:00+02:00", "2022-10-24T12:00:00",
                           "2022-10-24 12:00:00.25-0500", "10/24/2022 1:05:00 PM"}) {
    CAPTURE(text);
    CHECK(table::is_date_or_time(text));
  }
  for (const char* text : {"", "12", "12.5", "-12.5", "12.345.678", "12+345.6", "12:900.00", "1-2",
                           "2022-10-24x", "2022-10", "12K345.6M", "1/10 mm", "12:5", "1.2.3.4"}) {
    CAPTURE(text);
    CHECK_FALSE(table::is_date_or_time(text));
  }
  CHECK(table::is_date("2022/10/24"));
  CHECK_FALSE(table::is_date("12:00"));
  CHECK_FALSE(table::is_clock("2022-10-24"));
}

TEST_CASE("input: between blanks a date and a time are one cell or two, as the headers have them") {
  const TemporaryFolder folder("times");
  const auto rows = [&](const std::string& header, const std::string& text) {
    return table::read_table(folder.write("a.txt", header + "\n" + text)).rows;
  };
  using Rows = std::vector<std::vector<std::string>>;
  CHECK(rows("when x_m z_mm", "2022-10-24 12:00:00.5 0 1.5\n2022-10-24 12:00:01 0.25 -2\n") ==
        Rows{{"2022-10-24 12:00:00.5", "0", "1.5"}, {"2022-10-24 12:00:01", "0.25", "-2"}});
  CHECK(rows("day time x_m z_mm", "24.10.2022 12:00 0 1.5\n") ==
        Rows{{"24.10.2022", "12:00", "0", "1.5"}});
  CHECK(rows("when x_m z_mm", "10/24/2022 1:05 PM 0 1.5\n") ==
        Rows{{"10/24/2022 1:05 PM", "0", "1.5"}});
}

TEST_CASE("input: a column that is not there is refused with what may find it") {
  const TemporaryFolder folder("columns");
  const auto reader = [&](const std::string& text) {
    return table::CsvReader{folder.write("a.csv", text)};
  };
  const table::CsvReader other = reader("Weg;H\xF6he\n0;1\n");
  CHECK_THROWS_WITH(other.column("x"), Contains("--encoding if its text is not UTF-8"));
  CHECK_THROWS_WITH(reader("Weg;H\xC3\xB6he\n0;1\n").column("x"), !Contains("--encoding"));
  // A name before what is no unit; one that fits two is refused.
  CHECK(reader("x_m,Level [counts]\n0,1\n").column("level") == 1);
  CHECK_THROWS_WITH(reader("Level [raw],Level (new)\n0,1\n").column("level"),
                    Contains("is there twice"));
  CHECK_THROWS_WITH(reader(std::string{"a\0,\0b\0\n\0", 8}), Contains("--encoding UTF-16LE"));
  CHECK_THROWS_WITH(reader(std::string{"\0\1\2\3abc\0\n", 9}), !Contains("--encoding"));
}
