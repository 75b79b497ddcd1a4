// Cattaneo's problem: a Hertz contact pulled sideways without rolling, exact and by cells.
#pragma once

#include <Eigen/Core>

#include "rolling/rolling_case.hpp"

namespace railbook::rolling {

// C. Cattaneo (1938), R. D. Mindlin (1949): an inner ellipse sticks, similar to the contact's and smaller by
// (1 - q)^(1/3), q = Q/(mu N) from 0 to 1. Exact for nu = 0; otherwise the slip is not quite along the traction.
double cattaneo_stick_ratio(double q);
// The traction along the pull over mu p0 at radius r of the contact (x^2/a^2 + y^2/b^2 = r^2 <= 1).
double cattaneo_traction(double q, double r);
// The shift of one body against the other, times G sqrt(a b)/(mu N), for nu = 0 and axis ratio a/b > 0.
double cattaneo_shift(double axis_ratio, double q);

// The same by rows of cells of constant traction: the case's longitudinal and lateral creepage are the shift [m] of body 1
// against body 2 along x and y; its spin is not used. Error of the force about 1e-3 mu N with 32 x 32 cells.
CreepForces solve_shift(const RollingCase& c, Eigen::Index along = 32, Eigen::Index rows = 32);

}  // namespace railbook::rolling
