// What profiles, placements and tables are refused for, each limit from both sides, and the axle
// kept level.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;
using units::inch;

namespace {

template <class Make>
std::string refusal(Make&& make) {
  try {
    make();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// Points of a circle's top, evenly across.
std::vector<Point> circle(int n, double width, double radius) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double u = width * (double(i) / (n - 1) - 0.5);
    points.push_back({u, -u * u / (radius + std::sqrt((radius - u) * (radius + u)))});
  }
  return points;
}

}  // namespace

TEST_CASE("Pieces that are no curve are refused, and those that just are one are not") {
  const double quarter = units::pi / 2, nan = units::nan;
  const auto with = [&](auto&& change) {
    Piece first, second;
    first.end.u = second.start.u = 1, second.end.u = 2;
    change(second);
    return refusal([&] { Curve({first, second}); });
  };
  CHECK(with([](Piece&) {}).empty());
  CHECK(with([](Piece& p) { p.end.u = 1; }).starts_with("profile: it goes back at u = 1 m"));
  CHECK(with([](Piece& p) { p.end.u = 1 + 1e-12; }).empty());
  for (double Point::*coordinate : {&Point::u, &Point::z})
    for (Point Piece::*of : {&Piece::start, &Piece::end})
      for (const double bad : {nan, units::infinity})
        CHECK(with([&](Piece& p) { (p.*of).*coordinate = bad; }) ==
              "profile: a coordinate is not finite");
  for (double Piece::*angle : {&Piece::angle_start, &Piece::angle_end})
    for (const double sign : {-1.0, 1.0}) {
      CHECK(with([&](Piece& p) {
              p.*angle = sign * quarter;
            }).starts_with("profile: it is vertical at u = 1 m"));
      CHECK(with([&](Piece& p) { p.*angle = sign * (quarter - 1e-9); }).empty());
    }
  for (const double apart : {-1.1e-9, 1.1e-9, -0.9e-9, 0.9e-9}) {
    const bool joins = std::abs(apart) < 1e-9;
    CHECK(with([&](Piece& p) { p.start.z = apart; }).empty() == joins);
    CHECK(with([&](Piece& p) { p.start.u += apart; }).empty() == joins);
  }
  for (const double sign : {-1.0, 1.0})
    for (const double share : {0.999, 1.001})
      CHECK(refusal([&] { arc(1, sign * share * quarter); }).empty() == (share < 1));
}

TEST_CASE("A measured profile has 8 to 20000 points over 10 mm to 1 m, in either order") {
  for (const auto& [n, width, fits] : {std::tuple{7, 0.05, false},
                                       {8, 0.05, true},
                                       {20000, 0.5, true},
                                       {20001, 0.5, false},
                                       {50, 0.0099, false},
                                       {50, 0.0101, true},
                                       {50, 0.999, true},
                                       {50, 1.001, false}}) {
    CAPTURE(n, width);
    CHECK(refusal([&, n = n, width = width] { measured_curve(circle(n, width, 2), 0); }).empty() ==
          fits);
    CHECK(refusal([&, n = n, width = width] { scatter(circle(n, width, 2)); }).empty() == fits);
  }
  auto points = circle(40, 0.06, 0.3);
  const Curve one = measured_curve(points, 0).curve;
  std::ranges::reverse(points);
  const Curve other = measured_curve(points, 0).curve;
  for (double u = -0.029; u < 0.03; u += 0.007) CHECK(one.height(u) == other.height(u));
}

TEST_CASE("Arcs of a measured profile that hardly turn are lines, on the same curve") {
  for (const double radius : {1e3, 1e7}) {  // by 1e-6 and 1e-10 rad over 1 mm
    const Curve curve = measured_curve(circle(61, 0.06, radius), 0).curve;
    REQUIRE(curve.pieces().size() == 120);
    for (std::size_t i = 20; i < 100; ++i) CHECK(curve.pieces()[i].is_line() == (radius > 1e5));
    for (double u = -0.02; u < 0.02; u += 0.0037) {
      CHECK(curve.height(u) == Approx(-u * u / 2 / radius).margin(1e-12));
      CHECK(curve.angle(u) == Approx(u / radius).margin(1e-8));
    }
  }
}

TEST_CASE("Noise of a measured profile is met, and more than a straight line would leave refused") {
  const auto points = circle(60, 0.07, 0.3);
  // The line of the least squares, along the points: what is left at a smoothing without limit.
  double mean = 0, squares = 0;
  for (const Point& p : points) mean += p.z / 60;
  for (const Point& p : points) squares += (p.z - mean) * (p.z - mean) / 60;
  for (const double share : {0.01, 0.3, 0.9}) {
    const double noise = share * std::sqrt(squares);
    const MeasuredCurve smooth = measured_curve(points, noise);
    CHECK(smooth.rms == Approx(noise).epsilon(1e-4));
    CHECK(smooth.largest > smooth.rms);
    CHECK(smooth.largest < std::sqrt(60.0) * smooth.rms);
  }
  CHECK(refusal([&] {
          measured_curve(points, 1.01 * std::sqrt(squares));
        }).find("is more than its shape") != std::string::npos);
}

TEST_CASE("A wheel is no steeper than 84 degrees, and a rail leans by half a radian at most") {
  for (const double degrees : {83.9, 84.1})
    for (const double sign : {-1.0, 1.0}) {
      // From the middle of the track outwards: as steep up as down.
      const double angle = sign * degrees * units::degree;
      const Curve wheel = chain({-0.8, -0.5}, 0, {line(0.1), arc(sign * 1e-3, angle), line(1e-3)});
      const Curve rail = chain({-0.8, 0}, -0.1, {arc(1, 0.1)});
      CHECK(refusal([&] { WheelsetOnTrack(wheel, rail); }).empty() == (degrees < 84));
    }
  const Curve head = turned(moved(cn_pair().rail(), 0.75, 0), -paper_track.cant);
  for (const double share : {-1.001, 1.001})
    CHECK(refusal([&] { placed_rail(head, 1.435, 0.014, share * 0.5); }).starts_with("cant of"));
  CHECK(refusal([&] { placed_rail(head, 1.435, 0.014, 0.499); }).find("cant of") ==
        std::string::npos);
}

TEST_CASE("A table's end and mean are whole numbers of its steps, up to a million") {
  const auto told = [](double end, double step, double average) {
    return refusal([&] {
      tabulate(cn_pair(), {.half_spacing = 0.75, .end = end, .step = step, .average = average});
    });
  };
  for (const double off : {-2e-6, -5e-7, 5e-7, 2e-6}) {
    const bool whole = std::abs(off) < 1e-6;
    CHECK(told((10 + off) * 1e-4, 1e-4, 0).empty() == whole);
    CHECK(told(1e-3, 1e-4, 2e-4 * (1 + off)).empty() == whole);
  }
  CHECK(told(1e-3, 1e-4, 1e-4).starts_with("half the width of the mean 5e-05 m is no whole"));
  CHECK(told(1, 1e-6 / 1.001, 0).find("is no whole number of steps") != std::string::npos);
}

TEST_CASE("With the axle kept level each side touches where its own gap is least") {
  const auto least = [](const WheelsetOnTrack& pair, double x) {  // of the left side: gap, u
    const double low = std::max(pair.wheel().start().u - x, pair.rail().start().u),
                 high = std::min(pair.wheel().end().u - x, pair.rail().end().u);
    std::pair best{1.0, 0.0};
    for (int k = 1; k < 40000; ++k) {
      const double u = low + (high - low) * k / 40000;
      best = std::min(best, std::pair{pair.wheel().height(u + x) - pair.rail().height(u), u});
    }
    return best;
  };
  for (const WheelsetOnTrack* pair : {&new_wheel_pair(), &cn_pair(), &heumann_pair()})
    for (const double x : {-0.35, -0.1, 0.0, 0.2, 0.35}) {
      const WheelsetContact at = pair->level_contact(x * inch);
      CAPTURE(x);
      REQUIRE(at.converged);
      CHECK(at.x == x * inch);
      CHECK(at.roll == 0);
      const auto [left, u] = least(*pair, x * inch);
      const auto [right, v] = least(*pair, -x * inch);
      CHECK(at.height == Approx(-std::min(left, right)).margin(1e-9));
      CHECK(at.left.on_rail.u == Approx(u).margin(2e-4));
      CHECK(at.right.on_rail.u == Approx(v).margin(2e-4));
      for (const auto& [side, shift] : {std::pair{at.left, x * inch}, {at.right, -x * inch}}) {
        CHECK(side.on_wheel.u == Approx(side.on_rail.u + shift).epsilon(1e-13));
        CHECK(side.on_rail.z == Approx(pair->rail().height(side.on_rail.u)).margin(1e-14));
        CHECK(side.radius == Approx(-pair->wheel().height(side.on_wheel.u)).epsilon(1e-13));
        CHECK(side.delta == Approx(pair->wheel().angle(side.on_wheel.u)).margin(1e-9));
        CHECK_FALSE(side.at_end);
      }
    }
  CHECK_FALSE(cn_pair().level_contact(0.5).converged);
  CHECK_FALSE(refusal([] { cn_pair().level_contact(units::nan); }).empty());
}
