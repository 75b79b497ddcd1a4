// Stresses in a half-space below its surface, from normal and tangential tractions on the cells of
// a uniform grid.
//
//   const LargestStress worst = largest_stress(grid, 0.28, p, qx, qy);
//   worst.von_mises.value, worst.von_mises.depth
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include <railbook/contact/grid.hpp>

namespace railbook::contact {

// xx, yy, zz, xy, yz, zx [Pa], tension > 0; z into the half-space.
using Stress = Eigen::Matrix<double, 1, 6>;
using Stresses = Eigen::Matrix<double, Eigen::Dynamic, 6>;  // a row a cell

// Relative accuracy 2e-15, close to hydrostatic stress too.
double von_mises(const Stress& s);
// Half the difference of the largest and the least principal stress, to 1e-14 of von Mises' stress.
double largest_shear(const Stress& s);

// Of constant tractions on every cell, with transforms over the cells: exact for them, to 1e-13 of
// the largest (Boussinesq's and Cerruti's potentials over a rectangle: Love 1929; Johnson, Contact
// Mechanics, 1985, ch. 3). What the cells leave out of smooth tractions goes with the square of
// their size; at depths below half a cell only the cells' middles are good, not their edges.
class Subsurface {
 public:
  // Poisson's ratio 0 to 0.5 of the body. p >= 0 presses on its surface, qx and qy pull along x and
  // y; one value a cell [Pa]. Throws InputError on a ratio out of range, a vector of another size,
  // or a value that is not finite.
  Subsurface(const Grid& grid, double poisson, const Eigen::VectorXd& p, const Eigen::VectorXd& qx,
             const Eigen::VectorXd& qy);
  ~Subsurface();
  Subsurface(Subsurface&&) noexcept;

  // Below the middles of the cells at a depth >= 0 [m].
  Stresses at(double depth) const;
  // Those of p alone, and of qx and qy alone.
  std::array<Stresses, 2> parts_at(double depth) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

struct LargestStress {
  struct Place {
    double value = 0;     // [Pa]
    double depth = 0;     // [m]; 0: at the surface
    double x = 0, y = 0;  // of the cell [m]
  };
  Place von_mises, shear;
  // What they are found from: the depths, the largest at each, and the largest von Mises stress
  // below every cell.
  Eigen::VectorXd depths, von_mises_at, shear_at, below;
};

// The largest stresses from the surface down to twice the narrower semi-axis of the ellipse with
// the pressure's second moments, at the surface and 17 depths that grow by 1.2, and from a parabola
// through the deepest three of these: below the surface to 0.5 % on 32 x 32 cells of a smooth
// contact. At the surface a sliding contact (friction above some 0.35) is worst in its last cell,
// where 40 cells are 7 % low. All zero without pressure. Throws as Subsurface, and for pressures <
// 0.
LargestStress largest_stress(const Grid& grid, double poisson, const Eigen::VectorXd& p,
                             const Eigen::VectorXd& qx, const Eigen::VectorXd& qy);

// The same of both bodies of a contact, of one Poisson's ratio: the second is pulled the other way.
std::array<LargestStress, 2> largest_stresses(const Grid& grid, double poisson,
                                              const Eigen::VectorXd& p, const Eigen::VectorXd& qx,
                                              const Eigen::VectorXd& qy);

}  // namespace railbook::contact
