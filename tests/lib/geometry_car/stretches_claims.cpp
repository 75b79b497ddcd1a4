// A record in stretches is the record as a whole, in the memory of a stretch.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/geometry_car/sensors.hpp>
#include <railbook/geometry_car/simulate.hpp>
#include <railbook/geometry_car/stretches.hpp>
#include <railbook/units/constants.hpp>

#include "support/claim.hpp"
#include "support/final_position.hpp"

using namespace railbook;
using namespace railbook::geometry_car;

namespace {

// 4 km of typical sensors, repeated: the memory of the filters and the place of the cut are what
// counts here.
const Record& long_record() {
  static const Record record = [] {
    TrackDescription d;
    d.length = 4000 * units::foot;
    d.substeps = 4;
    const Track track = build(d);
    Motion motion{.start = 80 * units::foot, .speed = 25};
    motion.cruise(track.length() - motion.start - 1);
    const Record one = measured(drive(track, Car{}, motion), Layout{}, typical_sensors(), 5);
    Record all;
    for (long n = 0; n < 6; ++n)
      for (std::size_t i = 0; i < one.size(); ++i) {
        all.elapsed.push_back(i == 0 ? one.elapsed[1] : one.elapsed[i]);
        all.mark.push_back(static_cast<long>(all.mark.size()));
        for (std::size_t c = 0; c < channels; ++c) all.values[c].push_back(one.values[c][i]);
      }
    return all;
  }();
  return record;
}

Record beginning(std::size_t rows) {
  Record record = long_record();
  record.elapsed.resize(rows), record.mark.resize(rows);
  for (auto& values : record.values) values.resize(rows);
  return record;
}

struct Read {
  Measurement m;
  std::array<std::vector<Quality>, parameters> quality;
  std::size_t rows = 0, most = 0, runs = 0, rejected = 0;
  std::vector<Finding> findings;
};

Read in_stretches(const Record& record, std::size_t rows) {
  Read read;
  Stretches stretches{{},
                      [&](const Stretch& s) {
                        REQUIRE(s.first == read.rows);
                        read.rows += s.to - s.from;
                        for (std::size_t i = s.from; i < s.to; ++i) {
                          read.m.mark.push_back(s.m.mark[i]);
                          read.m.speed.push_back(s.m.speed[i]);
                          for (std::size_t p = 0; p < parameters; ++p) {
                            read.m.values[p].push_back(s.m.values[p][i]);
                            read.quality[p].push_back(s.quality[p][i]);
                          }
                        }
                      },
                      rows};
  for (std::size_t i = 0; i < record.size(); ++i) {
    Row row{record.elapsed[i], record.mark[i], {}};
    for (std::size_t c = 0; c < channels; ++c) row.values[c] = record.values[c][i];
    stretches.push(row);
    read.most = std::max(read.most, stretches.held());
  }
  stretches.finish();
  read.runs = stretches.runs();
  read.rejected = stretches.rejected();
  read.findings = stretches.findings();
  return read;
}

}  // namespace

TEST_CASE("claim: stretches give what the whole record gives, wherever it is cut") {
  tests::Claim claim("geometry_car::Stretches");
  Record record = long_record();
  REQUIRE(record.size() > 20000);
  record.elapsed[9000] = 0;                                                 // rejected
  for (std::size_t i = 12000; i < record.size(); ++i) record.mark[i] += 7;  // a gap
  Record masked = record;
  const Health health = examine(masked, {});
  const Measurement whole = reconstruct(masked, {});
  for (const std::size_t rows : {1UL, 12000UL}) {  // 12000: at the gap
    const Read pieces = in_stretches(record, rows);
    CHECK(pieces.most <= std::max<std::size_t>(rows, 2 * 4096) + 2 * 4096);
    CHECK(pieces.runs == whole.runs);
    CHECK(pieces.rejected == whole.rejected);
    REQUIRE(pieces.m.size() == whole.size());
    CHECK(pieces.m.mark == whole.mark);
    for (const ParameterInfo& info : parameter_list()) {
      const auto p = static_cast<std::size_t>(info.parameter);
      const auto expected = quality(whole, info.parameter, {}, health);
      double largest = 0;
      for (std::size_t i = 0; i < whole.size(); ++i)
        if (expected[i] != Quality::missing)
          largest = std::max(largest, std::abs(whole.values[p][i]));
      for (std::size_t i = 0; i < whole.size(); ++i) {
        claim.error(pieces.quality[p][i] == expected[i] ? 0 : 1);
        if (expected[i] != Quality::missing)
          claim.error(std::abs(pieces.m.values[p][i] - whole.values[p][i]) / largest);
      }
    }
  }
}

TEST_CASE("geometry_car: a short record is one stretch") {
  Record record = long_record();
  const Read one = in_stretches(record, record.size());
  const Health health = examine(record, {});
  const Measurement whole = reconstruct(record, {});
  for (const ParameterInfo& info : parameter_list()) {
    const auto p = static_cast<std::size_t>(info.parameter);
    CHECK(one.quality[p] == quality(whole, info.parameter, {}, health));
  }
  CHECK(one.findings.size() == health.findings.size());
}

TEST_CASE("geometry_car: a zero that has moved and a speed that leapt are remembered across cuts") {
  // Cut at row 8192, and held from row 4096 on, of which stretch the first four rows are not
  // judged.
  for (const std::size_t at : {3000UL, 4097UL}) {
    INFO("at row " << at);
    Record moved = beginning(14000);
    const auto yaw = static_cast<std::size_t>(Channel::yaw_rate);
    for (std::size_t i = at; i < moved.size(); ++i) moved.values[yaw][i] += 2 * units::degree;
    const Read read = in_stretches(moved, 1);
    const auto& quality = read.quality[static_cast<std::size_t>(Parameter::curvature)];
    for (std::size_t i = at + 100; i < moved.size(); ++i) REQUIRE(quality[i] != Quality::good);
    const auto step = std::find_if(
        read.findings.begin(), read.findings.end(),
        [](const Finding& f) { return f.fault == Fault::step && f.what == "yaw_rate"; });
    REQUIRE(step != read.findings.end());
    CHECK(step->first >= at - 3);
    CHECK(step->first <= at + 3);
    CHECK_THAT(step->text, Catch::EndsWith(" of 2 stretches; first at row " +
                                           std::to_string(step->first + 1) + ")"));
  }

  for (const std::size_t at : {3000UL, 4097UL}) {
    Record leapt = beginning(14000);
    for (std::size_t i = at; i < leapt.size(); ++i) leapt.elapsed[i] *= 0.8;
    const Read fast = in_stretches(leapt, 1);
    const auto& profile = fast.quality[static_cast<std::size_t>(Parameter::profile_left)];
    for (std::size_t i = at; i < leapt.size(); ++i) REQUIRE(profile[i] != Quality::good);
  }
}

TEST_CASE("geometry_car: a finding of several stretches is reported once, as the worst of them") {
  // The first ends at row 12288, the second begins at row 4096: one spike in the one, two in the
  // other.
  Record r;
  for (long k = 0; k < 14000; ++k) r.elapsed.push_back(0.01), r.mark.push_back(k);
  for (auto& values : r.values) values.assign(r.size(), std::nan(""));
  for (std::size_t k = 0; k < r.size(); ++k)
    r[Channel::lateral][k] = r[Channel::height_left][k] = k % 2 == 0 ? 1e-6 : -1e-6;
  r[Channel::lateral][2000] += 0.5;
  r[Channel::lateral][12500] += 0.3, r[Channel::lateral][13500] += 0.3;
  r[Channel::height_left][12800] += 0.02;
  Read read = in_stretches(r, 1);
  std::erase_if(read.findings, [](const Finding& f) { return f.fault == Fault::dead; });
  REQUIRE(read.findings.size() == 2);
  const Finding &of_both = read.findings[0], &of_one = read.findings[1];
  CHECK(of_both.what == "lateral");
  CHECK(of_both.fault == Fault::jump);
  CHECK(of_both.rows == 2);
  CHECK(of_both.size == Approx(0.3).epsilon(1e-3));
  CHECK(of_both.first == 1998);
  CHECK_THAT(of_both.text, Catch::StartsWith("2 jumps"));
  CHECK_THAT(of_both.text, Catch::EndsWith("(the worst of 2 of 2 stretches; first at row 1999)"));
  CHECK(of_one.what == "height_left");
  CHECK(of_one.first == 12799);
  CHECK_THAT(of_one.text, Catch::EndsWith("(the worst of 1 of 2 stretches; first at row 12800)"));
}

TEST_CASE("geometry_car: stretches refuse what the whole record is refused for") {
  Record record = long_record();
  for (std::size_t i = 0; i < record.size(); ++i)
    record.mark[i] += static_cast<long>(5 * (i / 600));
  CHECK_THROWS_WITH(in_stretches(record, 1), Catch::Contains("has 600 samples"));
  CHECK_THROWS_WITH(in_stretches({}, 1), Catch::Contains("has 0 samples"));
  CHECK_THROWS(Stretches({.curvature_mean = 0}, [](const Stretch&) {}));
}
