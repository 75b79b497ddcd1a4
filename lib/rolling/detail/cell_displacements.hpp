// What a row of cells of constant traction does to a point of the surface.
#pragma once

#include <vector>

namespace railbook::rolling {

// Parts xx, xy = yx and yy of an influence.
struct Influence2 {
  double xx = 0, xy = 0, yy = 0;
};

// pi times the displacements, for two bodies of shear modulus 1, at distance (x, y) from the
// centres of a row of u.size() cells dx by dy, the k-th centred at k dx: Boussinesq and Cerruti's
// kernel integrated in closed form. Relative accuracy 5e-15 times the square of the distance in
// cells.
void row_displacements(double x, double y, double dx, double dy, double poisson,
                       std::vector<Influence2>& u);

}  // namespace railbook::rolling
