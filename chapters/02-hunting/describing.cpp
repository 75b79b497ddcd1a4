/***
## Describing functions

A sine of amplitude $A$ through a nonlinear function $f$ comes out distorted. Its describing function is the gain that
loses least, equation (8),

$$N(A)=\frac2{\pi A}\int_0^\pi f(A\sin\psi)\sin\psi\,d\psi .$$

The constraint functions are tables, linear between points, and for these the integral is known: each change of
slope $\Delta m_k$ at $b_k$ adds $\Delta m_k\,[1-\frac2\pi(\arcsin\beta+\beta\sqrt{1-\beta^2})]$, $\beta=b_k/A$, once $A$ exceeds $b_k$.
No quadrature, and the derivative $dN/dA$ that Newton's method needs comes along. {{describing-values}} sets it against adaptive
quadrature of the same tables, and of functions whose $N$ is known otherwise.

{{describing-values}}

The three figures are the paper's Figures 7 to 9 (it calls the first *conicity*; which of the other two came first is
not legible). On the tread the gains are the slopes at the origin. They shoot up once the flange
is met, reach their largest values, and fall again as the amplitude passes the steepest part. Before the flange the hollow wheels have a slight dip, to
{{gain-dip}} of the first value for the Heumann wheel at {{gain-dip-at}}: that dip will
make a small limit cycle without any flange.

{{fig-07}}

{{fig-08}}

{{fig-09}}

Dry friction $F_0\,\mathrm{sign}\,\dot x$ has $N=4F_0/\pi A$, equation (12), where $A$ is the amplitude of the *rate*. With
a viscous core of width $\varepsilon$ the gain is $F_0/\varepsilon$ up to $A=\varepsilon$; at $A=10\,\varepsilon$ the two differ by
{{friction-difference}}.
*/

#include "dynamics/describing_function.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "items.hpp"
#include "num/quadrature.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

constexpr std::array<const char*, 3> keys{"new", "cn", "heumann"};
constexpr std::array<const char*, 3> functions{"R", "D", "Phi"};

const wheelrail::OddTable& function_of(const wheelrail::ConstraintFunctions& t, std::size_t f) {
  return f == 0 ? t.R : f == 1 ? t.D : t.Phi;
}

// N against x_w / a, as in the paper.
double gain(const Study& s, std::size_t f, double amplitude) {
  Vector9c shape = Vector9c::Zero();
  shape[X_TF] = amplitude;
  return s.car.at(shape, 1).wheel[0][f].value * s.table->half_spacing;
}

void curves(report::Item& item, std::size_t f) {
  item.reconstructed("profiles of ours; the paper's measured ones and its curves are lost");
  auto& data = item.data({"A_in", "A_over_a", "new", "cn", "heumann"});
  for (int k = 1; k <= 300; ++k) {
    const double amplitude = 0.0025 * k * units::inch;
    data.add(amplitude / units::inch, amplitude / study("new").table->half_spacing,
             gain(study("new"), f, amplitude), gain(study("cn"), f, amplitude),
             gain(study("heumann"), f, amplitude));
  }
}

// N of a table by quadrature, interval by interval so that the integrand is smooth.
double by_quadrature(const wheelrail::OddTable& table, double amplitude) {
  double sum = 0, from = 0;
  for (std::size_t k = 0; from < units::pi / 2; ++k) {
    const double corner = table.step() * static_cast<double>(k + 1);
    const double to = corner < amplitude ? std::asin(corner / amplitude) : units::pi / 2;
    const double slope = table.slope(table.step() * (static_cast<double>(k) + 0.5));
    const double offset = table(table.step() * static_cast<double>(k)) -
                          slope * table.step() * static_cast<double>(k);
    sum += num::integrate(
               [&](double psi) {
                 return (offset + slope * amplitude * std::sin(psi)) * std::sin(psi);
               },
               from, to, 1e-12, 1e-18)
               .value;
    from = to;
  }
  return 4 * sum / (units::pi * amplitude);
}

void compare(report::Item& item, const std::string& id, const std::string& what, double closed,
             double other, const std::string& method) {
  item.add_row({what, fmt::format("{:.9g}", closed), fmt::format("{:.9g}", other), method});
  item.agree(id, what, "", closed, other, 1e-9, method);
}

void values(report::Item& item) {
  item.columns({"N", "closed form", "other", "by"});
  item.explained("ours: the paper computed these numerically and prints no value");
  item.expect_checks(3 * 3 * 2 + 5);
  for (const char* key : keys) {
    const Study& s = study(key);
    for (std::size_t f = 0; f < 3; ++f)
      for (const double inches : {0.45, 0.6}) {
        const double amplitude = inches * units::inch;
        compare(item, fmt::format("{}-{}-{:.0f}", key, functions[f], 100 * inches),
                fmt::format("{}, N_{} at {:.2f} in", s.name, functions[f], inches),
                gain(s, f, amplitude),
                s.table->half_spacing * by_quadrature(function_of(*s.table, f), amplitude),
                "adaptive quadrature");
      }
  }
  const auto cube =
      describe([](double x) { return x * x * x; }, [](double x) { return 3 * x * x; }, 0.7);
  compare(item, "cube", "x^3 at 0.7 by quadrature", cube.gain.value, 0.75 * 0.49, "3/4 A^2");
  const auto sine =
      describe([](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }, 2.0);
  compare(item, "sine", "sin x at 2 by quadrature", sine.gain.value, std::cyl_bessel_j(1.0, 2.0),
          "2 J_1(A) / A");
  for (const double ratio : {2.0, 20.0}) {
    const auto law = [&](double v) { return v < 1 ? v : 1.0; };
    const double half = std::asin(1 / ratio);
    const auto part = [&](double a, double b) {
      return num::integrate([&](double p) { return law(ratio * std::sin(p)) * std::sin(p); }, a, b,
                            1e-12)
          .value;
    };
    compare(item, fmt::format("friction-{:.0f}", ratio),
            fmt::format("regularized friction at A = {:.0f} ε", ratio),
            regularized_friction(1, 1, ratio).value,
            4 / (units::pi * ratio) * (part(0, half) + part(half, units::pi / 2)),
            "adaptive quadrature");
  }
  compare(item, "friction-limit", "regularized friction at A = 1e6 ε",
          regularized_friction(1, 1e-6, 1).value, ideal_friction(1, 1).value, "eq. (12)");
  item.value("friction-difference",
             100 * (1 - regularized_friction(1, 0.1, 1).value / ideal_friction(1, 1).value), "%",
             "{:.2f}");
  const Study& s = study("heumann");
  double least = 1e9, at = 0;
  for (double inches = 0.05; inches < 0.3; inches += 0.001)
    if (const double n = gain(s, 0, inches * units::inch); n < least) least = n, at = inches;
  item.value("gain-dip", 100 * least / gain(s, 0, 0.01 * units::inch), "%", "{:.1f}");
  item.value("gain-dip-at", at, "in", "{:.2f}");
}

}  // namespace

void add_describing(report::Chapter& chapter) {
  chapter.table("describing-values", "Describing functions by two routes", values);
  for (std::size_t f = 0; f < 3; ++f) {
    const std::array<const char*, 3> titles{
        "N_R, of the difference of rolling radii (the paper's Fig. 7)",
        "N_D, of the difference of contact angles (the paper's Fig. 8)",
        "N_Φ, of the wheelset's roll (the paper's Fig. 9)"};
    chapter.figure(fmt::format("fig-{:02}", 7 + f), titles[f],
                   [f](report::Item& item) { curves(item, f); });
  }
}

}  // namespace railbook::hunting_chapter
