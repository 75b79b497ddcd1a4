// Lagrange's cubic between samples.
#pragma once

#include <array>

namespace railbook::filters::detail {

// The weights of the four samples from one before `t`, 0 <= t < 1, on.
inline std::array<double, 4> cubic(double t) {
  return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
          (t + 1) * t * (t - 1) / 6};
}

}  // namespace railbook::filters::detail
