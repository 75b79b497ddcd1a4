// Workbooks: their first sheet is a table. The archives are packed here.
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"
#include "support/workbook.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

using workbook::book;
using workbook::Files;

std::string deflated(const std::string& text) {
  z_stream z{};
  REQUIRE(deflateInit2(&z, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string packed(deflateBound(&z, static_cast<uLong>(text.size())), '\0');
  std::string in = text;
  z.next_in = reinterpret_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(packed.size());
  REQUIRE(deflate(&z, Z_FINISH) == Z_STREAM_END);
  packed.resize(packed.size() - z.avail_out);
  deflateEnd(&z);
  return packed;
}

std::string zipped(const Files& files, bool pack, std::size_t liar = 0) {
  return pack ? workbook::zipped(files, deflated, liar) : workbook::zipped(files, {}, liar);
}

// The headers of a sheet.
std::vector<std::string> headers(const std::string& archive, const std::string& sheet) {
  const TemporaryFolder folder("sheet");
  return table::CsvReader{folder.write("a.xlsx", archive), {.sheet = sheet}}.header();
}

table::CsvTable read(const std::string& archive) {
  const TemporaryFolder folder("workbook");
  return table::read_table(folder.write("a.xlsx", archive));
}

const std::string header =
    "<row r=\"1\"><c r=\"A1\" t=\"s\"><v>0</v></c><c r=\"B1\" t=\"s\"><v>1</v></c></row>";
const std::string strings =
    "<si><t>distance_m</t></si><si><r><t>H&#246;he, </t></r><r><t xml:space=\"preserve\">a&amp;b "
    "[mm]</t></r><rPh><t>reading</t></rPh></si>";

}  // namespace

TEST_CASE("input: the first sheet of a workbook is a table, packed or stored") {
  const std::string rows =
      header +
      "<row r=\"2\"><c r=\"A2\"><v>0.25</v></c><c r=\"B2\"><f>A2*2</f><v>-1.5E-2</v></c></row>"
      "<row r=\"4\"><c r=\"A4\"><v>0.5</v></c></row>"
      "<row><c><v>0.75</v></c><c t=\"inlineStr\"><is><t>lost, \"x\"</t></is></c></row>"
      "<row><c r=\"A6\"><v>1</v></c><c r=\"B6\" t=\"e\"><v>#DIV/0!</v></c><c r=\"C6\"/></row>";
  for (const bool pack : {true, false}) {
    const table::CsvTable t = read(zipped(book(rows, strings), pack));
    CHECK(t.header == std::vector<std::string>{"distance_m", "H\xC3\xB6he, a&b [mm]", "3"});
    CHECK(t.rows == std::vector<std::vector<std::string>>{{"0.25", "-1.5E-2", ""},
                                                          {"0.5", "", ""},
                                                          {"0.75", "lost, \"x\"", ""},
                                                          {"1", "#DIV/0!", ""}});
  }
}

TEST_CASE("input: a sheet is chosen by name or number, and one that is not there is refused") {
  Files files = book(header, strings);
  files.emplace_back("xl/worksheets/old.xml",
                     "<worksheet><row><c t=\"inlineStr\"><is><t>km</t></is></c></row></worksheet>");
  const std::string archive = zipped(files, true);
  for (const char* sheet : {"", "Run", "1"}) CHECK(headers(archive, sheet).size() == 2);
  for (const char* sheet : {"Old", "2"})
    CHECK(headers(archive, sheet) == std::vector<std::string>{"km"});
  CHECK_THROWS_WITH(headers(archive, "New"), Contains("no sheet \"New\"; there are: Run, Old"));
  CHECK_THROWS_WITH(headers("a,b\n1,2\n", "Run"), Contains("no workbook (.xlsx)"));
}

TEST_CASE("input: an archive that is no workbook, or a damaged one, is refused by name") {
  const auto refused = [](const std::string& archive, const char* why) {
    CAPTURE(why);
    CHECK_THROWS_WITH(read(archive), Contains("a.xlsx") && Contains(why));
  };
  const std::string good = zipped(book(header, strings), true);
  refused(zipped({{"a.txt", "x"}}, true), "no workbook (.xlsx)");
  refused(good.substr(0, good.size() - 40), "damaged or cut off");
  refused(zipped(book(header, strings), true, 70), "damaged or cut off");
  refused(zipped(book(header, strings), true, 600U << 20), "more than 512 MiB");
  refused(zipped(book(header, ""), true), "sheet of the workbook is damaged");
  refused(zipped(book("<row r=\"1\"><c r=\"B1\"><v>1</v></c><c r=\"A1\"><v>1</v></c></row>"), true),
          "sheet of the workbook is damaged");
  refused(zipped(book("<row r=\"1\"><c r=\"ZZZZ1\"><v>1</v></c></row>"), true),
          "sheet of the workbook is damaged");
  refused(zipped(book("<row r=\"9999999\"></row>"), true), "sheet of the workbook is damaged");
  // Cells far apart, of a few bytes each, would fill the memory.
  std::string far;
  for (int i = 1; i < 40000; ++i) far += "<row><c r=\"XFD1\"><v>1</v></c></row>";
  refused(zipped(book(far), true), "more than 512 MiB");
}

TEST_CASE("property: whatever byte of a workbook is changed, it is read or refused") {
  const std::string good = zipped(book(header, strings), false);
  for (std::size_t i = 4; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << i % 8));
    try {
      static_cast<void>(read(bad));
    } catch (const InputError&) {
    }
  }
}
