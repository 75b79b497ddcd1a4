// Left and right that differ.
#include <catch2/catch.hpp>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheelset;

namespace {

ConstraintFunctions table_of(const WheelsetOnTrack& pair) {
  return tabulate(pair, {.half_spacing = paper_track.half_spacing,
                         .end = 0.4 * units::inch,
                         .step = 0.01 * units::inch,
                         .average = 0.04 * units::inch});
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double sign) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - sign * b[k]));
  return worst;
}

}  // namespace

TEST_CASE("Two sides that are alike are the symmetric wheelset", "[sides]") {
  const WheelsetOnTrack& pair = new_wheel_pair();
  const auto one = table_of(pair), two = table_of({pair, pair});
  CHECK(one.symmetric());
  CHECK_FALSE(two.symmetric());
  CHECK(largest_difference(one.R.values(), two.R.values(), 1) < 1e-12);
  CHECK(largest_difference(one.Phi.values(), two.Phi.values(), 1) < 1e-12);
  for (const auto* e : {&two.even.R, &two.even.D, &two.even.Phi})
    for (const double value : *e) CHECK(std::abs(value) < 1e-12);
  CHECK(largest_difference(one.delta_right, two.delta_right, 1) < 1e-12);
}

TEST_CASE("Sides exchanged are the mirror image", "[sides]") {
  const auto a = table_of({cn_pair(), new_wheel_pair()}),
             b = table_of({new_wheel_pair(), cn_pair()});
  CHECK(largest_difference(a.R.values(), b.R.values(), 1) < 1e-12);
  CHECK(largest_difference(a.even.R, b.even.R, -1) < 1e-12);
  CHECK(largest_difference(a.even.D, b.even.D, -1) < 1e-12);
  CHECK(largest_difference(a.even.Phi, b.even.Phi, -1) < 1e-12);
  // The functions themselves are those of both wheels, on both sides of the centre.
  const std::size_t middle = a.r_left.size() / 2;
  for (const int k : {-30, -7, 0, 5, 33}) {
    const auto at = std::size_t(int(middle) + k);
    const auto c = a.at(k * a.R.step());
    CHECK(c.R == Approx((a.r_left[at] - a.r_right[at]) / (2 * a.half_spacing)).margin(1e-14));
    CHECK(c.D == Approx((a.delta_left[at] - a.delta_right[at]) / 2).margin(1e-14));
  }
}
