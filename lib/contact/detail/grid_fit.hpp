// Placing a grid on a contact region that is roughly known.
#pragma once

#include <optional>

#include <railbook/contact/region.hpp>

namespace railbook::contact {

// Where a grid should lie along one axis, as its lower end, cell size and number of cells.
struct Axis {
  double start = 0, step = 0;
  Eigen::Index cells = 0;
};

// At most `cells` cells over [low, high] with two empty cells beyond each end, placed so that the
// share `phase` (0 to 1) of the outermost cells lies inside. With `edge` a cell edge lies there,
// and the cell size (within 3 % of the least possible) is the one that meets the phase best.
Axis fit_axis(double low, double high, Eigen::Index cells, double phase,
              std::optional<double> edge);

// An axis of `cells` cells from low to high; with an edge, of slightly larger cells with an edge
// there.
Axis cover_axis(double low, double high, Eigen::Index cells, std::optional<double> edge);

}  // namespace railbook::contact
