// What lib/table states, on seeded files: a number is the nearest double, and records are those of
// a reader that takes a text as a whole, one character at a time.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <railbook/table/csv.hpp>

#include "support/claim.hpp"
#include "support/number_text.hpp"
#include "support/packed.hpp"
#include "support/temporary_folder.hpp"

using namespace railbook;
using namespace railbook::table;
using namespace railbook::tests;

namespace {

// As it stands, or packed in one to three members, with or without padding.
std::string as_kept(RandomStream& draw, const std::string& text) {
  if (draw(0, 1) < 0.5) return text;
  const std::size_t one = below(draw, text.size() + 1),
                    two = one + below(draw, text.size() - one + 1);
  return packed(text.substr(0, one)) + packed(text.substr(one, two - one)) +
         (two < text.size() ? packed(text.substr(two)) : "") +
         std::string(below(draw, 2) * 512, '\0');
}

bool same(double a, double b) {
  return a == b ? std::signbit(a) == std::signbit(b) : a != a && b != b;
}

}  // namespace

TEST_CASE("claim: lines of any length, wherever a block ends") {
  Claim claim("table::LineSource");
  const TemporaryFolder at("lines");
  RandomStream draw(1);
  for (int k = 0; k < 60; ++k) {
    std::vector<std::string> lines;
    std::string text;
    const std::size_t block = 1 << 18;
    for (std::size_t n = k % 5 == 0 ? 1 : 20 + below(draw, 20); n > 0; --n) {
      // A third ends within two bytes of a block's end.
      const std::size_t left = (text.size() / block + 1) * block - text.size();
      const double kind = draw(0, 1);
      const std::size_t length = kind < 0.33
                                     ? left + below(draw, 5) - std::min<std::size_t>(left, 3)
                                 : kind < 0.36 ? below(draw, 3 * block)
                                               : below(draw, 100);
      lines.emplace_back(length, static_cast<char>('a' + below(draw, 26)));
      if (draw(0, 1) < 0.1) lines.back() += '\r';
      text += lines.back() + "\n";
    }
    if (k % 3 == 0 || k % 5 == 0) {  // the last line without its feed
      text.pop_back();
      if (lines.back().empty()) lines.pop_back();
    }
    LineSource source(at.write("a", as_kept(draw, text)));
    const std::string_view begun = source.lines_ahead();  // whole lines, maybe none
    claim.error((begun.empty() || begun.back() == '\n') && text.starts_with(begun) ? 0 : 1);
    std::size_t i = 0;
    for (std::string_view line; source.next(line); ++i) {
      claim.error(i < lines.size() && line == lines[i] && source.line() == i + 1 ? 0 : 1);
      if (draw(0, 1) < 0.7) continue;
      // Some of the lines that are in memory, at once.
      const std::string_view ahead = source.lines_ahead();
      std::size_t used = 0, count = 0;
      while (used < ahead.size() && count < 3) {
        ++count;
        const std::size_t feed = ahead.find('\n', used);
        claim.error(feed != ahead.npos && i + count < lines.size() &&
                            ahead.substr(used, feed - used) == lines[i + count]
                        ? 0
                        : 1);
        used = feed + 1;
      }
      source.use(used, count);
      i += count;
    }
    claim.error(i == lines.size() ? 0 : 1);
  }
}

TEST_CASE("claim: a line may have 64 MiB and not a byte more") {
  const TemporaryFolder at("long");
  std::string packed_most;
  for (int i = 0; i < 64; ++i) packed_most += packed(std::string(1 << 20, 'x'));
  for (const char* rest : {"\nb\n", "x\nb\n"}) {
    LineSource source(at.write("a", packed_most + packed(rest)));
    std::string_view line;
    if (rest[0] == 'x') {
      CHECK_THROWS_WITH(source.next(line), Catch::Contains("line 1: longer than 67108864 bytes"));
      continue;
    }
    REQUIRE(source.next(line));
    CHECK(line.size() == 64 << 20);
    REQUIRE(source.next(line));
    CHECK(line == "b");
  }
}

namespace {

// What lies half between two doubles, in all its digits; and with one more behind them.
struct Half {
  std::string text;
  double nearest;
};
Half half(RandomStream& draw) {
  const double low = draw(0, 1) < 0.3
                         ? std::round(draw(1, 3e5)) * std::numeric_limits<double>::denorm_min()
                     : draw(0, 1) < 0.5 ? std::round(draw(4.6e15, 9e15))
                                        : draw.decades(1e-307, 1e308),
               high = std::nextafter(low, HUGE_VAL);
  char text[1200];
  std::snprintf(text, sizeof text, "%.1100Lg", (Long{low} + high) / 2);
  std::string all{text};
  const double r = draw(0, 1);
  if (r < 0.4) {  // up from the half
    const std::size_t e = std::min(all.find('e'), all.size());
    all.insert(e, all.find('.') == all.npos ? ".000000000000000000001" : "000001");
    return {all, high};
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &low, sizeof bits);
  return {all, bits % 2 == 0 ? low : high};
}

}  // namespace

TEST_CASE("claim: a cell's number is the nearest double") {
  Claim claim("table::CsvReader");
  const TemporaryFolder at("numbers");
  RandomStream draw(2);
  for (const std::string separator : {",", ";", "\t"})
    for (const bool comma : {false, true}) {
      if (comma && separator == ",") continue;
      std::string text = "a" + separator + "b\n";
      std::vector<double> expected;
      for (int k = 0; k < 4000; ++k) {
        Half one{figures(draw), 0};
        if (k % 4 == 0)
          one = half(draw);
        else
          one.nearest = std::strtod(one.text.c_str(), nullptr);
        const bool zero = one.text.find_first_of("123456789") >=
                          std::min(one.text.find_first_of("eE"), one.text.size());
        if (std::isinf(one.nearest) || (one.nearest == 0 && !zero)) {
          if (k % 20 > 2) continue;
          CsvReader reader(at.write("one.csv", "a\n" + one.text + "\n"));
          REQUIRE(reader.next());
          claim.error(refuses([&] { (void)reader.number(0); }) ? 0 : 1);
          continue;
        }
        expected.push_back(one.nearest);
        if (comma) std::replace(one.text.begin(), one.text.end(), '.', ',');
        text += (k % 7 == 0 ? " " : "") + one.text + (k % 5 == 0 ? "  " : "") + separator + "x\n";
      }
      const auto file = at.write("a.csv", text);
      CsvReader cells(file), blocks(file);
      std::vector<double> many;
      std::array<double, 7> values{};
      const std::array<std::size_t, 1> first{0};
      while (true) {
        const std::size_t rows = blocks.numbers(first, values);
        many.insert(many.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rows));
        if (rows > 0) continue;
        if (!blocks.next()) break;
        many.push_back(blocks.number(0));
      }
      claim.error(many.size() == expected.size() ? 0 : 1);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        REQUIRE(cells.next());
        claim.error(same(cells.number(0), expected[i]) && same(many.at(i), expected[i]) ? 0 : 1);
      }
    }
}

namespace {

using Records = std::vector<std::vector<std::string>>;

// The records of a text in the dialect of csv.hpp.
Records naive(const std::string& text, char separator) {
  Records records;
  std::size_t i = 0;
  const auto strip = [](std::string cell) {
    const std::size_t from = cell.find_first_not_of(" \t");
    if (from == cell.npos) return std::string{};
    return cell.substr(from, cell.find_last_not_of(" \t") + 1 - from);
  };
  const auto ends = [&] {  // a record, here; of it as many characters
    if (i == text.size() || text[i] == '\n') return 1;
    return text[i] == '\r' && (i + 1 == text.size() || text[i + 1] == '\n') ? 2 : 0;
  };
  while (i < text.size()) {
    const std::size_t line = std::min(text.find('\n', i), text.size());
    if (text[i] == '#' || text.substr(i, line - i).find_first_not_of(" \t\r") == text.npos) {
      i = line + 1;
      continue;
    }
    records.emplace_back();
    while (true) {
      std::string cell;
      if (text[i] == '"') {
        for (++i; text[i] != '"' || text[i + 1] == '"'; ++i) {
          if (text[i] == '"') ++i;
          cell += text[i];
        }
        ++i;
      } else {
        while (ends() == 0 && text[i] != separator) cell += text[i++];
        cell = strip(cell);
      }
      records.back().push_back(cell);
      if (const int end = ends(); end > 0) {
        i += static_cast<std::size_t>(end);
        break;
      }
      ++i;
    }
  }
  return records;
}

}  // namespace

TEST_CASE("claim: records by blocks of rows are those of the whole text") {
  Claim claim("table::read_table");
  const TemporaryFolder at("records");
  RandomStream draw(3);
  const std::array bare{"1.5", " 2 ",      "-3e5",  "x y",      "",
                        "nan", "5\" rail", "1 # 2", "\xc3\xa9", "-"};
  const std::array quoted{"\"a, b; c\td\"",          "\"\"",   "\"\"\"\"", "\"1\n2\"",
                          "\"\r\n# no remark\n\n\"", "\" 7 \""};
  for (int k = 0; k < 40; ++k) {
    const char separator = ",;\t"[below(draw, 3)];
    const std::string feed = draw(0, 1) < 0.5 ? "\n" : "\r\n";
    const bool plain = k % 2 == 0;  // long, and nearly all plain
    std::string text = std::string("\"a\n(mm)\"") + separator + "b" + separator + "c" + feed;
    if (plain) text = std::string("a") + separator + "b" + separator + "c" + feed;
    const int rows = plain ? 40000 : 100;
    const std::size_t head = text.size();
    for (int row = 0; row < rows; ++row) {
      const double odd = plain ? 1e-4 : 0.2;
      if (draw(0, 1) < odd)
        text += std::array{"# remark, \" it\n", "\n", " \t\n", "\r\n"}[below(draw, 4)];
      for (int cell = 0; cell < 3; ++cell) {
        if (cell > 0) text += separator;
        const double r = draw(0, 1);
        text += r < odd       ? quoted[below(draw, quoted.size())]
                : r < 2 * odd ? bare[below(draw, bare.size())]
                              : std::to_string(row) + (cell == 2 ? "" : ".25");
      }
      if (row + 1 < rows || draw(0, 1) < 0.5) text += feed;
    }
    if (plain) {  // a row's end within two bytes of the first block's
      const std::size_t block = 1 << 18, end = text.rfind(feed, block - 100) + feed.size();
      text.insert(head, "#" + std::string(block - end - 4 + below(draw, 5), '-') + "\n");
    }
    const auto file = at.write("a.csv", as_kept(draw, text));
    Records expected = naive(text, separator);
    const CsvTable whole = read_table(file);
    claim.error(whole.header == expected[0] && whole.rows.size() + 1 == expected.size() ? 0 : 1);
    // Rows that are numbers come at once where they can; the others one by one.
    CsvReader reader(file);
    std::vector<double> values(2 * (1 + below(draw, 300)));
    const std::size_t room = values.size() / 2;
    const std::array<std::size_t, 2> columns{0, 2};
    const auto number = [](const std::string& cell, double value) {
      char* end = nullptr;
      const double exact = std::strtod(cell.c_str(), &end);
      return end == cell.c_str() + cell.size() && !cell.empty() && same(exact, value);
    };
    std::size_t i = 1;
    for (; i < expected.size(); ++i) {
      claim.error(i <= whole.rows.size() && whole.rows[i - 1] == expected[i] ? 0 : 1);
      std::size_t got = reader.numbers(columns, values);
      for (std::size_t r = 0; r < got; ++r, ++i)
        claim.error(i < expected.size() && number(expected[i][0], values[r]) &&
                            number(expected[i][2], values[room + r])
                        ? 0
                        : 1);
      if (i == expected.size()) break;
      REQUIRE(reader.next());
      for (std::size_t c = 0; c < 3; ++c) claim.error(reader.cell(c) == expected[i][c] ? 0 : 1);
    }
    claim.error(i == expected.size() && !reader.next() ? 0 : 1);
  }
}

TEST_CASE("claim: what is written reads back") {
  Claim cell("table::csv_cell"), number("table::csv_number");
  const TemporaryFolder at("written");
  const std::array pieces{"a", ",",  ";",  "\t",   "\"", "#",
                          " ", "\n", "\r", "\r\n", "1",  "\xEF\xBB\xBF"};
  RandomStream draw(4);
  const auto any = [&] {
    std::string text;
    for (std::size_t n = below(draw, 5); n > 0; --n) text += pieces[below(draw, pieces.size())];
    return text;
  };
  for (int k = 0; k < 1000; ++k) {
    const std::size_t columns = 2 + below(draw, 3);
    Records table(2 + below(draw, 3), std::vector<std::string>(columns));
    std::string text;
    for (std::size_t row = 0; row < table.size(); ++row)
      for (std::size_t c = 0; c < columns; ++c) {
        table[row][c] = row == 0 ? "h" + any() : any();
        text += csv_cell(table[row][c]) + (c + 1 < columns ? "," : "\n");
      }
    const CsvTable back = read_table(at.write(std::to_string(k), text));
    Records found = back.rows;
    found.insert(found.begin(), back.header);
    cell.error(found == table ? 0 : 1);

    const int digits = 1 + static_cast<int>(below(draw, 17));
    const double value = k % 10 == 0   ? draw(-9, 9) * std::numeric_limits<double>::denorm_min()
                         : k % 10 == 1 ? std::round(draw(-1e4, 1e4)) + 0.5
                                       : draw(-1, 1) * draw.decades(1e-300, 1e300);
    char printed[400];
    std::snprintf(printed, sizeof printed, "%.*g", digits, value);
    number.error(csv_number(value, digits) == printed ? 0 : 1);
  }
}

TEST_CASE("claim: columns with units in their headers") {
  Claim header("table::parse_column"), columns("table::read_columns");
  const TemporaryFolder at("columns");
  struct Spelt {
    std::vector<const char*> as;
    Long si;
    units::Dimension dimension;
  };
  const std::vector<Spelt> known{
      {{"m", "metre", "metres", "meter", "meters"}, 1, units::length},
      {{"mm", "millimetre", "millimetres", "millimeter", "millimeters"}, 1e-3L, units::length},
      {{"km", "kilometre", "kilometres", "kilometer", "kilometers"}, 1e3L, units::length},
      {{"in", "inch", "inches", "in."}, 0.0254L, units::length},
      {{"ft", "foot", "feet", "ft."}, 0.3048L, units::length},
      {{"mi", "mile", "miles"}, 1609.344L, units::length},
      {{"um", "micron", "microns", "\xC2\xB5m", "\xCE\xBCm"}, 1e-6L, units::length},
      {{"s", "sec", "second", "seconds"}, 1, units::time},
      {{"kmh", "km/h", "kph"}, 1 / 3.6L, units::speed},
      {{"deg", "degree", "degrees", "\xC2\xB0"}, long_pi / 180, units::angle},
      {{"m/s^2", "m/s2", "m/s\xC2\xB2"}, 1, units::acceleration},
      {{"mm/s^2", "mm/s\xC2\xB2"}, 1e-3L, units::acceleration},
      {{"GPa"}, 1e9L, units::pressure}};
  RandomStream draw(5);
  for (int k = 0; k < 1000; ++k) {
    const Spelt& one = known[below(draw, known.size())];
    const std::string name = std::array{"x", "left rail", "Rail 2 top"}[below(draw, 3)];
    std::string unit = one.as[below(draw, one.as.size())];
    if (unit != "GPa" && draw(0, 1) < 0.3)
      for (char& c : unit) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
    const std::string
        text = std::array{name + " (" + unit + ")",   name + " [" + unit + "]",
                          name + "[ " + unit + " ] ", name + ", " + unit,
                          name + " in " + unit,       " " + name + "_" + unit}[below(draw, 6)];
    const units::Header found = parse_column(text);
    header.error(found.name == name && found.unit.dimension == one.dimension
                     ? static_cast<double>(std::abs(found.unit.si / one.si - 1))
                     : 1);
    if (k % 10 > 0) continue;
    std::string rows = "\"" + text + "\",y\n";
    std::vector<Long> values(20);
    for (Long& value : values) {
      char digits[40];
      std::snprintf(digits, sizeof digits, "%.17g", draw(-1, 1) * draw.decades(1e-290, 1e290));
      value = std::strtold(digits, nullptr) * one.si;
      rows += digits + std::string(",7\n");
    }
    const auto read = read_columns(at.write("a.csv", rows), {{name, one.dimension}});
    REQUIRE(read[0].size() == values.size());
    for (std::size_t i = 0; i < values.size(); ++i) columns.relative(read[0][i], values[i]);
  }
}
