/***
## The measurements, made anew

The measured points stand in the paper's figures only, which are lost to us. The paper's *reduction*
is its way from the points to one curve. To see what it can do, we take the theory for the truth,
add errors, and reduce the points as the paper does. **Every point below
is synthetic**, and the figures say so. What is assumed:

* four loads of 500, 1000, 1500 and 2500 lbf (1 lbf is 4.448 N); the paper prints one, 4449.72 N or
  1000 lb;
* the longer axis of the ellipse along rolling;
* a largest friction coefficient $\mu_c$ of 0.5 at 1000 lbf, falling with the load to the power
  −{{exponent}}, and 28 points a test (free choices);
* contact areas 1.1 to 1.9 times Hertz's, by wear, and measured with an error of 3 %;
* errors of 0.0005 in the creep (Appendix A) and 22.249 N in the force, both taken as two standard
  deviations.

The line through the points stands for the paper's average curve. It is the theory's curve, fitted
with $\mu_c$ and the area free. The paper takes the forces as given and the creep as the quantity
that is measured. Our fit minimises the distances in the friction instead; the table below shows
that it finds the area again.

{{fig-03}}

Two statements of the paper on its own points do not fit these. It says "The dispersion of values is
very large"; here the errors of creep and force alone scatter the points about their curves by
{{dispersion}} of $\mu_c$ (root mean square). And it says that the curves of its Figure 8 are
"almost parallel, indicating a common decreasing trend". The four areas assumed here, in no order,
break that trend: at a creep of 0.004 the friction is {{mu-1500}} at 1500 lbf and {{mu-2500}} at
2500 lbf, while $\mu_c$ falls, so these two curves cross. In the paper either the four areas must
have been closer together or have followed the load, or the friction must have fallen more steeply
with it.

### Friction and area against the load

At constant creep the friction falls with the load, and the paper says of it: "This trend is
predicted by the theoretical analysis of Vermeulen and Johnson … and Kalker". It is, even where
$\mu_c$ is the same at all loads. Hertz's area goes with $N^{2/3}$, so
$X\propto\xi N^{-1/3}$: at the same creep a larger load has a smaller $X$. In the linear part this
gives $\mu\propto N^{-1/3}$, and closer to full slip the trend is weaker. At the creeps of the
figure, from {{creep-first}} to {{creep-last}}, the exponent of $N$ runs from {{exponent-first}} to
{{exponent-last}} for $\mu_c$ = 0.5 and an area 1.5 times Hertz's. {{outcome:fig-08/trend}}

{{fig-08}}

::: {.fold summary="How parallel the lines are, and the areas of the four tests"}

By the full theory with $\mu_c$ = 0.5 at all loads, $d\mu/d\ln N$ at 1000 lbf is {{slopes}} at the
four creeps, so the slopes differ by a factor of {{slope-ratio-all}}, and by {{slope-ratio}} from a
creep of 0.001 on. The paper calls its own lines "almost parallel"; they are lost, so the two cannot
be compared. The lines of the figure are steeper than that at large creep, since they have the
falling $\mu_c$ assumed above.

The next figure shows Hertz's area for both directions of the longer axis, since the text does not
say which the rig had: across, the area is {{across-larger}} larger than along. For worn wheels the
paper finds a considerable difference from Hertz's area; the synthetic areas stand for it.

{{fig-09}}

:::

## One curve for all

The paper's claim is that with the actual area of contact all tests fall on one curve. The reduction
takes few lines. `each_reduced` goes through the points of all tests and forms $X$ and $\mu/\mu_c$
from the load, the friction and the creep of each; `hertz_group` is $G\,ab/N$. The largest friction
is that of the test's average curve; the area is Hertz's, or Hertz's times the measured factor:

{{code: experiment.cpp each_reduced}}

With **Hertz's** area the four tests stay apart, each shifted by its own wear. With the **measured**
area they fall on one line, which is the theory's, since the points were made from it:

{{fig-11}}

The upper scale of the figure uses full axes for $a$ and $b$, as the paper's nomenclature and
equation (4) have them. The lower one uses semi-axes, as Kalker and this page do.

{{table-collapse}}

In numbers: each test needs some factor on its area to bring its points onto the curve. With Hertz's
area the largest of the four factors is {{spread-hertz}} above the smallest; with the measured area
it is {{spread-true}} above. The points of all tests scatter about the curve by {{rms-hertz}} with
Hertz's area and by {{rms-true}} with the measured one (root mean square of $\mu/\mu_c$). The second
number is what the errors of force, creep and area make by themselves.
Vermeulen and Johnson's curve lies at most {{vj-apart}} above the full theory's, somewhat more than
a single point scatters.

The fit also finds the contact area of a test from its creep curve alone, without the replica tape.
In these four tests the area found is within {{factor-error}} of the true one; over {{draws}}
repetitions of each with other random errors its standard deviation is {{factor-scatter}}. This
shows what the reduction can do at best, not that the paper's own points did so.

{{fold}}
*/

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <vector>

#include <railbook/num/random_source.hpp>
#include <railbook/report/values.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/creep_laws.hpp>

#include "rig.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr const char* synthetic =
    "the paper's measured points are lost; these are synthetic, from the theory and the errors "
    "listed above";
constexpr double creep_error = 0.0005 / 2, force_error = 22.249 / 2, area_error = 0.03;
constexpr std::uint64_t repetitions = 100;

// mu_c that the synthetic wheels have.
constexpr double friction_exponent = 0.17;
double synthetic_friction(double load) {
  return 0.5 * std::pow(load / paper_load, -friction_exponent);
}

// The average curve of a test: mu_c and the factor on Hertz's area that fit its points best.
struct Average {
  double friction = 0, area_factor = 0;
  double mu(double load, double creep) const {
    return friction * master_curve(area_factor * hertz_group(load) * creep / friction);
  }
};

struct Point {
  double creep = 0, mu = 0;
};

// One test, at one load with one pair of wheels; its area over Hertz's, by wear, true and as
// measured.
struct Test {
  double load = 0, friction = 0;
  double area_factor = 0, area_measured = 0;
  std::vector<Point> points = {};
  Average average = {};
};

// Stream k of the random numbers is test k's.
Test make_test(double load, double area_factor, std::uint64_t stream) {
  const num::RandomSource random(1979, stream);
  Test test{.load = load,
            .friction = synthetic_friction(load),
            .area_factor = area_factor,
            .area_measured = area_factor * (1 + area_error * random.normal(1000))};
  const double group = area_factor * hertz_group(load) / test.friction;  // X per creep
  for (std::uint64_t i = 0; i < 28; ++i) {
    const double x = 1.1 * (static_cast<double>(i) + 0.5) / 28;
    const double mu =
        test.friction * master_curve(x) + force_error / load * random.normal(2 * i + 1);
    test.points.push_back({x / group + creep_error * random.normal(2 * i), mu});
  }
  return test;
}

// mu_c by least squares for a given area: linear but for mu_c in X, which a few passes settle.
Average with_area(const Test& test, double area_factor) {
  Average mean{test.points.back().mu, area_factor};
  const double group = area_factor * hertz_group(test.load);
  for (double before = 0; std::abs(mean.friction - before) > 1e-9;) {
    before = mean.friction;
    double num = 0, den = 0;
    for (const Point& p : test.points) {
      const double f = master_curve(group * p.creep / mean.friction);
      num += f * p.mu, den += f * f;
    }
    mean.friction = num / den;
  }
  return mean;
}

// Golden section on the area factor: the sum of squares has one valley.
Average fitted(const Test& test) {
  const auto squares = [&](double area_factor) {
    const double friction = with_area(test, area_factor).friction;
    const double group = area_factor * hertz_group(test.load);
    double sum = 0;
    for (const Point& p : test.points)
      sum += std::pow(p.mu - friction * master_curve(group * p.creep / friction), 2);
    return sum;
  };
  double low = 0.5, high = 4;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  while (high - low > 1e-4) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    const bool below = squares(left) < squares(right);
    (below ? high : low) = below ? right : left;
  }
  return with_area(test, (low + high) / 2);
}

const std::vector<Test>& tests() {
  static const std::vector<Test> all = [] {
    std::vector<Test> four{make_test(500 * units::lbf, 1.3, 1), make_test(paper_load, 1.6, 2),
                           make_test(1500 * units::lbf, 1.1, 3),
                           make_test(2500 * units::lbf, 1.9, 4)};
    for (Test& test : four) test.average = fitted(test);
    return four;
  }();
  return all;
}

// Relative standard deviation of the area factor that the fit finds, over repetitions of a test.
double scatter_of(std::size_t which) {
  const Test& test = tests()[which];
  double sum = 0, squares = 0;
  for (std::uint64_t k = 0; k < repetitions; ++k) {
    const std::uint64_t stream = 100 + repetitions * which + k;
    const double ratio =
        fitted(make_test(test.load, test.area_factor, stream)).area_factor / test.area_factor;
    sum += ratio, squares += ratio * ratio;
  }
  const double mean = sum / repetitions;
  return std::sqrt((squares / repetitions - mean * mean) * repetitions / (repetitions - 1));
}

const std::array<double, 4>& fitted_scatters() {
  static const std::array all{scatter_of(0), scatter_of(1), scatter_of(2), scatter_of(3)};
  return all;
}

// Root mean square distance of a test's points from its average curve, over mu_c.
double dispersion(const Test& test) {
  double sum = 0;
  for (const Point& p : test.points)
    sum += std::pow((p.mu - test.average.mu(test.load, p.creep)) / test.average.friction, 2);
  return std::sqrt(sum / static_cast<double>(test.points.size()));
}

void each_load(report::Item& item) {
  auto& curve = item.data({"creep", "mu_500", "mu_1000", "mu_1500", "mu_2500"});
  auto& points = item.data("points", {"load_lbf", "creep", "mu", "creep_error", "mu_error"});
  for (int i = 0; i <= 200; ++i) {
    const auto mu = [&](std::size_t k) { return tests()[k].average.mu(tests()[k].load, 1e-4 * i); };
    curve.add(1e-4 * i, mu(0), mu(1), mu(2), mu(3));
  }
  for (const Test& test : tests())
    for (const Point& p : test.points)
      points.add(std::round(test.load / units::lbf), p.creep, p.mu, creep_error,
                 force_error / test.load);
  item.rebuilt(synthetic);
  item.value("exponent", friction_exponent, "", "{:.2f}");
}

// A theory's mu at a creep and load, on an ellipse of the rig with worn sizes.
struct ConstantCreep {
  double creep = 0.002, friction = 0.5, area_factor = 1.5;
  bool along = true;
  std::string theory = "full theory";

  double mu(double load) const {
    const double ratio = along ? axis_ratio : 1 / axis_ratio;
    const double x = area_factor * hertz_group(load, along) * creep / friction;
    const auto c = with_reduced_creepage(normalised_case(ratio, poisson), {x, 0, 0});
    if (theory == "full theory")
      return friction * EllipseRolling(ratio, poisson, {.along = 24, .rows = 12}).solve(c).fx;
    return friction *
           creep_forces(theory == "FASTSIM" ? Theory::fastsim : Theory::vermeulen_johnson, c).fx;
  }
  // d ln mu/d ln N at 1000 lb, the largest friction being the same at all loads.
  double exponent() const {
    const double step = 1.1;
    return std::log(mu(paper_load * step) / mu(paper_load / step)) / (2 * std::log(step));
  }
  // -d mu/d ln N there.
  double fall() const { return -exponent() * mu(paper_load); }
};

// Four creeps of the figure, in the same order as the names of its columns.
constexpr std::array drawn_creeps{0.0005, 0.001, 0.002, 0.004};

// A row of the figure: load [lbf], friction at each creep, largest friction.
void add_constant_creep(report::Data& data, double load, const Average& a) {
  const auto mu = [&](std::size_t k) { return a.mu(load, drawn_creeps[k]); };
  data.add(load / units::lbf, mu(0), mu(1), mu(2), mu(3), a.friction);
}

report::Trial trend(const report::Item& item) {
  report::Trial trial = item.trial("trend", "exponent of the load", "{:.2f}",
                                   [](double exponent) { return exponent < 0; });
  trial.vary("creep",
             [](const report::Setting& s) { return ConstantCreep{.creep = s.number}.exponent(); });
  trial.vary("theory at creep 0.002",
             [](const report::Setting& s) { return ConstantCreep{.theory = s.text}.exponent(); });
  trial.vary("largest friction at creep 0.002", [](const report::Setting& s) {
    return ConstantCreep{.friction = s.number}.exponent();
  });
  trial.vary("area over Hertz's at creep 0.002", [](const report::Setting& s) {
    return ConstantCreep{.area_factor = s.number}.exponent();
  });
  trial.vary("longer axis at creep 0.002", [](const report::Setting& s) {
    return ConstantCreep{.along = s.index == 0}.exponent();
  });
  return trial;
}

void constant_creep(report::Item& item) {
  auto& lines = item.data({"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  auto& points = item.data("points", {"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  for (double load = 400; load <= 2700; load += 20)  // one wear for all loads: smooth lines
    add_constant_creep(lines, load * units::lbf, {synthetic_friction(load * units::lbf), 1.5});
  for (const Test& test : tests()) add_constant_creep(points, test.load, test.average);
  item.rebuilt("loads, friction and wear are not printed; those used are stated above");
  item.expect_checks(1);
  const report::Trial trial = trend(item);
  item.claim("trend", "the fall of friction with the load at constant creep is predicted", trial,
             fmt::format("exponent of the load {}, with a largest friction that does not fall",
                         trial.range()));
  const report::Variation& by_creep = trial.variations().front();
  item.value("creep-first", by_creep.settings.front());
  item.value("creep-last", by_creep.settings.back());
  std::array<double, 4> falls{};
  std::ranges::transform(drawn_creeps, falls.begin(),
                         [](double creep) { return ConstantCreep{.creep = creep}.fall(); });
  const auto ratio = [](const auto& r) { return std::ranges::max(r) / std::ranges::min(r); };
  item.value("slopes", fmt::format("−{:.3f}", fmt::join(falls, ", −")));
  report::values(item, "", "{:.1f}", "slope-ratio-all", ratio(falls), "slope-ratio",
                 ratio(falls | std::views::drop(1)));
  const auto mu = [](const Test& test) { return test.average.mu(test.load, 0.004); };
  report::values(item, "", "{:.2f}", "exponent-first", by_creep.results.front(), "exponent-last",
                 by_creep.results.back(), "mu-1500", mu(tests()[2]), "mu-2500", mu(tests()[3]));
}

// [mm^2] at a load [lbf]
double hertz_area(double load, bool major_along_rolling) {
  const auto c =
      rig_contact(std::max(load, 1e-3) * units::lbf, profile_radius(major_along_rolling));
  return units::pi * c.a * c.b / 1e-6;
}

void areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2", "across_mm2"});
  auto& points = item.data("points", {"load_lbf", "area_mm2", "test"});
  for (double load = 0; load <= 3000; load += 25)
    line.add(load, hertz_area(load, true), hertz_area(load, false));
  int number = 0;
  for (const Test& test : tests())
    points.add(test.load / units::lbf,
               hertz_area(test.load / units::lbf, true) * test.area_measured,
               fmt::format("test {}: {:.2f}", ++number, test.area_measured));
  item.rebuilt(
      "Hertz's lines for the material and radii used; the paper's points are lost, those shown are "
      "synthetic");
  item.value("across-larger", 100 * (hertz_area(1000, false) / hertz_area(1000, true) - 1), "%",
             "{:.0f}");
}

// Calls `use` with X and mu/mu_c of every point, by Hertz's area or the measured one.
template <class Use>
void each_reduced(bool measured_area, const Use& use) {
  for (const Test& test : tests()) {
    const double friction = test.average.friction, factor = measured_area ? test.area_measured : 1;
    for (const Point& p : test.points)
      use(factor * hertz_group(test.load) * p.creep / friction, p.mu / friction, test);
  }
}

double vermeulen_johnson(double x) {
  const auto c = with_reduced_creepage(normalised_case(axis_ratio, poisson), {x, 0, 0});
  return creep_forces(Theory::vermeulen_johnson, c).fx;
}

void dimensionless(report::Item& item) {
  auto& curves = item.data({"x", "full", "vermeulen_johnson"});
  auto& points = item.data("points", {"x_hertz", "x_measured", "f", "test"});
  double apart = 0;
  for (int i = 0; i <= 250; ++i) {
    const double x = 1.25 * i / 250, full = master_curve(x), simple = vermeulen_johnson(x);
    apart = std::max(apart, simple - full);
    curves.add(x, full, simple);
  }
  item.value("vj-apart", apart, "", "{:.2f}");
  each_reduced(false, [&](double x, double share, const Test& test) {
    points.add(x, test.area_measured * x, share, std::round(test.load / units::lbf));
  });
  item.rebuilt(synthetic);
}

// Root mean square distance of all points from the curve.
double scatter(bool measured_area) {
  double sum = 0, count = 0;
  each_reduced(measured_area, [&](double x, double share, const Test&) {
    sum += std::pow(share - master_curve(x), 2), ++count;
  });
  return std::sqrt(sum / count);
}

// Least and largest of a quantity of the four tests.
template <class Of>
std::ranges::minmax_result<double> range_of(const Of& of) {
  std::array<double, 4> all{};
  std::ranges::transform(tests(), all.begin(), of);
  return std::ranges::minmax(all);
}

void four_tests(report::Item& item) {
  item.columns({"test",
                {"load, lbf", "{:.0f}"},
                {"area over Hertz's: true", "{:.2f}"},
                {"measured", "{:.3f}"},
                {"found from the curve", "{:.3f}"},
                {"found over measured", "{:.3f}"},
                {"standard deviation of the area found, %", "{:.1f}"},
                {"µ<sub>c</sub>: true", "{:.4f}"},
                {"µ<sub>c</sub>: fitted", "{:.4f}"}});
  item.rebuilt(synthetic);
  item.expect_checks(static_cast<int>(tests().size()));
  for (std::size_t k = 0; k < tests().size(); ++k) {
    const Test& test = tests()[k];
    const Average& mean = test.average;
    const std::string number = fmt::format("{}", k + 1);
    item.add_row(number, test.load / units::lbf, test.area_factor, test.area_measured,
                 mean.area_factor, mean.area_factor / test.area_measured,
                 100 * fitted_scatters()[k], test.friction, mean.friction);
    item.agree("factor-" + number, "area over Hertz's from the curve, test " + number, "",
               mean.area_factor, test.area_factor, 0.15,
               "the area put in, through 28 points with the errors listed above");
  }
  const auto by_hertz = range_of([](const Test& t) { return t.average.area_factor; });
  const auto by_measured =
      range_of([](const Test& t) { return t.average.area_factor / t.area_measured; });
  const auto off =
      range_of([](const Test& t) { return std::abs(t.average.area_factor / t.area_factor - 1); });
  report::values(item, "%", "{:.0f}", "spread-hertz", 100 * (by_hertz.max / by_hertz.min - 1),
                 "spread-true", 100 * (by_measured.max / by_measured.min - 1), "factor-error",
                 100 * off.max);
  report::values(item, "", "{:.3f}", "rms-hertz", scatter(false), "rms-true", scatter(true));
  const auto percent = [&](std::string_view id, std::ranges::minmax_result<double> range) {
    item.value(id, fmt::format("{:.1f} to {:.1f} %", 100 * range.min, 100 * range.max));
  };
  percent("factor-scatter", std::ranges::minmax(fitted_scatters()));
  percent("dispersion", range_of(dispersion));
  item.value("draws", static_cast<double>(repetitions), "", "{:.0f}");
}

}  // namespace

creep_chapter::ReductionError creep_chapter::reduction_error() {
  return {fitted_scatters()[1], area_error};
}

const report::Section creep_chapter::experiment{
    report::figure("fig-03", each_load), report::figure("fig-08", constant_creep),
    report::figure("fig-09", areas), report::figure("fig-11", dimensionless),
    report::table("table-collapse", four_tests)};
