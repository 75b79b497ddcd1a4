/***
### Amplitude against speed

{{fig-11}} is the paper's central figure, recomputed twice: the largest amplitude of any wheelset on each limit cycle against speed. The thin lines are the describing functions', solid where the *paper's rule*
calls the cycle stable: a little more amplitude at the same speed makes the mode decay, that is, $V$ rises with $A$. On the cone's tread every amplitude is a cycle at
the one critical speed, neither stable nor unstable; the paper counts that vertical line as unstable.

The rule looks at one mode only, the cycle's own. The thick lines are the branches of the full equations, solid where *every* small deviation dies out ({{true-branches}}).

{{fig-11}}

{{include: answer.cpp}}

With new wheels the flange is met at {{flange-new}}; from there the describing functions' branch runs far to the right, while that of the equations is stable to {{torus-speed}} only.
With CN wheels there is a lower region, where one truck has met the flange, and a higher one with both, on a falling branch and unstable.
The Heumann wheel has a small stable cycle without flange contact, in the paper's "limited range of speeds".
With friction the cycles come down to {{friction-fold}}, a minimum that hangs on the sticking rate; there is a stable cycle with flange contact, the rear truck's, but it lasts for a tenth of a ft/s only.

{{claims}}

**The frequency on the flange.** "For all three wheel profiles, frequencies for limit cycles with flange contact approach a single high value in the
neighborhood of 30.5 rad/s." The paper does not say at which amplitude. At 0.6 in, well up the flange, the describing functions have about one frequency; the full equations have lower ones, farther apart, for a cycle
driven from wall to wall is no sine.

{{flange-frequency}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

const std::vector<std::string> columns{"V_ft_per_s", "A_in", "stable_in", "unstable_in",
                                       "neutral_in"};

double speed_of(const CyclePoint& p) {
  return p.motion.speed / foot;
}
double speed_of(const LimitCycle& p) {
  return p.parameter / foot;
}

// Speeds of the main branch's points with `accept`, ft/s.
template <class Accept>
Range speeds(const Vehicle& v, Accept&& accept) {
  Range range;
  for (const auto& p : v.main_branch().points)
    if (accept(p)) range.add(speed_of(p));
  return range;
}
std::string text(const Range& r) {
  return fmt::format("{:.2f} to {:.2f} ft/s", r.low, r.high);
}

CyclePoint at_amplitude(const Vehicle& v, double inches) {
  return cycles_at_amplitude(v.car, v.main_branch(), inches * inch).at(0);
}

// How far bolster and truck move against each other, a part of the truck's motion.
double stroke(const Vehicle& v, const CyclePoint& p) {
  const Complex u = v.car.car().joint[1].row.cast<Complex>().dot(p.motion.shape);
  return std::abs(u) / std::abs(p.motion.shape[X_TR]);
}

// One column a kind of line; a line to the next point is of this point's kind.
template <class Point>
void draw_branch(report::Data& data, const std::vector<Point>& points) {
  const Point* before = &points.front();
  for (const Point& p : points) {
    const auto in = [&](bool here, bool there) { return here || there ? p.largest / inch : nan; };
    const auto plain = [](const Point& q) { return !q.neutral && !q.stable; };
    data.add(speed_of(p), p.largest / inch,
             in(p.stable && !p.neutral, before->stable && !before->neutral),
             in(plain(p), plain(*before)), in(p.neutral, before->neutral));
    before = &p;
  }
}

void fig_11(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  for (const auto& v : vehicles())
    draw_branch(v.key == "new" ? item.data(columns) : item.data(v.key, columns),
                v.main_branch().points);
  auto& exact = item.data("true", columns);
  auto& marks = item.data("special", {"V_ft_per_s", "fold_in", "torus_in", "other_in"});
  for (const auto& v : vehicles()) {
    draw_branch(exact, true_branch(v.key).points);
    exact.gap();
    for (const SpecialCycle& s : true_branch(v.key).special) {
      const auto in = [&](bool is) { return is ? s.at.largest / inch : nan; };
      const bool fold = s.kind == CycleEvent::fold, torus = s.kind == CycleEvent::torus;
      marks.add(speed_of(s.at), in(fold), in(torus), in(!fold && !torus));
    }
  }
  speed_answer(item);
  item.value("flange-new", vehicle("new").flange / inch, "in", "{:.2f}");
  item.value("friction-fold", speed_of(vehicle("friction").main_branch().folds.at(0)), "ft/s",
             "{:.0f}");
}

void speed_claims(report::Item& item) {
  const Vehicle &fresh = vehicle("new"), &cn = vehicle("cn"), &heumann = vehicle("heumann");
  const auto tread = [](const Vehicle& v) {
    return speeds(v, [&](const CyclePoint& p) { return p.largest < v.flange; });
  };
  const auto stable_flange = [](const Vehicle& v) {
    return speeds(v, [&](const CyclePoint& p) { return p.stable && p.largest > v.flange; });
  };
  const Range v = tread(fresh), a = tread(cn), b = tread(heumann);
  claim(item, "vertical", v.width() < words::drawn * v.low,
        fmt::format("{}, up to {:.2f} in", text(v), fresh.flange / inch));
  claim(item, "variation",
        std::min(a.width(), b.width()) > v.width() && a.width() < words::nearly * a.low &&
            b.width() < words::nearly * b.low,
        fmt::format("CN A {}, Heumann {}", text(a), text(b)));
  const auto stable = [](const Vehicle& of) {
    return speeds(of, [](const CyclePoint& p) { return p.stable; });
  };
  const Range n = stable_flange(fresh), r = stable(cn), every = stable(heumann),
              h = speeds(heumann, [&](auto&p) { return p.stable && p.largest < heumann.flange; });
  claim(item, "far-right", n.high * foot > words::much * fresh.hopf[0].motion.speed, text(n));
  claim(item, "smaller-range", std::max(r.width(), every.width()) < stable(fresh).width(),
        fmt::format("CN A {}, Heumann {}", text(r), text(every)));
  claim(item, "heumann-window", h.high > h.low && h.width() < words::nearly * h.low,
        fmt::format("{}; the flange is met at {:.2f} in", text(h), heumann.flange / inch));
  // A region is another one when it begins a tenth of the amplitude beyond the last.
  int regions = 0;
  double up_to = 0;
  for (const auto& p : cn.main_branch().points)
    if (p.stable && p.largest > cn.flange) {
      regions += p.largest > (1 + words::nearly) * up_to;
      up_to = std::max(up_to, p.largest);
    }
  refute(item, "cn-regions", regions < 2,
         fmt::format("by the paper's own rule one region, up to {:.3f} in", up_to / inch));
  const auto low = at_amplitude(cn, 0.42).amplitude, high = at_amplitude(cn, 0.48).amplitude;
  refute(item, "cn-rear", low[0] > cn.flange && low[0] > low[2],
         fmt::format("the front truck's does: {:.3f} in at the front, {:.3f} at the rear",
                     low[0] / inch, low[2] / inch));
  claim(item, "cn-both", std::min(high[0], high[2]) > cn.flange,
        fmt::format("{:.3f} and {:.3f} in", high[0] / inch, high[2] / inch));
  const auto body = [&](std::size_t k) { return std::abs(fresh.hopf[k].motion.shape[X_C]); };
  claim(item, "secondary", fresh.hopf.size() > 1 && body(1) < words::small * body(0),
        fmt::format("from {:.1f} ft/s on; body over wheelset {:.2f} instead of {:.2f}",
                    fresh.hopf[1].motion.speed / foot, body(1), body(0)));
}

void friction_claims(report::Item& item) {
  const Vehicle &cn = vehicle("cn"), &friction = vehicle("friction");
  const double linear = cn.hopf[0].motion.speed / foot, low = words::small * cn.flange;
  const Range small = speeds(friction, [&](const CyclePoint& p) { return p.largest < low; });
  const Range large = stable_on_flange(friction);
  claim(item, "friction-low", small.low < linear / words::much,
        fmt::format("from {:.0f} ft/s on, {:.1f} in the linear car", small.low, linear));
  double largest = 0;
  for (const auto& p : friction.main_branch().points)
    if (p.stable && speed_of(p) * words::much < linear) largest = std::max(largest, p.largest);
  claim(item, "friction-stable", largest > 0 && largest < low,
        fmt::format("up to {:.3f} in below {:.0f} ft/s", largest / inch, linear / words::much));
  claim(item, "friction-large", large.low > small.low && large.high < linear, text(large));
  claim(item, "friction-flange", large.width() > 0,
        fmt::format(
            "by multipliers, over {:.2f} ft/s where a wheelset of the rear truck meets it; beyond "
            "they are unstable",
            large.width()));
  const double stuck = stroke(friction, at_amplitude(friction, 0.02)),
               sliding = stroke(friction, at_amplitude(friction, 0.3));
  claim(
      item, "friction-rigid", stuck < sliding,
      fmt::format("stroke over truck motion {:.4f} at 0.02 in, {:.4f} at 0.3 in", stuck, sliding));
  CarParameters less;
  less.damper_travel *= 0.5, less.damper_angle *= 0.5;
  const double slower = first_critical(less, cn).speed;
  claim(item, "equivalent-too-large", std::abs(slower - large.high) < std::abs(linear - large.high),
        fmt::format("{:.1f} ft/s with half, {:.1f} with all", slower, linear));
}

void claims(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(15);
  speed_claims(item);
  friction_claims(item);
}

void flange_frequency(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(4);
  item.columns(headings("{:#.4g}", {"wheel", "V, ft/s", "ω by describing functions, rad/s",
                                    "ω of the full equations", "amplitude there, in"}));
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
    item.add_row(v.name, speed_of(p), omega, truth.converged ? truth.omega : nan,
                 truth.converged ? truth.amplitude / inch : nan);
  }
  const auto between = [](const Range& r, const char* how) {
    return fmt::format("{:.1f} to {:.1f} rad/s {}", r.low, r.high, how);
  };
  item.print("flange-frequency", "mean of the three by describing functions, 0.6 in", "rad/s",
             "30.5", mean, report::relative(words::nearly, "\"in the neighborhood\" of it"));
  claim(item, "flange-single", quasi.high < (1 + words::nearly) * quasi.low,
        between(quasi, "by describing functions"));
  refute(item, "flange-true", exact.high > (1 + words::nearly) * exact.low,
         between(exact, "near the same cycles"));
  claim(item, "flange-high",
        std::min(quasi.low, exact.low) > vehicle("heumann").hopf[0].motion.lambda.imag(),
        "by describing functions and by the full equations");
}

}  // namespace

const report::Section branches{
    report::figure("fig-11", "Amplitude of limit cycles against speed (Fig. 11)", fig_11),
    report::table("claims", "What the text says of amplitudes and speeds", claims),
    report::table("flange-frequency", "Frequencies with flange contact, 0.6 in", flange_frequency)};

}  // namespace railbook::hunting_chapter
