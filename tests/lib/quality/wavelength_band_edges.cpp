// Ends of ranges: halves of windows, sections of one sample, the printed coefficients of each
// spectrum.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include <railbook/quality/alignment.hpp>
#include <railbook/quality/sections.hpp>
#include <railbook/spectra/reference_spectra.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

namespace {
const double gone = std::numeric_limits<double>::quiet_NaN();

double height(double x) {
  double z = 0;
  for (int k = 1; k < 60; ++k) z += std::cos(0.13 * k * x + k * k * 1.7) / k;
  return z;
}
// Two runs of 4000 samples a quarter of a metre apart, the second with its stretches slipped.
template <class Slip>
std::vector<quality::Match> aligned(const Slip& slip, std::size_t lost = 0,
                                    const quality::AlignmentOptions& options = {.window = 100,
                                                                                .reach = 10}) {
  std::vector<double> a(4000), b(4000);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = 0.25 * static_cast<double>(i);
    a[i] = height(x);
    b[i] = height(x - slip(x));
  }
  for (std::size_t i = 0; i < lost; ++i) a[i] = gone;
  return quality::align(a, b, 0.25, options);
}
}  // namespace

TEST_CASE("unit: a window is found with half of its samples, and not at the end of the reach") {
  const auto still = [](double) { return 0.0; };
  CHECK(aligned(still, 200)[0].found);
  CHECK_FALSE(aligned(still, 201)[0].found);
  CHECK(aligned(still, 201)[0].correlation == -1);
  CHECK(aligned(still, 200)[1].found);
  const auto all = aligned(still);
  REQUIRE(all.size() == 19);
  CHECK(all[0].centre == 200);
  CHECK(all[1].centre == 400);
  for (const auto& m : all) {
    CHECK(m.correlation == Approx(1));
    CHECK(m.offset == Approx(0).margin(1e-3));
  }
  for (const double slip : {10.0, -10.0, 12.0})
    for (const auto& m : aligned([&](double) { return slip; })) CHECK_FALSE(m.found);
  for (const double slip : {9.75, -9.75, 3.1}) {
    const auto found = aligned([&](double) { return slip; });
    for (std::size_t i = 1; i + 1 < found.size(); ++i) {
      CHECK(found[i].found);
      CHECK(found[i].offset == Approx(slip).margin(0.03));
    }
  }
  const std::vector<double> flat(4000, 2.0);
  for (const auto& m : quality::align(flat, flat, 0.25)) CHECK_FALSE(m.found);
}

TEST_CASE("unit: one window that leaves its neighbours by over two metres is a stray") {
  const auto jump = [](double by) {
    return [by](double x) { return x > 450 && x < 550 ? by : 0.0; };
  };
  const auto kept = aligned(jump(1.5)), dropped = aligned(jump(4));
  CHECK(kept[9].found);
  CHECK(kept[9].offset == Approx(1.5).margin(0.05));
  CHECK(dropped[9].centre == 2000);
  CHECK(dropped[9].offset == Approx(4).margin(0.1));
  CHECK_FALSE(dropped[9].found);
  CHECK(dropped[6].found);
  CHECK(dropped[12].found);
  // Two windows alone have no neighbours to leave.
  const auto few = aligned([](double x) { return x > 500 ? 5.0 : 0.0; }, 0,
                           {.window = 600, .reach = 10, .least = 0});
  for (const auto& m : few) CHECK(m.found);
}

TEST_CASE("unit: an offset is linear between the windows found, and level beyond") {
  using quality::Match;
  const std::vector<Match> some{{10, 9, 1, false},
                                {20, 1, 1, true},
                                {30, 50, 1, false},
                                {40, 3, 1, true},
                                {50, -7, 1, false}};
  CHECK(quality::offset_at(some, 0) == 1);
  CHECK(quality::offset_at(some, 15) == 1);
  CHECK(quality::offset_at(some, 20) == 1);
  CHECK(quality::offset_at(some, 25) == Approx(1.5));
  CHECK(quality::offset_at(some, 35) == Approx(2.5));
  CHECK(quality::offset_at(some, 40) == Approx(3));
  CHECK(quality::offset_at(some, 45) == 3);
  CHECK(quality::offset_at(some, 99) == 3);
  CHECK(quality::offset_at(std::span{some}.first(1), 12) == 0);
}

TEST_CASE("unit: sections of few samples, and their extremes to either side") {
  quality::Sections sections{10, [](std::size_t i) { return 1.0 * static_cast<double>(i); }};
  std::vector<double> z(31, gone);
  z[2] = 4;
  z[11] = -3, z[12] = 1, z[13] = -3, z[14] = 1;
  z[20] = 2, z[21] = 5, z[22] = 5, z[23] = 2;
  sections.push(z);
  REQUIRE(sections.all().size() == 4);
  const quality::Section &one = sections.all()[0], &below = sections.all()[1],
                         &above = sections.all()[2], &none = sections.all()[3];
  CHECK_FALSE(one.deviation());
  CHECK(one.lowest == 4);
  CHECK(one.highest == 4);
  CHECK(one.highest_at == 2);
  CHECK(one.missing == 9);
  CHECK(one.samples == 10);
  CHECK(below.largest() == 3);
  CHECK(below.lowest_at == 11);
  CHECK(below.highest_at == 12);
  CHECK(below.mean == Approx(-1));
  CHECK(*below.deviation() == Approx(2));
  CHECK(above.largest() == 5);
  CHECK(above.highest_at == 21);
  CHECK(above.lowest_at == 20);
  CHECK(*above.deviation() == Approx(1.5));
  CHECK(none.from == 30);
  CHECK_FALSE(none.deviation());
  CHECK_THROWS_WITH(quality::Sections(0, [](std::size_t) { return 0.0; }),
                    Contains("section is 0"));

  quality::Sections rounded{0.3, [](std::size_t i) { return 0.1 * static_cast<double>(i); }};
  rounded.push(std::vector<double>(30, 1.0));
  CHECK(rounded.all().size() == 10);
  for (const auto& s : rounded.all()) CHECK(s.samples == 3);

  CHECK_THROWS_AS(quality::Twist(0.1, 0.25), InputError);
  CHECK(quality::Twist(0.13, 0.25).base() == 0.25);
  CHECK_THROWS_AS(quality::Twist(-1, 0.25), InputError);
  quality::Twist twist{0.5, 0.25};
  for (const double c : {1.0, gone, 3.0}) (void)twist.push(c);
  CHECK(std::isnan(twist.push(4)));
  CHECK(twist.push(4) == 2);
}

TEST_CASE(
    "unit: the spectra at one wavenumber each, by hand from the coefficients of the sources") {
  const double phi = 0.1, w = 2 * units::pi * phi;
  const auto german = [&](double a) {
    return 2 * units::pi * a * 0.8246 * 0.8246 /
           ((w * w + 0.0206 * 0.0206) * (w * w + 0.8246 * 0.8246));
  };
  const auto fra = [&](double a) {
    return 2 * units::pi * 0.25e-4 * a * 0.8245 * 0.8245 / (w * w * (w * w + 0.8245 * 0.8245));
  };
  const auto yang = [&](double a, double one, double two) {
    return 1e-7 * a * two * two * (0.01 + one * one) / (1e-4 * (0.01 + two * two));
  };
  const struct {
    const char *name, *channel;
    double density;
  } known[] = {{"german-low", "vertical", german(4.032e-7)},
               {"german-low", "lateral", german(2.119e-7)},
               {"german-high", "vertical", german(1.080e-6)},
               {"german-high", "lateral", german(6.125e-7)},
               {"fra-1", "vertical", fra(1.2107)},
               {"fra-2", "vertical", fra(1.0181)},
               {"fra-3", "vertical", fra(0.6816)},
               {"fra-4", "vertical", fra(0.5376)},
               {"fra-5", "vertical", fra(0.2095)},
               {"fra-6", "vertical", fra(0.0339)},
               {"fra-5", "lateral", fra(0.0762)},
               {"fra-6", "lateral", fra(0.0339)},
               {"hamid-yang-1", "vertical", yang(16.7217, 0.0233, 0.1312)},
               {"hamid-yang-2", "vertical", yang(9.5250, 0.0233, 0.1312)},
               {"hamid-yang-3", "vertical", yang(5.2917, 0.0233, 0.1312)},
               {"hamid-yang-4", "vertical", yang(2.9633, 0.0233, 0.1312)},
               {"hamid-yang-5", "vertical", yang(1.6722, 0.0233, 0.1312)},
               {"hamid-yang-6", "vertical", yang(0.9525, 0.0233, 0.1312)},
               {"hamid-yang-1", "lateral", yang(10.5833, 0.0328, 0.1837)},
               {"hamid-yang-2", "lateral", yang(5.9267, 0.0328, 0.1837)},
               {"hamid-yang-3", "lateral", yang(3.3867, 0.0328, 0.1837)},
               {"hamid-yang-4", "lateral", yang(1.8838, 0.0328, 0.1837)},
               {"hamid-yang-5", "lateral", yang(1.0583, 0.0328, 0.1837)},
               {"hamid-yang-6", "lateral", yang(0.5927, 0.0328, 0.1837)},
               {"china-hsr", "vertical", 1e-6 * 1.9784e-2 * std::pow(0.1, -1.3643)},
               {"china-hsr", "lateral", 1e-6 * 1.1047e-2 * std::pow(0.1, -1.5354)}};
  CHECK(spectra::references().size() == std::size(known));
  for (const auto& k : known) {
    CAPTURE(k.name, k.channel);
    CHECK(spectra::reference(k.name, k.channel).density(phi) == Approx(k.density).epsilon(1e-12));
  }
  const auto& up = spectra::reference("china-hsr", "vertical").density;
  CHECK(up(0.0187) == Approx(1e-6 * 1.0544e-5 * std::pow(0.0187, -3.3891)));
  CHECK(up(0.0188) == Approx(1e-6 * 3.5588e-3 * std::pow(0.0188, -1.9271)));
  CHECK(up(0.6) == Approx(1e-6 * 3.9488e-4 * std::pow(0.6, -3.4516)));
  CHECK_THROWS_WITH(spectra::reference("fra-1", "lateral"), Contains("fra-5, fra-6"));
  CHECK(spectra::reference("german-low").high == 1);
}
