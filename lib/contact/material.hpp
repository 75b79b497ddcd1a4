// The elastic material of a body, and the steel that every tool takes when it is given none.
#pragma once

namespace railbook::contact {

// An isotropic elastic solid: Young's modulus (Pa, > 0) and Poisson's ratio (0 <= nu <= 0.5).
struct Material {
  double young = 0;
  double poisson = 0;
  constexpr double shear_modulus() const { return young / (2 * (1 + poisson)); }
};

// Rail and wheel steel as rolling contact usually takes it: G = 82 GPa and nu = 0.28 in the
// examples of CONTACT, with E rounded to three digits. A chapter has its paper's own values.
inline constexpr Material default_steel{210e9, 0.28};

// E* of two bodies, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa]; k of eq. (9) of chapter 01
// is 1/(pi E*). Relative accuracy 2e-15. Throws InputError on a modulus or a ratio out of range.
double effective_modulus(const Material& one, const Material& two);

}  // namespace railbook::contact
