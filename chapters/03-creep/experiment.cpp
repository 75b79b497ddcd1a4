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
*/

#include "experiment.hpp"

#include <cmath>

#include "curve.hpp"
#include "num/random_source.hpp"
#include "rig.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::creep_chapter;

namespace {

constexpr double creep_error = 0.0005 / 2, force_error = 22.249 / 2, area_error = 0.03;
constexpr int points_a_test = 28;

// Stream k of the random numbers is test k's.
Test make_test(double load, double area_factor, std::uint64_t stream) {
  const num::RandomSource random(1979, stream);
  Test test{.load = load,
            .friction = synthetic_friction(load),
            .area_factor = area_factor,
            .area_measured = area_factor * (1 + area_error * random.normal(1000))};
  const double group = area_factor * hertz_group(load) / test.friction;  // X per creep
  for (int i = 0; i < points_a_test; ++i) {
    const auto k = static_cast<std::uint64_t>(2 * i);
    const double x = 1.1 * (i + 0.5) / points_a_test;
    const double mu = test.friction * master_curve(x) + force_error / load * random.normal(k + 1);
    test.points.push_back({x / group + creep_error * random.normal(k), mu});
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

double residual(const Test& test, const Average& mean) {
  double sum = 0;
  for (const Point& p : test.points) sum += std::pow(p.mu - mean.mu(test.load, p.creep), 2);
  return sum;
}

// Golden section on the area factor: the residual has one valley.
Average fitted(const Test& test) {
  double low = 0.5, high = 4;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  while (high - low > 1e-4) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    const bool below =
        residual(test, with_area(test, left)) < residual(test, with_area(test, right));
    (below ? high : low) = below ? right : left;
  }
  return with_area(test, (low + high) / 2);
}

}  // namespace

double creep_chapter::synthetic_friction(double load) {
  return 0.5 * std::pow(load / paper_load, -friction_exponent);
}

double creep_chapter::hertz_group(double load) {
  const auto c = rig_contact(load, profile_radius(true));
  return shear_modulus * c.a * c.b / load;
}

double creep_chapter::Average::mu(double load, double creep) const {
  return friction * master_curve(area_factor * hertz_group(load) * creep / friction);
}

const std::vector<Test>& creep_chapter::tests() {
  static const std::vector<Test> all = [] {
    std::vector<Test> four{make_test(500 * units::lbf, 1.3, 1), make_test(paper_load, 1.6, 2),
                           make_test(1500 * units::lbf, 1.1, 3),
                           make_test(2500 * units::lbf, 1.9, 4)};
    for (Test& test : four) test.average = fitted(test);
    return four;
  }();
  return all;
}

namespace {

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

}  // namespace

const report::Section creep_chapter::experiment{
    report::figure("fig-03", "Friction against creep at 500 lbf (synthetic)", one_load<0>),
    report::figure("fig-04", "Friction against creep at 1000 lbf (synthetic)", one_load<1>),
    report::figure("fig-05", "Friction against creep at 1500 lbf (synthetic)", one_load<2>),
    report::figure("fig-06", "Friction against creep at 2500 lbf (synthetic)", one_load<3>),
    report::figure("fig-07", "All average curves (synthetic)", all_loads)};
