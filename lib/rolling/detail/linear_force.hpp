// What the fast theories start from: Kalker's linear force, as a direction and a size.
#pragma once

#include <railbook/rolling/case.hpp>
#include <railbook/rolling/kalker_table.hpp>

namespace railbook::rolling {

struct LinearForce {
  double scale = 0;     // G a b [N]
  double size = 0;      // |force| over G a b
  double x = 0, y = 0;  // its direction; zero without a force
  double moment = 0;    // mz over G a b [m]
  double reduced = 0;   // |force| over mu N; not_known for friction 0
};

// Throws InputError on a case out of range.
LinearForce linear_force(const RollingCase& c, const KalkerCoefficients& k);

}  // namespace railbook::rolling
