// Describing functions: the gain N(A) that fits an odd function f(A sin psi) by N(A) A sin psi
// best.
//
//   N(A) = 2 / (pi A) * integral over 0 ... pi of f(A sin psi) sin psi dpsi            (the paper's
//   eq. (8))
//
//   const vehicle::PiecewiseLinearGain table{x, {r, d, phi}};   // three functions over the same
//   points table.evaluate(amplitude, gains);                            // N and dN/dA of each
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace railbook::vehicle {

// N(A) and dN/dA.
struct Gain {
  double value = 0;
  double slope = 0;
};

// Odd functions that are linear between common points and beyond the last. With slope changes dm_k
// at b_k,
//   N = m_0 + sum over b_k < A of dm_k [1 - 2/pi (asin beta + beta sqrt(1 - beta^2))],  beta = b_k
//   / A:
// exact, no quadrature, to rounding also just beyond a dead zone. Points where no function bends
// are dropped.
class PiecewiseLinearGain {
 public:
  // x: ascending from 0; values[f][k] at x[k], values[f][0] = 0. Throws InputError otherwise, or
  // when fewer than two points are given or a number is not finite.
  PiecewiseLinearGain(std::span<const double> x, std::span<const std::vector<double>> values);

  std::size_t functions() const { return functions_; }
  // Fills gains (one a function) for amplitude >= 0; a linear function has N = f'(0) at A = 0.
  void evaluate(double amplitude, std::span<Gain> gains) const;

 private:
  std::size_t functions_ = 0;
  std::vector<double> first_slope_;  // a function
  std::vector<double> bend_;         // ascending
  std::vector<double> change_;       // [bend][function]
};

// Any odd f by adaptive quadrature; `derivative` is f'. Accuracy asked for: `relative` of N. A > 0.
// The result is for f smooth on (0, A); `converged` false when the accuracy was not reached.
struct QuadratureGain {
  Gain gain;
  int evaluations = 0;
  bool converged = false;
};
QuadratureGain describe(const std::function<double(double)>& f,
                        const std::function<double(double)>& derivative, double amplitude,
                        double relative = 1e-10);

// Dry friction level * sign(v): N = 4 level / (pi A); A > 0 is the amplitude of the rate v (eq.
// (12)); InputError otherwise. Relative accuracy 1e-15.
Gain ideal_friction(double level, double amplitude);

// level * saturate(v / stick): N = level / stick up to A = stick, then
// 2 level / (pi stick) (asin beta + beta sqrt(1 - beta^2)), beta = stick / A. A >= 0, stick > 0
// (not checked); relative accuracy 1e-14.
Gain regularized_friction(double level, double stick, double amplitude);

}  // namespace railbook::vehicle
