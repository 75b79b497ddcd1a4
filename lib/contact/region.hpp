// What is read off a pressure field on a grid: sums, the ends of the region and the peak, by local
// fits.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <railbook/contact/grid.hpp>

namespace railbook::contact {

// A connected part of the contact: at least one cell without pressure lies between it and
// the others.
struct PressurePatch {
  Eigen::Index cells = 0;  // with pressure
  double force = 0;        // sum over its cells [N]
  double area = 0;         // from the ends of every run of cells with pressure in every row [m^2]
  double p_max = 0, x_p_max = 0,
         y_p_max = 0;  // vertex of a parabola in p^2 through the peak's neighbours
  double peak_drop =
      0;     // from the peak cell to the lowest of its four neighbours, as a share of the peak
  Box ends;  // where p^2, continued outward, reaches zero
  // K of p = K sqrt(distance) at the ends of its rows and columns, over that of Hertz's pressure
  // with the same mean along the line, on average: 1 for every Hertzian contact. Falls again where
  // the grid is too coarse to see K.
  double edge_intensity = 1;
  // Cells across its narrowest direction, whichever way that lies: those of Hertz's ellipse with
  // the same second moments of pressure.
  double cells_across = 0;
};

struct Region {
  double force = 0, moment_x = 0, moment_y = 0;  // sums over the cells [N, N m]
  double p_max = 0, x_p_max = 0, y_p_max = 0;    // of the patch with the highest peak
  Box ends;                                      // of all patches together
  double area = 0;                               // of all patches [m^2]
  std::vector<PressurePatch> patches;            // the one that carries most first
  Eigen::Index cells = 0;                        // with pressure
  bool ends_steeply =
      false;  // somewhere p falls to nothing within a cell or two: an edge, under-resolved
  bool meets_body_edge = false;  // some cell with pressure is next to a place without a body
  bool touches_x_min = false, touches_x_max = false, touches_y_min = false, touches_y_max = false;

  bool touches_edge() const {
    return touches_x_min || touches_x_max || touches_y_min || touches_y_max;
  }
};

// Describes the pressures p on `grid`; f is the gap there (infinite: no body, and the region ends
// with the body). The position of an end is better than the cell it lies in (about 0.1 cell), but
// first order in the cell.
Region describe(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f);

// The outer edge of each patch in every column of cells with pressure: it lies between y = low and
// y = high [m].
struct Outline {
  Eigen::VectorXd x, low, high;
  std::vector<int> patch;  // its place in Region::patches
};
Outline outline(const Grid& grid, const Eigen::VectorXd& p, const Eigen::VectorXd& f);

}  // namespace railbook::contact
