// Steady rolling of elastically unlike bodies.
#pragma once

#include <memory>

#include <railbook/rolling/contact.hpp>

namespace railbook::rolling {

// As solve_rolling on a given pressure, with Kalker's K of the pair (material_pair.hpp, -0.5 to
// 0.5): pressures drive unlike surfaces apart along themselves, which is slip (Bentall and Johnson
// 1967). What the tractions do to the pressure in return, of the order mu K, is left out. Throws
// InputError as solve_rolling, and on a K out of range.
CreepForces solve_rolling_unlike(const contact::Grid& grid, const Eigen::VectorXd& pressure,
                                 const RollingCase& c, const RollingOptions& options,
                                 double dissimilarity);

// The same for contacts much alike, one after the other: each solution starts from the last one,
// whose influence is kept where the cells have its number and shape.
class RollingSeries {
 public:
  RollingSeries();
  ~RollingSeries();
  RollingSeries(const RollingSeries&);
  RollingSeries& operator=(RollingSeries&&) noexcept;
  CreepForces solve(const contact::Grid& grid, const Eigen::VectorXd& pressure,
                    const RollingCase& c, const RollingOptions& options, double dissimilarity);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace railbook::rolling
