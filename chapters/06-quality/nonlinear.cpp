/*** ## The hypothesis: any vehicle, however nonlinear

The paper proposes that the curves of its Figure 4 hold for every vehicle: a constant level up to a wavelength set by speed, whatever the model. It plans
to test that with single sines on the envelope, and then with pairs whose frequencies are nearly rational multiples (7). We do the test with the nonlinearity it names
first, bump stops: at 0.6 of the stroke limit a stop of $\kappa$ times the spring's stiffness is met,

$$\ddot x+2\rho\omega_0\dot x+\omega_0^2\left[x+\kappa\,(|x|-d)_+\,\mathrm{sgn}\,x\right]=-\ddot z .$$

Between two contacts with a stop this is linear, and its solution for any sum of sines is known. So we do not integrate. The solution is followed from one
switch to the next, and each switch is a root of known functions: no step size, no tolerance. Data of this section (stops, start, times) are ours.

### On the resonance

One sine at the frequency of the linear peak, with the amplitude of the envelope:

{{table-stops}}

The linear vehicle reaches the limit, as it must. Stops help here, the stiffer the more, and the hypothesis looks safe.

### Inside the flat zone

But stops make the vehicle harder, and its resonance bends to higher frequencies, that is to shorter waves. There the amplitude allowed is the same flat level. What happens depends on how the sine
begins:

{{table-starts}}

{{fig-starts}}

Two steady motions coexist. On the upper one the stroke is {{high-1}} at 1 Hz and {{high-12}} at 1.2 Hz against a limit of 2.54 cm, on track that complies with the descriptor. A
slowly growing sine ends on the lower. A sudden one ends on the upper if the stroke is at rest when it starts; if it is the body that is at rest, the lower motion catches it from
{{first-low}} on. The hypothesis fails: the flat level is not valid for this vehicle, unless the way the track disturbance begins is part of it.
*/
#include "nonlinear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "num/dopri5.hpp"
#include "num/roots.hpp"

namespace railbook::quality_chapter {

using namespace railbook;
using quality::Motion;
using quality::Track;

quality::StoppedBody stopped(double kappa) {
  return {roll, 0.6 * inch_limit.stroke, kappa};
}

double peak_frequency() {
  return roll.frequency * quality::stroke_peak(roll.damping).ratio;
}

double peak_amplitude() {
  return inch_limit.stroke / quality::stroke_peak(roll.damping).gain;
}

namespace {

using State = Eigen::Vector2d;

// -z'' from the waves, with the ramp's share.
double acceleration(const Track& track, double t) {
  double sum = 0;
  for (const quality::Wave& wave : track.waves) {
    const double w = 2 * units::pi * wave.frequency, angle = w * t + wave.phase;
    const double now = t < track.ramp ? t / track.ramp : 1;
    sum += wave.amplitude * w * w * now * std::sin(angle);
    if (t < track.ramp) sum -= 2 * wave.amplitude * w / track.ramp * std::cos(angle);
  }
  return sum;
}

/*** The check on all this is the integrator of chapter 07, which knows nothing of closed forms: it stops at each switch, found on its own dense output, and starts
again.
*/
class Integration {
 public:
  Integration(const quality::StoppedBody& body, const Track& track, double tolerance, bool locate)
      : body_(body),
        track_(track),
        rate_(2 * units::pi * body.suspension.frequency),
        locate_(locate),
        ode_(State{tolerance, tolerance * rate_}, 1e-3) {}

  OdeResult run(const Motion& start, double end, double watch_from) {
    State y{start.x, start.v};
    double t = start.t;
    if (track_.ramp > t && track_.ramp < end) {
      y = leg(t, y, track_.ramp, watch_from);
      for (const quality::Wave& w : track_.waves)
        y[1] += w.amplitude / track_.ramp *
                std::sin(2 * units::pi * w.frequency * track_.ramp + w.phase);
      t = track_.ramp;
    }
    y = leg(t, y, end, watch_from);
    result_.x = y[0];
    result_.v = y[1];
    result_.evaluations = ode_.evaluations();
    return result_;
  }

 private:
  void rhs(double t, const State& s, State& d) const {
    const double w = rate_;
    const double over = locate_ ? (stop_ == 0 ? 0 : s[0] - stop_ * body_.gap)
                                : s[0] - std::clamp(s[0], -body_.gap, body_.gap);
    d[0] = s[1];
    d[1] = -2 * body_.suspension.damping * w * s[1] - w * w * (s[0] + body_.kappa * over) +
           acceleration(track_, t);
  }

  State leg(double begin, const State& from, double end, double watch_from) {
    const auto f = [this](double t, const State& s, State& d) { rhs(t, s, d); };
    stop_ = std::abs(from[0]) > body_.gap ? (from[0] > 0 ? 1 : -1) : 0;
    ode_.restart(f, begin, from);
    while (ode_.t() < end) {
      if (!ode_.step(f, end)) {
        result_.complete = false;
        return ode_.y();
      }
      const auto& dense = ode_.dense();
      double upto = dense.end;
      if (locate_) {
        if (const double at = first_switch(dense); at < upto) {
          const State y = dense.at(at);
          const int side = y[0] > 0 ? 1 : -1;
          stop_ = stop_ == 0 ? side : 0;
          upto = at;
          ode_.restart(f, at, State{side * body_.gap, y[1]});
        }
      }
      look(dense, upto, watch_from);
    }
    return ode_.y();
  }

  double first_switch(const num::DenseStep<2>& dense) const {
    const auto past = [&](double t) {  // positive once the branch has ended
      const double x = dense.at(t)[0];
      return stop_ == 0 ? std::abs(x) - body_.gap : body_.gap - stop_ * x;
    };
    constexpr int parts = 6;
    for (int i = 1; i <= parts; ++i) {
      const double a = dense.begin + dense.length * (i - 1) / parts;
      const double b = dense.begin + dense.length * i / parts;
      if (past(b) <= 0) continue;
      if (past(a) >= 0) {
        if (i > 1) return a;
        continue;  // just switched, to rounding
      }
      return num::find_root(past, a, b, 1e-15).x;
    }
    return dense.end;
  }

  void look(const num::DenseStep<2>& dense, double upto, double watch_from) {
    if (upto < watch_from) return;
    double at = upto;
    const auto v = [&](double t) { return dense.at(t)[1]; };
    if (v(dense.begin) * v(upto) < 0) at = num::find_root(v, dense.begin, upto, 1e-14).x;
    if (at >= watch_from) result_.largest = std::max(result_.largest, std::abs(dense.at(at)[0]));
  }

  quality::StoppedBody body_;
  Track track_;
  double rate_;
  bool locate_;
  int stop_ = 0;
  num::Dopri5<2> ode_;
  OdeResult result_;
};

}  // namespace

OdeResult integrated_with_stops(const quality::StoppedBody& body, const Track& track,
                                const Motion& start, double end, double watch_from,
                                double tolerance, bool locate_switches) {
  return Integration{body, track, tolerance, locate_switches}.run(start, end, watch_from);
}

namespace {

constexpr double settled_from = 120, settled_to = 180;  // s; a free motion has decayed by exp(-75)
constexpr double ode_tolerance = 1e-12;                 // m

void table_stops(report::Item& item) {
  const std::vector<double> kappas{0, 1, 10, 100, 1000};
  item.expect_checks(2 * static_cast<int>(kappas.size()) + 1);
  item.columns({"κ", "settled stroke, cm", "by integration, cm", "switches", "energy unbalanced"});
  const Track track{{{peak_amplitude(), peak_frequency(), 0}}, 0};
  for (const double kappa : kappas) {
    const auto r = quality::run(stopped(kappa), track, {}, settled_to,
                                {.watch_from = settled_from, .audit = true});
    const double ode =
        integrated_with_stops(stopped(kappa), track, {}, settled_to, settled_from, ode_tolerance)
            .largest;
    item.agree(fmt::format("ode-{:g}", kappa), fmt::format("settled stroke, κ = {:g}", kappa), "cm",
               r.largest / cm, ode / cm, 1e-8, "integration with switches located");
    item.check(fmt::format("energy-{:g}", kappa), fmt::format("energy unbalanced, κ = {:g}", kappa),
               "", "1e-12", r.energy.defect(),
               report::at_most("work of the track less damping and storage, over the work"));
    item.add_row({fmt::format("{:g}", kappa), fmt::format("{:.5f}", r.largest / cm),
                  fmt::format("{:.5f}", ode / cm), fmt::format("{}", r.switches.size()),
                  fmt::format("{:.0e}", r.energy.defect())});
    if (kappa == 0)
      item.check("linear", "settled stroke without stops: the limit", "cm", "2.54", r.largest / cm,
                 report::absolute(1e-9, "the envelope against the exact motion"));
  }
  item.reconstructed("the paper announces the test; stops and start are ours");
}

struct Starts {
  double stroke = 0, body = 0, ramp = 0;  // settled strokes, m
};

/*** Three ways to begin: the stroke at rest and the track's acceleration at once; the body at rest, so that the stroke begins with the wheel's own rate; and an amplitude that
grows over a minute.
*/
Starts starts(double frequency) {
  const auto body = stopped(10);
  const Track sudden{{{peak_amplitude(), frequency, 0}}, 0}, ramp{sudden.waves, 60};
  const quality::RunOptions settled{.watch_from = settled_from};
  return {quality::run(body, sudden, {}, settled_to, settled).largest,
          quality::run(body, sudden, {0, 0, -quality::wheel_rate(sudden, 0)}, settled_to, settled)
              .largest,
          quality::run(body, ramp, quality::at_rest(ramp), settled_to, settled).largest};
}

void table_starts(report::Item& item) {
  const std::vector<double> frequencies{0.7, 0.8, 0.9, 1.0, 1.2};
  item.expect_checks(2 * static_cast<int>(frequencies.size()) + 2);
  item.columns({"frequency, Hz", "wavelength at 100 km/h, m", "sudden, stroke at rest, cm",
                "sudden, body at rest, cm", "ramp of 60 s, cm", "above the limit"});
  double first_low = 0;
  for (const double f : frequencies) {
    const Starts s = starts(f);
    const Track sudden{{{peak_amplitude(), f, 0}}, 0}, ramp{sudden.waves, 60};
    const auto check = [&](const char* id, const char* what, const Track& track, double exact) {
      item.agree(fmt::format("{}-{:g}", id, f), fmt::format("{}, {:g} Hz", what, f), "cm",
                 exact / cm,
                 integrated_with_stops(stopped(10), track, quality::at_rest(track), settled_to,
                                       settled_from, ode_tolerance)
                         .largest /
                     cm,
                 1e-8, "integration with switches located");
    };
    check("sudden", "sudden, stroke at rest", sudden, s.stroke);
    check("ramp", "ramp", ramp, s.ramp);
    if (first_low == 0 && s.body < 0.7 * s.stroke) first_low = f;
    item.add_row({fmt::format("{:g}", f), fmt::format("{:.1f}", track_speed / f),
                  fmt::format("{:.3f}", s.stroke / cm), fmt::format("{:.3f}", s.body / cm),
                  fmt::format("{:.3f}", s.ramp / cm),
                  std::max({s.stroke, s.body, s.ramp}) > inch_limit.stroke ? "yes" : "no"});
    if (f == 1.0) {
      item.value("high-1", s.stroke / cm, "cm", "{:.2f}");
      item.check("fails", "settled stroke at 1 Hz on the flat level: above the limit", "cm", "2.54",
                 s.stroke / cm, report::at_least("the limit the descriptor promises to keep"));
      item.check("keeps", "the same after a ramp: below it", "cm", "2.54", s.ramp / cm,
                 report::at_most("the limit the descriptor promises to keep"));
    }
    if (f == 1.2) item.value("high-12", s.stroke / cm, "cm", "{:.2f}");
  }
  item.value("first-low", first_low, "Hz", "{:g}");
  item.reconstructed("the paper announces the test; stops and start are ours");
}

void fig_starts(report::Item& item) {
  const auto body = stopped(10);
  const Track sudden{{{peak_amplitude(), 1.0, 0}}, 0}, ramp{sudden.waves, 60};
  auto& data = item.data({"time_s", "sudden_cm", "ramp_cm"});
  Motion a = quality::at_rest(sudden), b = quality::at_rest(ramp);
  for (int i = 0; i <= 2400; ++i) {
    const double t = 70.0 / 2400 * i;
    a = quality::run(body, sudden, a, t).end;
    b = quality::run(body, ramp, b, t).end;
    data.add(t, a.x / cm, b.x / cm);
  }
  item.reconstructed("the paper announces the test; stops and start are ours");
}

}  // namespace

void add_nonlinear(report::Chapter& chapter) {
  chapter.table("table-stops", "Stops of growing stiffness, on the linear resonance", table_stops);
  chapter.table("table-starts", "Three starts, κ = 10, amplitude of the flat level", table_starts);
  chapter.figure("fig-starts", "The same track at 1 Hz, begun in two ways", fig_starts);
}

}  // namespace railbook::quality_chapter
