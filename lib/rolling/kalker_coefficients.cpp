#include <railbook/rolling/kalker_coefficients.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include <railbook/num/dense_lu.hpp>
#include <railbook/num/quadrature.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

// Lengths over sqrt(a b), tractions over G; X = x/a = r cos(t), Y = y/b. For n = 0, 1, ... and
// harmonics m = n, n - 2, ...
//   f = Y_nm(X, Y, Z) / Z,  Z = sqrt(1 - X^2 - Y^2),  Y_nm the spherical harmonic scaled to cos(mt)
//   or sin(mt) at r = 1,
// span the tractions. The sphere's projection makes its transform 2 pi i^-n j_n(k) cos(mt), j_n the
// spherical Bessel function. That of the half-space is A(t)/k with A = 2/D (1 - nu n n'), where D =
// |(cos(t)/a, sin(t)/b)|, n = the same vector over D (also the outward normal at t), so that with
// q, p for the values at the rim
//   <q, dU/dx p> = b int j_n' j_n k dk Re(i^(n'-n+1)) oint cos(t) q'A p dt,   the first integral
//   +-pi/4,
// taken as the mean of the values for ellipses a little smaller and a little larger. Two
// singularities that meet at the edge leave a term
//   <q, dU/dx p> + <p, dU/dx q> = pi b/2 oint cos(t) q'A p dt.
// Its part from the leading half (cos(t) > 0) vanishes for the true traction, and is taken off.
// What remains is
//   B(q, p) = pi b/4 oint (sgn(n - n') cos(t) - |cos(t)|) q'A p dt = -<q, rigid slip>:
// its symmetric part is negative, its transpose is rolling backwards, and so the error of a
// coefficient is B(error of one traction, error of another), the square of theirs.
namespace railbook::rolling {
namespace {

struct Term {
  Eigen::Index degree, harmonic, direction;  // direction 0 along, 1 across
  bool sine;
};

// px even and py odd in y for longitudinal creepage, the reverse for lateral creepage and spin.
std::vector<Term> terms(int degree, bool lateral) {
  std::vector<Term> list;
  for (const Eigen::Index direction : {0, 1}) {
    const bool sine = (direction == 1) != lateral;
    for (Eigen::Index n = 0; n <= degree; ++n)
      for (Eigen::Index m = n % 2; m <= n; m += 2)
        if (m > 0 || !sine) list.push_back({n, m, direction, sine});
  }
  return list;
}

// Integrals over the whole rim of |cos(t)| e_i A_ij e_j dt, e the harmonics 0 to `degree` along,
// then across; those over cos(t) are the same where they do not vanish. Only a quarter of the rim
// is needed, by symmetry.
Eigen::MatrixXd rim_integrals(double a, double b, double poisson, int degree, bool lateral) {
  const num::GaussRule rule = num::gauss_legendre(128, 0, units::pi / 2);  // enough for 40
  const Eigen::Index size = degree + 1;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2 * size, 2 * size), e(size, 2), weighted;
  const double stretch = std::sqrt(b / a);  // nodes where D varies
  for (Eigen::Index k = 0; k < rule.x.size(); ++k) {
    const double c0 = std::cos(rule.x[k]), s0 = stretch * std::sin(rule.x[k]);
    const double t = std::atan2(s0, c0), c = std::cos(t), s = std::sin(t);
    const double weight = 4 * rule.w[k] * stretch / (c0 * c0 + s0 * s0) * c;
    for (Eigen::Index m = 0; m < size; ++m) {
      const auto x = static_cast<double>(m) * t;
      e(m, lateral ? 1 : 0) = std::cos(x);
      e(m, lateral ? 0 : 1) = std::sin(x);
    }
    const double d = std::hypot(c / a, s / b);
    const Eigen::Vector2d normal{c / a / d, s / b / d};
    const Eigen::Matrix2d response =
        2 / d * (Eigen::Matrix2d::Identity() - poisson * normal * normal.transpose());
    for (Eigen::Index i = 0; i < 2; ++i)
      for (Eigen::Index j = 0; j < 2; ++j)
        sum.block(i * size, j * size, size, size) +=
            (weight * response(i, j) * e.col(i)) * e.col(j).transpose();
  }
  return sum;
}

// The forces on the terms: columns fx, or fy and mz.
Eigen::MatrixXd forces(const std::vector<Term>& list, double a, double b, bool lateral) {
  const auto n = static_cast<Eigen::Index>(list.size());
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(n, lateral ? 2 : 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Term& term = list[static_cast<std::size_t>(i)];
    if (term.degree == 0) f(i, 0) = 2 * units::pi;
    if (term.degree == 1 && lateral)
      f(i, 1) = 2 * units::pi / 3 * (term.direction == 1 ? a : -b);  // of x py - y px
  }
  return f;
}

// Slopes of the forces by the creepages. The rigid slip of creepages and spin is (xi - phi y, eta +
// phi x), and its product with a term that term's force.
Eigen::MatrixXd slopes(double axis_ratio, double poisson, int degree, bool lateral) {
  const double a = std::sqrt(axis_ratio), b = 1 / a;
  const std::vector<Term> list = terms(degree, lateral);
  const Eigen::MatrixXd rim = rim_integrals(a, b, poisson, degree, lateral);
  const auto n = static_cast<Eigen::Index>(list.size());
  Eigen::MatrixXd matrix(n, n);
  const auto at = [&](const Term& t) { return t.direction * (degree + 1) + t.harmonic; };
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const Term &q = list[static_cast<std::size_t>(i)], &p = list[static_cast<std::size_t>(j)];
      // Degrees apart by an odd number meet in cos(t), the others in |cos(t)| only.
      const bool rising = p.degree > q.degree && (p.degree - q.degree) % 2 == 1;
      matrix(i, j) = units::pi * b / 4 * rim(at(q), at(p)) * (rising ? 1 : -1);
    }
  num::DenseLu lu;
  lu.factor(matrix);
  const Eigen::MatrixXd f = forces(list, a, b, lateral);
  Eigen::MatrixXd p = -f;
  for (Eigen::Index k = 0; k < p.cols(); ++k) lu.solve_in_place(p.col(k));
  return f.transpose() * p;
}

ComputedCoefficients of_degree(double axis_ratio, double poisson, int degree) {
  const Eigen::MatrixXd along = slopes(axis_ratio, poisson, degree, false),
                        across = slopes(axis_ratio, poisson, degree, true);
  ComputedCoefficients c;
  c.c11 = along(0, 0);
  c.c22 = across(0, 0), c.c32 = -across(1, 0);
  c.c23 = across(0, 1), c.c33 = across(1, 1);
  return c;
}

}  // namespace

ComputedCoefficients kalker_coefficients(double axis_ratio, double poisson, int degree) {
  units::require_between("axis ratio a/b", axis_ratio, 1e-4, 1e4);
  units::require_between("Poisson's ratio", poisson, 0, 0.5);
  units::require_between("degree of the tractions", degree, 4, 40);
  ComputedCoefficients c = of_degree(axis_ratio, poisson, degree);
  const ComputedCoefficients before = of_degree(axis_ratio, poisson, degree - 4);
  const auto change = [](double now, double then) { return std::abs(then / now - 1); };
  c.error = std::max({change(c.c11, before.c11), change(c.c22, before.c22),
                      change(c.c23, before.c23), change(c.c33, before.c33)});
  return c;
}

}  // namespace railbook::rolling
