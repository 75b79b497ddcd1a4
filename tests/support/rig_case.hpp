// The creep rig's contact at about 1000 lbf, for tests of rolling contact.
#pragma once

#include <railbook/rolling/case.hpp>

namespace railbook {

inline constexpr rolling::RollingCase rig_case{.a = 1.49e-3,
                                               .b = 0.95e-3,
                                               .load = 4450,
                                               .shear_modulus = 79.6e9,
                                               .poisson = 0.3,
                                               .friction = 0.3,
                                               .creepage = {}};

}  // namespace railbook
