/***
## The critical speed of small motions

For small motions the gains are constants and the car is linear. A motion $q\,e^{(\sigma+i\omega)t}$
grows if $\sigma$ is positive. At the *critical speed* $\sigma$ of one of the car's motions passes
through zero, and the motion $q\,e^{i\omega t}$ neither grows nor dies: $Z(i\omega,V)\,q=0$, where
$Z$ is the matrix that gives the forces for a motion of this frequency and speed. The code calls
this a *Hopf point*.

A scan of the speeds may step over a critical one. There is a safer way. The creep forces contain
the speed as $1/V$ only, so the matrix of the linear car, of 18 rows, is a fixed part plus $1/V$
times another one. We form its *bialternate sum*: a matrix of 153 rows, whose eigenvalues are the
sums of every two of the 18 eigenvalues of the car.

At a critical speed two of these are $i\omega$ and $-i\omega$; their sum is zero, and the
bialternate sum is singular. It is a fixed part plus $1/V$ times another one as well, so a single
eigenvalue problem in $1/V$ gives all critical speeds at once. The function `pair_sums` forms it:
each pair of states `r` and `s` is a column, and the matrix `a` acts on one of the two at a time.

{{code: vehicle/linear_stability.cpp pair_sums}}

{{critical-speeds}}

**Two kinds of hunting.** The car has two kinds of motion, and each has a critical speed. In one the
trucks go **together**, and the body sways with them. In the other they **oppose** each other, and
the body yaws about its middle. With new wheels the trucks go together at the first critical speed,
and oppose each other at the second, only {{hopf-gap}} above. With worn wheels the trucks oppose
each other at the first one. The middle of the body is then nearly at rest, but its ends move with
the trucks ({{end-cn}} of the truck's motion with CN wheels, {{end-heumann}} with Heumann wheels).

**The dampers are fitted.** To study wheel and rail alone, the paper replaces dry friction by
dampers, "assuming constant amplitudes and frequency" that it does not give. Our dampers are the
gains (12) of friction at a frequency $\omega_c$, for a travel $A_c$ of the translations and an
angle $\theta_c$ of the rotations. So they depend on two rates only, $\omega_cA_c$ and
$\omega_c\theta_c$.

Many pairs of rates give 145 ft/s with new wheels ({{dampers}}). They form two groups. In group A
the frequency is {{upper-omega}}, in group B {{lower-omega}}. The printed 12 rad/s leave the part of
group A in which $\omega_c\theta_c$ is at least {{fit-low}}, marked "fits"; there the frequency with
CN wheels is {{fit-cn}}, and the paper prints 21. All other results on this page use 20 rad/s with
0.5 in and 0.003 rad, a pair of this part.

**Do CN wheels lower the critical speed?** The paper says that it is "much lower". With these pairs,
and with single dampers changed as well, the speed with CN wheels is {{cn-speeds-tried}}: an eighth
lower than with new wheels at one end, as high or higher at the other. It is much lower only with
some dampers of group B, with which new wheels hunt at {{lower-omega}} instead of 12.

The printed frequencies, too, speak against a much lower speed. A truck that is held square moves at
$\omega\propto V\sqrt\lambda$. At the same speed, three times the conicity therefore raises the
frequency $\sqrt3$ times, from 12 to 21 rad/s, and these are the printed values.

{{dampers: checks}}

::: {.fold summary="The exponent of the warp stiffness, and the cone that the printed pair needs"}

The exponent of the warp stiffness is illegible. With $10^5$, $10^7$ or $10^8$ there are dampers
that give 145 ft/s as well, but at {{warp-others}}. Only $10^6$ gives 145 ft/s and 12 rad/s
together.

The printed pair can be checked by itself. If a truck is rigid, its wheelsets cannot yaw alone, and
its wave is longer than that of a single wheelset:

$$\omega=V\sqrt{\frac\lambda{ar_0}}\,\Big/\sqrt{1+\Big(\frac{L_T}a\Big)^2}.$$

For 12 rad/s at 145 ft/s this needs a conicity of {{implied-conicity}}, the cone of 1:20, and a
truck that its warp stiffness holds square. Without the last factor, for a single wheelset, it would
need {{free-conicity}}, a cone of 1:40; but the new wheel of 1976 had 1:20.

:::

{{fold}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>

#include <railbook/report/values.hpp>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

// The two groups of dampers that give 145 ft/s with new wheels, by omega theta [rad/s]; 0.06 is
// ours. In the first the frequency rounds to 12 rad/s from the fourth on.
constexpr std::array upper{0.008, 0.010, 0.011, 0.0116, 0.014, 0.018, 0.024, 0.06, 0.15, 3.0};
constexpr std::array lower{0.00001, 0.00003, 0.0001, 0.0002};

bool rounds_to_12(const Critical& c) {
  return std::abs(c.omega - 12) <= 0.5;
}

// Body yaw at the trucks' places over the motion of the truck that swings more.
double body_end(const Vehicle& v) {
  const Vector9c& q = v.hopf[0].motion.shape;
  return CarParameters{}.half_truck_distance * std::abs(q[TH_C]) /
         std::max(std::abs(q[X_TF]), std::abs(q[X_TR]));
}

// The frequencies with other exponents of the warp stiffness and dampers that give 145 ft/s again:
// all that there are, by omega theta.
Range with_other_warp_stiffness() {
  Range omega;
  for (const double factor : {0.1, 10.0, 100.0})
    for (double rotation = 1e-5; rotation < 10; rotation *= 10) {
      CarParameters data;
      data.warp_stiffness *= factor;
      const double translation = translation_for(rotation, data);
      if (std::isfinite(translation))
        omega.add(first_critical(with_dampers(translation, rotation, data), vehicle("new")).omega);
    }
  return omega;
}

// The conicity at which a wheelset alone hunts at 12 rad/s and 145 ft/s, and a rigid truck.
struct Conicity {
  double wheelset, truck;
};
Conicity implied_conicity() {
  const CarParameters p;
  const double alone = 12.0 * 12.0 / std::pow(145 * foot, 2) * p.half_gauge * p.wheel_radius;
  return {alone, alone * (1 + std::pow(p.half_wheelbase / p.half_gauge, 2))};
}

void critical_speeds(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(4);
  item.columns({"wheel",
                {"V, ft/s", "{:.1f}"},
                {"V, m/s", "{:.1f}"},
                {"ω, rad/s", "{:.2f}"},
                {"dσ/dV, 1/ft", "{:.3f}"},
                {"phase between the trucks, °", "{:.0f}"},
                {"body X<sub>C</sub> over the largest wheelset", "{:.2f}"}});
  for (std::size_t k = 0; k < damped_cars; ++k)
    for (const HopfPoint& hopf : vehicles()[k].hopf) {
      const Vector9c& q = hopf.motion.shape;
      item.add_row(vehicles()[k].name, hopf.motion.speed / foot, hopf.motion.speed,
                   hopf.motion.lambda.imag(), hopf.rate_by_speed.real() * foot,
                   std::abs(std::arg(q[X_TF] / q[X_TR])) / units::degree, std::abs(q[X_C]));
    }
  const Vehicle &fresh = vehicle("new"), &heumann = vehicle("heumann");
  const double first = fresh.hopf[0].motion.speed;
  item.print("speed-new", "critical speed with new wheels", "ft/s", "145", first / foot,
             report::fitted("the dampers were chosen for it"));
  item.print("speed-si", "the printed 145 ft/s in metres", "m/s", "44.2", 145 * foot);
  item.print("frequency-heumann", "frequency before flange contact, modified Heumann", "rad/s",
             "26", heumann.hopf[0].motion.lambda.imag(),
             report::fitted("the hollow's radius was chosen; the text says \"much steeper\" only"));
  const std::string others = with_other_warp_stiffness().text(0, "rad/s");
  item.print("warp-stiffness",
             "frequency, new wheels, with a warp stiffness of 3.81×10⁶ and dampers for 145 ft/s",
             "rad/s", "12", first_critical(with_dampers(translation_for(0.06), 0.06), fresh).omega,
             report::restored("the exponent is illegible: 5, 7 and 8 give " + others +
                              " with dampers that give 145 ft/s"));
  item.value("warp-others", others);
  report::values(item, "%", "{:.0f}", "end-cn", 100 * body_end(vehicle("cn")), "end-heumann",
                 100 * body_end(heumann));
  item.value("hopf-gap", (fresh.hopf[1].motion.speed - first) / foot, "ft/s", "{:.0f}");
  const Conicity conicity = implied_conicity();
  report::values(item, "", "{:.3f}", "implied-conicity", conicity.truck, "free-conicity",
                 conicity.wheelset);
}

// The critical speed with CN wheels over that with new ones.
double cn_ratio(const CarParameters& data) {
  const Critical fresh = first_critical(data, vehicle("new"));
  return rounds_to_12(fresh) ? first_critical(data, vehicle("cn")).speed / fresh.speed : nan;
}

// The same for one of four dampers changed, and all of them scaled until new wheels have 145 ft/s.
double cn_ratio_changed(std::size_t which) {
  struct Change {
    double CarParameters::*friction;
    double factor;
  };
  constexpr std::array changes{Change{&CarParameters::lateral_friction, 0.25},
                               Change{&CarParameters::lateral_friction, 4},
                               Change{&CarParameters::vertical_friction, 0.25},
                               Change{&CarParameters::vertical_friction, 4},
                               Change{&CarParameters::warp_friction, 0.25},
                               Change{&CarParameters::warp_friction, 4},
                               Change{&CarParameters::centre_plate_friction, 0.25},
                               Change{&CarParameters::centre_plate_friction, 2}};
  CarParameters data;
  data.*changes.at(which).friction *= changes.at(which).factor;
  return cn_ratio(with_dampers(translation_for(0.06, data), 0.06, data));
}

wheelset::OddTable scaled(const wheelset::OddTable& function, double factor) {
  std::vector<double> values = function.values();
  for (double& value : values) value *= factor;
  return wheelset::OddTable(function.step(), std::move(values));
}

// The same with other CN wheels: R, of the rolling radii, and D, of the contact angles, times these
// factors.
double cn_ratio_with(double of_R, double of_D) {
  wheelset::ConstraintFunctions table = *vehicle("cn").table;
  table.R = scaled(table.R, of_R);
  table.D = scaled(table.D, of_D);
  const auto found = hopf_points({assemble({}, Suspension::dampers), table}, 20 * foot, 400 * foot);
  return found.at(0).motion.speed / vehicle("new").hopf[0].motion.speed;
}

// And from the printed frequencies alone, by the rigid truck.
double cn_ratio_printed(double omega_cn, double omega_new, double slope) {
  return omega_cn / omega_new / std::sqrt(slope);
}

// The ratio with everything varied that we chose, or that the print rounds.
void vary_cn_ratio(report::Trial& trial) {
  trial.vary("dampers that give 145 ft/s and 12 rad/s, by the rate of rotation",
             [](const report::Setting& s) {
               return cn_ratio(with_dampers(translation_for(s.number), s.number));
             });
  trial.vary("one of the four dampers changed, all scaled until 145 ft/s",
             [](const report::Setting& s) { return cn_ratio_changed(s.index); });
  trial.vary("slope of R, CN A over the new wheel's, printed as about three",
             [](const report::Setting& s) {
               const double now =
                   vehicle("cn").table->R.slope(0) / vehicle("new").table->R.slope(0);
               return cn_ratio_with(s.number / now, 1);
             });
  trial.vary("slope of D, of the contact angles, times ours",
             [](const report::Setting& s) { return cn_ratio_with(1, s.number); });
  trial.vary("printed frequencies and slopes alone, by a rigid truck",
             [](const report::Setting& s) {
               constexpr std::array<std::array<double, 3>, 3> cases{
                   {{20.5, 12.5, 3.5}, {21, 12, 3}, {21.5, 11.5, 2.5}}};
               const auto& c = cases.at(s.index);
               return cn_ratio_printed(c[0], c[1], c[2]);
             });
}

void much_lower(report::Item& item) {
  report::Trial trial = item.trial("much-lower-cn", "critical speed, CN A over new wheels",
                                   "{:.2f}", [](double r) { return r > 1 / words::much; });
  vary_cn_ratio(trial);
  Range by_dampers, of_the_car;
  for (const report::Variation& v : trial.variations())
    if (&v != &trial.variations().back())
      for (const double r : v.results) of_the_car.add(r);
  item.value("cn-ratio-car", of_the_car.text(2, "times"));
  item.value("cn-ratio-formula", trial.range_of(trial.variations().back()) + " times");
  for (std::size_t k = 0; k < 2; ++k)
    for (const double r : trial.variations()[k].results) by_dampers.add(145 * r);
  item.value("cn-speeds-tried", by_dampers.text(0, "ft/s"));
  item.refute("much-lower-cn",
              "the initial speed with CN A is much lower than that with new wheels", trial,
              "it is " + of_the_car.text(2, "times") + " that with new wheels");
}

// Dampers that give 145 ft/s with new wheels, and the first critical speeds of the three wheels.
struct FittedDampers {
  double rotation, translation = translation_for(rotation);
  std::array<Critical, damped_cars> at{};
};
template <std::size_t n>
std::vector<FittedDampers> fitted_dampers(const std::array<double, n>& rotations) {
  std::vector<FittedDampers> all;
  all.reserve(n);
  for (const double rotation : rotations) {
    FittedDampers& d = all.emplace_back(FittedDampers{rotation});
    for (std::size_t w = 0; w < damped_cars; ++w)
      d.at[w] = first_critical(with_dampers(d.translation, rotation), vehicles()[w]);
  }
  return all;
}

// How many of the rotations between the two groups have a translation that gives 145 ft/s.
int between_the_groups() {
  int found = 0;
  for (const double rotation : {0.0005, 0.001, 0.002, 0.004})
    found += std::isfinite(translation_for(rotation)) ? 1 : 0;
  return found;
}

double frequency_ratio(double rotation) {
  const CarParameters data = with_dampers(translation_for(rotation), rotation);
  return first_critical(data, vehicle("cn")).omega / first_critical(data, vehicle("new")).omega;
}

// What the dampers leave open that give 12 rad/s as well.
struct LeftOpen {
  double lowest_rotation = 0;
  Range cn_speed, cn_omega;
};
LeftOpen left_open(const std::vector<FittedDampers>& dampers) {
  LeftOpen left;
  for (const FittedDampers& d : dampers) {
    if (!rounds_to_12(d.at[0])) continue;
    if (left.lowest_rotation == 0) left.lowest_rotation = d.rotation;
    left.cn_speed.add(d.at[1].speed), left.cn_omega.add(d.at[1].omega);
  }
  return left;
}

Range new_wheel_frequencies(const std::vector<FittedDampers>& dampers) {
  Range omega;
  for (const FittedDampers& d : dampers) omega.add(d.at[0].omega);
  return omega;
}

void dampers(report::Item& item) {
  item.rebuilt(rebuilt_reason);
  item.expect_checks(5);
  item.columns({"group",
                {"ω<sub>c</sub>A<sub>c</sub>, in/s", "{:.3g}"},
                {"ω<sub>c</sub>θ<sub>c</sub>, rad/s", "{:.3g}"},
                {"new: V, ft/s", "{:.1f}"},
                {"ω, rad/s", "{:.1f}"},
                {"CN A: V, ft/s", "{:.1f}"},
                {"ω, rad/s", "{:.1f}"},
                {"Heumann: V, ft/s", "{:.1f}"},
                {"ω, rad/s", "{:.1f}"}});
  const auto low = fitted_dampers(lower), high = fitted_dampers(upper);
  for (const auto* group : {&low, &high})
    for (const auto& [rotation, translation, at] : *group)
      item.add_row(group == &low         ? "B"
                   : rounds_to_12(at[0]) ? "A, fits"
                                         : "A",
                   translation / inch, rotation, at[0].speed, at[0].omega, at[1].speed, at[1].omega,
                   at[2].speed, at[2].omega);
  const int others = between_the_groups();
  item.claim_if("gap", others == 0, {double(others)});
  const LeftOpen left = left_open(high);
  item.print("frequency-new", "frequency with new wheels", "rad/s", "12",
             vehicle("new").hopf[0].motion.lambda.imag(),
             report::fitted("the stretch of dampers was chosen for it"));
  const double half = 0.5 * left.cn_omega.width();
  item.print("frequency-cn", "frequency, CN A, middle of those with dampers for 145 and 12",
             "rad/s", "21", left.cn_omega.low + half,
             report::absolute(half + 0.5, "half of what these dampers leave open, half a digit"));
  report::Trial rise = item.trial("frequencies-rise", "frequency, CN A over new wheels", "{:.2f}",
                                  [](double r) { return r > words::much; });
  rise.vary("dampers that give 145 ft/s and 12 rad/s, by the rate of rotation",
            [](const report::Setting& s) { return frequency_ratio(s.number); });
  item.claim("frequencies-rise",
             "the frequency before the flange is quite a bit smaller for the new wheel (much)",
             rise, rise.range() + " times with CN A wheels");
  const auto speed = [](const char* key) { return vehicle(key).hopf[0].motion.speed / foot; };
  item.consistent(
      "lower-speeds", "cars with CN A and Heumann wheels hunt at lower speeds",
      std::max(speed("cn"), speed("heumann")) < speed("new"),
      fmt::format("CN A {:.0f}, Heumann {:.0f} ft/s with our dampers", speed("cn"),
                  speed("heumann")),
      fmt::format("other dampers that give 145 ft/s and 12 rad/s give up to {:.0f} ft/s "
                  "with CN A wheels",
                  left.cn_speed.high));
  much_lower(item);
  item.claim_if("much-lower-heumann", speed("heumann") < speed("new") / words::much,
                {speed("heumann")});
  item.value("lower-omega", new_wheel_frequencies(low).text(1, "rad/s"));
  item.value("upper-omega", new_wheel_frequencies(high).text(1, "rad/s"));
  item.value("fit-low", left.lowest_rotation, "rad/s", "{:.3f}");
  item.value("fit-cn", left.cn_omega.text(0, "rad/s"));
}

}  // namespace

const report::Section critical{report::table("critical-speeds", critical_speeds),
                               report::table("dampers", dampers)};

}  // namespace railbook::hunting_chapter
