/***
## A synthetic experiment

The measured points stand in the paper's figures only, which are lost to us. So the theory is taken for the truth, the errors the paper states are added, and the points reduced as the paper does. **Every point below is synthetic**, and the figures say so. What is assumed:

* four loads of 500, 1000, 1500 and 2500 lbf; the paper prints one, 4449.72 N or 1000 lb, and with the stress of its summary read as the mean pressure
  the largest is {{load-200-mean}};
* a largest friction of 0.5 at 1000 lbf, falling with the load to the power −{{exponent}};
* contact areas 1.1 to 1.9 times Hertz's, by wear, and measured with an error of 3 %;
* errors of 0.0005 in the creep (Appendix A) and 22.249 N in the force, both taken as two standard deviations.

The line through the points stands for the paper's average curve: the theory's, fitted with the largest friction and the area free.

{{fig-03}}

{{fig-04}}

{{fig-05}}

{{fig-06}}

{{fig-07}}

### Friction and area against the load

At constant creep the friction falls with the load. The area goes with $N^{2/3}$, so $X\propto\xi N^{-1/3}$, and in the linear part $\mu=\mu_cC_{11}X\propto N^{-1/3}$ whatever $\mu_c$ does; at
large creep $\mu=\mu_c(N)$. The paper's "almost parallel" lines ask for an exponent well below 1/3 there: slopes $-\frac13\mu_1/N$ and $-q\,\mu_2/N$ are equal for $q=\frac13\mu_1/\mu_2$. The paper says that "this trend is predicted" by Vermeulen and Johnson and by Kalker: it is, for small creep
{{outcome:fig-08/trend}}; the largest friction is an input of those theories and its trend is not in them {{outcome:fig-08/largest}}.

{{fig-08}}

Then the areas. For smooth new wheels they are Hertz's; for worn ones they are not.

{{fig-09}}

{{fig-10}}

## One curve for all

The paper's claim: with the actual area of contact all tests fall on one curve. Each synthetic point has a load, a force and a creep; the largest friction is that of its average
curve. Reduced with **Hertz's** area the four tests stay apart, each shifted by its own wear:

{{fig-11-hertz}}

Reduced with the **measured** area they fall on one line, and it is the theory's:

{{fig-11}}

{{table-collapse}}

In numbers: the factor that brings each test onto the curve spreads by {{spread-hertz}} with Hertz's area and by
{{spread-true}} with the measured one; the points scatter about the curve by {{rms-hertz}} against {{rms-true}} (root mean
square of $\mu/\mu_c$), and the second is what the errors of force, creep and area make by
themselves. The fit finds the contact area of a
test from its creep curve alone, without the replica tape, to {{factor-error}}. This shows what the reduction can do, not that the paper's own points did so.

The figure has two scales: the paper's $a$ and $b$ are **full axes** by its nomenclature and its equation (4), Kalker's are semi-axes.
*/

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "num/random_source.hpp"
#include "rig.hpp"
#include "rolling/creep_laws.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

constexpr const char* synthetic =
    "the paper's measured points are lost; these are synthetic, made from the theory and the "
    "stated errors";
constexpr double creep_error = 0.0005 / 2, force_error = 22.249 / 2, area_error = 0.03;

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

// One test, at one load with one pair of wheels; its area over Hertz's, by wear, true and as measured.
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
  for (int pass = 0; pass < 40; ++pass) {
    double num = 0, den = 0;
    for (const Point& p : test.points) {
      const double f = mean.mu(test.load, p.creep) / mean.friction;
      num += f * p.mu, den += f * f;
    }
    mean.friction = num / den;
  }
  return mean;
}

// Golden section on the area factor: the sum of squares has one valley.
Average fitted(const Test& test) {
  const auto squares = [&](double area_factor) {
    const Average mean = with_area(test, area_factor);
    double sum = 0;
    for (const Point& p : test.points) sum += std::pow(p.mu - mean.mu(test.load, p.creep), 2);
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

template <std::size_t which>
void one_load(report::Item& item) {
  const Test& test = tests()[which];
  auto& curve = item.data({"creep", "mu"});
  auto& points = item.data("points", {"creep", "mu"});
  for (int i = 0; i <= 200; ++i) curve.add(1e-4 * i, test.average.mu(test.load, 1e-4 * i));
  for (const Point& p : test.points) points.add(p.creep, p.mu);
  item.script("load.gp");
  item.rebuilt(synthetic);
}

void all_loads(report::Item& item) {
  auto& curves = item.data({"creep", "mu_500", "mu_1000", "mu_1500", "mu_2500"});
  for (int i = 0; i <= 200; ++i) {
    const auto mu = [&](std::size_t k) { return tests()[k].average.mu(tests()[k].load, 1e-4 * i); };
    curves.add(1e-4 * i, mu(0), mu(1), mu(2), mu(3));
  }
  item.rebuilt(synthetic);
  item.value("exponent", friction_exponent, "", "{:.2f}");
}

void constant_creep(report::Item& item) {
  auto& lines = item.data({"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  auto& points = item.data("points", {"load_lbf", "mu_0005", "mu_001", "mu_002", "mu_004", "mu_c"});
  const auto add = [](report::Data& data, double load, const Average& a) {
    data.add(load / units::lbf, a.mu(load, 0.0005), a.mu(load, 0.001), a.mu(load, 0.002),
             a.mu(load, 0.004), a.friction);
  };
  const auto worn = [](double load) {  // one wear for all loads: the lines are smooth
    return Average{synthetic_friction(load), 1.5};
  };
  for (double load = 400; load <= 2700; load += 20)
    add(lines, load * units::lbf, worn(load * units::lbf));
  for (const Test& test : tests()) add(points, test.load, test.average);
  item.rebuilt("loads, friction and wear are not printed; those used are stated above");
  item.expect_checks(2);
  const auto exponent = [&](double creep) {
    const double n = paper_load, up = 1.01 * n;
    return std::log(worn(up).mu(up, creep) / worn(n).mu(n, creep)) / std::log(1.01);
  };
  item.claim(
      "trend", "the fall of friction with the load is predicted by the theories, at small creep",
      std::abs(exponent(1e-6) + 1.0 / 3) < 1e-3, fmt::format("exponent {:.4f}", exponent(1e-6)));
  item.refute("largest", "the theories predict the fall of the largest friction",
              std::abs(exponent(0.1) + friction_exponent) < 2e-3,
              fmt::format("in full slip the exponent is that of the friction put in, {:.3f}",
                          exponent(0.1)));
}

// [mm^2] at a load [lbf]
double hertz_area(double load, bool major_along_rolling) {
  const auto c =
      rig_contact(std::max(load, 1e-3) * units::lbf, profile_radius(major_along_rolling));
  return units::pi * c.a * c.b / 1e-6;
}

void smooth_areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2", "across_mm2"});
  for (double load = 0; load <= 3000; load += 25)
    line.add(load, hertz_area(load, true), hertz_area(load, false));
  item.rebuilt("Hertz's lines for the material and radii used; the paper's points are lost");
}

void worn_areas(report::Item& item) {
  auto& line = item.data({"load_lbf", "area_mm2"});
  auto& points = item.data("points", {"load_lbf", "area_mm2", "test"});
  for (double load = 0; load <= 3000; load += 25) line.add(load, hertz_area(load, true));
  int number = 0;
  for (const Test& test : tests())
    points.add(test.load / units::lbf,
               hertz_area(test.load / units::lbf, true) * test.area_measured,
               fmt::format("test {}: {:.2f}", ++number, test.area_measured));
  item.rebuilt("Hertz's line is exact for the material and radii used; the points are synthetic");
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

template <bool measured_area>
void dimensionless(report::Item& item) {
  auto& curves = item.data({"x", "full", "fastsim", "vermeulen_johnson"});
  auto& points = item.data("points", {"x", "f", "test"});
  for (int i = 0; i <= 250; ++i) {
    const double x = 1.25 * i / 250;
    const auto c = with_reduced_creepage(rolling::unit_case(axis_ratio, poisson), {x, 0, 0});
    curves.add(x, master_curve(x), creep_forces(Theory::fastsim, c).fx,
               creep_forces(Theory::vermeulen_johnson, c).fx);
  }
  each_reduced(measured_area, [&](double x, double share, const Test& test) {
    points.add(x, share, std::round(test.load / units::lbf));
  });
  item.script("dimensionless.gp");
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

void four_tests(report::Item& item) {
  item.columns({"test",
                {"load, lbf", "{:.0f}"},
                {"area over Hertz's: true", "{:.2f}"},
                {"measured", "{:.3f}"},
                {"found from the curve", "{:.3f}"},
                {"μ_c: true", "{:.4f}"},
                {"fitted", "{:.4f}"},
                {"over the measured", "{:.3f}"}});
  std::vector<double> by_hertz, by_measured, off;
  item.expect_checks(static_cast<int>(tests().size()));
  for (const Test& test : tests()) {
    const Average& mean = test.average;
    by_hertz.push_back(mean.area_factor);
    by_measured.push_back(mean.area_factor / test.area_measured);
    off.push_back(std::abs(mean.area_factor / test.area_factor - 1));
    const std::string number = fmt::format("{}", off.size());
    item.add_row(number, test.load / units::lbf, test.area_factor, test.area_measured,
                 mean.area_factor, test.friction, mean.friction, by_measured.back());
    item.agree("factor-" + number, "area over Hertz's from the curve, test " + number, "",
               mean.area_factor, test.area_factor, 0.15,
               "the area put in, through 28 points with the stated errors");
  }
  const auto spread = [](const std::vector<double>& shifts) {
    const auto [low, high] = std::ranges::minmax(shifts);
    return 100 * (high / low - 1);
  };
  item.rebuilt(synthetic);
  item.value("spread-hertz", spread(by_hertz), "%", "{:.0f}");
  item.value("spread-true", spread(by_measured), "%", "{:.0f}");
  item.value("rms-hertz", scatter(false), "", "{:.3f}");
  item.value("rms-true", scatter(true), "", "{:.3f}");
  item.value("factor-error", 100 * std::ranges::max(off), "%", "{:.0f}");
}

}  // namespace

const report::Section creep_chapter::experiment{
    report::figure("fig-03", "Friction against creep at 500 lbf (synthetic)", one_load<0>),
    report::figure("fig-04", "Friction against creep at 1000 lbf (synthetic)", one_load<1>),
    report::figure("fig-05", "Friction against creep at 1500 lbf (synthetic)", one_load<2>),
    report::figure("fig-06", "Friction against creep at 2500 lbf (synthetic)", one_load<3>),
    report::figure("fig-07", "All average curves (synthetic)", all_loads),
    report::figure("fig-08", "Friction at constant creep against the load", constant_creep),
    report::figure("fig-09", "Contact area of smooth new wheels", smooth_areas),
    report::figure("fig-10", "Contact area in four tests", worn_areas),
    report::figure("fig-11-hertz", "The dimensionless curve with Hertz's area (synthetic)",
                   dimensionless<false>),
    report::figure("fig-11", "The dimensionless curve with the measured area (synthetic)",
                   dimensionless<true>),
    report::table("table-collapse", "Four tests on one curve", four_tests)};
