/*** ## Short waves: the wheel force

If 1.6 cm were allowed at any wavelength, the rails might rise and fall by it every half metre. The
suspension would bear this, but the contact of wheel and rail would not. Eliminating $x$ from (1)
and (2) gives an equation for the dynamic force $g$ alone, and with $G$ its amplitude

$$M\ddot g+b\dot g+kg=Mm\,z^{(4)}+(M+m)b\,z^{(3)}+(M+m)k\,\ddot z , \tag{5}$$

$$\left|\frac GZ\right|^2=(2\pi)^4m^2v^4\varphi^4\,\frac{v^4\varphi^4+2(2q^2-1)v^2f''^2\varphi^2+f''^4}
{v^4\varphi^4+2(2\rho^2-1)v^2f'^2\varphi^2+f'^4}. \tag{6}$$

Here $z^{(3)}$ and $z^{(4)}$ are the third and fourth derivative in time, and $r=M/m$,
$q^2=(1+r)\rho^2$ and $f''^2=(1+r)f'^2$ belong to the body and the wheel together. The first factor
of (6) cannot be read in our copy; this is the one that (5) gives.

We compute the same in another way. The force is the two masses times their accelerations, $G=-(2\pi
f)^2(mZ+MY)$, where $f=v\varphi$ is the frequency and $Y$ the amplitude of the body. 

{{table-equations}} compares both equations with (1) and (2) integrated in time.

{{table-equations}}

The paper asks that the dynamic force and the static load together stay below 143 kN. What the
static load leaves, divided by the gain $|G/Z|$, is the allowed amplitude:

{{fig-06}}

The paper prints no masses, springs or dampers. We take the part that rests on one wheel of three
cars from `data/cars.csv`. All have a wheel of 800 kg, half the critical damping, and a bounce, the
up-and-down motion of the body, at 2 Hz: car A with a body of 7000 kg, car B, a loaded 70-ton car,
with 11 700 kg, and car C, a loaded 100-ton car, with 14 090 kg. 

The curves of this car do not cross. They would if the gain $|G/Z|$ fell with frequency anywhere,
because a slower train would then need the smoother track. The least damping that prevents it
depends on $r$ alone:

{{table-damping}}

With the damping of the roll example, 0.2, the curves of all these cars would cross. The paper says
that for the wheel force it uses "spring and damping constants appropriate for vehicle response" to
profile and alignment (the heights of the rails and their line sideways), and does not print them,
so its statement cannot be tested. Cars with a body of less than twice the wheel's mass need less
damping: {{damping-light}} at $r$ = 0.5.

The force left for the track is 143 kN less the static load, {{margin-A}} for car A and {{margin-B}}
for car B. Car C has nothing left. Its static {{static-C}} exceed the limit, and the library's
answer is *{{refusal-C}}*.

{{fold}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/num/dopri5.hpp>
#include <railbook/num/log_spaced.hpp>
#include <railbook/units/input_error.hpp>

#include "sections.hpp"

namespace railbook::quality_chapter {

using quality::allowed_amplitude;

namespace {

// Equations (1) and (2) on a unit sine of the track, integrated until the transient has decayed.
// The force's amplitude (N/m) follows from two values a quarter of a period apart.
double integrated_force(const quality::Car& car, double frequency) {
  using State = Eigen::Vector2d;  // x, its rate
  const double rate = 2 * units::pi * frequency;
  const auto f = [&](double t, const State& s, State& d) {
    d[0] = s[1];
    d[1] =
        rate * rate * std::sin(rate * t) - (car.damping * s[1] + car.stiffness * s[0]) / car.body;
  };
  const auto force = [&](double t, const State& s) {
    return -car.wheel * rate * rate * std::sin(rate * t) - car.damping * s[1] -
           car.stiffness * s[0];
  };
  num::Dopri5<2> ode{State{1e-13, 1e-13 * rate}, 0.01 / rate};
  ode.restart(f, 0, State::Zero());
  const double end = 32 * 2 * car.body / car.damping, later = end + 0.25 / frequency;
  while (ode.t() < end)
    if (!ode.step(f, end)) return units::nan;
  const double now = force(end, ode.y());
  while (ode.t() < later)
    if (!ode.step(f, later)) return units::nan;
  return std::hypot(now, force(later, ode.y()));
}

// Equation (5), a sine put in.
double by_equation_5(const quality::Car& car, double frequency) {
  const std::complex<double> s{0, 2 * units::pi * frequency};
  const auto [m, M, k, b] = car;
  return std::abs(s * s * (M * m * s * s + (M + m) * b * s + (M + m) * k) /
                  (M * s * s + b * s + k));
}

// Equation (6), term by term, with the first factor (2π)⁴m²v⁴φ⁴.
double by_equation_6(const quality::Car& car, double frequency) {
  const auto [f_1, rho] = suspension(car);
  const double r = car.body / car.wheel, q2 = (1 + r) * rho * rho;
  const double f2 = frequency * frequency, own = f_1 * f_1, upper = own * (1 + r);
  return std::pow(2 * units::pi, 2) * car.wheel * f2 *
         std::sqrt((f2 * f2 + 2 * (2 * q2 - 1) * f2 * upper + upper * upper) /
                   (f2 * f2 + 2 * (2 * rho * rho - 1) * f2 * own + own * own));
}

void table_equations(report::Item& item) {
  const quality::Car A = car(item, "A").car;
  item.columns({{"frequency, Hz", "{:g}"},
                {"(1), (2) integrated, kN/m", "{:.2f}"},
                {"(5), kN/m", "{:.2f}"},
                {"(6), kN/m", "{:.2f}"}});
  double off_5 = 0, off_6 = 0;
  for (const double f : {0.5, 2.0, 10.0}) {
    const double truth = integrated_force(A, f);
    off_5 = std::max(off_5, std::abs(by_equation_5(A, f) / truth - 1));
    off_6 = std::max(off_6, std::abs(by_equation_6(A, f) / truth - 1));
    item.add_row(f, truth / kN, by_equation_5(A, f) / kN, by_equation_6(A, f) / kN);
  }
  item.claims({{"five", {off_5}}, {"six", {off_6}}});
  item.rebuilt("the car: the paper prints none");
}

void fig_06(report::Item& item) {
  const quality::ForceLimit A = car(item, "A"), B = car(item, "B"), C = car(item, "C");
  auto& data = item.data({"speed_kmh", "wavelength_m", "amplitude_cm"});
  for (const double v : speeds(item)) {
    for (const double w : num::log_spaced(0.5, 1000, 60))
      data.add(v / kmh, w, allowed_amplitude(severity(A, v, 1 / w)) / cm);
    data.gap();
  }
  report::values(item, "kN", "{:.1f}", "margin-A", force_margin(A) / kN, "margin-B",
                 force_margin(B) / kN, "static-C", static_force(C.car) / kN);
  try {
    item.value("refusal-C", force_margin(C) / kN, "kN", "{:.1f}");
  } catch (const InputError& error) {
    const std::string why = error.what();
    item.value("refusal-C", why.substr(0, why.find(':')));
  }
  item.rebuilt("masses, spring, damper and speeds (car A); the paper prints none");
}

// The damping that is enough whatever the ratio of the masses is, from 2 on.
double enough_damping() {
  double enough = 0;
  for (const double r : num::log_spaced(2.0, 100.0, 200))
    enough = std::max(enough, quality::least_damping_without_peak(r));
  return enough;
}

void table_damping(report::Item& item) {
  item.columns({{"M/m", "{:g}"}, {"least damping ρ without crossing", "{:.4f}"}});
  double least = 1;
  for (const double r : {2.0, 5.0, 8.75, 14.6, 20.0, 100.0}) {
    const double bound = quality::least_damping_without_peak(r);
    least = std::min(least, bound);
    if (r == 8.75) item.value("damping-A", bound, "", "{:.3f}");
    item.add_row(r, bound);
  }
  item.value("enough-damping", std::ceil(1000 * enough_damping()) / 1000, "", "{:.3f}");
  item.value("damping-light", quality::least_damping_without_peak(0.5), "", "{:.2f}");
  item.expect_checks(1);
  item.at_least("least", "least of these bounds, for M/m from 2 to 100", "", least, 0.2,
                "the damping printed for the roll mode, with which the curves would cross");
  item.added("the paper states that its curves do not cross, not when");
}

}  // namespace

const report::Section force{report::table("table-equations", table_equations),
                            report::figure("fig-06", fig_06),
                            report::table("table-damping", table_damping)};

}  // namespace railbook::quality_chapter
