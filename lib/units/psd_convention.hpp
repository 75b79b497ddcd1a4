// What a power spectral density means: which side, which variable. Never mix two without converting.
#pragma once

#include "units/constants.hpp"

namespace railbook::units {

enum class Sides { one, two };  // all power at positive frequencies, or half at each sign
enum class SpectralVariable { cycles, radians };  // per cycle/m (or Hz), or per rad/m (or rad/s)

struct PsdConvention {
  Sides sides = Sides::one;
  SpectralVariable variable = SpectralVariable::cycles;
  friend bool operator==(const PsdConvention&, const PsdConvention&) = default;
};

// Factor on a density when it is re-expressed from one convention in another; the frequency axis of a
// radian density is 2 pi times that of a cycle density, and the variance is the same in all of them.
constexpr double psd_factor(PsdConvention from, PsdConvention to) {
  double factor = 1.0;
  if (from.sides != to.sides) factor *= to.sides == Sides::one ? 2.0 : 0.5;
  if (from.variable != to.variable)
    factor *= to.variable == SpectralVariable::cycles ? 2.0 * pi : 1.0 / (2.0 * pi);
  return factor;
}

}  // namespace railbook::units
