// Two bodies' materials as one, for rolling contact.
#pragma once

#include <railbook/contact/material.hpp>

namespace railbook::rolling {

// Relative accuracy 2e-15 (of K absolute: equal bodies differ by rounding). Throws InputError on a
// modulus or ratio out of range. G and nu of the pair as RollingCase wants them, E*, and Kalker's
// K, which is 0 for elastically similar bodies: then the pressure does not depend on the tractions.
struct MaterialPair {
  double shear_modulus, poisson, effective_modulus, dissimilarity;
};
inline MaterialPair combine(const contact::Material& one, const contact::Material& two) {
  const double g1 = one.shear_modulus(), g2 = two.shear_modulus();
  const double g = 2 / (1 / g1 + 1 / g2);
  return {g, g / 2 * (one.poisson / g1 + two.poisson / g2), contact::effective_modulus(one, two),
          g / 4 * ((1 - 2 * one.poisson) / g1 - (1 - 2 * two.poisson) / g2)};
}

}  // namespace railbook::rolling
