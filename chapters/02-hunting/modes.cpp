/***
## The shape of the motion

{{fig-12}} shows, for new wheels, the amplitude of each motion over that of the rear truck, and the
frequency. On the tread nothing changes, as the cone is straight. When the flange is met the shape
changes abruptly.

The paper's "limiting mode with flange contact" is *fishtailing*: the rear truck swings, and front
truck and body hardly move. It is not on the branch that begins at the first critical speed, whose
trucks stay together all the way. It is on the **second** family, which begins with trucks that
oppose each other. Its mirror image, with a swinging front truck, exists too, because exchanging
front and rear changes nothing in the equations but the coupling through the centre plates.

{{fig-12}}

::: {.fold summary="Why the body moves with new wheels only, and a third shape"}

The paper says that with new wheels this "may be because the frequency of the limit cycle is below
the resonant frequency for car-body lateral motion", and that with worn wheels the body moves
little, "as would be expected at high frequencies". On its springs, with the trucks held, the body
has two natural motions in which it moves sideways and rolls, at {{body-frequency}} (damped at
{{body-damping}} the critical value) and at {{upper-frequency}}. The cycle of 12 rad/s lies between
the two, so the first remark depends on which resonance is meant.

The second remark depends on the dampers. If both trucks together moved the body at 21 and 26 rad/s,
it would still move {{forced-21}} and {{forced-26}} times as far as they do with the dampers used
here, and {{undamped-21}} and {{undamped-26}} times without any; so the remark cannot be tested. In
our car the body moves little for another reason. With worn wheels the trucks oppose each other, so
the middle of the body stays at rest while its ends move.

The paper reports fishtailing and its mirror image. The first family has a third shape: both trucks
are on the flange, and at 0.45 in the front one swings {{third-ratio}} as far as the rear one.
Ratios of amplitudes do not show whether trucks go together or oppose each other;
{{critical-speeds}} has the phase.

{{mode-claims}}

:::

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/eigenvalues.hpp>
#include <railbook/report/values.hpp>

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

// Natural frequencies [rad/s] of the body's sway with the trucks held, and the damping ratio of the
// lower one.
struct Held {
  double lower, upper, damping;
};
Held body_alone() {
  const FreightCar& car = vehicle("new").car.car();
  const std::array<int, 2> body{X_C, PHI_C};
  const Eigen::Matrix2d m = car.mass(body, body), k = car.suspension_stiffness(body, body),
                        c = car.suspension_damping(body, body);
  const Eigen::VectorXcd squares = num::eigenvalues(num::solved(m, k));
  const double omega = std::sqrt(squares.real().minCoeff());
  return {omega, std::sqrt(squares.real().maxCoeff()), c(0, 0) / (2 * omega * m(0, 0))};
}

// |X_C| over the motion of both trucks together at a frequency.
double forced(const FreightCar& car, double omega) {
  constexpr std::array body{X_C, PHI_C};
  const Matrix9c z = car.suspension_stiffness.cast<Complex>() +
                     Complex(0, omega) * car.suspension_damping.cast<Complex>() -
                     omega * omega * car.mass.cast<Complex>();
  const Eigen::Matrix2cd m = z(body, body);
  const Eigen::Vector2cd f = -(z.col(X_TF) + z.col(X_TR))(body);
  return std::abs((m(1, 1) * f[0] - m(0, 1) * f[1]) / (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0)));
}

// The paper's explanation of the body's rest with worn wheels, their frequencies: whether the body
// would rest if the trucks went together depends on the dampers, which the paper does not give.
void high_frequencies(report::Item& item) {
  const FreightCar usual = assemble({}, Suspension::dampers);
  CarParameters data;
  data.lateral_friction = data.vertical_friction = 0;
  const FreightCar undamped = assemble(data, Suspension::dampers);
  report::values(item, "", "{:.1f}", "forced-21", forced(usual, 21), "forced-26", forced(usual, 26),
                 "undamped-21", forced(undamped, 21), "undamped-26", forced(undamped, 26));
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

// How much any part of the first family's shape changes on the tread of new wheels, relatively.
double change_on_tread() {
  double most = 0;
  for (const int k : coordinates) {
    Range part;
    for (const auto& p : vehicle("new").branches[0].points)
      if (p.neutral) part.add(relative(p, k));
    most = std::max(most, part.high / part.low - 1);
  }
  return most;
}

// How much X_C / X_TR changes from 0.1 in to another amplitude, relatively.
double change_of_body(const char* key, double inches) {
  return std::abs(relative(cycle(key, inches), X_C) / relative(cycle(key, 0.1), X_C) - 1);
}

void tread_claims(report::Item& item) {
  const std::array<CyclePoint, 3> wheels{cycle("new", 0.1), cycle("cn", 0.1),
                                         cycle("heumann", 0.1)};
  const CyclePoint &fresh = wheels[0], &cn = wheels[1], &heumann = wheels[2];
  const auto of = [&](int k) {
    return std::array{relative(fresh, k), relative(cn, k), relative(heumann, k)};
  };
  const auto fronts = of(X_TF), yaws = of(TH_TR), warps = of(TH_WR);
  item.claim_if("body-new", relative(fresh, X_C) > 1 / words::much, {relative(fresh, X_C)});
  item.claim_if("body-worn", std::max(relative(cn, X_C), relative(heumann, X_C)) < words::nearly,
                {relative(cn, X_C), relative(heumann, X_C)});
  item.claim_if("trucks-equal",
                std::ranges::all_of(wheels,
                                    [](const CyclePoint& p) {
                                      const double front = relative(p, X_TF);
                                      return std::min(front, 1 / front) > 1 - words::nearly;
                                    }),
                {fronts[0], fronts[1], fronts[2]});
  const auto larger = [&](int k) {
    return relative(fresh, k) < std::min(relative(cn, k), relative(heumann, k));
  };
  item.claim_if("yaw-and-warp", larger(TH_TR) && larger(TH_WR),
                {yaws[0], yaws[1], yaws[2], warps[0], warps[1], warps[2]});
  const double most = change_on_tread();
  item.claim_if("constant-on-tread", most < words::drawn, {std::max(most, 1e-5)});
  const double hollow = change_of_body("cn", 0.3), steeper = change_of_body("heumann", 0.2);
  item.claim_if("varies-worn", std::min(hollow, steeper) > words::drawn,
                {100 * hollow, 100 * steeper});
  high_frequencies(item);
  const Held held = body_alone();
  item.value("body-frequency", held.lower, "rad/s", "{:.1f}");
  item.value("upper-frequency", held.upper, "rad/s", "{:.0f}");
  item.value("body-damping", held.damping, "times", "{:.1f}");
}

// How conicity, frequency, yaw and warp of the rear truck change from one amplitude to another,
// times.
struct Change {
  double conicity, omega, yaw, warp;
};
Change change_of(const char* key, double from, double to) {
  const CyclePoint a = cycle(key, from), b = cycle(key, to);
  const auto conicity = [&](const CyclePoint& p) {
    return vehicle(key).car.at(p.motion.shape, p.motion.lambda.imag()).wheel[2][0].value;
  };
  const auto over = [](double x, double y) { return y / x; };
  return {over(conicity(a), conicity(b)), over(a.motion.lambda.imag(), b.motion.lambda.imag()),
          over(relative(a, TH_TR), relative(b, TH_TR)),
          over(relative(a, TH_WR), relative(b, TH_WR))};
}

void follow_conicity(report::Item& item) {
  const std::array<Change, 2> changes{change_of("heumann", 0.17, 0.23),
                                      change_of("new", vehicle("new").flange / inch, 0.5)};
  const auto same_way = [](double a, double b) { return (a > 1) == (b > 1); };
  bool follow = true;
  std::vector<double> numbers;
  for (const Change& c : changes) {
    follow = follow && same_way(c.conicity, c.omega) && same_way(c.conicity, c.warp);
    numbers.insert(numbers.end(), {c.conicity, c.omega, c.warp, c.yaw});
  }
  item.claim_if("follow-conicity", follow, numbers);
}

void flange_claims(report::Item& item) {
  const Vehicle& v = vehicle("new");
  const double flange = v.flange / inch;
  const auto before = cycle("new", flange), after = cycle("new", (1 + words::nearly) * flange),
             fish = cycle("new", 0.48, 1), rear = cycle("new", 0.45, 1), both = cycle("new", 0.45);
  item.claim_if(
      "abrupt", relative(after, X_C) < relative(before, X_C) / words::much,
      {relative(before, X_C), before.largest / inch, relative(after, X_C), after.largest / inch});
  follow_conicity(item);
  item.claim_if("fishtailing", std::max(relative(fish, X_TF), relative(fish, X_C)) < words::small,
                {relative(fish, X_TF), relative(fish, X_C)});
  const auto front = find_cycle(v.car, exchanged(rear.motion), 0.45 * inch);
  const Motion &m = front.cycle.motion, &r = rear.motion;
  const auto same = [](double a, double b) { return std::abs(a / b - 1) < words::drawn; };
  item.claim_if("mirrored",
                front.converged &&
                    front.cycle.amplitude[2] < words::small * front.cycle.amplitude[0] &&
                    same(m.speed, r.speed) && same(m.lambda.imag(), r.lambda.imag()),
                {r.speed / foot, r.lambda.imag(), m.speed / foot, m.lambda.imag()});
  item.value("third-ratio", relative(both, X_TF), "times", "{:.2f}");
  const double body = std::abs(m.shape[X_C]) / std::abs(r.shape[X_C]);
  item.claim_if("mirrored-body", std::abs(body - 1) < words::drawn, {body});
}

void mode_claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  tread_claims(item);
  flange_claims(item);
}

}  // namespace

const report::Section mode_shapes{report::figure("fig-12", fig_12),
                                  report::table("mode-claims", mode_claims)};

}  // namespace railbook::hunting_chapter
