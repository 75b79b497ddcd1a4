// A uniform rectangular grid of cells, and fields on it.
#pragma once

#include <Eigen/Core>

#include <railbook/contact/normal_contact.hpp>

namespace railbook::contact {

// Rectangle in the contact plane [m].
struct Box {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
};

// nx by ny cells of dx by dy [m] whose lower left corner is (x0, y0). Fields on it are vectors of
// nx ny values with x running fastest: cell (i, j) is at index j nx + i.
struct Grid {
  double x0 = 0, y0 = 0;
  double dx = 0, dy = 0;
  Eigen::Index nx = 0, ny = 0;

  Eigen::Index cells() const { return nx * ny; }
  double x(Eigen::Index i) const { return x0 + (static_cast<double>(i) + 0.5) * dx; }
  double y(Eigen::Index j) const { return y0 + (static_cast<double>(j) + 0.5) * dy; }
};

// The gap at the cell centres [m]. Throws InputError where it is NaN or minus infinity; plus
// infinity stays.
Eigen::VectorXd sample(const Gap& gap, const Grid& grid);

// Pressures carried from one grid to another: p^2 is interpolated bilinearly between centres (p^2
// goes like the distance from the edge of a contact, p like its root). Beside the contact p^2 goes
// on along the line through the last two cells, to the place where it is zero; farther away it is
// zero. p^2 to 1e-14 of the largest near.
Eigen::VectorXd transfer(const Grid& from, const Eigen::VectorXd& p, const Grid& to);

// A box that holds {f < approach}, and hence the contact region: displacements of pressures >= 0
// are positive, so f = approach - u < approach wherever bodies touch. Found by moving four sides
// outward from the origin until f >= approach on all of them; a separate patch beyond is not seen,
// a slender one that crosses a side is, wherever (axes 1:10000). When f >= approach at the origin,
// the sides start from a place where it is less, sought on circles round the origin and downhill
// from the lowest place. Throws InputError when no such place is found, or a side goes farther than
// 1 km (the bodies do not separate).
Box interpenetration_box(const Gap& gap, double approach);

}  // namespace railbook::contact
