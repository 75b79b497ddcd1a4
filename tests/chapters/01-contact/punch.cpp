#include "method/punch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include <railbook/contact/hertz.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>

using namespace railbook;
using namespace railbook::contact;
using namespace railbook::contact_chapter;

namespace {

double load_between(const PunchContact& c, double r1, double r2) {
  return num::integrate([&](double r) { return 2 * units::pi * r * punch_pressure(c, r); }, r1, r2,
                        1e-9)
      .value;
}

}  // namespace

TEST_CASE("unit: the punch's load is the integral of its pressure") {
  for (double edge : {0.1, 1.0, 5.0}) {
    const PunchContact c = punch_from_approach({0.5, edge}, 1e6, 1e-3);
    CHECK(load_between(c, 0, 0.5) + load_between(c, 0.5, c.radius) ==
          Approx(c.force).epsilon(1e-8));
  }
}

TEST_CASE("unit: a punch with a very small flat is Hertz's sphere") {
  const HertzContact sphere = hertz_from_approach({0.5, 0.5, 0}, 1e6, 1e-3);
  for (double flat : {0.0, 1e-9}) {
    const PunchContact c = punch_from_approach({flat, 1}, 1e6, 1e-3);
    const double off = 2 * flat / sphere.a;  // first order in the flat
    CHECK(c.force == Approx(sphere.force).epsilon(off + 1e-12));
    CHECK(c.radius == Approx(sphere.a).epsilon(off + 1e-12));
    for (double share : {0.1, 0.5, 0.9})
      CHECK(punch_pressure(c, share * sphere.a) ==
            Approx(hertz_pressure(sphere, share * sphere.a, 0)).epsilon(2 * off + 1e-10));
  }
  CHECK(punch_peak(punch_from_approach({0, 1}, 1e6, 1e-3)).pressure ==
        Approx(sphere.p_max).epsilon(1e-10));
}

TEST_CASE("unit: the sharp punch, and the rounded one as its edge radius goes to 0") {
  const PunchContact sharp = punch_from_approach({0.5, 0}, 1e6, 1e-3);
  CHECK(sharp.force == Approx(2e6 * 0.5 * 1e-3).epsilon(1e-15));
  CHECK(punch_pressure(sharp, 0.3) == Approx(1e3 / (units::pi * 0.4)).epsilon(1e-14));
  CHECK(std::isinf(punch_pressure(sharp, 0.5)));
  CHECK(punch_pressure(sharp, 0.6) == 0);
  CHECK(std::isinf(punch_peak(sharp).pressure));
  CHECK(punch_peak(sharp).r == sharp.shape.flat_radius);
  double before = 1;
  for (double edge : {1e-2, 1e-4, 1e-8, 1e-12}) {
    const double off = punch_from_approach({0.5, edge}, 1e6, 1e-3).force / sharp.force - 1;
    CHECK(off > 0);
    CHECK(off < before);
    before = off;
  }
  CHECK(before < 1e-9);
}

// Values for E* = 1.5e7/0.91 psi, delta = .001 in, b = .5 in from tests/reference/closed_forms.cpp,
// in 113 bits, by the unreduced form F = 2 E* (delta a - (s^3/3 - a^2 b/2 arccos(b/a) + b^2
// s/2)/R), whose terms cancel in double precision.
TEST_CASE("unit: the punch against the unreduced closed form in 113 bits") {
  const double modulus = 1.5e7 / 0.91;
  struct Case {
    double edge, radius, force, centre, peak, at;
  };
  for (const Case& k :
       {Case{1, 0.5129812370635, 16740.969759532, 10332.8163464, 82354.858772, 0.503973},
        Case{0.1, 0.50281729892805, 16539.275995119, 10458.3771946, 177643.07151, 0.500860},
        Case{5, 0.53731970146681, 17227.097986844, 10044.3028091, 48018.344895, 0.511472}}) {
    const PunchContact c = punch_from_approach({0.5, k.edge}, modulus, 1e-3);
    CHECK(c.radius == Approx(k.radius).epsilon(1e-12));
    CHECK(c.force == Approx(k.force).epsilon(5e-11));
    CHECK(punch_pressure(c, 0) == Approx(k.centre).epsilon(1e-10));
    const PunchPeak peak = punch_peak(c);
    CHECK(peak.pressure == Approx(k.peak).epsilon(1e-10));
    CHECK(peak.r == Approx(k.at).margin(5e-7));
  }
}

// Beside the edge of a hardly rounded punch the pressure is plane, tanh z + z/cosh^2 z with r^2 -
// b^2 = (s/cosh z)^2: its peak is at z tanh z = 1. And everywhere the pressure falls to both sides
// by what a parabola takes off.
TEST_CASE("unit: the place of the punch's peak to its claim") {
  const PunchContact plane = punch_from_approach({0.5, 1e-9}, 1, 1e-3);
  const double z = 1.1996786402577338;
  CHECK((punch_peak(plane).r - 0.5) / plane.edge_width ==
        Approx(1 / (std::cosh(z) * std::cosh(z))).margin(2 * plane.s / 0.5));
  for (const auto& [flat, edge, approach] : {std::tuple{0.5, 1.0, 1e-3},
                                             {0.5, 0.1, 1e-3},
                                             {0.5, 5.0, 1e-3},
                                             {1e-3, 1.0, 1e-3},
                                             {0.5, 1e3, 1.0},
                                             {0.1, 0.3, 0.05},
                                             {0.01, 0.02, 1e-6}}) {
    INFO(flat << " " << edge);
    const PunchContact c = punch_from_approach({flat, edge}, 1, approach);
    const PunchPeak peak = punch_peak(c);
    // The zero of the derivative by differences far apart, extrapolated to none apart: another
    // order, other points.
    const auto middle = [&](double h) {  // of the chord of half length h that is level
      double low = -0.5 * h, high = 0.5 * h;
      for (int k = 0; k < 60; ++k) {
        const double t = 0.5 * (low + high);
        (punch_pressure(c, peak.r + t + h) > punch_pressure(c, peak.r + t - h) ? low : high) = t;
      }
      return 0.5 * (low + high);
    };
    const double h = 0.02 * (peak.r - flat), m1 = middle(h), m2 = middle(2 * h), m4 = middle(4 * h);
    const double first = (4 * m1 - m2) / 3, second = (4 * m2 - m4) / 3;
    CHECK((16 * first - second) / 15 / c.edge_width == Approx(0).margin(1e-8));
  }
}
