// How far this library's answers are from those of CONTACT, the reference program, over the cases
// of its test bank that both answer (tests/reference/peer_bank).
#pragma once

#include <array>

namespace railbook::wheel_contact {

// Of ln(ours/theirs) over `count` values: mean and standard deviation, ours on cells of half the
// bank's size. `agree` of them are within 1 %. `cells` more are so on the bank's own cells, which
// make the difference; `differ` are not. `small` further values are below 2 % of what the quantity
// can be, and not compared. `limit` is the mean with ours extrapolated to cells of no size, which
// changes what is solved in steps along a history.
struct ModelError {
  const char* key;       // for programs: "largest_pressure"
  const char* quantity;  // for people: "largest pressure"
  int count, agree, cells, differ, small;
  double bias, scatter, limit;
};

// The test "reference: peer_bank" computes them again and compares.
inline constexpr std::array model_errors{
    ModelError{"approach", "approach", 67, 67, 0, 0, 0, 0.0005, 0.0013, 0.0005},
    ModelError{"contact_area", "contact area", 143, 94, 21, 28, 0, -0.0122, 0.0194, -0.0122},
    ModelError{"creepage_or_shift_of_a_given_force", "creepage or shift of a given force", 180, 30,
               150, 0, 0, 0.0115, 0.0058, 0.0228},
    ModelError{"largest_Tresca_stress", "largest Tresca stress", 2, 2, 0, 0, 0, 0.0003, 0.0005,
               0.0003},
    ModelError{"largest_pressure", "largest pressure", 140, 133, 0, 7, 0, -0.0009, 0.0036, -0.0009},
    ModelError{"largest_von_Mises_stress", "largest von Mises stress", 2, 2, 0, 0, 0, 0.0002,
               0.0002, 0.0002},
    ModelError{"lateral_force", "lateral force", 286, 218, 66, 2, 280, -0.0079, 0.0044, -0.0135},
    ModelError{"lateral_force_of_FASTSIM", "lateral force of FASTSIM", 5, 2, 0, 3, 30, 0.0167,
               0.0250, 0.0167},
    ModelError{"lateral_force_of_the_creep_table", "lateral force of the creep table", 180, 35, 145,
               0, 12, 0.0113, 0.1664, 0.0113},
    ModelError{"longitudinal_force", "longitudinal force", 377, 326, 51, 0, 9, -0.0049, 0.0040,
               -0.0089},
    ModelError{"longitudinal_force_of_FASTSIM", "longitudinal force of FASTSIM", 29, 24, 0, 5, 6,
               -0.0042, 0.0080, -0.0042},
    ModelError{"longitudinal_force_of_the_creep_table", "longitudinal force of the creep table",
               192, 69, 123, 0, 0, -0.0224, 0.0187, -0.0224},
    ModelError{"mean_stress", "mean stress", 16, 16, 0, 0, 0, 0.0001, 0.0001, 0.0001},
    ModelError{"moment", "moment", 19, 7, 11, 1, 304, 0.0046, 0.0145, 0.0046},
    ModelError{"moment_of_FASTSIM", "moment of FASTSIM", 5, 2, 0, 3, 30, -0.0294, 0.0297, -0.0294},
    ModelError{"moment_of_the_creep_table", "moment of the creep table", 173, 13, 160, 0, 19,
               0.0038, 0.0798, 0.0038},
    ModelError{"normal_force", "normal force", 117, 117, 0, 0, 0, -0.0003, 0.0004, -0.0003},
    ModelError{"power_of_friction", "power of friction", 41, 13, 0, 28, 0, 0.0190, 0.0424, 0.0190},
    ModelError{"pressure_of_a_cell", "pressure of a cell", 47, 41, 6, 0, 0, -0.0037, 0.0111,
               -0.0037},
    ModelError{"shear_stress_zx", "shear stress zx", 13, 13, 0, 0, 0, 0.0005, 0.0005, 0.0005},
    ModelError{"stick_area", "stick area", 459, 314, 140, 5, 107, 0.0074, 0.0120, 0.0146},
    ModelError{"traction_of_a_cell", "traction of a cell", 21, 14, 7, 0, 0, -0.0084, 0.0134,
               -0.0084},
    ModelError{"von_Mises_stress", "von Mises stress", 15, 15, 0, 0, 0, 0.0000, 0.0001, 0.0000},
};

}  // namespace railbook::wheel_contact
