// A record read from a file: its columns, its units, what stands for a place and for a lost sample.
#include <railbook/records/record_file.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

struct Read {
  std::vector<double> heights;
  std::unique_ptr<const records::RecordStream> stream;
};

Read read(const std::string& text, records::RecordFile input = {}) {
  const TemporaryFolder folder("record file");
  input.file = folder.write("record.csv", text);
  Read result;
  result.stream =
      records::read_record(input, [&](std::span<const double> piece, const records::RecordStream&) {
        result.heights.insert(result.heights.end(), piece.begin(), piece.end());
      });
  return result;
}

// Heights of 1, 2, 4, 1, 2, 4 ... mm, each row after what `place` makes of its number.
template <class Place>
std::string rows(const std::string& header, Place&& place, int n = 40) {
  std::string text = header + "\n";
  for (int i = 0; i < n; ++i) text += place(i) + std::to_string(1 << i % 3) + "\n";
  return text;
}

}  // namespace

TEST_CASE("unit: heights and places come in metres, whatever the file's units") {
  const auto place = [](int i) { return std::to_string(100 + 2 * i) + ","; };
  for (const auto& [header, unit, distance_unit, height, metre] :
       {std::tuple{"distance_m,profile_mm", "", "", 1e-3, 1.0},
        {"distance (ft),profile (in)", "", "", 0.0254, 0.3048},
        {"distance,profile", "in", "ft", 0.0254, 0.3048},
        {"km,profile_mm", "", "", 1e-3, 1000.0}}) {
    CAPTURE(header);
    const Read r = read(rows(header, place), {.unit = unit, .distance_unit = distance_unit});
    REQUIRE(r.heights.size() == 40);
    for (std::size_t i = 0; i < 40; ++i)
      CHECK(r.heights[i] == Approx((1 << i % 3) * height).epsilon(1e-14));
    CHECK(r.stream->spacing() == Approx(2 * metre));
    CHECK(r.stream->places().at(0) == Approx(100 * metre));
  }
}

TEST_CASE("unit: a place may be written in kilometres and metres, or in stations of 100 ft") {
  const auto two = [](int i) { return std::string(i < 10 ? "0" : "") + std::to_string(i); };
  const std::string ones = "distance_m,profile_mm", feet = "distance_ft,profile_mm";
  for (const std::string& text :
       {rows(ones, [&](int i) { return "12+3" + two(i) + ".5,"; }),
        rows(ones, [&](int i) { return "K12+3" + two(i) + ".5,"; }),
        rows(ones, [&](int i) { return "12K3" + two(i) + ".5M,"; }),
        rows(ones, [&](int i) { return "12k3" + two(i) + ".5m,"; }),
        rows("km,m,profile_mm", [&](int i) { return "12,3" + two(i) + ".5,"; })}) {
    const Read r = read(text, {.distance = text.starts_with("km") ? "km+m" : "distance"});
    CHECK(r.stream->spacing() == Approx(1));
    CHECK(r.stream->places().at(7) == Approx(12307.5));
  }
  const Read r = read(rows(feet, [&](int i) { return "12+" + two(i) + ".5,"; }));
  CHECK(r.stream->spacing() == Approx(0.3048));
  CHECK(r.stream->places().at(7) == Approx(1207.5 * 0.3048));
  for (const std::string cell :
       {"12+-5", "12+", "12.5+3", "12+3x", "1e400+3", "K12", "12K345", "12M"}) {
    CAPTURE(cell);
    CHECK_THROWS_WITH(read(rows(ones, [&](int i) { return i == 3 ? cell + "," : two(i) + ","; })),
                      Contains(cell) && Contains("line 5"));
  }
}

// --where keeps rows from being read at once.
TEST_CASE("property: rows read at once are the rows read one by one, however they are written") {
  const auto differs = [](const std::string& text, records::RecordFile input) {
    const Read at_once = read(text, input);
    input.where = {"run=a"};
    const Read one_by_one = read(text, input);
    REQUIRE(at_once.heights.size() == 50);
    double worst = 0;
    for (std::size_t i = 0; i < 50; ++i) {
      const double u = at_once.heights[i], v = one_by_one.heights[i];
      worst = std::max(worst, std::isnan(u) && std::isnan(v) ? 0 : std::abs(u - v));
      worst = std::max(
          worst, std::abs(at_once.stream->places().at(i) - one_by_one.stream->places().at(i)));
    }
    return !(worst == 0);
  };
  const auto written = [](const std::string& header, char separator, char mark, bool quoted,
                          const auto& place) {
    std::string text = header + "\n";
    const auto add = [&](std::string cell, char end) {
      std::replace(cell.begin(), cell.end(), '.', mark);
      text += quoted ? '"' + cell + '"' : cell;
      text += end;
    };
    for (int i = 0; i < 50; ++i) {
      add(place(i), separator);
      add(i == 20   ? "-9999.0"
          : i == 30 ? "1.0000000000000000123"
                    : std::to_string((i * 7 % 11) / 8.0),
          separator);
      add("a", '\n');
    }
    return text;
  };
  const auto metres = [](int i) { return std::to_string(1234.5 + 0.25 * i); };
  const auto marked = [](int i) { return "1+" + std::to_string(234.5 + 0.25 * i); };
  for (const bool quoted : {false, true})
    for (const auto& [separator, mark] :
         {std::pair{',', '.'}, {';', '.'}, {';', ','}, {'\t', ','}, {'|', '.'}, {' ', ','}}) {
      if (quoted && separator == ' ') continue;
      CAPTURE(separator, mark, quoted);
      const std::string end = separator + std::string("profile_mm") + separator + "run";
      const records::RecordFile plain{.missing = {std::string("-9999") + mark + "0"}};
      CHECK_FALSE(differs(written("distance_m" + end, separator, mark, quoted, metres), plain));
      CHECK_FALSE(differs(written("distance_m" + end, separator, mark, quoted, marked), plain));
      records::RecordFile two = plain;
      two.distance_unit = "mi+yd";
      CHECK_FALSE(differs(written("distance" + end, separator, mark, quoted, marked), two));
      CHECK_THROWS_WITH(read(written("distance" + end, separator, mark, quoted, metres), two),
                        Contains("allowed: 12+345, as the unit of this column says"));
    }
}

TEST_CASE("unit: cells that stand for lost samples, by their number or by their text") {
  std::string text = "distance_m,profile_mm\n";
  for (int i = 0; i < 60; ++i)
    text += std::to_string(i) + "," +
            (i == 9    ? "-9999.0"
             : i == 19 ? "off"
                       : std::to_string(1 << i % 3)) +
            "\n";
  const Read r = read(text, {.bridge = 0, .missing = {"-9999", "off"}});
  CHECK(r.stream->missing() == 2);
  for (std::size_t i = 0; i < 60; ++i) CHECK(std::isnan(r.heights[i]) == (i == 9 || i == 19));
  CHECK_THROWS_WITH(read(text, {.missing = {"-9999"}}), Contains("off"));
  // Without a input, gaps of up to a metre are bridged.
  CHECK(read(text, {.missing = {"-9999", "off"}}).stream->bridged() == 2);
}

TEST_CASE("unit: progress of reading is reported where the size is known") {
  std::vector<double> shares;
  read(rows(
           "profile_mm", [](int) { return ""; }, 50000),
       {.spacing = 0.5, .progress = [&](double share) { shares.push_back(share); }});
  CHECK(shares.size() >= 2);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.front() > 0.2);
  CHECK(shares.back() <= 1);
}

TEST_CASE("unit: a file without places needs a spacing, and units may not contradict each other") {
  const auto none = [](int) { return ""; };
  const auto place = [](int i) { return std::to_string(i) + ","; };
  CHECK_THROWS_WITH(read(rows("profile_mm", none)),
                    Contains("no column \"distance\"") && Contains("profile_mm"));
  CHECK(read(rows("profile_mm", none), {.spacing = 0.25}).stream->spacing() == 0.25);
  // A column called km is a place only where nothing else says where the samples are.
  CHECK(read(rows("km,profile_mm", place), {.spacing = 0.25}).stream->spacing() == 0.25);
  CHECK_THROWS_WITH(read(rows("profile", none), {.spacing = 1}), Contains("names no unit"));
  CHECK_THROWS_WITH(read(rows("profile_s", none), {.spacing = 1}), Contains("a length"));
  CHECK_THROWS_WITH(read(rows("profile_mm", none), {.unit = "in", .spacing = 1}),
                    Contains("in mm by its header, in in by --unit"));
  CHECK_NOTHROW(read(rows("profile_mm", none), {.unit = "mm", .spacing = 1}));
  CHECK_THROWS_WITH(read(rows("distance,profile_mm", place)), Contains("names no length"));
}

TEST_CASE("unit: a number that stands for a lost sample does so however it is written") {
  // A height as any other: no screen would take it out.
  const auto with = [](const std::string& cell) {
    std::string text = "distance_m,profile_mm\n";
    for (int i = 0; i < 40; ++i)
      text += std::to_string(i) + "," + (i == 9 ? cell : std::to_string(1 << i % 3)) + "\n";
    return text;
  };
  for (const std::string cell : {"3", "3.0", "0.3e1", "03"}) {
    const Read r = read(with(cell), {.bridge = 0, .missing = {"3"}});
    INFO(cell);
    CHECK(r.stream->missing() == 1);
    CHECK(std::isnan(r.heights[9]));
    CHECK(r.stream->faults().empty());
  }
  // A text that only begins like a number is one.
  CHECK(read(with("3x"), {.bridge = 0, .missing = {"3x"}}).stream->missing() == 1);
  CHECK(read(with("3"), {.bridge = 0, .missing = {"3x"}}).stream->missing() == 0);
}

TEST_CASE("unit: tenths of a millimetre, by the header, the row under it, or the option") {
  const auto place = [](int i) { return std::to_string(2 * i) + ","; };
  for (const auto& [header, unit] : {std::pair{"distance_m,profile [1/10 mm]", ""},
                                     std::pair{"distance_m,profile\nm,1/10 mm", ""},
                                     std::pair{"distance_m,profile", "0.1 mm"}}) {
    CAPTURE(header);
    const Read r = read(rows(header, place), {.unit = unit});
    CHECK(r.heights.at(1) == Approx(2e-4).epsilon(1e-14));
  }
}

TEST_CASE("input: miles and yards behind the point are no decimals of miles") {
  const auto place = [](int i) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4f,", 12 + i / 160 + 11 * (i % 160) * 1e-4);
    return std::string{text};
  };
  CHECK_THROWS_WITH(read(rows("distance_mi,profile_mm", place, 400)),
                    Contains("--distance-unit mi.yd"));
  CHECK(read(rows("distance_mi,profile_mm", place, 400), {.distance_unit = "mi.yd"})
            .stream->spacing() == Approx(11 * 0.9144));
  // Of many samples the first mile ends before the whole is known.
  const auto close = [](int i) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4f,", 12 + i / 1760 + (i % 1760) * 1e-4);
    return std::string{text};
  };
  CHECK_THROWS_WITH(read(rows("distance_mi,profile_mm", close, 3000)),
                    Contains("--distance-unit mi.yd"));
}

TEST_CASE("input: dates and times are no places and no heights, and do no harm beside them") {
  for (const char* time : {"2022-10-24T12:00:00", "24.10.2022", "12:00:01.5", "1/2/22 1:05 PM"}) {
    CAPTURE(time);
    const auto place = [&](int) { return std::string{time} + ","; };
    CHECK_THROWS_WITH(read(rows("distance_m,profile_mm", place)),
                      Contains("is a date or a time") && Contains("--distance none"));
    CHECK_THROWS_WITH(read(rows("time,profile_mm", place), {.distance = "time"}),
                      Contains("is a date or a time") && Contains("--distance none"));
    CHECK_THROWS_WITH(read(rows("time,profile_mm", place),
                           {.column = "time", .unit = "mm", .distance = "none", .spacing = 0.25}),
                      Contains("is a date or a time"));
    const auto beside = [&](int i) { return std::string{time} + "," + std::to_string(i) + ","; };
    CHECK(read(rows("time,distance_m,profile_mm", beside)).stream->spacing() == 1);
  }
}

TEST_CASE("input: a word that stands for a lost sample is named with its option, in places too") {
  const auto place = [](int i) { return (i == 7 ? "none" : std::to_string(2 * i)) + ","; };
  CHECK_THROWS_WITH(read(rows("distance_m,profile_mm", place)), Contains("--missing \"none\""));
  CHECK(read(rows("distance_m,profile_mm", place), {.missing = {"none"}}).stream->missing() +
            read(rows("distance_m,profile_mm", place), {.missing = {"none"}}).stream->bridged() ==
        1);
  for (const char* word : {"None", "---", "*", "ERR", "#DIV/0!"}) {
    const std::string text = std::string{"distance_m,profile_mm\n0,1\n1,"} + word + "\n2,4\n3,2\n";
    CHECK_THROWS_WITH(read(text), Contains(std::string{"--missing \""} + word + "\""));
    CHECK(read(text, {.missing = {word}}).stream->bridged() == 1);
  }
}

TEST_CASE("unit: the columns of one pass are those of a pass each") {
  const std::string text = rows("distance_m,left_mm,right_mm", [](int i) {
    return std::to_string(i) + "," + std::to_string(i % 7) + ",";
  });
  const TemporaryFolder folder("record file");
  records::RecordFile input{.file = folder.write("record.csv", text)};
  std::vector<double> left, right;
  const auto into = [](std::vector<double>& all) {
    return [&all](std::span<const double> piece, const records::RecordStream&) {
      all.insert(all.end(), piece.begin(), piece.end());
    };
  };
  const auto both = records::read_records(input, {"right", "left"}, {into(right), into(left)});
  CHECK(both.size() == 2);
  CHECK(right == read(text, {.column = "right"}).heights);
  CHECK(left == read(text, {.column = "left"}).heights);
  CHECK(left != right);
}
