// Patches that a grid is too coarse, or too narrow, to have seen.
#pragma once

#include <vector>

#include <railbook/contact/grid.hpp>

namespace railbook::contact {

struct Point {
  double x = 0, y = 0;
};

// Places of `box` outside `grid` where the bodies still overlap by more than `share` of the
// approach under the pressures p on the grid, whose cells act as points or rods: 97 x 97 places,
// and 1025 along each axis through the origin. None means that a patch beyond the grid is narrower
// than that, or bears less than about share^1.5 of the load.
std::vector<Point> missed_places(const Gap& gap, double approach, double effective_modulus,
                                 const Grid& grid, const Eigen::VectorXd& p, const Box& box,
                                 double share);

}  // namespace railbook::contact
