/***
### Mode shapes

{{fig-12}} shows, for new wheels, each motion over that of the rear truck, and the frequency. On the tread nothing changes, as the cone is straight; when the flange is met the shape changes abruptly.
The paper's "limiting mode with flange contact" is fishtailing: the rear truck swings, the front truck and the body hardly move. It is not on the branch that begins at the first
critical speed, whose trucks stay together all the way. It is on the **second** family, and its mirror image exists too: exchanging front and rear
changes nothing in the equations but the coupling through the centre plates. The paper found those two shapes only.

{{fig-12}}

The paper explains the body's large motion with new wheels by a frequency below the resonance of the body's lateral motion. With its own data the body on its lateral
springs, trucks held, has {{body-frequency}}, *below* the 12 rad/s of the cycle; it goes along because the dampers, {{body-damping}} critical, carry it.

{{mode-claims}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "num/dense_lu.hpp"
#include "num/eigenvalues.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

// |q_k| / |X_TR| as in the paper's figure; angles in rad a foot of X_TR.
double relative(const CyclePoint& p, int coordinate) {
  const double ratio = std::abs(p.motion.shape[coordinate]) / std::abs(p.motion.shape[X_TR]);
  const bool angle = coordinate != X_TF && coordinate != X_C;
  return angle ? ratio * foot : ratio;
}

constexpr std::array coordinates{X_TF, X_C, TH_TR, TH_WR, TH_C, PHI_C};  // those of Fig. 12

CyclePoint cycle(const char* key, double inches, std::size_t family = 0) {
  const Vehicle& v = vehicle(key);
  return cycles_at_amplitude(v.car, v.branches[family], inches * inch).at(0);
}

// Natural frequency [rad/s] of the body's lateral motion with the trucks held, and its damping ratio.
struct Held {
  double frequency, damping;
};
Held body_alone() {
  const FreightCar& car = vehicle("new").car.car();
  const std::array<int, 2> body{X_C, PHI_C};
  const Eigen::Matrix2d m = car.mass(body, body), k = car.suspension_stiffness(body, body),
                        c = car.suspension_damping(body, body);
  const Eigen::VectorXcd squares = num::eigenvalues(num::solved(m, k));
  const double omega = std::sqrt(squares.real().minCoeff());
  return {omega, c(0, 0) / (2 * omega * m(0, 0))};
}

void fig_12(report::Item& item) {
  item.rebuilt("the paper's curves are lost; " + std::string(rebuilt_reason));
  for (std::size_t family = 0; family < 2; ++family) {
    auto& data = item.data(family == 0 ? "" : "second",
                           {"A_in", "X_TF", "X_C", "TH_TR", "TH_WR", "TH_C", "PHI_C", "omega"});
    for (const auto& p : vehicle("new").branches[family].points)
      data.add(p.largest / inch, relative(p, X_TF), relative(p, X_C), relative(p, TH_TR),
               relative(p, TH_WR), relative(p, TH_C), relative(p, PHI_C), p.motion.lambda.imag());
  }
}

void tread_claims(report::Item& item) {
  const std::array<CyclePoint, 3> wheels{cycle("new", 0.1), cycle("cn", 0.1),
                                         cycle("heumann", 0.1)};
  const CyclePoint &fresh = wheels[0], &cn = wheels[1], &heumann = wheels[2];
  const auto three = [&](int coordinate) {
    return fmt::format("{:.3f}, {:.3f}, {:.3f}", relative(wheels[0], coordinate),
                       relative(wheels[1], coordinate), relative(wheels[2], coordinate));
  };
  claim(item, "body-new", relative(fresh, X_C) > 1 / words::much,
        fmt::format("{:.2f}", relative(fresh, X_C)));
  claim(item, "body-worn", std::max(relative(cn, X_C), relative(heumann, X_C)) < words::nearly,
        fmt::format("CN A {:.2f}, Heumann {:.2f}", relative(cn, X_C), relative(heumann, X_C)));
  claim(item, "trucks-equal",
        std::ranges::all_of(wheels,
                            [](const CyclePoint& p) {
                              const double front = relative(p, X_TF);
                              return std::min(front, 1 / front) > 1 - words::nearly;
                            }),
        three(X_TF));
  const auto larger = [&](int k) {
    return relative(fresh, k) < std::min(relative(cn, k), relative(heumann, k));
  };
  claim(item, "yaw-and-warp", larger(TH_TR) && larger(TH_WR),
        fmt::format("yaw {} rad/ft; warp {}", three(TH_TR), three(TH_WR)));
  std::array<Range, coordinates.size()> shape;
  for (const auto& p : vehicle("new").branches[0].points)
    if (p.neutral)
      for (std::size_t k = 0; k < shape.size(); ++k) shape[k].add(relative(p, coordinates[k]));
  double most = 0;
  for (const Range& r : shape) most = std::max(most, r.high / r.low - 1);
  claim(item, "constant-on-tread", most < words::drawn,
        fmt::format("each part of it over X_TR within {}", report::below(most)));
  const auto change = [](const char* key, double inches, const CyclePoint& first) {
    return std::abs(relative(cycle(key, inches), X_C) / relative(first, X_C) - 1);
  };
  const double hollow = change("cn", 0.3, cn), steeper = change("heumann", 0.2, heumann);
  claim(item, "varies-worn", std::min(hollow, steeper) > words::drawn,
        fmt::format(
            "X_C/X_TR from 0.1 in on: CN A by {:.0f} % to 0.3 in, Heumann by {:.0f} % to 0.2 in",
            100 * hollow, 100 * steeper));
  const Held held = body_alone();
  const double omega = fresh.motion.lambda.imag();
  refute(item, "below-resonance", omega > held.frequency,
         fmt::format("{:.1f} rad/s, the body on its springs {:.1f}", omega, held.frequency));
  item.value("body-frequency", held.frequency, "rad/s", "{:.1f}");
  item.value("body-damping", held.damping, "times", "{:.1f}");
}

void flange_claims(report::Item& item) {
  const Vehicle& v = vehicle("new");
  const double flange = v.flange / inch;
  const auto before = cycle("new", flange), after = cycle("new", (1 + words::nearly) * flange),
             far = cycle("new", 0.5), fish = cycle("new", 0.48, 1), rear = cycle("new", 0.45, 1),
             both = cycle("new", 0.45);
  claim(item, "abrupt", relative(after, X_C) < relative(before, X_C) / words::much,
        fmt::format("X_C/X_TR {:.2f} at {:.2f} in, {:.2f} at {:.2f} in", relative(before, X_C),
                    before.largest / inch, relative(after, X_C), after.largest / inch));
  const double low = before.motion.lambda.imag(), high = far.motion.lambda.imag();
  claim(item, "follow-conicity",
        high > low && relative(far, TH_TR) > relative(before, TH_TR) &&
            relative(far, TH_WR) > relative(before, TH_WR),
        fmt::format("to 0.5 in: {:.1f} to {:.1f} rad/s, yaw {:.3f} to {:.3f}, warp {:.3f} to "
                    "{:.3f} rad/ft",
                    low, high, relative(before, TH_TR), relative(far, TH_TR),
                    relative(before, TH_WR), relative(far, TH_WR)));
  claim(item, "fishtailing", std::max(relative(fish, X_TF), relative(fish, X_C)) < words::small,
        fmt::format("second family, 0.48 in: X_TF {:.3f}, X_C {:.3f} of X_TR", relative(fish, X_TF),
                    relative(fish, X_C)));
  Motion swapped = rear.motion;
  for (const int k : {X_TF, TH_TF, TH_WF}) std::swap(swapped.shape[k], swapped.shape[k + 1]);
  swapped.shape[TH_C] *= -1;
  const auto front = find_cycle(v.car, swapped, 0.45 * inch);
  const Motion &m = front.cycle.motion, &r = rear.motion;
  const auto same = [](double a, double b) { return std::abs(a / b - 1) < words::drawn; };
  claim(item, "mirrored",
        front.converged && front.cycle.amplitude[2] < words::small * front.cycle.amplitude[0] &&
            same(m.speed, r.speed) && same(m.lambda.imag(), r.lambda.imag()),
        fmt::format("rear {:.2f} ft/s and {:.2f} rad/s, front {:.2f} and {:.2f}, at 0.45 in",
                    r.speed / foot, r.lambda.imag(), m.speed / foot, m.lambda.imag()));
  const double together = relative(both, X_TF);
  refute(item, "two-shapes", std::abs(together - 1) < words::nearly,
         fmt::format("there is a third: at 0.45 in X_TF is {:.2f} of X_TR on the first family",
                     together));
  const double body = std::abs(m.shape[X_C]) / std::abs(r.shape[X_C]);
  claim(item, "mirrored-body", std::abs(body - 1) < words::drawn,
        fmt::format("{:.3f} times", body));
}

void mode_claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(13);
  tread_claims(item);
  flange_claims(item);
}

}  // namespace

const report::Section mode_shapes{
    report::figure("fig-12", "Mode shapes with new wheels against amplitude (Fig. 12)", fig_12),
    report::table("mode-claims", "What the text says of mode shapes", mode_claims)};

}  // namespace railbook::hunting_chapter
