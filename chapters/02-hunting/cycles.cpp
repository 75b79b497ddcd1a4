/***
## Cycles of the full equations

A describing function keeps the first harmonic and nothing else. Near the flange that is not obviously enough: a wheelset
that bounces between two walls has a rounded rectangle for a force. The paper's own list of future work begins with
"comparison with numerical integration". This part of the chapter makes the comparison, by three methods that share the equations
and nothing else.

*Harmonic balance* with any number of harmonics needs only the harmonics of the four wheelsets' displacements (and
with friction of the seven joints' rates), since the rest of the car is linear and is solved once a harmonic:
$$\hat s_k=\mathrm{rows}\,\big[K+ik\omega C-k^2\omega^2M\big]^{-1}G\,\hat f_k(s),$$
96 real numbers and $\omega$ for 23 odd harmonics. The forces are sampled in time and transformed back (FFTW), and so are
their slopes, which gives Newton's Jacobian exactly, as a Toeplitz plus a Hankel matrix.

*Time integration* comes in three kinds. Two are general: an explicit Runge-Kutta pair (Dormand-Prince) and an implicit one (Radau IIA) for when
the car is slow or its friction sticks. The third uses what this system is: tables with straight pieces, and friction
that is straight in three pieces. Between two knots the equations are linear with constant coefficients; a Taylor series
carries the state to rounding, and the moment of reaching the next knot is the root of a polynomial. The textbook's tool, a matrix
exponential for each combination of pieces, would be a poor one: a period at the flange has more than a thousand pieces, nearly all of them
different. A series of eight or so terms costs less than a step of Runge-Kutta, and no step ever contains a kink.

*Shooting* makes the series periodic: Newton on the state and the period, with the derivative of the flow from the same
series, to a closing error of 1e-10. Since all laws are odd, half a period is enough. That derivative, over a
whole period, is the monodromy matrix; its eigenvalues are the Floquet multipliers.
*/

#include "cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

// Which of the describing function's cycles at that speed: the order along the main branch.
struct Choice {
  const char* key;
  const char* study;
  double feet_a_second;
  std::size_t which;
};
constexpr std::array choices{Choice{"new-146", "new", 146, 0},
                             Choice{"new-150", "new", 150, 0},
                             Choice{"new-153", "new", 153, 0},
                             Choice{"new-154", "new", 154, 0},
                             Choice{"heumann-87", "heumann", 87, 0},
                             Choice{"heumann-87.4", "heumann", 87.4, 0},
                             Choice{"heumann-upper", "heumann", 87.4, 1},
                             Choice{"cn-130.8", "cn", 130.8, 0},
                             Choice{"cn-131.5", "cn", 131.5, 0},
                             Choice{"cn-upper", "cn", 131.5, 1},
                             Choice{"cn-140", "cn", 140, 0},
                             Choice{"friction-66", "friction", 66, 0},
                             Choice{"friction-90", "friction", 90, 0},
                             Choice{"friction-100", "friction", 100, 0},
                             Choice{"friction-103", "friction", 103, 0},
                             Choice{"friction-upper", "friction", 103, 1}};

CycleCase solve(const Choice& choice) {
  const Study& s = study(choice.study);
  CycleCase c;
  c.key = choice.key;
  c.study = &s;
  c.speed = choice.feet_a_second * units::foot;
  c.name = fmt::format("{}, {:g} ft/s", s.name, choice.feet_a_second);
  if (c.key.ends_with("upper")) c.name += ", upper";
  c.car = car_on_track(assemble({}, s.suspension), *s.table, c.speed);
  const auto found = cycles_at_speed(s.car, s.main_branch(), c.speed);
  if (found.size() <= choice.which) {
    c.examined.reason = "the describing function has no such cycle";
    return c;
  }
  c.quasi = found[choice.which];
  c.examined = examine(assemble({}, s.suspension), *s.table, c.quasi.motion);
  return c;
}

}  // namespace

const std::vector<CycleCase>& cycle_cases() {
  static const std::vector<CycleCase> all = [] {
    std::vector<CycleCase> list;
    for (const Choice& choice : choices) list.push_back(solve(choice));
    return list;
  }();
  return all;
}

const CycleCase& cycle_case(const std::string& key) {
  for (const CycleCase& c : cycle_cases())
    if (c.key == key) return c;
  throw std::logic_error("no cycle \"" + key + "\"");
}

double largest_amplitude(const Oscillator& car, const Cycle& cycle) {
  double largest = 0;
  for (std::size_t i = 0; i < wheelsets; ++i)
    largest = std::max(largest, amplitude(cycle, car.channels[i].row));
  return largest;
}

HistoryOptions watching(const Oscillator& car, double tolerance) {
  HistoryOptions options;
  options.tolerance = tolerance;
  for (std::size_t i = 0; i < wheelsets; ++i) options.watch.push_back(car.channels[i].row);
  return options;
}

Swing largest_swing(const History& history, int periods) {
  Swing largest;
  for (std::size_t i = 0; i < wheelsets; ++i) {
    const Swing s = swing(history, i, periods);
    if (s.found && s.amplitude > largest.amplitude) largest = s;
  }
  return largest;
}

Eigen::VectorXd state_of(const Motion& motion) {
  Eigen::VectorXd y(18);
  y << motion.shape.real(), (motion.lambda * motion.shape).real();
  return y;
}

}  // namespace railbook::hunting_chapter
