#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include <railbook/contact/hertz.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

#include "support/no_fp_fault.hpp"

using namespace railbook;
using namespace railbook::contact;

namespace {

// For A = 1/m, B = q/m, delta = 1 m, E* = 1 Pa: the semi-axis a, b sqrt(B), F and p0/sqrt(B).
// By tests/reference/closed_forms.cpp in 113 bits.
struct Reference {
  double ratio, a, b, force, p_max;
};
constexpr Reference references[] = {
    {1.5, 0.730503738175431552248099, 0.682908697053801289929663, 0.854840367460846849159265,
     0.818165801337490408710504},
    {36.5, 0.855784546498815278364486, 0.517332397954948372171273, 0.485068378318446040758223,
     0.523130731263886959200131},
    {1e3, 0.906444206684954998186980, 0.422325585499247943179823, 0.338756796452374675487883,
     0.422513833858856831139443},
    {1e7, 0.951544324763278009774377, 0.307511622562135540086612, 0.188456329041303296489636,
     0.307511637134807242415701},
    {1e12, 0.969364129350341663620360, 0.245628143193841034380503, 0.122490331223702330148848,
     0.245628143193959905690715},
    {1e16, 0.976257849931845955655546, 0.216611658149900467439126, 0.095937148588366113523769,
     0.216611658149900478003111},
};

void close(double computed, double expected) {
  CHECK(std::abs(computed / expected - 1) < 1e-12);
}

}  // namespace

TEST_CASE("unit: Hertz to 1e-12 from a round contact to an axis ratio of 1e-8") {
  for (const Reference& r : references) {
    const HertzContact h = hertz_from_approach({1, r.ratio, 0}, 1, 1);
    close(h.a, r.a);
    close(h.b, r.b / std::sqrt(r.ratio));
    close(h.force, r.force);
    close(h.p_max, r.p_max * std::sqrt(r.ratio));
    // From the load back to the approach, and with the axes exchanged.
    close(hertz_from_force({1, r.ratio, 0}, 1, h.force).approach, 1);
    const HertzContact turned = hertz_from_approach({r.ratio, 1, 0}, 1, 1);
    CHECK(turned.a == h.b);
    CHECK(turned.b == h.a);
  }
}

TEST_CASE("unit: Hertz of a sphere") {
  const double radius = 0.3, modulus = 1.1e11, delta = 2e-5;
  const HertzContact h =
      hertz_from_approach({1 / (2 * radius), 1 / (2 * radius), 0}, modulus, delta);
  close(h.a, std::sqrt(radius * delta));
  close(h.b, std::sqrt(radius * delta));
  close(h.force, 4.0 / 3 * modulus * std::sqrt(radius) * std::pow(delta, 1.5));
  close(h.p_max, 2 * modulus / units::pi * std::sqrt(delta / radius));
}

TEST_CASE("unit: Hertz's load is the integral of Hertz's pressure, also turned") {
  const HertzContact h = hertz_from_force({3, 11, 0.6}, 1e11, 2e4);
  close(h.force, 2 * units::pi / 3 * h.a * h.b * h.p_max);
  const double cosine = std::cos(0.6), sine = std::sin(0.6);
  CHECK(hertz_pressure(h, 0.999 * h.a * cosine, 0.999 * h.a * sine) > 0);
  CHECK(hertz_pressure(h, 1.001 * h.a * cosine, 1.001 * h.a * sine) == 0);
  CHECK(hertz_pressure(h, -0.5 * h.b * sine, 0.5 * h.b * cosine) ==
        Approx(h.p_max * std::sqrt(0.75)).epsilon(1e-12));
}

TEST_CASE("unit: elliptic integrals against quadrature") {
  for (double log_m1 : {0.0, -1e-8, -0.3, -3.0, -9.0}) {
    const double m1 = std::exp(log_m1);
    const EllipticIntegrals i = elliptic_integrals(log_m1);
    const auto part = [m1](double c, double s) {
      return num::integrate(
                 [=](double t) {
                   const double cosine = std::cos(t), sine = std::sin(t);
                   return (c * cosine * cosine + s * sine * sine) /
                          std::sqrt(cosine * cosine + m1 * sine * sine);
                 },
                 0, units::pi / 2, 1e-13)
          .value;
    };
    CHECK(i.k == Approx(part(1, 1)).epsilon(1e-12));
    CHECK(i.b == Approx(part(1, 0)).epsilon(1e-12));
    CHECK(i.d == Approx(part(0, 1)).epsilon(1e-12));
  }
}

TEST_CASE("extreme: Hertz follows delta^(1/2) and delta^(3/2) over 40 decades") {
  const NoFpFault no_fault;
  const HertzContact one = hertz_from_approach({0.4, 1.1, 0}, 1e11, 1);
  for (double delta : {1e-40, 1e-14, 0.0254e-12, 1e-5}) {
    const HertzContact h = hertz_from_approach({0.4, 1.1, 0}, 1e11, delta);
    CHECK(h.a / (one.a * std::sqrt(delta)) == Approx(1).epsilon(1e-13));
    CHECK(h.p_max / (one.p_max * std::sqrt(delta)) == Approx(1).epsilon(1e-13));
    CHECK(h.force / (one.force * std::pow(delta, 1.5)) == Approx(1).epsilon(1e-13));
    CHECK(hertz_from_force({0.4, 1.1, 0}, 1e11, h.force).approach / delta ==
          Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("extreme: towards line contact the axis ratio follows its asymptote") {
  const NoFpFault no_fault;
  // B -> 1 and D -> ln(4/sqrt(m1)) - 1, so q m1 (ln(4 a/b) - 1) -> 1, with an error of order m1 ln
  // m1.
  for (double ratio : {1e14, 1e30, 1e100, 1e200}) {
    const HertzContact h = hertz_from_approach({1, ratio, 0}, 1e11, 1e-5);
    const double slender = h.b / h.a;
    CHECK(ratio * slender * slender * (std::log(4 / slender) - 1) == Approx(1).epsilon(1e-11));
    CHECK(h.force == Approx(2 * units::pi / 3 * h.a * h.b * h.p_max).epsilon(1e-13));
  }
  CHECK_THROWS_AS(hertz_from_approach({1, 1e201, 0}, 1e11, 1e-5), InputError);
}

TEST_CASE("extreme: nearly round contacts lose no accuracy") {
  const NoFpFault no_fault;
  for (double excess : {1e-3, 1e-8, 1e-15}) {
    const HertzContact h = hertz_from_approach({1, 1 + excess, 0}, 1, 1);
    // B/A = 1 + 3/4 m + O(m^2) for m = 1 - (b/a)^2, so 1 - b/a = 2/3 excess to first order.
    CHECK(h.b <= h.a);
    CHECK(1 - h.b / h.a == Approx(2.0 / 3 * excess).epsilon(2 * excess).margin(5e-16));
  }
}

TEST_CASE("input: Hertz refuses an empty contact and bodies that do not touch first at O") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {0.0, -1e-5, nan}) {
    CHECK_THROWS_AS(hertz_from_approach({1, 2, 0}, 1e11, bad), InputError);
    CHECK_THROWS_AS(hertz_from_force({1, 2, 0}, 1e11, bad), InputError);
    CHECK_THROWS_AS(hertz_from_approach({bad, 2, 0}, 1e11, 1e-5), InputError);
    CHECK_THROWS_AS(hertz_from_approach({1, 2, 0}, bad, 1e-5), InputError);
  }
  CHECK_THROWS_AS(elliptic_integrals(0.1), InputError);
}
