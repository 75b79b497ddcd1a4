// A lumped track under a sampled force, for comparison with responses in closed form.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include <railbook/track/lumped.hpp>

// Rail deflection under any force history: `force` [N] sampled every `step` [s] and taken as linear
// in between, exact for that; from rest in equilibrium with force[0].
inline std::vector<double> respond(const railbook::track::LumpedTrack& track,
                                   std::span<const double> force, double step) {
  const auto n = track.input.size();
  // Track, force and the force's slope as one autonomous system over a step.
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + 2, n + 2);
  all.topLeftCorner(n, n) = track.rates;
  all.block(0, n, n, 1) = track.input;
  all(n, n + 1) = 1.0;
  const Eigen::MatrixXd flow = (all * step).exp();
  Eigen::VectorXd x(n + 2);
  x.head(n) = track.rates.partialPivLu().solve(-track.input * force[0]);
  std::vector<double> y{x[0]};
  y.reserve(force.size());
  for (std::size_t k = 1; k < force.size(); ++k) {
    x[n] = force[k - 1];
    x[n + 1] = (force[k] - force[k - 1]) / step;
    x = flow * x;
    y.push_back(x[0]);
  }
  return y;
}
