/***
The rows strain the search for cycles and critical speeds, friction's sticking rate and the end of the tables. The random cars have data drawn between half and twice the
paper's ({{random-cars}} of them, for one takes a tenth of a second); the error is the worst of all. The contact of random wheels and rails against a scan of all places is a test of the library.

{{digits}}

The derivative loses digits where the amplitude comes down to the core's width, for there $1-\beta$ is a small difference.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "bench/evidence.hpp"
#include "dynamics/describing_function.hpp"
#include "num/eigenvalues.hpp"
#include "sections.hpp"
#include "vehicles.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;
using report::Found;
using units::foot;
using units::inch;

namespace {

Oscillator new_car(double feet_a_second,
                   const wheelrail::ConstraintFunctions& table = wheelrail::new_wheel_table()) {
  return car_on_track(assemble({}, Suspension::dampers), table, feet_a_second * foot);
}

Eigen::VectorXd aside(double inches) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(18);
  y[X_TF] = y[X_TR] = inches * inch;
  return y;
}

History run(const Oscillator& car, const Eigen::VectorXd& y, double duration, Integrator integrator,
            double tolerance) {
  HistoryOptions options = watching(car, tolerance);
  options.integrator = integrator;
  return integrate(car, y, duration, options);
}

Found slow() {
  const Oscillator car = new_car(1);
  const History implicit = run(car, aside(0.2), 5, Integrator::radau5, 1e-8),
                exact = run(car, aside(0.2), 5, Integrator::pieces, 1e-12);
  return {fmt::format("{} implicit steps for 5 s, {} in exact pieces", implicit.steps, exact.steps),
          (exact.y - implicit.y).head(9).lpNorm<Eigen::Infinity>() / inch};
}

Found standstill() {
  (void)new_car(0);
  return {"accepted", 1};
}

// The amplitude with a sticking rate `part` of the usual, refined from the usual one's cycle.
double with_stick(const CycleCase& usual, double part) {
  CarParameters data;
  data.stick_speed *= part;
  data.stick_rate *= part;
  const Oscillator car =
      car_on_track(assemble(data, Suspension::friction), *usual.vehicle->table, 90 * foot);
  const Examined e = examine(car, harmonics(car, usual.examined.orbit, 23));
  if (!e.converged) throw report::NoAnswer(e.reason);
  return e.amplitude;
}

// The second quartering of the rate changes the amplitude less than the first: by a quarter if the error is of first order.
Found stick() {
  const CycleCase c = cycle_case(vehicle("friction"), 90 * foot);
  const double usual = c.examined.amplitude, quarter = with_stick(c, 0.25),
               less = with_stick(c, 0.0625);
  return {fmt::format("A {:.4f}, {:.4f}, {:.4f} in at 1, 1/4, 1/16 of the rate", usual / inch,
                      quarter / inch, less / inch),
          std::abs((less - quarter) / (quarter - usual))};
}

Found leaving() {
  const Oscillator car = new_car(240);
  const History exact = run(car, aside(0.45), 20, Integrator::pieces, 1e-12),
                other = run(car, aside(0.45), 20, Integrator::dopri5, 1e-9);
  if (exact.end != History::End::left_table) return {"did not leave", 1};
  return {fmt::format("stopped at {:.4f} s by both", exact.t), std::abs(exact.t - other.t)};
}

Found no_cycle() {
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(9);
  q[X_TF] = q[X_TR] = 0.3 * inch;
  const Oscillator car = new_car(60);
  const Cycle cycle = balance(car, first_harmonic(car, q, 8, 9));
  if (!cycle.converged) throw report::NoAnswer(cycle.reason);
  return {"a cycle", 1};
}

// The second describing-function cycle of 199 ft/s: what closes from there is another one.
Found another() {
  const CycleCase c = cycle_case(vehicle("new"), 199 * foot, 1);
  if (!c.examined.converged) throw report::NoAnswer("no true cycle near it");
  return {"a cycle", c.examined.distance};
}

double first_speed(const CarParameters& data) {
  return hopf_points({assemble(data, Suspension::dampers), wheelrail::new_wheel_table()}, 10, 120)
      .at(0)
      .motion.speed;
}

Found no_spring() {
  CarParameters none, weak;
  none.lateral_stiffness = 0;
  weak.lateral_stiffness = 1e-3;
  const double speed = first_speed(none);
  return {fmt::format("{:.2f} ft/s", speed / foot), std::abs(speed / first_speed(weak) - 1)};
}

Found no_damping() {
  const auto damped = [](double part) {
    CarParameters data;
    for (double CarParameters::*friction :
         {&CarParameters::lateral_friction, &CarParameters::vertical_friction,
          &CarParameters::warp_friction, &CarParameters::centre_plate_friction})
      data.*friction *= part;
    return first_speed(data);
  };
  const double none = damped(0);
  return {fmt::format("{:.2f} ft/s", none / foot), std::abs(damped(1e-6) / none - 1)};
}

Found cylinder() {
  const auto& table = wheelrail::new_wheel_table();
  wheelrail::ConstraintFunctions flat = table;
  flat.R = wheelrail::OddTable(table.R.step(), std::vector<double>(table.R.values().size(), 0.0));
  flat.D = flat.Phi = flat.R;
  const auto found = hopf_points({assemble({}, Suspension::dampers), flat}, 1 * foot, 400 * foot);
  return {fmt::format("{} critical speeds up to 400 ft/s", found.size()), double(found.size())};
}

// Critical speeds against the eigenvalues of the full system there, and their number against how many modes grow at the ends.
Found random_cars(int cars) {
  std::mt19937 engine(1976);
  std::uniform_real_distribution<double> exponent(-1, 1);
  const auto& table = wheelrail::new_wheel_table();
  const double low = 20 * foot, high = 300 * foot;
  double worst = 0;
  int points = 0;
  for (int k = 0; k < cars; ++k) {
    CarParameters data;
    for (const CarDatum& datum : car_data()) data.*datum.member *= std::exp2(exponent(engine));
    data.half_gauge = CarParameters{}.half_gauge;  // the tables', too
    const FreightCar car = assemble(data, Suspension::dampers);
    const auto eigenvalues = [&](double speed) -> Eigen::VectorXcd {
      StateMatrix jacobian;
      compile(car_on_track(car, table, speed)).jacobian(State::Zero(), jacobian);
      return num::eigenvalues(jacobian);
    };
    auto crossed = (eigenvalues(high).real().array() > 0).count() -
                   (eigenvalues(low).real().array() > 0).count();
    for (const HopfPoint& at : hopf_points({car, table}, low, high)) {
      const Complex lambda = at.motion.lambda;
      const Eigen::VectorXcd all = eigenvalues(at.motion.speed);
      worst = std::max(worst, (all.array() - lambda).abs().minCoeff() / std::abs(lambda));
      crossed -= at.rate_by_speed.real() > 0 ? 2 : -2;
      ++points;
    }
    if (crossed != 0) return {fmt::format("car {} has other critical speeds", k), 1};
  }
  return {fmt::format("{} cars, {} critical speeds", cars, points), worst};
}

// The gain of friction with a viscous core of width 1, and its derivative, against 80-bit arithmetic.
void digits(report::Item& item) {
  item.added("a study of methods");
  item.expect_checks(2);
  std::vector<double> amplitudes;
  for (double a = 1.01; a < 1e6; a *= 1.01) amplitudes.push_back(a);
  const auto root = [](long double b) { return std::sqrt((1 - b) * (1 + b)); };
  const auto gain = [&](double a) {
    const long double b = 1 / static_cast<long double>(a);
    return 2 / std::numbers::pi_v<long double> * (std::asin(b) + b * root(b));
  };
  const auto slope = [&](double a) {
    const long double b = 1 / static_cast<long double>(a);
    return -4 / std::numbers::pi_v<long double> * b * b * root(b);
  };
  const char *range = "A/ε from 1.01 to 1e6", *against = "80-bit arithmetic";
  bench::digits_table(
      item, {bench::worst_digits(
                 {"gain", "N(A) of regularized friction", range, against, 1e-15}, amplitudes,
                 [](double a) { return regularized_friction(1, 1, a).value; }, gain),
             bench::worst_digits(
                 {"slope", "dN/dA", range, against, 1e-13}, amplitudes,
                 [](double a) { return regularized_friction(1, 1, a).slope; }, slope)});
}

}  // namespace

const report::Section closed_forms{
    report::table("digits", "Digits of the closed form of friction's gain", digits)};

void extremes(report::Item& item) {
  using report::degrades, report::holds, report::refused;
  const int cars = item.full() ? 1000 : 40;
  item.value("random-cars", cars, "", "{:.0f}");
  item.stability({"slow", "V = 1 ft/s", "fastest decay 27,000 1/s against a period of a minute",
                  holds, 1e-5, "exact pieces, in"},
                 slow);
  item.stability({"standstill", "V = 0", "creepage divides by V", refused}, standstill);
  item.stability({"stick", "CN with friction, 90 ft/s, sticking rate 1/4 and 1/16",
                  "the sign function is approached; a half would be an order of 1/2", degrades, 0.5,
                  "the change before"},
                 stick);
  item.stability({"leaving", "new wheel, 240 ft/s", "a wheelset reaches the end of its table",
                  holds, 1e-6, "another integrator, s"},
                 leaving);
  item.stability(
      {"no-cycle", "new wheel, 60 ft/s, balance from 0.3 in", "there is no cycle", refused},
      no_cycle);
  item.stability({"another", "new wheel, 199 ft/s, second describing-function cycle",
                  "what closes from there is another cycle", refused},
                 another);
  item.stability({"no-spring", "no lateral springs", "the pencil is singular at every speed", holds,
                  1e-6, "springs of 1e-3 N/m"},
                 no_spring);
  item.stability({"no-damping", "no friction in any joint", "modes of the body hardly damped",
                  holds, 1e-4, "a millionth of the friction"},
                 no_damping);
  item.stability({"cylinder", "wheels without any cone", "nothing steers", holds, 0.5,
                  "none: such a car cannot hunt"},
                 cylinder);
  item.stability({"random-cars", "random cars: all critical speeds", "modes near one another",
                  holds, 1e-9, "eigenvalues of the full system"},
                 [&] { return random_cars(cars); });
}

}  // namespace railbook::hunting_chapter
