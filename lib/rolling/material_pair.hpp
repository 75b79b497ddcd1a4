// Two bodies' materials as one, for rolling contact.
#pragma once

#include <railbook/contact/normal_contact.hpp>

namespace railbook::rolling {

struct Steel {
  double young = 207e9;  // [Pa]
  double poisson = 0.3;
};

// Relative accuracy 2e-15 (of K absolute: equal bodies differ by rounding). Throws InputError on a
// modulus or ratio out of range. G and nu of the pair as RollingCase wants them, E*, and Kalker's
// K, which is 0 for elastically similar bodies: then the pressure does not depend on the tractions.
struct MaterialPair {
  double shear_modulus, poisson, effective_modulus, dissimilarity;
};
inline MaterialPair combine(const Steel& one, const Steel& two) {
  const double g1 = one.young / (2 * (1 + one.poisson)), g2 = two.young / (2 * (1 + two.poisson));
  const double g = 2 / (1 / g1 + 1 / g2);
  return {g, g / 2 * (one.poisson / g1 + two.poisson / g2),
          contact::effective_modulus({one.young, one.poisson, two.young, two.poisson}),
          g / 4 * ((1 - 2 * one.poisson) / g1 - (1 - 2 * two.poisson) / g2)};
}

}  // namespace railbook::rolling
