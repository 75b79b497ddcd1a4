/***
Two questions: the curve of the paper, without spin, and forces and moment with spin. Each run is a whole set of cases, what the method must set up included; only the
look-up of a table leaves out its making, as in the codes that use tables. The reference of both is the full theory on a finer grid than any shown, and its uncertainty the distance from
another mesh with another solver: rows fitted to the ellipse with a matrix against rows of one length of cell with Fourier transforms. What lies within 100 times that is drawn grey, and the sentences ask for no more.

{{curve-time}}

{{curve-answer}}

{{spin-time}}

{{spin-answer}} Each fast theory has one error, its own; FASTSIM's cells do not buy more than that.

{{work-precision: curve-time}}

{{work-precision: spin-time}}

### A matrix or transforms

The same cells of one length, once with the matrix of all influences and once with transforms along the rows: the answers are the same to the solver's tolerance.

{{table-solvers}}
*/

#include <fmt/format.h>

#include <cmath>

#include "../curve.hpp"
#include "../rig.hpp"
#include "../sections.hpp"
#include "bench/timing.hpp"
#include "bench/work_precision.hpp"
#include "rolling/creep_laws.hpp"
#include "rolling/fastsim.hpp"
#include "rolling/force_table.hpp"
#include "rolling/kalker_coefficients.hpp"
#include "rolling/rolling_parts.hpp"

using namespace railbook;
using namespace railbook::rolling;
using namespace railbook::creep_chapter;

namespace {

using Law = std::function<CreepForces(const RollingCase&)>;
using LawOf = std::function<Law(double axis_ratio)>;  // what is set up for an ellipse

// A set of cases on unit ellipses, and the answers they should have.
struct Problem {
  struct Part {
    double ratio;
    std::vector<Creepage> creepages;
  };
  std::vector<Part> parts;
  std::vector<CreepForces> answers;

  std::vector<CreepForces> solve(const LawOf& law) const {
    std::vector<CreepForces> all;
    for (const Part& part : parts) {
      const Law solve_one = law(part.ratio);
      for (const Creepage& c : part.creepages)
        all.push_back(solve_one(with_reduced_creepage(unit_case(part.ratio, poisson), c)));
    }
    return all;
  }
  // Mean distance of forces and moment, over mu N and mu N sqrt(a b).
  double apart(const std::vector<CreepForces>& found) const {
    double sum = 0;
    for (std::size_t k = 0; k < answers.size(); ++k)
      sum += std::hypot(found[k].fx - answers[k].fx, found[k].fy - answers[k].fy,
                        found[k].mz - answers[k].mz);
    return sum / static_cast<double>(answers.size());
  }
};

LawOf full(const RollingOptions& options) {
  return [options](double ratio) -> Law {
    const auto contact = std::make_shared<EllipseRolling>(ratio, poisson, options);
    return [contact](const RollingCase& c) { return contact->solve(c); };
  };
}

// 1 and its mean error, so that 1 is the reference.
bench::Outcome outcome(const Problem& problem, const LawOf& law, double work) {
  const auto found = problem.solve(law);
  for (const CreepForces& f : found)
    if (!f.converged) return {{units::nan}, work, false, f.reason};
  return {{1 + problem.apart(found)}, work, true, {}};
}

bench::Method by_cells(const char* name, const Problem& problem, bool remedy,
                       const std::vector<std::pair<int, int>>& sizes) {
  bench::Method method{name, {}};
  for (const auto& [n, m] : sizes) {
    const RollingOptions options{.along = n, .rows = m, .remedy = remedy};
    const double work = static_cast<double>(problem.answers.size()) * n * m;
    method.settings.push_back({fmt::format("{}x{}", n, m), [&problem, options, work] {
                                 return outcome(problem, full(options), work);
                               }});
  }
  return method.counts("cells times cases");
}

// Theories that answer in closed form, by the coefficients of each ellipse.
void add_theories(std::vector<bench::Method>& methods, const Problem& problem,
                  std::initializer_list<Theory> theories) {
  for (const Theory theory : theories)
    methods.push_back(
        {std::string(name(theory)),
         {{"closed", [&problem, theory] {
             const LawOf law = [theory](double ratio) -> Law {
               return [theory, k = kalker_table(ratio, poisson)](const RollingCase& c) {
                 return creep_forces(theory, c, k);
               };
             };
             return outcome(problem, law, static_cast<double>(problem.answers.size()));
           }}}});
}

void panel(report::Item& item, const std::vector<bench::Method>& methods, double uncertainty,
           std::initializer_list<double> errors, const char* answer) {
  item.added("a study of methods");
  const bench::Axes axes{
      .error_low = 1e-5, .error_high = 1, .seconds_low = 1e-6, .seconds_high = 10};
  const auto points = bench::figure(item, {"mean error", 1.0, uncertainty}, methods, 0.15, axes);
  item.value(answer, bench::answer(points, "mean error", errors));
}

void curve_time(report::Item& item) {
  Problem problem{{{axis_ratio, {}}}, {}};
  for (const double x : curve_abscissae()) problem.parts[0].creepages.push_back({x, 0, 0});
  std::vector<CreepForces> other;
  for (std::size_t k = 0; k < curve_abscissae().size(); ++k) {
    problem.answers.emplace_back();
    problem.answers.back().fx = reference_curve(item.full())[k].force;
    other.emplace_back();
    other.back().fx = other_curve()[k].force;
  }
  const double uncertainty = problem.apart(other);
  std::vector<bench::Method> methods{
      by_cells("full theory", problem, true, {{4, 4}, {6, 4}, {8, 6}, {12, 8}, {24, 12}})
          .expects(-1),
      by_cells("full theory unplaced", problem, false, {{6, 4}, {8, 6}, {12, 8}, {24, 12}})};
  add_theories(methods, problem,
               {Theory::fastsim, Theory::fastrip, Theory::shen_hedrick_elkins, Theory::polach,
                Theory::vermeulen_johnson});
  // Linear in X, as the tables of a vehicle code are.
  const ShareTheory theory = [](double ratio) {
    return shares_of(full({.along = 12, .rows = 8})(ratio), ratio, poisson);
  };
  const ForceTable table({.ratio_from = axis_ratio,
                          .ratio_to = axis_ratio,
                          .ratios = 1,
                          .reach = 2,
                          .spin_reach = 1,
                          .longitudinal = 33,
                          .lateral = 2,
                          .spin = 3},
                         theory);
  methods.push_back({"table of the full theory",
                     {{"33 nodes", [&] {
                         const LawOf law = [&](double) -> Law {
                           return [&](const RollingCase& c) {
                             CreepForces f;
                             f.fx = table.at(axis_ratio, reduced_creepage(c)).fx,
                             f.converged = true;
                             return f;
                           };
                         };
                         return outcome(problem, law, static_cast<double>(problem.answers.size()));
                       }}}});
  panel(item, methods, uncertainty, {3e-2, 8e-3}, "curve-answer");
}

void spin_time(report::Item& item) {
  Problem problem{{{axis_ratio, {{0.2, 0.05, 0.5}, {0, 0, 2}}},
                   {0.5, {{0.1, 0.1, 0.3}}},
                   {3, {{0.1, -0.1, 1}}}},
                  {}};
  problem.answers = problem.solve(full({.along = 64, .rows = 64}));
  const double uncertainty = problem.apart(problem.solve(full({.along = 28, .rows = 28})));
  std::vector<bench::Method> methods{by_cells(
      "full theory", problem, true, {{4, 4}, {6, 6}, {8, 8}, {12, 12}, {16, 16}, {24, 24}})};
  bench::Method cells{"fastsim", {}};
  for (const int n : {5, 10, 20, 40, 80})
    cells.settings.push_back({fmt::format("{}x{}", n, n), [&problem, n] {
                                const LawOf law = [n](double ratio) -> Law {
                                  return
                                      [n, k = kalker_table(ratio, poisson)](const RollingCase& c) {
                                        return fastsim_grid(c, k, {.along = n, .strips = n});
                                      };
                                };
                                return outcome(problem, law, 4.0 * n * n);
                              }});
  methods.push_back(cells.counts("cells times cases"));
  add_theories(methods, problem, {Theory::shen_hedrick_elkins, Theory::polach});
  panel(item, methods, uncertainty, {3e-1, 1e-1}, "spin-answer");
}

void solvers(report::Item& item) {
  item.added("a study of methods");
  item.columns({"cells",
                "matrix, MB",
                "transforms, MB",
                {"products", "{:.0f}"},
                {"products, transforms", "{:.0f}"},
                "time over the matrix's"});
  double worst = 0;
  for (const Eigen::Index n : {8, 16, 24}) {
    const RollingGrid grid = ellipse_grid(axis_ratio, n, n, true, true);
    StickSlip found[2];
    double seconds[2] = {};
    for (const bool dense : {true, false})
      seconds[dense] = bench::seconds_of([&] {
        const TangentialInfluence influence(grid.mesh, poisson, dense);
        found[dense] = solve_on(influence, grid, {0.2, 0.05, 0.3}, {});
      });
    worst = std::max(worst, (found[0].p - found[1].p).norm() / found[1].p.norm());
    const double cells = static_cast<double>(n * n);
    item.add_row(fmt::format("{} x {}", n, n), fmt::format("{:.2g}", 32e-6 * cells * cells),
                 fmt::format("{:.2g}", 32e-6 * cells * static_cast<double>(n)),
                 static_cast<double>(found[1].products), static_cast<double>(found[0].products),
                 item.timings() ? fmt::format("{:.2g}", seconds[0] / seconds[1]) : "(not timed)");
  }
  item.expect_checks(1);
  item.at_most("same", "largest difference of the tractions of the two", "", worst, 1e-8,
               "the solver's tolerance of 1e-11, times the condition of its equations");
}

}  // namespace

const report::Section creep_chapter::cost{
    report::figure("curve-time", "Mean error of f over the curve against run time", curve_time),
    report::figure("spin-time", "Mean error of forces and moment with spin against run time",
                   spin_time),
    report::table("table-solvers", "A matrix against transforms", solvers)};
