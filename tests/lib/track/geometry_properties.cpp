#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/track/track_geometry.hpp>

using namespace railbook::track;

TEST_CASE("property: half-staggered joints excite odd harmonics in roll, even ones in bounce") {
  const RectifiedSine rail{1.0, 12.0};
  constexpr int n = 4096;
  std::vector<double> bounce, roll;
  for (int i = 0; i < n; ++i) {
    const BounceRoll both = half_staggered(rail, rail.length * i / n);
    bounce.push_back(both.bounce);
    roll.push_back(both.roll);
  }
  const auto b = cosine_amplitudes(bounce, 12), r = cosine_amplitudes(roll, 12);
  for (int k = 0; k < 12; ++k) {
    const auto i = static_cast<std::size_t>(k);
    CHECK((k % 2 == 0 ? r[i] : b[i]) == Approx(0).margin(1e-15));
    CHECK((k % 2 == 0 ? b[i] : r[i]) ==
          Approx(rectified_sine_harmonic(k)).epsilon(1e-4).margin(1e-6));
  }
}

TEST_CASE("property: bounce plus roll is the left rail") {
  const RectifiedSine rail{0.02, 12.0};
  for (double x : {-7.0, 0.0, 1.0, 30.0}) {
    const BounceRoll both = half_staggered(rail, x);
    CHECK(both.bounce + both.roll == Approx(surface_at(rail, x).z).margin(1e-17));
  }
}
