// Time integration that is exact but for rounding: a Taylor series in each linear piece, knots
// located.
//
// Between knots the system is linear with constant coefficients, so its Taylor series converges
// everywhere and is as long as the tolerance wants; the time at which a scalar reaches the next
// knot is a root of a polynomial. No step ever contains a kink, nor more than some 4 turns of a
// scalar.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <railbook/cycles/oscillator.hpp>

namespace railbook::cycles {

// One step as a polynomial: y(begin + t) = sum_j terms[j] t^j, 0 <= t <= length.
struct PieceStep {
  static constexpr int most = 30;
  double begin = 0, length = 0;
  int order = 0;
  std::array<State, most + 1> terms;
  State at(double t) const;
};

// A scalar over one step: x(t) = sum_j s_j t^j.
struct PieceScalar {
  std::array<double, PieceStep::most + 1> s{};
  int order = 0;
  double at(double t) const {
    double sum = s[std::size_t(order)];
    for (int j = order - 1; j >= 0; --j) sum = sum * t + s[std::size_t(j)];
    return sum;
  }
  double slope(double t) const {
    double sum = order * s[std::size_t(order)];
    for (int j = order - 1; j >= 1; --j) sum = sum * t + j * s[std::size_t(j)];
    return sum;
  }
};

class PieceIntegrator {
 public:
  // tolerance > 0: of the truncation a step, relative to `scale` (positive, of each state).
  PieceIntegrator(Compiled system, const State& scale, double tolerance = 1e-13);

  void start(double t, const State& y);
  // The next step, to a knot, or as long as the series allows, or to `end`. False when a scalar has
  // reached its limit.
  bool step(double end);
  // Turns d(state)/d(start) along with it from now on, from the unit matrix.
  void follow_derivative();

  double t() const { return t_; }
  const State& y() const { return y_; }
  const StateMatrix& derivative() const { return derivative_; }
  const PieceStep& last() const { return step_; }
  const Compiled& system() const { return system_; }
  long steps() const { return steps_; }
  long knots() const { return knots_; }
  int channel_at_limit() const { return at_limit_; }

 private:
  struct Crossing {
    double time = 0;
    int channel = -1;
    int direction = 0;
  };
  void assemble();
  void expand(double guess);
  double series_length() const;
  double guess(double end) const;
  void find_crossing(std::size_t channel, Crossing& first) const;
  void turn_derivative(double h);

  Compiled system_;
  State inverse_scale_;
  double tolerance_;
  double t_ = 0, reach_ = 1e-4;
  State y_;
  std::vector<Eigen::Index> piece_;
  Acceleration jacobian_;
  Vector9 constant_;
  PieceStep step_;
  StateMatrix derivative_;
  bool follow_ = false;
  int at_limit_ = -1;
  long steps_ = 0, knots_ = 0, since_assembly_ = 0;
};

}  // namespace railbook::cycles
