// Numbers as colours.
#pragma once

#include <railbook/scene/scene.hpp>

namespace railbook::scene {

// The colour of `value` on a scale from `low` (dark blue) over green to `high` (yellow); values
// outside take the colour of the nearer end. Ten colours of matplotlib's viridis (van der Walt and
// Smith, 2015, public domain), linear in between: lightness rises steadily, so it reads in grey and
// by colour-blind readers. The palette in lib/plot/style.gp is the same, so gnuplot's colour bar
// fits. Throws InputError when `value` is not finite or `low` is not less than `high`.
Colour viridis(double value, double low, double high);

// One row a value; for Mesh::colours.
Points viridis(const Eigen::VectorXd& values, double low, double high);

}  // namespace railbook::scene
