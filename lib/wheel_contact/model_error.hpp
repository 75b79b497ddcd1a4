// How far this library's answers are from those of CONTACT, the reference program, over the cases
// of its test bank that both answer (tests/reference/peer_bank).
#pragma once

#include <array>

namespace railbook::wheel_contact {

// Of ln(ours/theirs) over `count` values: mean and standard deviation, ours on cells of half the
// bank's size. `agree` of them are within 1 %. `cells` more are so on the bank's own cells,
// which make the difference, or were solved on these alone (long histories); `differ` are not.
// `small` further values are below 2 % of what the quantity can be, and not compared.
struct ModelError {
  const char* key;       // for programs: "largest_pressure"
  const char* quantity;  // for people: "largest pressure"
  int count, agree, cells, differ, small;
  double bias, scatter;
};

// The test "reference: peer_bank" computes them again and compares.
inline constexpr std::array model_errors{
    ModelError{"approach", "approach", 67, 67, 0, 0, 0, 0.0005, 0.0013},
    ModelError{"contact_area", "contact area", 143, 94, 21, 28, 0, -0.0122, 0.0194},
    ModelError{"creepage_or_shift_of_a_given_force", "creepage or shift of a given force", 180, 14,
               166, 0, 0, 0.0039, 0.0064},
    ModelError{"largest_pressure", "largest pressure", 140, 133, 0, 7, 0, -0.0009, 0.0036},
    ModelError{"lateral_force", "lateral force", 286, 40, 244, 2, 280, -0.0024, 0.0036},
    ModelError{"lateral_force_of_FASTSIM", "lateral force of FASTSIM", 5, 2, 0, 3, 30, 0.0167,
               0.0250},
    ModelError{"longitudinal_force", "longitudinal force", 377, 124, 253, 0, 9, -0.0009, 0.0030},
    ModelError{"longitudinal_force_of_FASTSIM", "longitudinal force of FASTSIM", 29, 24, 0, 5, 6,
               -0.0042, 0.0080},
    ModelError{"moment", "moment", 19, 7, 11, 1, 304, 0.0046, 0.0145},
    ModelError{"moment_of_FASTSIM", "moment of FASTSIM", 5, 2, 0, 3, 30, -0.0294, 0.0297},
    ModelError{"normal_force", "normal force", 117, 117, 0, 0, 0, -0.0003, 0.0004},
    ModelError{"power_of_friction", "power of friction", 41, 13, 0, 28, 0, 0.0190, 0.0424},
    ModelError{"stick_area", "stick area", 459, 38, 411, 10, 107, 0.0013, 0.0125},
};

}  // namespace railbook::wheel_contact
