#include <railbook/track/lumped.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include <railbook/track/moving_load.hpp>

#include "support/sampled_response.hpp"

using namespace railbook;
using namespace railbook::track;

namespace {
double influence(double x) {
  const double d = std::abs(x);
  return std::exp(-d) * (std::cos(d) + std::sin(d));
}
const RailOnBed bed{63.0375, 227.4452e6, 11973.96, 292.7402, 31.68331e6, 38522.67};
}  // namespace

TEST_CASE("unit: trackside peaks of the single mass with mu = 3/4") {
  CHECK(trackside_peak(0.0909, 0.75, 0).y == Approx(1.012393).margin(1e-6));
  CHECK(trackside_peak(0.0909, 0.75, 0.2).y == Approx(1.010668).margin(1e-6));
  CHECK(trackside_peak(0.2273, 0.75, 0.2).y == Approx(1.059457).margin(2e-6));
  CHECK(trackside_peak(0.5, 0.75, 0).y == Approx(1.342673).margin(1e-6));
  CHECK(trackside_peak(0.5, 0.75, 0.2).y == Approx(1.201669).margin(1e-6));
}

TEST_CASE("unit: the inertial correction is 2 mu theta^2 against the beam's theta^2 / 2") {
  for (double mu : {0.25, 0.75}) {
    const double theta = 0.01;
    CHECK((trackside_peak(theta, mu, 0).y - 1) / (theta * theta) == Approx(2 * mu).epsilon(1e-3));
  }
  CHECK((undamped_amplification(0.01) - 1) / 1e-4 == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("unit: a passage agrees with its own modulated force sampled in time, order two") {
  const double beta = 0.8, speed = 60;
  const auto error = [&](double step) {
    std::vector<double> force;
    for (double t = -0.5; t < 0.3; t += step) force.push_back(1e5 * influence(beta * speed * t));
    const std::vector<double> sampled = respond(two_layer(bed), force, step);
    const WheelLoad wheel{0, 1e5};
    const std::vector<double> exact = trackside(two_layer(bed), beta, speed, {&wheel, 1}, -0.5,
                                                step, static_cast<int>(sampled.size()));
    double worst = 0;
    for (std::size_t k = 0; k < sampled.size(); ++k)
      worst = std::max(worst, std::abs(sampled[k] - exact[k]));
    return worst;
  };
  const double coarse = error(2e-4), fine = error(1e-4);
  CHECK(fine < 1e-7);
  CHECK(coarse / fine == Approx(4).epsilon(0.2));
}
