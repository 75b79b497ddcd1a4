/***
A reference must be known 100 times better than what it judges; what lies below that is drawn grey, and the sentences ask for no more. Two cases are known that well, and lie at the two ends of
rolling contact: Carter's line contact, which sticks and slides but has no width, and the slopes at no creepage, where an ellipse of any shape sticks all over. Between them, on the
paper's curve and with spin, only limits of ever finer grids exist. All panels of the chapter have the same axes. Times are those of the whole set of cases, with what the method must set up; only tables are made beforehand, as
the codes that use them do.

### Carter's line contact

{{line-time}}

{{line-answer}} One row of cells, made a million times as wide, against $\xi\propto1-\sqrt{1-Q/\mu P}$. Cells that just fill the contact, as in most programs, stay of first order; with the ends placed they
are of second.

### The slopes at no creepage

{{slope-time}}

{{slope-answer}} Mean relative error of $C_{11}$, $C_{22}$, $C_{23}$ and $C_{33}$ at a/b = 0.55, 1.568 and 3, against polynomials of degree {{slope-degree}}, known by their own
estimate; a test holds them against grids and against Kalker's print.

### The paper's curve

{{curve-time}}

{{curve-answer}} Laws in closed form are one to three per cent off, for a thousandth of the time. The reference is what grids of up to 48 x 48 cells, solved by transforms, tend to, with the order that fits best. It is known to
{{curve-uncertainty}}, by how the limit moves when a grid is left out, and fitted rows solved with a matrix tend to the same within the uncertainties of both. {{outcome:curve-time/routes}} The full theory's own
cells are therefore grey: that they converge is seen in the two panels above.

### With spin, round and slender

{{spin-fx}}

{{spin-fx-answer}}

{{spin-fy}}

{{spin-fy-answer}}

{{spin-mz}}

{{spin-mz-answer}} Six cases: a/b = 0.5, 1.568 and 3, each with a spin that bends the tractions and one that turns them. The reference is made as that of the curve. {{outcome:spin-fx/routes}} Each fast theory has one error, its
own; FASTSIM's cells do not buy more than that. Transforms give the answers of the matrix: they cost more below some 20 cells along and less above.

{{work-precision: line-time}}

{{work-precision: slope-time}}

{{work-precision: curve-time}}

{{work-precision: spin-fx}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <list>

#include "../curve.hpp"
#include "../rig.hpp"
#include "../sections.hpp"
#include "bench/limit.hpp"
#include "bench/work_precision.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "rolling/rolling_parts.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

using Law = std::function<CreepForces(const RollingCase&)>;
using LawOf = std::function<Law(double axis_ratio)>;  // what is set up for an ellipse
using Answers = std::vector<double>;  // of each case fx and fy over mu N, mz over mu N sqrt(a b)
using Errors = std::array<double, 3>;

// Reduced creepages on ellipses of several shapes.
using Cases = std::vector<std::pair<double, std::vector<Creepage>>>;

Answers solved(const Cases& cases, const LawOf& law) {
  Answers all;
  for (const auto& [ratio, creepages] : cases) {
    const Law solve = law(ratio);
    for (const Creepage& c : creepages) {
      const CreepForces f = solve(with_reduced_creepage(unit_case(ratio, poisson), c));
      if (!f.converged) throw std::runtime_error(f.reason);
      all.insert(all.end(), {f.fx, f.fy, f.mz});
    }
  }
  return all;
}

LawOf full(const RollingOptions& options) {
  return [options](double ratio) -> Law {
    const auto contact = std::make_shared<EllipseRolling>(ratio, poisson, options);
    return [contact](const RollingCase& c) { return contact->solve(c); };
  };
}

LawOf square(int n, bool placed) {
  return full({.along = n, .rows = n, .remedy = placed});
}

// Cells as they are, nothing extrapolated: rows fitted to the ellipse, or rows of one length of cell.
LawOf on_cells(Eigen::Index n, bool one_length, bool matrix) {
  return [=](double ratio) -> Law {
    const auto grid = std::make_shared<RollingGrid>(ellipse_grid(ratio, n, n, true, one_length));
    const auto influence = std::make_shared<TangentialInfluence>(grid->mesh, poisson, matrix);
    return [=](const RollingCase& c) {
      return in_units(*grid, solve_on(*influence, *grid, reduced_creepage(c), {}), 1, 1);
    };
  };
}

LawOf formula(Theory theory) {
  return [=](double ratio) -> Law {
    return [=, k = kalker_table(ratio, poisson)](const RollingCase& c) {
      return creep_forces(theory, c, k);
    };
  };
}

LawOf fastsim_cells(int n) {
  return [=](double ratio) -> Law {
    return [=, k = kalker_table(ratio, poisson)](const RollingCase& c) {
      return fastsim_grid(c, k, {.along = n, .strips = n});
    };
  };
}

LawOf looked_up(const ForceTable& table) {
  return [&table](double ratio) -> Law {
    return [&table, ratio](const RollingCase& c) {
      const ForceShares s = table.at(ratio, reduced_creepage(c));
      CreepForces f;
      f.fx = s.fx, f.fy = s.fy, f.mz = s.mz, f.converged = true;
      return f;
    };
  };
}

// Means over the cases of each quantity's distance, or of its uncertainty.
Errors mean(const Answers& all, const Answers& from = {}) {
  Errors sum{};
  for (std::size_t k = 0; k < all.size(); ++k)
    sum[k % 3] += std::abs(all[k] - (from.empty() ? 0 : from[k]));
  for (double& e : sum) e *= 3 / static_cast<double>(all.size());
  return sum;
}

bench::Limit limit_of(const Cases& cases, const std::vector<int>& sizes, bool one_length) {
  std::vector<bench::Grid> ladder;
  for (const int n : sizes)
    ladder.push_back({1.0 * n, solved(cases, on_cells(n, one_length, !one_length))});
  return bench::limit_of(ladder);
}

// One set of cases by all methods; a method's error is its mean distance from the limit.
struct Study {
  Cases cases;
  bench::Limit limit = {};
  double routes =
      0;  // distance of the limits of two meshes with two solvers over their uncertainties
  std::vector<bench::Method> methods = {};
  std::vector<report::WorkPrecision> points = {};

  Study(Cases all, bool finer) : cases(std::move(all)) {
    const std::vector<int> sizes{20, 26, 32, 40, 48}, fitted{12, 14, 16, 18, 20};
    limit = limit_of(cases, finer ? std::vector{32, 40, 48, 64, 80} : sizes, true);
    const bench::Limit other = limit_of(cases, finer ? std::vector{16, 20, 24, 28} : fitted, false);
    const Errors off = mean(limit.answers, other.answers), a = mean(limit.uncertainty),
                 b = mean(other.uncertainty);
    for (std::size_t q = 0; q < 3; ++q)
      if (off[q] > 0) routes = std::max(routes, off[q] / (a[q] + b[q]));
  }
  // Errors of quantities that are 1.
  bench::Setting setting(const std::string& label, const LawOf& law, double work = 1) const {
    return {label, [this, law, work] {
              const Errors e = mean(solved(cases, law), limit.answers);
              return bench::Outcome{{1 + e[0], 1 + e[1], 1 + e[2]},
                                    work * static_cast<double>(limit.answers.size()) / 3,
                                    true,
                                    {}};
            }};
  }
  void add(std::initializer_list<Theory> theories) {
    for (const Theory theory : theories)
      methods.push_back({std::string(name(theory)), {setting("", formula(theory))}});
  }
  template <class LawAt>
  void add(const std::string& name, std::initializer_list<int> sizes, const LawAt& law_at) {
    bench::Method method{name, {}, 0, "cells times cases"};
    for (const int n : sizes)
      method.settings.push_back(setting(fmt::format("{0}x{0}", n), law_at(n), n * n));
    methods.push_back(method);
  }
  void measure(const report::Item& item) {
    std::vector<bench::Reference> references;
    for (std::size_t q = 0; q < 3; ++q)
      references.push_back({quantities[q], 1, mean(limit.uncertainty)[q]});
    points = bench::measure(item.id(), references, methods, item.timings(), 0.05);
  }
  void check(report::Item& item) const {
    item.expect_checks(1);
    item.at_most("routes", "limits of two meshes and solvers, apart over their uncertainties", "",
                 routes, 1, "rows of one length by transforms, fitted rows by a matrix");
  }
  static constexpr const char* quantities[] = {"fx", "fy", "mz"};
};

constexpr bench::Axes axes{
    .error_low = 1e-6, .error_high = 1, .seconds_low = 1e-7, .seconds_high = 10};

void show(report::Item& item, const std::vector<report::WorkPrecision>& points,
          const std::vector<bench::Method>& methods, const std::string& quantity,
          std::initializer_list<double> errors, const std::string& answer) {
  item.added("a study of methods");
  bench::show(item, points, quantity, methods, axes);
  item.value(answer, bench::answer(points, quantity, errors));
}

// Mean error of Q/(mu P) for nine creepages of a line contact: the row of an ellipse, made a million times as wide.
double line_error(int n, bool placed) {
  RollingGrid grid = ellipse_grid(1.5, n, 1, placed);  // half length 1
  const double p_0 = grid.bound.sum() * grid.mesh.dx[0] / (units::pi / 2);
  grid.mesh.dy *= 1e6;
  const TangentialInfluence influence(grid.mesh, poisson, true);
  double sum = 0;
  for (int k = 1; k < 10; ++k) {
    const double share = 0.1 * k, creepage = 2 * (1 - poisson) * p_0 * (1 - std::sqrt(1 - share));
    const StickSlip s = solve_on(influence, grid, {creepage, 0, 0}, {.remedy = placed});
    if (!s.converged) throw std::runtime_error("stick and slip did not settle");
    sum += std::abs(s.p.head(n).sum() / grid.bound.sum() - share) / 9;
  }
  return sum;
}

void line_time(report::Item& item) {
  const auto cells = [](bool placed) {
    return [placed](int n) {
      return bench::Outcome{{1 + line_error(n, placed)}, 9.0 * n, true, {}};
    };
  };
  const std::vector<bench::Method> methods{
      bench::sweep("ends placed", {8, 12, 16, 24, 32, 48, 64}, cells(true))
          .counts("cells times cases"),
      bench::sweep("cells fill the contact", {8, 12, 16, 24, 32, 48, 64}, cells(false))
          .counts("cells times cases")};
  const double width = 1e-12;  // the square of length over width is what the line leaves out
  const auto points = bench::measure(item.id(), {{"Q", 1, width}}, methods, item.timings(), 0.05);
  show(item, points, methods, "Q", {1e-2, 1e-3, 1e-4}, "line-answer");
  item.expect_checks(2);
  item.at_least("second", "order in the cells, ends placed", "",
                -bench::observed_slope(points, "Q", "ends placed"), 1.7, "second order is claimed");
  item.at_most("first", "order in the cells, cells that fill the contact", "",
               -bench::observed_slope(points, "Q", "cells fill the contact"), 1.2,
               "first order is known of them");
}

using Slopes4 = Eigen::Array4d;
Slopes4 slopes(const KalkerCoefficients& k) {
  return {k.c11, k.c22, k.c23, k.c33};
}
Slopes4 slopes_on_cells(double ratio, int n) {
  const Law solve = on_cells(n, false, true)(ratio);
  const auto at = [&](const Creepage& c) {
    return solve(with_reduced_creepage(unit_case(ratio, poisson), c));
  };
  const double e = 1e-6;  // sticks all over
  const CreepForces spin = at({0, 0, e});
  return Slopes4{at({e, 0, 0}).fx, at({0, e, 0}).fy, spin.fy, spin.mz} / e;
}

void slope_time(report::Item& item) {
  const double ratios[] = {0.55, axis_ratio, 3};
  const int degree = item.full() ? 40 : 32;
  std::vector<Slopes4> exact;
  double uncertainty = 0;
  for (const double ratio : ratios) {
    const ComputedCoefficients k = kalker_coefficients(ratio, poisson, degree);
    exact.push_back(slopes(k));
    uncertainty = std::max(uncertainty, k.error);
  }
  const auto method = [&](const auto& slopes_by) {
    return [&, slopes_by](int n) {
      double sum = 0;
      for (std::size_t k = 0; k < exact.size(); ++k)
        sum += (slopes_by(ratios[k], n) / exact[k] - 1).abs().mean() / 3;
      return bench::Outcome{{1 + sum}, 3.0 * n * n, true, {}};
    };
  };
  const auto by_table = method([](double r, int) { return slopes(kalker_table(r, poisson)); });
  const auto by_degree =
      method([](double r, int n) { return slopes(kalker_coefficients(r, poisson, n)); });
  const auto by_cells = method(slopes_on_cells);
  std::vector<bench::Method> methods{
      {"polynomials", {}, 0, "degree squared"},
      {"cells", {}, 0, "cells times cases"},
      {"Kalker's printed table", {{"", [=] { return by_table(1); }}}}};
  for (const int n : {4, 6, 8, 10, 12, 16})
    methods[0].settings.push_back({fmt::format("degree {}", n), [=] { return by_degree(n); }});
  for (const int n : {4, 6, 8, 12, 16})
    methods[1].settings.push_back({fmt::format("{0}x{0}", n), [=] { return by_cells(n); }});
  const auto points =
      bench::measure(item.id(), {{"slope", 1, uncertainty}}, methods, item.timings(), 0.05);
  show(item, points, methods, "slope", {1e-2, 1e-3}, "slope-answer");
  item.value("slope-degree", fmt::format("{}", degree));
}

void curve_time(report::Item& item) {
  std::vector<Creepage> creepages;
  for (const double x : {.04, .1, .2, .3, .4, .6}) creepages.push_back({x, 0, 0});
  Study study({{axis_ratio, creepages}}, item.full());
  study.add("full theory", {4, 6, 8, 12, 16}, [](int n) { return square(n, true); });
  study.add("cells fill the contact", {6, 8, 12, 16}, [](int n) { return square(n, false); });
  study.add({Theory::fastsim, Theory::fastrip, Theory::shen_hedrick_elkins, Theory::polach,
             Theory::vermeulen_johnson});
  study.methods.push_back({"table of the full theory", {}});
  std::list<ForceTable> tables;
  for (const int n : {9, 17, 33}) {
    tables.push_back(curve_table(n, {.along = 12, .rows = 8}));
    study.methods.back().settings.push_back(
        study.setting(fmt::format("{} nodes", n), looked_up(tables.back())));
  }
  study.measure(item);
  show(item, study.points, study.methods, "fx", {5e-2, 2e-2}, "curve-answer");
  study.check(item);
  item.value("curve-uncertainty", mean(study.limit.uncertainty)[0], "", "{:.0e}");
}

const Study& spinning(const report::Item& item) {
  static Study study = [&] {
    const std::vector<Creepage> creepages{{0.1, 0.05, 0.3}, {0.05, -0.1, 1.5}};
    return Study({{0.5, creepages}, {axis_ratio, creepages}, {3, creepages}}, item.full());
  }();
  static const ForceTable table({0.5, 3, 4, 0.5, 2, 5, 5, 9}, [](double ratio) {
    return shares_of(full({.along = 6, .rows = 6, .estimate = false})(ratio), ratio, poisson);
  });
  if (!study.points.empty()) return study;
  study.add("full theory", {4, 6, 8, 12, 16}, [](int n) { return square(n, true); });
  study.add("rows of one length and a matrix", {8, 12, 16},
            [](int n) { return on_cells(n, true, true); });
  study.add("the same by transforms", {8, 12, 16, 24},
            [](int n) { return on_cells(n, true, false); });
  study.add("fastsim", {5, 10, 20, 40}, fastsim_cells);
  study.add({Theory::shen_hedrick_elkins, Theory::polach});
  study.methods.push_back(
      {"table of the full theory", {study.setting("900 nodes", looked_up(table))}});
  study.measure(item);
  return study;
}

template <int quantity>
void spin(report::Item& item) {
  const Study& s = spinning(item);
  show(item, s.points, s.methods, Study::quantities[quantity], {3e-1, 3e-2}, item.id() + "-answer");
  if (quantity == 0) s.check(item);
}

}  // namespace

const report::Section creep_chapter::cost{
    report::figure("line-time", "Carter's line contact: error against run time", line_time),
    report::figure("slope-time", "Kalker's coefficients: error against run time", slope_time),
    report::figure("curve-time", "Mean error of f over the curve against run time", curve_time),
    report::figure("spin-fx", "Mean error of fx with spin against run time", spin<0>),
    report::figure("spin-fy", "Mean error of fy with spin against run time", spin<1>),
    report::figure("spin-mz", "Mean error of mz with spin against run time", spin<2>)};
