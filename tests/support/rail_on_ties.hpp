// A rail of finite length on discrete ties, its load in the middle.
#pragma once

#include <railbook/track/beam_elements.hpp>

namespace railbook::support {

inline track::BeamModel rail_on_ties(double bending_stiffness, double tie_stiffness,
                                     double tie_spacing, int bays_each_side,
                                     track::LoadPlace place) {
  const Eigen::Index n = 2 * Eigen::Index(bays_each_side) + 1, middle = n / 2;
  track::BeamModel model{.bending_stiffness = bending_stiffness,
                         .x = Eigen::VectorXd(n),
                         .spring = Eigen::VectorXd::Constant(n, tie_stiffness)};
  const bool midspan = place == track::LoadPlace::midspan;
  const double shift = midspan ? 0.5 * tie_spacing : 0.0;
  for (Eigen::Index i = 0; i < n; ++i)
    model.x(i) = double(i - middle) * tie_spacing + (i < middle ? shift : i > middle ? -shift : 0);
  if (midspan) model.spring(middle) = 0;
  return model;
}

}  // namespace railbook::support
