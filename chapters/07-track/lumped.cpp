/***
## The lumped track, on car and at trackside

Below $V_c$ the rail's dent travels with the wheel almost unchanged, and so may a lumped model: one mass or two on springs and dampers, moved along below each wheel.
{{fig-04}} is that model as rebuilt here; the paper's drawing has no numbers, and its text breaks off after (10).

{{fig-04}}

A fixed point beside the track sees something else: wheels that come and go. The paper takes the same lumped model,

$$Y(s)=\frac{P(s)}{K_r+C_rs+M_rs^2}, \tag{10}$$

puts the wheel/rail forces on its rail mass, and scales each by the beam's deflection at that distance. Equations (11) to (14) are not in the text that is
available. Its words are read as

$$P(t)=\sum_iP_i(t)\,a\bigl(\beta(Vt-x_i)\bigr),$$

$$M_{rail}\ddot y_r+C_1(\dot y_r-\dot y_t)+K_1(y_r-y_t)=P(t),$$

$$m_t\ddot y_t+C_g\dot y_t+K_gy_t=C_1(\dot y_r-\dot y_t)+K_1(y_r-y_t).$$

$a$ is a sum of damped exponentials, so for constant loads the response is one too, and needs no time stepping: before a wheel passes only the forced part exists, after
it the system is carried on by a matrix exponential, with the modulation itself as two more states.

{{code: track/lumped.cpp state}}

{{fig-05}}

At 60 mph the two-layer track answers a truck almost statically. At 250 mph the inertia shows: the bed is still moving after the last wheel.

### What the lumped mass gets wrong

For one mass the response depends on three numbers, the speed ratio $\theta$, the damping $\zeta$ and the mass ratio $\mu=M\beta^2V_c^2/K_r$, which is 3/4 for the mass
of (15). Its peak grows as $1+2\mu\theta^2$, the true beam's as $1+\theta^2/2$. So the mass that is right for kinetic energy makes inertia at a fixed point three
times too important; $M=\rho/2\beta$, $\mu=1/4$, would be right in the limit of low speed.

{{trackside-peak}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sections.hpp"
#include "track/lumped.hpp"
#include "track/moving_load.hpp"
#include "track/wheel_on_track.hpp"

namespace railbook::track_chapter {

using namespace track;

namespace {

// The scheme of Figure 4 as line drawing: polylines, boxes and labels in one small coordinate system.
void scheme(report::Item& item) {
  auto& lines = item.data({"x", "y"});
  const auto stroke = [&](std::initializer_list<std::array<double, 2>> points) {
    for (const auto& p : points) lines.add(p[0], p[1]);
    lines.gap();
  };
  const auto box = [&](double x, double y, double w, double h) {
    stroke({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}});
  };
  const auto spring = [&](double x, double low, double high) {
    const double end = 0.18 * (high - low), turn = (high - low - 2 * end) / 6;
    lines.add(x, low);
    for (int i = 0; i <= 6; ++i)
      lines.add(x + (i == 0 || i == 6 ? 0 : i % 2 ? 0.14 : -0.14), low + end + turn * i);
    lines.add(x, high);
    lines.gap();
  };
  const auto damper = [&](double x, double low, double high) {
    const double mid = 0.5 * (low + high);
    stroke({{x, low}, {x, mid - 0.12}});
    stroke({{x - 0.14, mid + 0.18},
            {x - 0.14, mid - 0.12},
            {x + 0.14, mid - 0.12},
            {x + 0.14, mid + 0.18}});
    stroke({{x - 0.1, mid + 0.05}, {x + 0.1, mid + 0.05}});
    stroke({{x, mid + 0.05}, {x, high}});
  };
  for (int i = 0; i <= 40; ++i)  // the wheel
    lines.add(0.55 * std::sin(units::pi * i / 20), 4.95 + 0.55 * std::cos(units::pi * i / 20));
  lines.gap();
  spring(0, 3.6, 4.4);
  box(-0.6, 3.2, 1.2, 0.4);
  spring(-0.35, 2.2, 3.2);
  damper(0.35, 2.2, 3.2);
  box(-0.8, 1.7, 1.6, 0.5);
  spring(-0.35, 0.7, 1.7);
  damper(0.35, 0.7, 1.7);
  stroke({{-1.1, 0.7}, {1.1, 0.7}});
  for (int i = -5; i < 5; ++i) stroke({{0.22 * i, 0.5}, {0.22 * i + 0.2, 0.7}});
  for (double x = 1.2; x <= 4.7; x += 0.05)  // the rail's running surface, with a joint
    lines.add(x, 3.9 - 0.35 * (1 - std::abs(std::sin(units::pi * (x - 2.95) / 2.9))));
  lines.gap();
  auto& labels = item.data("labels", {"x", "y", "label"});
  labels.add(0.0, 5.85, "static load P_0");
  labels.add(0.0, 4.95, "m_w");
  labels.add(-0.95, 4.0, "Hertz contact");
  labels.add(-0.95, 3.75, "F = C_H x^{3/2}");
  labels.add(0.0, 3.4, "M_{rail}");
  labels.add(-0.8, 2.7, "K_1");
  labels.add(0.8, 2.7, "C_1");
  labels.add(0.0, 1.95, "m_t");
  labels.add(-0.8, 1.2, "K_g");
  labels.add(0.8, 1.2, "C_g");
  labels.add(2.95, 4.25, "rail surface z(Vt), dip at a joint");
  labels.add(2.95, 2.7, "pads and ties");
  labels.add(2.95, 1.2, "ballast and subgrade");
  item.sketch("scheme of the lumped model as rebuilt here");
}

void modulation(report::Item& item) {
  const auto track = two_layer(typical_impact().track);
  const double beta = typical_beam().beta(), stiffness = typical_beam().point_stiffness();
  const std::array<WheelLoad, 4> trucks{{{0, typical_wheel_load},
                                         {70 * units::inch, typical_wheel_load},
                                         {15, typical_wheel_load},
                                         {15 + 70 * units::inch, typical_wheel_load}}};
  auto& data = item.data({"distance_m", "static_mm", "at_60mph_mm", "at_250mph_mm"});
  constexpr int count = 1600;
  const double first = -5, last = 27, step = (last - first) / count;
  std::array<std::vector<double>, 2> runs;
  for (std::size_t i = 0; i < 2; ++i) {
    const double speed = (i == 0 ? 60 : 250) * units::mph;
    runs[i] = trackside(track, beta, speed, trucks, first / speed, step / speed, count + 1);
  }
  for (int k = 0; k <= count; ++k) {
    const double x = first + k * step;
    double still = 0;
    for (const auto& wheel : trucks)
      still += wheel.force / stiffness * winkler_shapes(beta * std::abs(x - wheel.x)).a;
    data.add(x, 1e3 * still, 1e3 * runs[0][std::size_t(k)], 1e3 * runs[1][std::size_t(k)]);
  }
  item.rebuilt("the figure's caption and (11)-(14) are lost: typical track, two trucks assumed");
}

void trackside_peaks(report::Item& item) {
  item.rebuilt("follows from the reading of (10)-(14) above");
  item.columns({{"theta", "{:.4f}"},
                {"moving load on the beam", "{:.6f}"},
                {"lumped, mu = 3/4", "{:.6f}"},
                {"lumped, mu = 3/4, zeta = 0.2", "{:.6f}"},
                {"lumped, mu = 1/4", "{:.6f}"}});
  for (const double theta : {100.0 / 1100, 160.0 / 1100, 250.0 / 1100, 0.5})
    item.add_row(theta, undamped_amplification(theta), trackside_peak(theta, 0.75, 0).y,
                 trackside_peak(theta, 0.75, 0.2).y, trackside_peak(theta, 0.25, 0).y);
  item.expect_checks(2);
  // The slope in theta^2 as theta goes to zero, by Richardson from two small speeds, against 2 mu.
  for (const double mu : {0.75, 0.25}) {
    const auto slope = [mu](double theta) {
      return (trackside_peak(theta, mu, 0).y - 1) / (theta * theta);
    };
    const double limit = (4 * slope(0.01) - slope(0.02)) / 3;
    item.agree(fmt::format("growth-{}", mu), fmt::format("growth of the peak, mu = {}", mu), "",
               limit, 2 * mu, 1e-4, "the expansion for low speed");
  }
}

}  // namespace

const report::Section lumped{
    report::figure("fig-04", "Lumped track below a wheel (the paper's Fig. 4)", scheme),
    report::figure("fig-05", "Trackside deflection under two trucks (the paper's Fig. 5)",
                   modulation),
    report::table("trackside-peak", "Peak at a fixed point over the static deflection",
                  trackside_peaks)};

}  // namespace railbook::track_chapter
