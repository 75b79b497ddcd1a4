// Integrals of a function of one variable: adaptive (GSL) and fixed Gauss-Legendre rules.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace railbook::num {

struct Integral {
  double value = 0;
  double error = 0;        // the routine's own estimate of |value - exact|
  int evaluations = 0;     // of the integrand
  bool converged = false;  // false: the requested accuracy was not reached
};

// The integral of f from a to b (either may be infinite), adaptive, with end-point singularities
// allowed (GSL QAGS / QAGI). Asks for an error below `relative` |value| or `absolute`, and keeps
// within twice that; a feature narrower than 1/100 of the range (to infinity: of a length 100 times
// off 1) may be missed without a warning.
[[nodiscard]] Integral integrate(const std::function<double(double)>& f, double a, double b,
                                 double relative = 1e-10, double absolute = 0.0);

// Nodes and weights of the n-point Gauss-Legendre rule on [a, b], n >= 1 (else InputError): exact
// for polynomials of degree 2n - 1 but for rounding, 1e-14 up to n = 64.
struct GaussRule {
  Eigen::VectorXd x;  // n nodes, ascending
  Eigen::VectorXd w;  // n weights, sum b - a
};
GaussRule gauss_legendre(int n, double a = -1.0, double b = 1.0);

}  // namespace railbook::num
