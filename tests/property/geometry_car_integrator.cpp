// The vertical chain once more by another integrator and another form of the filter: Runge-Kutta of order 4 on the
// acceleration itself, over the same straight pieces of track, while the speed changes.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "geometry_car/simulate.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::geometry_car;

namespace {

using State = std::array<double, 4>;  // height of the body, its rate, two poles of F

State plus(const State& x, const State& d, double h) {
  State y;
  for (std::size_t i = 0; i < 4; ++i) y[i] = x[i] + h * d[i];
  return y;
}

struct Bounce {
  double rail = 0, slope = 0;  // of the straight piece: height at its start, rate
  State operator()(const State& x, double t) const {
    const double w = 2 * units::pi, f = 2 * units::pi;
    const double a = -0.4 * w * (x[1] - slope) - w * w * (x[0] - rail - slope * t);
    return {x[1], a, f * (a - x[2]), f * (x[2] - x[3])};
  }
};

State step(const Bounce& f, State x, double h) {
  constexpr int parts = 8;
  const double k = h / parts;
  for (int i = 0; i < parts; ++i) {
    const double t = i * k;
    const State a = f(x, t), b = f(plus(x, a, k / 2), t + k / 2),
                c = f(plus(x, b, k / 2), t + k / 2), d = f(plus(x, c, k), t + k);
    for (std::size_t j = 0; j < 4; ++j) x[j] += k / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
  }
  return x;
}

}  // namespace

TEST_CASE("geometry car: bounce and F by Runge-Kutta, speed changing", "[simulation]") {
  TrackDescription d;
  d.length = 1600 * units::foot;
  d.line.A = d.gage_variation.A = d.opposite_share = d.curvature = d.superelevation = 0;
  d.staggered = false;
  const Track track = build(d);
  Motion motion{.start = 80 * units::foot, .speed = 25};
  motion.cruise(30).change_speed(8, 0.9).cruise(20).change_speed(12, 0.6).cruise(10);
  const Record record = drive(track, Car{}, motion);

  State x{};
  Moment last;
  std::size_t row = 0;
  double worst = 0, largest = 0;
  bool first = true;
  each_moment(motion, track.spacing, 0.1, [&](const Moment& m) {
    const auto rail = [&](double s) {
      const auto i = static_cast<std::size_t>(s / track.spacing);
      return track.z_left[i] +
             (s / track.spacing - static_cast<double>(i)) * (track.z_left[i + 1] - track.z_left[i]);
    };
    if (first) x = {rail(m.position), 0, 0, 0};
    const double h = first ? 0 : m.time - last.time;
    if (h > 0) x = step({rail(last.position), (rail(m.position) - rail(last.position)) / h}, x, h);
    first = false;
    last = m;
    if (m.node < 0 || m.node % track.substeps != 0) return;
    const double there =
        0.5 * (record[Channel::vertical_left][row] + record[Channel::vertical_right][row]);
    worst = std::max(worst, std::abs(there - x[3]));
    largest = std::max(largest, std::abs(x[3]));
    ++row;
  });
  CHECK(row == record.size());
  CHECK(largest > 0.1);
  CHECK(worst < 1e-9);
}
