/***
Which theory gives a creep force to one per cent, or to a tenth of that, in the least time, and what
does it cost to set up? For an ellipse that sticks and slides there is no closed form, only the
limit of ever finer grids. The best method stands at the lower left of a panel. An error is the mean
over six cases of the distance from that limit, over $\mu_cN$ for a force and over
$\mu_cN\sqrt{ab}$ for the moment; panels and tables call it the relative error, and one case can be
several times worse. A time is that of all six cases, with what the method must set up for them;
panels, tables and advice have the median of the runs. Tables of the full theory are the exception:
they are made beforehand, and what that costs is said below the panel. Points are grey where the
reference is not at least 100 times as accurate. The advice may use them, since it adds the
uncertainty of the reference to each error.

**What the reference shares with what it judges.** It is made by this library: the same formula for
the displacements and the same law of slip, on other meshes, by another solver and without the
extrapolation of the full theory. Its stated accuracy is therefore how well our grids agree with
each other. Outside evidence ends earlier: a separate program with the same theory, good to 0.0005
by its own account, differs from the reference by {{outside-apart}} at most. So nothing outside of
this library confirms errors below that. Where closed forms exist, tests hold the solver to them:
Carter's line contact, Kalker's coefficients, full slip.

### Which theory for creep along the track alone?

*Cells fill the contact* in the panel is the full theory without placing the ends of its rows (first
page).

{{curve-time}}

{{curve-time-answer}} The closed formulas and the tables cost about the same (for one force divide
by six), so take a table where its one ratio of axes is yours, and a formula otherwise. All this is
for one ratio of axes, 1.568, and holds without spin only: with it the same formulas are far worse,
as the next section shows. Making the table of 33 nodes took {{curve-making}}; it pays if many more
than 33 forces are wanted.

The laws *shen-hedrick-elkins*, *polach*, *fastsim* and *fastrip* have Kalker's slope at small creep
and are one to three per cent off, for less than a hundredth of the time of the full theory.
Vermeulen and Johnson's law has another slope, and the linear theory no limit of friction.

The reference is what grids of 96 to 224 cells a side tend to, with the order of convergence that
fits best; that takes a quarter of an hour and was done once (`tests/reference/rolling_limits.cpp`).
We tried the limit in three ways: we left out one grid, left out the coarser half of them, and
fitted an order of its own to each force. It moved by at most {{curve-uncertainty}}. Two other ways
to make the limit are repeated here at each run: grids of {{limit-grids}} cells by Fourier
transforms, and rows fitted to the ellipse by a matrix. Both tend to the same limit
{{outcome:curve-time/routes}}. They differ from it far less than the methods that it judges do
{{outcome:curve-time/judges}}.

### Which theory when the wheel also spins?

The ratio of the semi-axes along and across is a/b = 0.5, 1.568 and 3. Each ellipse has two cases:
$X$ = 0.1 with a lateral creepage of 0.05 and a spin $\Phi$ of 0.3, which bends the tractions, and
0.05, −0.1 and 1.5, which turns them round. The reference is made in the same way
({{outcome:spin-fx/routes}}, {{outcome:spin-fx/judges}}).

*One length* in the next panels are grids without estimate or extrapolation, whose cells have one
length in all rows. They are a part of the solver and not a choice of the tool.

{{spin-fx}}

{{spin-fx-answer}}

{{spin-fy}}

{{spin-fy-answer}}

{{spin-mz}}

{{spin-mz-answer}}

Only the full theory keeps 5 % in all three, from 4 x 4 cells on. The advice leaves the table of
900 nodes out, since the six cases flatter it: two of their three
ellipses have the a/b of nodes. At {{spin-table-places}} other places of its range its forces differ
from the full theory on 12 x 12 cells by {{spin-table-rms}} of the friction limit (root mean square)
and by {{spin-table-most}} at most. Where that is enough it is by far the quickest. Making it took
{{spin-making}}, on 6 x 6 cells.

{{one-length-answer}} FASTRIP has no spin and is not shown. Vermeulen and Johnson's law leaves spin
out, and the linear theory has no limit of friction; both are shown only because the tool offers
them, and it warns that they are out of their range here. **More than 10 x 10 cells do not make FASTSIM better.** From 5 x 5 to 40 x 40
cells its error of the longitudinal force falls from {{fastsim-fx-5}} to {{fastsim-fx-40}}, but that
of the lateral force grows from {{fastsim-fy-5}} to {{fastsim-fy-40}}: coarse cells cancel a part of
the error of the theory itself.

### How fast does the full theory converge, and where is it slow?

{{spin-cells}}

**The order is not 2 in the end.** The order that fits best to grids of {{limit-grids}} cells is
{{curve-order}} without spin (not drawn), but on the grids of the reference, 96 to 224 cells, it is
{{curve-order-fine}}; with spin the two are {{spin-order}} and {{spin-order-fine}}. A fit of the
order 2 to coarse grids must not be used to extrapolate fine ones, and each limit here takes the
order of its own grids. With spin the error of a single case follows no power of the cell. Leaving
out one grid at a time hides how uncertain the limit is; leaving out the coarser half, or fitting
each force by itself, shows it. {{spin-worst}}

{{work-precision: curve-time}}

{{work-precision: spin-fx}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <list>

#include <railbook/bench/limit.hpp>
#include <railbook/bench/timing.hpp>
#include <railbook/bench/work_precision.hpp>
#include <railbook/num/stopwatch.hpp>
#include <railbook/report/values.hpp>
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/parts.hpp>

#include "../rig.hpp"

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
      const CreepForces f = solve(with_reduced_creepage(normalised_case(ratio, poisson), c));
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

LawOf full_cells(int n) {
  return full({.along = n, .rows = n});
}

// Cells as they are, nothing extrapolated: rows fitted to the ellipse, or rows of one length of
// cell.
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

using Ladder = std::vector<bench::Grid>;

Ladder ladder_of(const Cases& cases, const std::vector<int>& sizes, bool one_length) {
  Ladder ladder;
  for (const int n : sizes)
    ladder.push_back({1.0 * n, solved(cases, on_cells(n, one_length, !one_length))});
  return ladder;
}

// A set of data/limits.csv: its cases, and what tests/reference/rolling_limits.cpp found that they
// tend to.
struct Known {
  Cases cases;
  bench::Limit limit;

  Known(const report::Item& item, std::string_view set) {
    const table::CsvTable file = item.printed("limits.csv");
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
      if (file.at(row, "set") != set) continue;
      const auto at = [&](const char* column) {
        return report::printed_number(file.at(row, column));
      };
      if (cases.empty() || cases.back().first != at("ratio")) cases.push_back({at("ratio"), {}});
      cases.back().second.push_back({at("longitudinal"), at("lateral"), at("spin")});
      for (const char* force : {"fx", "fy", "mz"}) limit.answers.push_back(at(force));
      for (const char* known : {"fx_known", "fy_known", "mz_known"})
        limit.uncertainty.push_back(at(known));
      limit.order = at("order");
    }
  }
};

// Coarse grids to be judged, then those that are extrapolated here.
constexpr int coarse = 4;
std::vector<int> sizes(bool full) {
  return full ? std::vector{6, 8, 12, 16, 48, 56, 64, 72, 80, 88, 96, 104, 112}
              : std::vector{6, 8, 12, 16, 24, 28, 32, 36, 40, 44, 48, 56, 64};
}

// One set of cases by all methods; a method's error is its mean distance from the limit.
struct Study : Known {
  Ladder ladder = {};
  double order = 0;  // of the ladder
  // Distance of the limits of two meshes and solvers from the reference, over the uncertainties and
  // over the error of 16 x 16 cells.
  double routes = 0, share = 0;
  std::vector<bench::Method> methods = {};
  std::vector<report::WorkPrecision> points = {};
  bool spins = false;

  Study(const report::Item& item, std::string_view set)
      : Known(item, set), ladder(ladder_of(cases, sizes(item.full()), true)), spins(set == "spin") {
    const bench::Limit here = bench::limit_of({ladder.begin() + coarse, ladder.end()});
    order = here.order;
    meet(here);
    meet(bench::limit_of(ladder_of(
        cases,
        item.full() ? std::vector{20, 24, 28, 32, 36, 40} : std::vector{16, 18, 20, 22, 24, 28, 32},
        false)));
  }
  void meet(const bench::Limit& other) {
    const Errors off = mean(limit.answers, other.answers), a = mean(limit.uncertainty),
                 b = mean(other.uncertainty),
                 judged = mean(ladder[coarse - 1].answers, limit.answers);
    for (std::size_t q = 0; q < 3; ++q) {
      if (judged[q] < 1e-9) continue;  // along rolling alone there is neither fy nor mz
      routes = std::max(routes, off[q] / (a[q] + b[q]));
      share = std::max(share, off[q] / judged[q]);
    }
  }
  // Of the answers of a grid for one case from their limits.
  Errors distance(const bench::Grid& grid, std::size_t k) const {
    Errors off{};
    for (std::size_t q = 0; q < 3; ++q)
      off[q] = std::abs(grid.answers[3 * k + q] - limit.answers[3 * k + q]);
    return off;
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
      method.settings.push_back(setting(fmt::format("{0} x {0} cells", n), law_at(n), n * n));
    methods.push_back(method);
  }
  void measure(const report::Item& item) {
    std::vector<bench::Reference> references;
    for (std::size_t q = 0; q < 3; ++q)
      references.push_back({quantities[q], 1, mean(limit.uncertainty)[q]});
    points = bench::measure(item.id(), references, methods, item.timings(), 0.05);
  }
  // The panel of quantity q, and the check of the reference beside the first.
  void show(report::Item& item, std::size_t q, std::initializer_list<double> asked) const {
    item.added("a study of methods");
    bench::show(item, points, quantities[q], methods,
                {.error_low = 1e-4, .error_high = 3, .seconds_low = 3e-7, .seconds_high = 0.3});
    // Rows of one length are a part of the solver and not offered by the tool, and a table with spin
    // is not to be judged at its own nodes.
    auto offered = points;
    std::erase_if(offered, [&](const auto& p) {
      return p.method.starts_with("one length") || (spins && p.method.starts_with("table"));
    });
    item.value(item.id() + "-answer", bench::answer(offered, quantities[q], asked));
    if (q > 0) return;
    item.expect_checks(2);
    item.at_most("routes",
                 "two other extrapolations: distance from the limit used, over the sum of the "
                 "uncertainties",
                 "", routes, 2, "rows of one length by transforms, fitted rows by a matrix");
    item.at_most(
        "judges",
        "two other extrapolations: distance from the limit used, over the error of 16 x 16 cells",
        "", share, 0.5, "the reference must be nearer to the truth than what it judges");
  }
  // How long the grids of one length take beside the full theory.
  std::string one_length_answer(bool timings) const {
    if (!timings) return "(The grids were not timed.)";
    const auto of = [&](const char* method, const char* setting) {
      const auto point = std::ranges::find_if(
          points, [&](const auto& p) { return p.method == method && p.setting == setting; });
      return bench::duration(point == points.end() ? units::nan : point->seconds_median);
    };
    const auto both = [&](const char* setting) {
      return fmt::format("{} with a matrix and {} by transforms", of("one length: matrix", setting),
                         of("one length: transforms", setting));
    };
    return fmt::format(
        "On 12 x 12 cells the full theory takes {}, and grids of one length {}; on 16 x 16 cells, "
        "{} and {}.",
        of("full theory", "12 x 12 cells"), both("12 x 12 cells"),
        of("full theory", "16 x 16 cells"), both("16 x 16 cells"));
  }
  static constexpr const char* quantities[] = {"fx", "fy", "mz"};
};

// "33 solutions of the full theory, 12 ms".
std::string making_of(const report::Item& item, int solutions, const num::Stopwatch& watch) {
  const double seconds = watch.seconds();
  return fmt::format("{} solutions of the full theory{}", solutions,
                     item.timings() ? fmt::format(", {:.2f} s", seconds) : " (not timed)");
}

// The largest distance of the reference from a separate program's forces.
double outside_apart(const Known& known, const table::CsvTable& program) {
  double apart = 0;
  for (std::size_t k = 0; k < known.cases[0].second.size(); ++k) {
    const std::string x = fmt::format("{:.6g}", known.cases[0].second[k].longitudinal);
    apart = std::max(
        apart, std::abs(known.limit.answers[3 * k] - report::printed_number(program.at(x, "f"))));
  }
  return apart;
}

void curve_time(report::Item& item) {
  Study study(item, "curve");
  study.add("full theory", {4, 6, 8, 12, 16}, full_cells);
  study.add("cells fill the contact", {6, 8, 12, 16},
            [](int n) { return full({.along = n, .rows = n, .remedy = false}); });
  study.add({Theory::fastsim, Theory::fastrip, Theory::shen_hedrick_elkins, Theory::polach,
             Theory::vermeulen_johnson, Theory::linear});
  study.methods.push_back({"table of the full theory", {}});
  std::list<ForceTable> tables;
  std::string making;  // of the last
  for (const int n : {9, 17, 33}) {
    const num::Stopwatch watch;
    tables.push_back(curve_table(n, {.along = 12, .rows = 8}));
    making = making_of(item, n, watch);
    study.methods.back().settings.push_back(
        study.setting(fmt::format("{} nodes", n), looked_up(tables.back())));
  }
  study.measure(item);
  study.show(item, 0, {1e-2, 1e-3});
  item.value("limit-grids",
             fmt::format("{:g} to {:g}", study.ladder[coarse].size, study.ladder.back().size));
  report::values(item, "", "{:.2f}", "curve-order", study.order, "curve-order-fine",
                 study.limit.order);
  item.value("curve-uncertainty", mean(study.limit.uncertainty)[0], "", "{:.6f}");
  item.value("curve-making", making);
  item.value("outside-apart", outside_apart(study, item.printed("contact-curve.csv")), "",
             "{:.4f}");
}

const Study& spinning(report::Item& item) {
  static Study study(item, "spin");
  if (!study.points.empty()) return study;
  const num::Stopwatch watch;
  static const ForceTable table({0.5, 3, 4, 0.5, 2, 5, 5, 9}, [](double ratio) {
    return shares_of(full({.along = 6, .rows = 6, .estimate = false})(ratio), ratio, poisson);
  });
  item.value("spin-making", making_of(item, 900, watch));
  const InterpolationError off = table.error(
      [](double ratio) { return shares_of(full_cells(12)(ratio), ratio, poisson); }, 48);
  item.value("spin-table-places", off.points, "", "{:.0f}");
  report::values(item, "%", "{:.0f}", "spin-table-rms", 100 * off.rms_force, "spin-table-most",
                 100 * off.largest_force);
  study.add("full theory", {4, 6, 8, 12, 16}, full_cells);
  study.add("one length: matrix", {8, 12, 16}, [](int n) { return on_cells(n, true, true); });
  study.add("one length: transforms", {8, 12, 16, 24},
            [](int n) { return on_cells(n, true, false); });
  study.add("fastsim", {5, 10, 20, 40}, fastsim_cells);
  study.add(
      {Theory::shen_hedrick_elkins, Theory::polach, Theory::vermeulen_johnson, Theory::linear});
  study.methods.push_back(
      {"table of the full theory", {study.setting("900 nodes", looked_up(table))}});
  study.measure(item);
  item.value("one-length-answer", study.one_length_answer(item.timings()));
  for (const int cells : {5, 40}) {
    const Errors e = mean(solved(study.cases, fastsim_cells(cells)), study.limit.answers);
    item.value(fmt::format("fastsim-fx-{}", cells), e[0], "", "{:.3f}");
    item.value(fmt::format("fastsim-fy-{}", cells), e[1], "", "{:.3f}");
  }
  return study;
}

template <std::size_t quantity>
void spin(report::Item& item) {
  spinning(item).show(item, quantity, {5e-2, 5e-3});
}

// "a/b = 3 and Φ = 1.5" of each case.
std::vector<std::string> names_of(const Cases& cases) {
  std::vector<std::string> names;
  for (const auto& [ratio, creepages] : cases)
    for (const Creepage& c : creepages)
      names.push_back(fmt::format("a/b = {:g} and Φ = {:g}", ratio, c.spin));
  return names;
}

// Each case's distance from its limit, over the cells.
void spin_cells(report::Item& item) {
  item.added("a study of methods");
  item.script("study/spin-cells.gp");
  const Study& s = spinning(item);
  auto& lines = item.data(
      {"case", "shape_and_spin", "cells", "fx", "fy", "mz", "fx_knows", "fy_knows", "mz_knows"});
  double worst = 0;
  std::string where;
  const std::vector<std::string> names = names_of(s.cases);
  for (std::size_t k = 0; k < names.size(); ++k)
    for (const bench::Grid& g : s.ladder) {
      const Errors off = s.distance(g, k);
      const double* known = &s.limit.uncertainty[3 * k];
      lines.add(static_cast<double>(k + 1), names[k], g.size, off[0], off[1], off[2], known[0],
                known[1], known[2]);
      const double most = std::ranges::max(off);
      if (g.size == 16 && most > worst) worst = most, where = names[k];
    }
  lines.holds_to("*", 0.9, 1e-5, "limits of a few grids move with their last digits");
  report::values(item, "", "{:.2f}", "spin-order", s.order, "spin-order-fine", s.limit.order);
  item.value(
      "spin-worst",
      fmt::format("On 16 x 16 cells the largest error of the 18 (six cases, two forces and the "
                  "moment) is {:.3f}, at {}.",
                  worst, where));
}

}  // namespace

const report::Section creep_chapter::cost{
    report::figure("curve-time", curve_time), report::figure("spin-fx", spin<0>),
    report::figure("spin-fy", spin<1>), report::figure("spin-mz", spin<2>),
    report::figure("spin-cells", spin_cells)};
