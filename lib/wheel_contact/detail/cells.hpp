// The pressure of one patch on a uniform grid, between the exact surfaces.
#pragma once

#include <memory>

#include <railbook/contact/convolution.hpp>
#include <railbook/contact/region.hpp>
#include <railbook/wheel_contact/patch.hpp>

namespace railbook::wheel_contact {

// A patch's grid, the overlaps on it with the wheel at the depth z, and the pressure so far.
struct Cells {
  contact::Grid grid;
  Eigen::VectorXd overlap, pressure, lowered;
  std::unique_ptr<contact::Convolution> convolution;
  contact::Region region;

  Cells(const PlacedWheel& wheel, double effective_modulus, const Frame& frame, double z,
        const contact::Box& box, Eigen::Index nx, Eigen::Index ny);
  // The normal force [N], the wheel lowered by `down` [m] along n; negative when the solver fails.
  double solve(double down);
  void describe();
  // One and a half cells around the contact, of a grid of nx by ny cells.
  contact::Box around(Eigen::Index nx, Eigen::Index ny) const;
};

}  // namespace railbook::wheel_contact
