/***
## Critical speeds of the linear car

For small motions the gains are constants and the car is linear. At the *critical speed* a pair of
eigenvalues crosses the imaginary axis, a Hopf point: $Z(i\omega,V)q=0$. In $1/V$ the matrix is linear. So is then the matrix of all *sums of two
eigenvalues* (the bialternate sum, 153 by 153), and it is singular exactly where two eigenvalues are opposite. Its pencil
gives every Hopf point of a speed range at once, with no scan that could step over one. Newton on $(q,\omega,V)$ polishes each until the update is
below $10^{-11}$. {{critical-speeds}} lists them all up to 400 ft/s. The
last column is an independent route: bisection on the number of growing eigenvalues.

{{critical-speeds}}

With new wheels the mode is one of the body, which rolls and sways on its springs at about 2 Hz while the trucks follow; with worn wheels the
frequency is beyond that and the body hardly moves. Each car has a **second** critical speed, of the other
body mode (yaw for the first, or the reverse). With new wheels it lies only {{hopf-gap}} above the first, and both families
of limit cycles have to be followed before a range of speeds is called stable.

{{eigenvalues}}

Which datum matters? With the left null vector $w$ of $Z$, $d\lambda=-w^H\,dZ\,q\,/\,w^HZ_\lambda q$, and what keeps the real part at zero
is $dV$. {{fig-sensitivities}} shows $\frac pV\frac{dV}{dp}$ for the ten data that matter most. Every bar of a datum of the car was checked by solving again with the datum moved by $10^{-3}$.
Creep $f_{11}$ and the wheelbase lead. Conicity, the slope of $R$, lowers the critical speed of worn wheels; with new wheels its bar is
{{conicity-new}}: a small change of the cone moves the frequency and leaves the speed alone.

{{fig-sensitivities}}

The illegible digits can be judged by what they do. {{changes}} changes one thing at a time. An exponent of 5 or 7 for the warp stiffness, or of 5 for $f_{11}$,
puts the critical speed nowhere near 145 ft/s, and so does half of every creep coefficient: of the exponents tried only 6 will do, and the
coefficients are the "full Kalker values" that the text names. The lost first digit of $f_{22}$ cannot be recovered from results.

{{changes}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr double foot_per_second = units::foot;

int growing(const QuasiLinearCar& car, double speed) {
  const auto all = modes(car, car.small(), speed);
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [](const Motion& m) { return m.lambda.real() > 0; }));
}

// The speed near `near` at which the number of growing modes changes, by bisection.
double by_counting(const QuasiLinearCar& car, double near) {
  double low = near * 0.99, high = near * 1.01;
  const int below = growing(car, low);
  for (int k = 0; k < 50 && high - low > 1e-14 * near; ++k) {
    const double middle = (low + high) / 2;
    (growing(car, middle) == below ? low : high) = middle;
  }
  return (low + high) / 2;
}

void critical_speeds(report::Item& item) {
  const auto printed = item.printed("critical.csv");
  item.columns({"wheel", "V, ft/s", "V, m/s", "ω, rad/s", "dσ/dV, 1/ft", "Newton steps",
                "|Zq|/|Kq|", "by counting, ft/s"});
  item.reconstructed("the profiles' slopes and the equivalent dampers are ours");
  item.expect_checks(4 + 6);
  for (int k = 0; k < linear_studies; ++k) {
    const Study& s = studies()[static_cast<std::size_t>(k)];
    for (std::size_t h = 0; h < s.hopf.size(); ++h) {
      const HopfPoint& hopf = s.hopf[h];
      const double v = hopf.motion.speed, counted = by_counting(s.car, v);
      item.add_row({s.name, fmt::format("{:.6f}", v / foot_per_second), fmt::format("{:.4f}", v),
                    fmt::format("{:.6f}", hopf.motion.lambda.imag()),
                    fmt::format("{:.5f}", hopf.rate_by_speed.real() * foot_per_second),
                    std::to_string(hopf.iterations), fmt::format("{:.0e}", hopf.residual),
                    fmt::format("{:.6f}", counted / foot_per_second)});
      item.agree(fmt::format("{}-{}", s.key, h + 1),
                 fmt::format("{}, Hopf point {}", s.name, h + 1), "m/s", v, counted, 1e-9,
                 "bisection on the number of growing modes");
    }
    const double omega = s.hopf[0].motion.lambda.imag();
    item.row(printed, "frequency-" + s.key).check("printed", omega);
    item.value("v-" + s.key, s.hopf[0].motion.speed / foot_per_second, "ft/s", "{:.2f}");
    item.value("omega-" + s.key, omega, "rad/s", "{:.2f}");
  }
  const Study& s = study("new");
  const double first = s.hopf[0].motion.speed;
  item.row(printed, "speed-new").check("printed", first / foot_per_second);
  item.value("hopf-gap", (s.hopf[1].motion.speed - first) / foot_per_second, "ft/s", "{:.1f}");
}

void eigenvalues(report::Item& item) {
  item.columns({"wheel", "V, ft/s", "σ, 1/s", "ω, rad/s", "front leading", "front trailing",
                "rear leading", "rear trailing", "|X_C|", "yaw L_C|θ_C|", "roll h_2|φ_C|"});
  item.reconstructed("the profiles' slopes and the equivalent dampers are ours");
  const std::array<double, linear_studies> speeds{145, 130, 87};
  for (std::size_t k = 0; k < linear_studies; ++k) {
    const Study& s = studies()[k];
    auto all = modes(s.car, s.car.small(), speeds[k] * foot_per_second);
    std::erase_if(all, [](const Motion& m) { return m.lambda.imag() < 1e-9; });
    for (std::size_t m = 0; m < 2; ++m) {
      const auto& q = all[m].shape;
      const auto w = wheelset_amplitudes(s.car.car(), q);
      const auto& data = s.car.car().data;
      std::vector<std::string> row{s.name, fmt::format("{:.0f}", speeds[k]),
                                   fmt::format("{:+.6f}", all[m].lambda.real()),
                                   fmt::format("{:.6f}", all[m].lambda.imag())};
      for (const double x : w) row.push_back(fmt::format("{:.4f}", x));
      row.push_back(fmt::format("{:.3f}", std::abs(q[X_C])));
      row.push_back(fmt::format("{:.3f}", data.half_truck_distance * std::abs(q[TH_C])));
      row.push_back(fmt::format("{:.3f}", data.bolster_depth * std::abs(q[PHI_C])));
      item.add_row(row);
    }
  }
}

// The half gauge is also the tables' and what measures the linearization is the dampers'; both are left out.
bool shown(const std::string& key) {
  return key != "half-gauge" && key != "damper-frequency" && key != "damper-travel" &&
         key != "damper-angle" && key != "Phi-slope" && key != "D-slope";
}

std::string label(const std::string& key) {
  if (key == "R-slope") return "conicity (slope of R)";
  std::string text = key;
  std::replace(text.begin(), text.end(), '-', ' ');
  return text;
}

double solved_again(const Study& s, double CarParameters::*member, double factor) {
  CarParameters moved;
  moved.*member *= factor;
  return find_hopf({assemble(moved, s.suspension), *s.table}, s.hopf[0].motion).point.motion.speed;
}

void sensitivity_bars(report::Item& item) {
  item.reconstructed("the profiles' slopes and the equivalent dampers are ours");
  std::array<std::vector<Sensitivity>, linear_studies> all;
  for (std::size_t k = 0; k < linear_studies; ++k) {
    const Study& s = studies()[k];
    all[k] = sensitivities(s.car, s.suspension, *s.table, s.hopf[0]);
  }
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < all[0].size(); ++p)
    if (shown(all[0][p].key)) order.push_back(p);
  const auto size = [&](std::size_t p) {
    double largest = 0;
    for (const auto& of : all) largest = std::max(largest, std::abs(of[p].relative));
    return largest;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  order.resize(10);
  for (const auto& of : all[0])
    if (of.key == std::string("R-slope")) item.value("conicity-new", of.relative, "", "{:+.4f}");
  auto& data = item.data({"datum", "new", "cn", "heumann"});
  constexpr double step = 1e-3;
  int checks = 0;
  for (const std::size_t p : order) {
    data.add(label(all[0][p].key), all[0][p].relative, all[1][p].relative, all[2][p].relative);
    if (p >= car_data().size()) continue;
    checks += linear_studies;
  }
  item.expect_checks(checks);
  for (const std::size_t p : order) {
    if (p >= car_data().size()) continue;
    for (std::size_t k = 0; k < linear_studies; ++k) {
      const Study& s = studies()[k];
      const auto member = car_data()[p].member;
      const double again = (solved_again(s, member, 1 + step) - solved_again(s, member, 1 - step)) /
                           (2 * step * s.hopf[0].motion.speed);
      item.agree(fmt::format("{}-{}", s.key, all[k][p].key),
                 fmt::format("{}, {}", s.name, label(all[k][p].key)), "", all[k][p].relative, again,
                 1e-3, "solving again with the datum moved by 0.1 %");
    }
  }
}

struct Change {
  const char* what;
  std::function<void(CarParameters&)> apply;
};

const std::array<Change, 9> all_changes{{
    {"as in the table of data", [](CarParameters&) {}},
    {"warp stiffness of 0.381 10⁶ ft lb/rad", [](CarParameters& c) { c.warp_stiffness *= 0.1; }},
    {"warp stiffness of 38.1 10⁶ ft lb/rad", [](CarParameters& c) { c.warp_stiffness *= 10; }},
    {"f11 of 0.115 10⁶ lb", [](CarParameters& c) { c.f11 *= 0.1; }},
    {"half of all creep coefficients",
     [](CarParameters& c) { c.f11 /= 2, c.f12 /= 2, c.f22 /= 2, c.f33 /= 2; }},
    {"f22 of 2.1 ft² lb", [](CarParameters& c) { c.f22 *= 2.1 / 82.1; }},
    {"no spin creep (f12 = f22 = 0)", [](CarParameters& c) { c.f12 = c.f22 = 0; }},
    {"bolsters hang at the body's centre (h2 = 0)", [](CarParameters& c) { c.bolster_depth = 0; }},
    {"no damping at all",
     [](CarParameters& c) {
       c.lateral_friction = c.vertical_friction = c.warp_friction = c.centre_plate_friction = 0;
     }},
}};

void changes(report::Item& item) {
  item.columns({"car", "new wheel, ft/s", "ω, rad/s", "CN A, ft/s", "ω, rad/s", "Heumann, ft/s",
                "ω, rad/s"});
  item.reconstructed("the profiles' slopes and the equivalent dampers are ours");
  for (const Change& change : all_changes) {
    CarParameters data;
    change.apply(data);
    std::vector<std::string> row{change.what};
    for (std::size_t k = 0; k < linear_studies; ++k) {
      const QuasiLinearCar car{assemble(data, Suspension::dampers), *studies()[k].table};
      const auto found = hopf_points(car, 1 * foot_per_second, 400 * foot_per_second);
      row.push_back(found.empty() ? "none below 400"
                                  : fmt::format("{:.1f}", found[0].motion.speed / foot_per_second));
      row.push_back(found.empty() ? "-" : fmt::format("{:.1f}", found[0].motion.lambda.imag()));
    }
    item.add_row(row);
  }
}

}  // namespace

void add_critical(report::Chapter& chapter) {
  chapter.table("critical-speeds", "All critical speeds of the linear car up to 400 ft/s",
                critical_speeds);
  chapter.table("eigenvalues",
                "The two least damped modes near the critical speeds; largest wheelset 1",
                eigenvalues);
  chapter.figure("fig-sensitivities", "What a datum does to the critical speed", sensitivity_bars);
  chapter.table("changes", "The critical speed of other cars", changes);
}

}  // namespace railbook::hunting_chapter
