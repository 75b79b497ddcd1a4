/***
### Amplitude against speed

{{fig-11}} is the paper's central figure, recomputed twice: the largest amplitude of any wheelset on each limit cycle against speed. The thin lines are the describing functions', solid where the *paper's rule*
calls the cycle stable: a little more amplitude at the same speed makes the mode decay, which for a mode that speed excites means that $V$ rises with $A$. On the cone's tread every amplitude is a cycle at
the one critical speed, neither stable nor unstable; the paper counts that vertical line as unstable.

The rule looks at one mode only, the cycle's own. The thick lines are the branches of the full equations, solid where *every* small deviation dies out ({{true-branches}}); circles mark where they turn
in speed, squares where a second frequency sets in.

{{fig-11}}

{{include: answer.cpp}}

With new wheels the branch goes straight up at 145 ft/s until the flange is met at {{flange-new}} and then runs far to
the right, by describing functions. The thick line turns earlier and is stable to {{torus-speed}} only.
With CN wheels there is a lower region, where one truck has met the flange and the other has not, and a higher one with both, on a falling branch and unstable.
The Heumann wheel has its small stable cycle without flange contact, the paper's "limited range of speeds".
With friction the sticking car is nearly one rigid body, and its cycles come down to {{friction-fold}} (a minimum that hangs on the sticking rate).

{{claims}}

**The frequency on the flange.** "For all three wheel profiles, frequencies for limit cycles with flange contact approach a single high value in the
neighborhood of 30.5 rad/s." The paper does not say at which amplitude. At 0.6 in, well up the flange, the describing functions have about one frequency for all three; the full equations have lower ones, farther apart, because a cycle that is
driven from wall to wall is no sine.

{{flange-frequency}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double inch = units::inch, foot = units::foot;
using units::nan;

const std::vector<std::string> columns{"V_ft_per_s",  "A_in",       "stable_in",
                                       "unstable_in", "neutral_in", "omega"};

enum Kind { stable, unstable, neutral };
struct Dot {
  double speed, amplitude, omega;
  Kind kind;
};
Dot dot(const CyclePoint& p) {
  return {p.motion.speed, p.largest, p.motion.lambda.imag(),
          p.neutral  ? neutral
          : p.stable ? stable
                     : unstable};
}
Dot dot(const LimitCycle& p) {
  return {p.parameter, p.largest, p.cycle.omega,
          p.neutral  ? neutral
          : p.stable ? stable
                     : unstable};
}

// One column a kind of line; a line to the next point is of this point's kind.
template <class Point>
void draw_branch(report::Data& data, const std::vector<Point>& points) {
  Kind before = dot(points.front()).kind;
  for (const Point& point : points) {
    const Dot p = dot(point);
    const auto in = [&](Kind line) {
      return p.kind == line || before == line ? p.amplitude / inch : nan;
    };
    data.add(p.speed / foot, p.amplitude / inch, in(stable), in(unstable), in(neutral), p.omega);
    before = p.kind;
  }
}

void fig_11(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  for (const auto& v : vehicles())
    draw_branch(v.key == "new" ? item.data(columns) : item.data(v.key, columns),
                v.main_branch().points);
  auto& exact = item.data("true", columns);
  for (const auto& v : vehicles()) {
    draw_branch(exact, true_branch(v.key).points);
    exact.gap();
  }
  auto& marks = item.data("special", {"V_ft_per_s", "fold_in", "torus_in", "other_in"});
  for (const auto& v : vehicles())
    for (const SpecialCycle& s : true_branch(v.key).special) {
      const auto in = [&](bool is) { return is ? s.at.largest / inch : nan; };
      const bool fold = s.kind == CycleEvent::fold, torus = s.kind == CycleEvent::torus;
      marks.add(s.at.parameter / foot, in(fold), in(torus), in(!fold && !torus));
    }
  speed_answer(item);
  item.value("flange-new", vehicle("new").flange / inch, "in", "{:.2f}");
  item.value("friction-fold", vehicle("friction").main_branch().folds.at(0).motion.speed / foot,
             "ft/s", "{:.0f}");
}

struct Range {
  double low = 1e9, high = 0;
  double width() const { return high - low; }
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
  std::string text() const { return fmt::format("{:.2f} to {:.2f} ft/s", low, high); }
};

// Speeds of the main branch's points with `accept`, ft/s.
template <class Accept>
Range speeds(const Vehicle& v, Accept&& accept) {
  Range range;
  for (const auto& p : v.main_branch().points)
    if (accept(p)) range.add(p.motion.speed / foot);
  return range;
}

CyclePoint at_amplitude(const Vehicle& v, double inches) {
  return cycles_at_amplitude(v.car, v.main_branch(), inches * inch).at(0);
}

void tread_claims(report::Item& item) {
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn"), &heumann = vehicle("heumann");
  const auto tread = [](const Vehicle& v) {
    return [top = v.flange](const CyclePoint& p) { return p.largest < top; };
  };
  const Range v = speeds(fresh, tread(fresh)), a = speeds(cn, tread(cn)),
              b = speeds(heumann, tread(heumann));
  item.claim("vertical", "new wheels: the curve is vertical until the flange contacts",
             v.width() < words::drawn * v.low,
             fmt::format("{}, up to {:.2f} in", v.text(), fresh.flange / inch));
  item.claim("variation", "CN A and Heumann: slightly more variation, and still small",
             std::min(a.width(), b.width()) > v.width() && a.width() < words::nearly * a.low &&
                 b.width() < words::nearly * b.low,
             fmt::format("CN A {}, Heumann {}", a.text(), b.text()));
}

void flange_claims(report::Item& item) {
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn"), &heumann = vehicle("heumann");
  const auto stable_above = [](double a) {
    return [a](const CyclePoint& p) { return p.stable && p.largest > a; };
  };
  const Range n = speeds(fresh, stable_above(fresh.flange)),
              r = speeds(cn, stable_above(cn.flange)),
              h = speeds(heumann, [&](const CyclePoint&p) {
                return p.stable && p.largest < heumann.flange;
              });
  item.claim("far-right",
             "new wheels: by the paper's rule the stable cycles extend to a high speed",
             n.high * foot > words::much * fresh.hopf[0].motion.speed, n.text());
  item.claim("smaller-range", "the speed range of stable cycles is smaller for CN A and Heumann",
             std::max(r.width(), h.width()) < n.width(),
             fmt::format("CN A {}, Heumann {}", r.text(), h.text()));
  item.claim(
      "heumann-window",
      "Heumann: stable cycles in a limited range of speeds, at amplitudes without flange contact",
      h.high > h.low && h.width() < words::nearly * h.low,
      fmt::format("{}; the flange is met at {:.2f} in", h.text(), heumann.flange / inch));
  // A region is another one when it begins a tenth of the amplitude beyond the last.
  int regions = 0;
  double up_to = 0;
  for (const auto& p : cn.main_branch().points)
    if (p.stable && p.largest > cn.flange) {
      regions += p.largest > (1 + words::nearly) * up_to;
      up_to = std::max(up_to, p.largest);
    }
  item.refute("cn-regions", "CN A: stable cycles in two distinct regions of flange contact",
              regions < 2,
              fmt::format("by the paper's own rule one region, up to {:.3f} in", up_to / inch));
  const auto low = at_amplitude(cn, 0.42), high = at_amplitude(cn, 0.48);
  item.refute("cn-rear", "CN A, lower region: only a wheelset of the rear truck touches",
              low.amplitude[0] > cn.flange && low.amplitude[0] > low.amplitude[2],
              fmt::format("the front truck's does: {:.3f} in at the front, {:.3f} at the rear",
                          low.amplitude[0] / inch, low.amplitude[2] / inch));
  item.claim(
      "cn-both", "CN A, higher region: a wheelset of each truck touches",
      std::min(high.amplitude[0], high.amplitude[2]) > cn.flange,
      fmt::format("{:.3f} and {:.3f} in", high.amplitude[0] / inch, high.amplitude[2] / inch));
}

// How far bolster and truck move against each other, a part of the truck's motion.
double stroke(const Vehicle& v, const CyclePoint& p) {
  const Complex u = v.car.car().joint[1].row.cast<Complex>().dot(p.motion.shape);
  return std::abs(u) / std::abs(p.motion.shape[X_TR]);
}

void friction_claims(report::Item& item) {
  const Vehicle &cn = vehicle("cn"), &friction = vehicle("friction");
  const double linear = cn.hopf[0].motion.speed / foot;
  const double low = words::small * cn.flange;
  const Range small = speeds(friction, [&](const CyclePoint& p) { return p.largest < low; });
  item.claim("friction-low", "friction: at low amplitude the speeds are reduced drastically",
             small.low < linear / words::much,
             fmt::format("from {:.0f} ft/s on, {:.1f} in the linear car", small.low, linear));
  double largest = 0;
  for (const auto& p : friction.main_branch().points)
    if (p.stable && p.motion.speed * words::much < linear * foot)
      largest = std::max(largest, p.largest);
  item.claim(
      "friction-stable",
      "friction: stable cycles at low speeds have very low amplitudes (below half of what "
      "the flange allows)",
      largest > 0 && largest < low,
      fmt::format("up to {:.3f} in below {:.0f} ft/s", largest / inch, linear / words::much));
  const Range large = speeds(
      friction, [&](const CyclePoint& p) { return p.largest > low && p.largest < cn.flange; });
  item.claim(
      "friction-large",
      "friction: at larger amplitudes the speeds are closer to the linear critical speed, and "
      "below it",
      large.high > small.low && large.high < linear, large.text());
  const auto touching = at_amplitude(friction, 0.42);
  item.refute("friction-flange", "friction: the cycles with flange contact are stable",
              !touching.stable,
              fmt::format("at 0.42 in speed falls with amplitude ({:.1f} ft/s)",
                          touching.motion.speed / foot));
  const double stuck = stroke(friction, at_amplitude(friction, 0.02)),
               sliding = stroke(friction, at_amplitude(friction, 0.3));
  item.claim(
      "friction-rigid",
      "friction: at low amplitude the car moves more as one rigid body, at large amplitude its "
      "parts move apart",
      stuck < sliding,
      fmt::format("stroke over truck motion {:.4f} at 0.02 in, {:.4f} at 0.3 in", stuck, sliding));
  CarParameters less;
  less.damper_travel *= 0.5, less.damper_angle *= 0.5;
  const auto found =
      hopf_points({assemble(less, Suspension::dampers), *cn.table}, 20 * foot, 250 * foot);
  const double slower = found.empty() ? nan : found[0].motion.speed / foot;
  item.claim("equivalent-too-large",
             "friction: equivalent amplitudes and frequencies were too large: half of them bring "
             "the linear car nearer",
             std::abs(slower - large.high) < std::abs(linear - large.high),
             fmt::format("{:.1f} ft/s with half, {:.1f} with all", slower, linear));
}

void claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(15);
  tread_claims(item);
  flange_claims(item);
  friction_claims(item);
  const Vehicle& fresh = vehicle("new");
  const auto body = [&](std::size_t k) { return std::abs(fresh.hopf[k].motion.shape[X_C]); };
  item.claim("secondary", "there are secondary limit cycles at higher speeds, of another shape",
             fresh.hopf.size() > 1 && body(1) < words::small * body(0),
             fmt::format("from {:.1f} ft/s on; body over wheelset {:.2f} instead of {:.2f}",
                         fresh.hopf[1].motion.speed / foot, body(1), body(0)));
}

void flange_frequency(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(4);
  item.columns({"wheel",
                {"V, ft/s", "{:.1f}"},
                {"ω by describing functions, rad/s", "{:.2f}"},
                {"ω of the full equations", "{:.2f}"},
                {"amplitude there, in", "{:.3f}"}});
  Range quasi, exact;
  double mean = 0;
  for (std::size_t k = 0; k < with_dampers; ++k) {
    const Vehicle& v = vehicles()[k];
    const auto p = at_amplitude(v, 0.6);
    const Examined truth = examine(v.car.car(), *v.table, p.motion);
    const double omega = p.motion.lambda.imag();
    mean += omega / with_dampers;
    quasi.add(omega);
    if (truth.converged) exact.add(truth.omega);
    item.add_row(v.name, p.motion.speed / foot, omega, truth.converged ? truth.omega : nan,
                 truth.converged ? truth.amplitude / inch : nan);
  }
  item.print("flange-frequency", "mean of the three by describing functions, 0.6 in", "rad/s",
             "30.5", mean, report::relative(words::nearly, "\"in the neighborhood\" of it"));
  item.claim("flange-single", "with flange contact all three frequencies approach a single value",
             quasi.high < (1 + words::nearly) * quasi.low,
             fmt::format("{:.1f} to {:.1f} rad/s by describing functions", quasi.low, quasi.high));
  item.refute(
      "flange-true",
      "with flange contact all three frequencies approach a single value, by the full equations",
      exact.high > (1 + words::nearly) * exact.low,
      fmt::format("{:.1f} to {:.1f} rad/s near the same cycles", exact.low, exact.high));
  item.claim("flange-high", "it is a high value: above those of the tread",
             std::min(quasi.low, exact.low) > vehicle("heumann").hopf[0].motion.lambda.imag(),
             "by describing functions and by the full equations");
}

}  // namespace

const report::Section branches{
    report::figure("fig-11", "Amplitude of limit cycles against speed (Fig. 11)", fig_11),
    report::table("claims", "What the text says of amplitudes and speeds", claims),
    report::table("flange-frequency", "Frequencies with flange contact, 0.6 in", flange_frequency)};

}  // namespace railbook::hunting_chapter
