/*** Each panel shows the relative error of one number against the time of the whole solution, on
one core, including all coarser grids and earlier meshes that lead to the result. Crosses at the top
are runs in which the program gave no result. The column *work* counts what takes the time: the
squares of the numbers of unknowns of all systems solved, or the points that are Fourier
transformed.

COUNTACT-1 and COUNTAXI are the paper's program for one axis of symmetry and for round contacts.
COUNTACT-1 is tried with the two kinds of columns of the paper, equal ones and two widths on each
side of the origin, and with *graded* columns, which become narrower by degrees. CG-FFT is the
method of the command `railbook contact solve`: it solves the problem by conjugate gradients on
three uniform grids and extrapolates from them, which takes 24 cells or more. "CG-FFT raw" is the
finest of these grids alone.

### Which method for the force on a jump of the radius?

{{cost-jump-force-answer}} Equal columns fail (the crosses), which is why the paper has a footnote
on two widths; with two widths the force of COUNTACT-1 is a little better than with graded columns.
A single grid follows the edge of the contact in steps of a cell; the extrapolation removes the
regular part of the error that this makes.

{{cost-jump-force}}

Example 2 has no closed form. The reference puts pressures at the points of {{lattices}} square
lattices. The displacement at a point is $k$ times the sum $\sum h^2p/r$ over all other points,
where $k$ is the compliance of the bodies, $h$ the spacing, $p$ the pressure and $r$ the distance,
and $3.9003\,hp$ for the point itself; this constant makes the sum exact to third order where $p$ is
smooth. A straight line in $h^2$ is fitted to the forces. Its value at $h=0$ is the reference, and
twice the standard error of that value is its uncertainty: {{uncertainty}} of the force and
{{peak-uncertainty}} of the peak. Smaller errors are drawn at the uncertainty, and no advice is
better than it. Errors of less than 100 times this uncertainty are themselves uncertain by more than
1 %, and are drawn grey.

The reference uses another influence function and other grids than CG-FFT, but the same solver (the
convolution and the conjugate gradients), so an error of the solver would not be seen. COUNTACT has
nothing in common with the reference but the function of the gap. CG-FFT on 255 x 255 cells is
{{other-route}} from the reference.

### Which method for its peak pressure?

{{cost-jump-peak-answer}} The peak is close to the jump, so it needs narrow cells there: COUNTACT-1
with two widths, whose columns are narrow at the ends only, is far behind the graded columns.

{{cost-jump-peak}}

{{work-precision: cost-jump-force}}

### Which method for the force of a round punch?

{{cost-punch-force-answer}} Rings save the most, because they use the symmetry. They must be narrow
where the peak is, in a strip of a fortieth of the radius.

{{cost-punch-force}}

The closed form is the reference; it shares nothing with the methods but the shape of the stamp. The
integral of its pressure equals its force to {{punch-force-known}}, and another quadrature gives its
peak to {{punch-peak-known}}.

### Which method for its peak pressure?

{{cost-punch-peak-answer}} No setting tried reaches 10⁻⁴ reliably. The error of the peak does not
fall evenly, because it depends on how far the middle of a ring is from the peak: it is {{peak-80}}
on 80 graded rings, {{peak-160}} on 160 and {{peak-240}} on 240.
With equal rings the program gives no result as long as too few of them lie between the peak and the
boundary.

{{cost-punch-peak}}

{{work-precision: cost-punch-force}}

{{fold}}
*/
#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <railbook/bench/work_precision.hpp>
#include <railbook/num/quadrature.hpp>

#include "method/countaxi.hpp"
#include "method/punch.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

bench::Outcome outcome(const NormalContact& c) {
  return {
      {c.force, c.p_max}, static_cast<double>(c.work), c.converged, c.converged ? "" : c.reason};
}

NormalContact on_grid(const Gap& gap, double approach, int n, std::optional<double> edge = {},
                      bool remedy = true) {
  CgFftOptions options{n, n};
  options.edge_x = edge;
  options.remedy = remedy;
  return solve_cg_fft(gap, approach, modulus, options).contact;
}

NormalContact by_columns(const Columns& columns, int rows) {
  return countact_1(on_the_jump(), delta_2, modulus, {columns, rows}).contact;
}

// The paper's footnote: on each side half of the columns lie in its outer 30 %.
Columns two_widths(int n) {
  const auto side = [](int columns) { return Side{columns - columns / 2, columns / 2, 0.3}; };
  return split_columns(side(3 * n / 5), side(n - 3 * n / 5));
}

// One task by all methods: two quantities of the same runs, a panel each.
struct Study {
  std::vector<bench::Reference> references;
  std::vector<bench::Method> methods;
  std::vector<report::WorkPrecision> points = {};
};

// What the sum of 1/r over the points of a lattice, from -n to n both ways, lacks of the integral,
// for a spacing of 1.
double lacking(int n) {
  double sum = 0;
  for (int j = -n; j <= n; ++j)
    for (int i = -n; i <= n; ++i)
      if (i || j) sum += (i * i == n * n ? 0.5 : 1) * (j * j == n * n ? 0.5 : 1) / std::hypot(i, j);
  return 8 * n * std::asinh(1.0) - sum;
}

// The part of the point at the centre: what the edge of the square leaves falls with 1/n.
double lattice_constant() {
  return 2 * lacking(400) - lacking(200);
}

// Example 2 on a lattice with so many spacings across; the jump is half-way between points.
Region on_lattice(int across) {
  constexpr double left = -0.0149, right = 0.0019, side = 0.0086;  // the patch and a little [m]
  static const double own = lattice_constant();
  const double h = (right - left) / across;
  const auto cells = [h](double length) {
    return static_cast<Eigen::Index>(std::ceil(length / h));
  };
  const Eigen::Index before = cells(-left), half = cells(side);
  const Grid grid{-static_cast<double>(before) * h,
                  -static_cast<double>(half) * h,
                  h,
                  h,
                  before + cells(right),
                  2 * half};
  Convolution a(grid, modulus, [h](Eigen::Index i, Eigen::Index j) {
    return i || j ? h / std::hypot(i, j) : h * own;
  });
  const Eigen::VectorXd f = sample(on_the_jump(), grid);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(grid.cells());
  if (!solve_bounded_cg(a, f, delta_2, p, {}).converged)
    throw std::runtime_error("the reference did not converge");
  Region region = describe(grid, p, f);
  if (region.touches_edge()) throw std::runtime_error("the reference's lattice is too small");
  return region;
}

constexpr int coarsest = 100, finest = 250, every = 8;  // lattices of the reference

// The least-squares line in h^2 through the lattices, of which each is off by about h^2.5 in its
// own way.
std::vector<bench::Reference> fitted_lattices() {
  std::vector<bench::Reference> references{{"F"}, {"p_max"}};
  std::vector<double> squares, weights, found[2];
  for (int n = coarsest; n <= finest; n += every) {
    const Region r = on_lattice(n);
    squares.push_back(1 / (double(n) * n));
    weights.push_back(std::pow(n, 5));
    found[0].push_back(r.force);
    found[1].push_back(r.p_max);
  }
  for (std::size_t q = 0; q < 2; ++q) {
    double slope, c00, c01, c11, sum;
    gsl_fit_wlinear(squares.data(), 1, weights.data(), 1, found[q].data(), 1, squares.size(),
                    &references[q].value, &slope, &c00, &c01, &c11, &sum);
    const double scatter = std::sqrt(sum / double(squares.size() - 2) * c00);
    references[q].uncertainty = 2 * scatter / references[q].value;
  }
  return references;
}

const std::vector<bench::Reference>& jump_references() {
  static const std::vector<bench::Reference> found = fitted_lattices();
  return found;
}

// What the closed form of Example 4 is known to: its pressures bear its force, and its peak is that
// of another quadrature, t = r cosh u in the integral of the page.
std::vector<bench::Reference> punch_references(const PunchContact& c) {
  const double b = c.shape.flat_radius;
  const auto borne = [&](double t) {  // by the ring at r = a sin t
    const double r = c.radius * std::sin(t);
    return 2 * units::pi * r * punch_pressure(c, r) * c.radius * std::cos(t);
  };
  const double kink = std::asin(b / c.radius);
  const double force = num::integrate(borne, 0, kink, 1e-9).value +
                       num::integrate(borne, kink, units::pi / 2, 1e-9).value;
  const PunchPeak peak = punch_peak(c);
  const num::GaussRule rule = num::gauss_legendre(400, 0, std::acosh(c.radius / peak.r));
  double pressure = 0;
  for (Eigen::Index i = 0; i < rule.x.size(); ++i) {
    const double t = peak.r * std::cosh(rule.x[i]), s = std::sqrt(t * t - b * b);
    pressure += rule.w[i] * (2 * s - b * std::atan(s / b));
  }
  pressure *= c.effective_modulus / (units::pi * c.shape.edge_radius);
  return {{"F", c.force, std::abs(force / c.force - 1)},
          {"p_max", peak.pressure, std::abs(pressure / peak.pressure - 1)}};
}

const Study& jump(const report::Item& item) {
  static const Study study = [&] {
    const auto grids = [](bool remedy) {
      return [=](int n) { return outcome(on_grid(on_the_jump(), delta_2, n, 0, remedy)); };
    };
    std::vector<bench::Method> methods{
        bench::sweep("COUNTACT-1 equal", {9, 15, 21, 31},
                     [](int n) { return outcome(by_columns(uniform_columns(n), n)); })
            .labelled("{} columns")
            .counts("unknowns squared"),
        bench::sweep("COUNTACT-1 graded", {10, 15, 20, 30},
                     [](int n) {
                       const Columns columns = graded_columns(3 * n / 5, 2 * n / 5);
                       return outcome(by_columns(columns, n / 2 * 2 - 1));
                     })
            .labelled("{} columns")
            .counts("unknowns squared"),
        bench::sweep("CG-FFT raw", {12, 17, 24, 34, 48, 68, 96, 136, 192, 255}, grids(false))
            .labelled("{0} x {0} cells")
            .counts("points transformed"),
        bench::sweep("CG-FFT", {24, 34, 48, 68, 96, 136, 192, 255}, grids(true))
            .labelled("{0} x {0} cells")
            .counts("points transformed"),
        bench::sweep("COUNTACT-1 two widths", {10, 15, 20, 30},
                     [](int n) { return outcome(by_columns(two_widths(n), n / 2 * 2 - 1)); })
            .labelled("{} columns")
            .counts("unknowns squared")};
    Study s{jump_references(), std::move(methods)};
    s.points = bench::measure("cost-jump-force", s.references, s.methods, item.timings(), 0.15);
    return s;
  }();
  return study;
}

const Study& punch(const report::Item& item) {
  static const Study study = [&] {
    const Gap gap = rounded_punch_gap(stamp);
    const PunchContact exact = punch_from_approach(stamp, modulus, delta_4);
    const auto rings = [=](double grading) {
      return [=](int n) {
        CountaxiOptions options;
        options.rings = n, options.grading = grading;
        const RingContact c = countaxi(gap, delta_4, modulus, options);
        return bench::Outcome{
            {c.force, c.p_max}, static_cast<double>(c.work), c.converged, c.reason};
      };
    };
    const auto grids = [=](bool remedy) {
      return [=](int n) { return outcome(on_grid(gap, delta_4, n, {}, remedy)); };
    };
    std::vector<bench::Method> methods{
        bench::sweep("COUNTAXI equal rings", {10, 20, 40, 80, 160, 240}, rings(1))
            .labelled("{} rings")
            .counts("unknowns squared"),
        bench::sweep("COUNTAXI graded rings", {10, 20, 40, 80, 160, 240}, rings(3))
            .labelled("{} rings")
            .counts("unknowns squared"),
        bench::sweep("CG-FFT raw", {17, 24, 34, 48, 68, 96, 136, 192, 255}, grids(false))
            .labelled("{0} x {0} cells")
            .counts("points transformed"),
        bench::sweep("CG-FFT", {24, 34, 48, 68, 96, 136, 192, 255}, grids(true))
            .labelled("{0} x {0} cells")
            .counts("points transformed")};
    Study s{punch_references(exact), std::move(methods)};
    s.points = bench::measure("cost-punch-force", s.references, s.methods, item.timings(), 0.15);
    return s;
  }();
  return study;
}

void panel(report::Item& item, const Study& study, const std::string& quantity,
           std::initializer_list<double> errors = {1e-2, 1e-3, 1e-4}) {
  bench::show(item, study.points, quantity, study.methods);
  item.value(item.id() + "-answer", bench::answer(study.points, quantity, errors));
  item.added("a study of methods");
}

void jump_force(report::Item& item) {
  panel(item, jump(item), "F");
  const bench::Reference& reference = jump(item).references.front();
  const double grid = jump_on_grid(255).force;
  constexpr int lattices = (finest - coarsest) / every + 1;
  item.value("lattices", lattices, "", "{:.0f}");
  item.value("uncertainty", reference.uncertainty, "", "{:.0e}");
  item.value("peak-uncertainty", jump(item).references.back().uncertainty, "", "{:.0e}");
  item.expect_checks(1);
  item.agree("other-route", "the force by CG-FFT, 255 x 255", "N", grid, reference.value, 1e-5,
             "sums over lattices, extrapolated");
  item.value("other-route", std::abs(grid / reference.value - 1), "", "{:.0e}");
}

void punch_force(report::Item& item) {
  const Study& study = punch(item);
  panel(item, study, "F");
  const auto decade = [](double error) {  // not below rounding
    return std::pow(10, std::ceil(std::log10(std::max(error, 1e-13))));
  };
  item.value("punch-force-known", decade(study.references[0].uncertainty), "", "{:.0e}");
  item.value("punch-peak-known", decade(study.references[1].uncertainty), "", "{:.0e}");
}

// How often the true error of CG-FFT on the jump and on the stamp is below the stated one, of the
// runs that state one: "12 of 16".
void stated_errors(report::Item& item) {
  int stated[2]{}, within[2]{};
  const auto count = [&](std::size_t q, double value, double error, const bench::Reference& r) {
    if (!std::isfinite(error)) return;
    ++stated[q];
    within[q] += std::abs(value / r.value - 1) <= error + r.uncertainty;
  };
  for (const int n : {24, 34, 48, 68, 96, 136, 192, 255})
    for (const bool jumps : {true, false}) {
      const NormalContact c = jumps ? on_grid(on_the_jump(), delta_2, n, 0)
                                    : on_grid(rounded_punch_gap(stamp), delta_4, n);
      const std::vector<bench::Reference>& known =
          jumps ? jump(item).references : punch(item).references;
      count(0, c.force, c.force_error, known[0]);
      count(1, c.p_max, c.p_max_error, known[1]);
    }
  item.value("stated-force", fmt::format("{} of {}", within[0], stated[0]));
  item.value("stated-peak", fmt::format("{} of {}", within[1], stated[1]));
}

void punch_peak_panel(report::Item& item) {
  const Study& study = punch(item);
  stated_errors(item);
  panel(item, study, "p_max", {1e-2, 1e-3});
  for (const report::WorkPrecision& p : study.points)
    if (p.quantity == "p_max" && p.method == "COUNTAXI graded rings" &&
        (p.setting == "80 rings" || p.setting == "160 rings" || p.setting == "240 rings"))
      item.value("peak-" + p.setting.substr(0, p.setting.find(' ')), p.error, "", "{:.0e}");
}

}  // namespace

double force_by_lattices() {
  return jump_references().front().value;
}

const report::Section cost{
    report::figure("cost-jump-force", jump_force),
    report::figure("cost-jump-peak", [](report::Item& item) { panel(item, jump(item), "p_max"); }),
    report::figure("cost-punch-force", punch_force),
    report::figure("cost-punch-peak", punch_peak_panel)};

}  // namespace railbook::contact_chapter
