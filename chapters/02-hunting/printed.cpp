/***
### Sentence by sentence

The results of the paper survive as sentences. {{claims}} puts a number to each. Where a sentence has no number of its own the table says what we took it to mean.
Mode shapes are in {{mode-claims}}, the numbers in {{critical-speeds}}.

{{claims}}

One number is left: "for all three wheel profiles, frequencies for limit cycles with flange contact approach a single high value in the
neighborhood of 30.5 rad/s". On our branches the frequency depends on the amplitude; at 0.6 in, well up the flange, describing functions give the values of {{flange-frequency}}, and
the full equations lower ones, because a cycle that is driven from wall to wall is no sine.

{{flange-frequency}}

A check on the numbers themselves: a rigid truck with the kinematic wavelength of wheelsets that cannot yaw alone,
$\omega=V\sqrt{\lambda/ar_0}\,/\sqrt{1+(L_T/a)^2}$, needs a conicity of {{implied-conicity}} to have the printed 12 rad/s at the printed 145 ft/s: the 1 in 20 cone, and a truck
whose warp stiffness holds it square. Without the last factor it would take {{free-conicity}}, no wheel's.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double inch = units::inch, foot = units::foot;

struct Range {
  double low = 1e9, high = 0;
  double width() const { return high - low; }
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
};

// Speeds of the first family's points with `accept`, ft/s.
template <class Accept>
Range speeds(const Study& s, Accept&& accept) {
  Range range;
  for (const auto& p : s.main_branch().points)
    if (accept(p)) range.add(p.motion.speed / foot);
  return range;
}

// Amplitudes of the stable cycles between two, inches.
std::string stable_amplitudes(const Study& s, double low, double high) {
  Range range;
  for (const auto& p : s.main_branch().points)
    if (p.stable && p.largest > low * inch && p.largest < high * inch) range.add(p.largest / inch);
  return fmt::format("{:.3f} to {:.3f} in", range.low, range.high);
}

// Amplitudes at which the wheelset's flange is met: where R is ten percent off its tread line.
double flange(const Study& s) {
  double x = 0.05 * inch;
  const double slope = (*s.table).R.slope(0.01 * inch);
  while (std::abs((*s.table).R(x) / (slope * x) - 1) < 0.1) x += 0.001 * inch;
  return x;
}

std::string between(const Range& r) {
  return fmt::format("{:.2f} to {:.2f} ft/s", r.low, r.high);
}

struct Claims {
  report::Item& item;
  const table::CsvTable& printed;

  void say(const std::string& key, bool holds, const std::string& numbers, bool check) const {
    const std::string& what = printed.at(key, "what");
    const std::string& said = printed.at(key, "printed");
    item.add_row({what, said, holds ? "yes" : "no", numbers, check ? "agrees" : "differs"});
    if (check) item.check_text(key, what, said, holds ? "yes" : "no");
  }
  void holds(const std::string& key, bool is, const std::string& numbers) const {
    say(key, is, numbers, true);
  }
  // Shown, explained under Deviations, and not checked: our result is another.
  void differs(const std::string& key, bool is, const std::string& numbers) const {
    say(key, is, numbers, is);
  }
};

void tread_claims(const Claims& c) {
  const Study &fresh = study("new"), &cn = study("cn"), &heumann = study("heumann");
  const auto tread = [](double top) {
    return [top](const CyclePoint& p) { return p.largest < top; };
  };
  const Range v = speeds(fresh, tread(0.395 * inch));
  c.holds("vertical", v.width() < 0.01, fmt::format("{:.1e} ft/s below 0.395 in", v.width()));
  const Range a = speeds(cn, tread(0.34 * inch)), b = speeds(heumann, tread(0.22 * inch));
  c.holds("variation",
          a.width() > v.width() && b.width() > v.width() && a.width() < 0.01 * a.low &&
              b.width() < 0.01 * b.low,
          fmt::format("CN A {}, Heumann {}", between(a), between(b)));
  const double v0 = fresh.hopf[0].motion.speed / foot, v1 = cn.hopf[0].motion.speed / foot,
               v2 = heumann.hopf[0].motion.speed / foot;
  const std::string lower = fmt::format("{:.0f} % lower with CN A, {:.0f} % with Heumann",
                                        100 * (1 - v1 / v0), 100 * (1 - v2 / v0));
  c.holds("lower-speeds", v1 < v0 && v2 < v0, lower);
  c.differs("much-lower", v1 < 0.75 * v0, lower);
}

void flange_claims(const Claims& c) {
  const Study &fresh = study("new"), &cn = study("cn"), &heumann = study("heumann");
  const auto stable_above = [](double a) {
    return [a](const CyclePoint& p) { return p.stable && p.largest > a; };
  };
  const Range n = speeds(fresh, stable_above(flange(fresh)));
  const Range r = speeds(cn, stable_above(0.36 * inch));
  c.holds("far-right", n.high > 1.25 * fresh.hopf[0].motion.speed / foot, between(n));
  const Range h =
      speeds(heumann, [&](const CyclePoint& p) { return p.stable && p.largest < 0.3 * inch; });
  c.holds("smaller-range", r.width() < n.width() && h.width() < n.width(),
          fmt::format("new {}, CN A {}, Heumann {}", between(n), between(r), between(h)));
  c.holds("heumann-window", h.high > h.low,
          fmt::format("{}, {}; R leaves its line at {:.2f} in", between(h),
                      stable_amplitudes(heumann, 0, 0.3), flange(heumann) / inch));
  const auto gain = [&](double a) {
    Vector9c q = Vector9c::Zero();
    q[X_TF] = a;
    return heumann.car.at(q, 1).wheel[0][0].value;
  };
  c.holds("conicity-dip", gain(0.24 * inch) < gain(0.17 * inch),
          fmt::format("{:.3f} at 0.24 in over its value at 0.17 in",
                      gain(0.24 * inch) / gain(0.17 * inch)));
  const bool upper =
      std::any_of(cn.main_branch().points.begin(), cn.main_branch().points.end(),
                  [&](const CyclePoint& p) { return p.stable && p.largest > 0.46 * inch; });
  c.differs("cn-regions", upper,
            fmt::format("stable by the rule: {}", stable_amplitudes(cn, 0.3, 0.75)));
  const auto low = cycles_at_amplitude(cn.car, cn.main_branch(), 0.42 * inch).at(0);
  c.differs("cn-rear", low.amplitude[2] > low.amplitude[0],
            fmt::format("front {:.3f}, rear {:.3f} in", low.amplitude[0] / inch,
                        low.amplitude[2] / inch));
}

void friction_claims(const Claims& c) {
  const Study &cn = study("cn"), &friction = study("friction");
  const double linear = cn.hopf[0].motion.speed / foot;
  const Range small = speeds(friction, [](const CyclePoint& p) { return p.largest < 0.05 * inch; });
  c.holds("friction-low", small.low < 0.5 * linear,
          fmt::format("from {:.1f} ft/s on, {:.1f} in the linear car", small.low, linear));
  double largest = 0;
  for (const auto& p : friction.main_branch().points)
    if (p.stable && p.motion.speed < 90 * foot) largest = std::max(largest, p.largest);
  c.holds("friction-stable", largest > 0 && largest < 0.05 * inch,
          fmt::format("up to {:.4f} in below 90 ft/s", largest / inch));
  const Range large = speeds(friction, [](const CyclePoint& p) {
    return p.largest > 0.1 * inch && p.largest < 0.45 * inch;
  });
  c.holds("friction-large", large.low > small.low && large.high < linear, between(large));
  const auto touching = cycles_at_amplitude(friction.car, friction.main_branch(), 0.42 * inch);
  c.differs("friction-flange", touching.at(0).stable,
            fmt::format("stable: {}; at 0.42 in V = {:.1f} ft/s falls with A",
                        stable_amplitudes(friction, 0, 0.4), touching.at(0).motion.speed / foot));
}

void family_claims(const Claims& c) {
  const Study& s = study("new");
  c.holds("secondary", s.hopf.size() > 1,
          fmt::format("from {:.2f} ft/s on", s.hopf[1].motion.speed / foot));
  const auto rear = cycles_at_amplitude(s.car, s.branches[1], 0.45 * inch).at(0);
  Motion swapped = rear.motion;
  for (const int k : {X_TF, TH_TF, TH_WF}) std::swap(swapped.shape[k], swapped.shape[k + 1]);
  swapped.shape[TH_C] *= -1;
  const auto front = find_cycle(s.car, swapped, 0.45 * inch);
  const double v = rear.motion.speed, w = rear.motion.lambda.imag();
  const auto& m = front.cycle.motion;
  c.holds("mirrored",
          front.converged && front.cycle.amplitude[0] > 5 * front.cycle.amplitude[2] &&
              std::abs(m.speed - v) < 0.01 * v && std::abs(m.lambda.imag() - w) < 0.01 * w,
          fmt::format("rear {:.2f} ft/s and {:.2f} rad/s, front {:.2f} and {:.2f}, at 0.45 in",
                      v / foot, w, m.speed / foot, m.lambda.imag()));
}

void claims(report::Item& item) {
  const auto printed = item.printed("claims.csv");
  item.columns({"claim", "paper", "here", "numbers", ""});
  item.reconstructed("profiles, equivalent dampers and the width of friction are ours");
  item.expect_checks(12);
  const Claims c{item, printed};
  tread_claims(c);
  flange_claims(c);
  friction_claims(c);
  family_claims(c);
  const CarParameters p;
  const double rigid = 12.0 * 12.0 / std::pow(145 * foot, 2) * p.half_gauge * p.wheel_radius;
  const double stretch = 1 + std::pow(p.half_wheelbase / p.half_gauge, 2);
  item.value("implied-conicity", rigid * stretch, "", "{:.3f}");
  item.value("free-conicity", rigid, "", "{:.3f}");
}

void flange_frequency(report::Item& item) {
  const auto printed = item.printed("flange.csv");
  item.columns({"wheel", "V, ft/s", "ω by describing functions, rad/s", "ω of the full equations",
                "amplitude there, in"});
  item.reconstructed("profiles and equivalent dampers are ours; the amplitude is our choice");
  item.expect_checks(linear_studies);
  for (int k = 0; k < linear_studies; ++k) {
    const Study& s = studies()[static_cast<std::size_t>(k)];
    for (const auto& l : labelled_cycles()) {
      if (l.study != &s || std::abs(l.point.largest - 0.6 * inch) > 1e-6) continue;
      const double omega = l.point.motion.lambda.imag();
      item.add_row({s.name, fmt::format("{:.1f}", l.point.motion.speed / foot),
                    fmt::format("{:.2f}", omega), fmt::format("{:.2f}", l.truth.omega),
                    fmt::format("{:.3f}", l.truth.amplitude / inch)});
      item.row(printed, s.key)
          .check(
              "printed", omega,
              report::absolute(4,
                               "\"approach\" a value \"in the neighborhood\" of 30.5, at no stated "
                               "amplitude, on profiles of ours"));
    }
  }
}

}  // namespace

void add_printed(report::Chapter& chapter) {
  chapter.table("claims", "What the text claims of limit cycles", claims);
  chapter.table("flange-frequency", "Frequencies with flange contact, 0.6 in", flange_frequency);
}

}  // namespace railbook::hunting_chapter
