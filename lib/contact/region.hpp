// What is read off a pressure field on a grid: sums, the ends of the region and the peak, by local fits.
#pragma once

#include <Eigen/Core>

#include "contact/grid.hpp"

namespace railbook::contact {

struct Region {
  double force = 0, moment_x = 0, moment_y = 0;  // sums over the cells [N, N m]
  double p_max = 0, x_p_max = 0,
         y_p_max = 0;            // vertex of a parabola in p^2 through the peak's neighbours
  Box ends;                      // where p^2, continued outward, reaches zero
  double area = 0;               // from the ends of every row
  Eigen::Index cells = 0;        // with pressure
  bool meets_body_edge = false;  // some cell with pressure is next to a place without a body
  bool touches_x_min = false, touches_x_max = false, touches_y_min = false, touches_y_max = false;

  bool touches_edge() const {
    return touches_x_min || touches_x_max || touches_y_min || touches_y_max;
  }
};

// Describes the pressures p on `grid`; f is the gap there (infinite: no body, and the region ends with the
// body). The position of an end is better than the cell it lies in (about 0.1 cell), but first order in the cell.
Region describe(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f);

// The edge of the contact in every column of cells that has pressure: it lies between y = low and y = high [m].
struct Outline {
  Eigen::VectorXd x, low, high;
};
Outline outline(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f);

}  // namespace railbook::contact
