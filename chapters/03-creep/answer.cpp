/***
Below {{fig-full-curve}} creep and spin can be moved, for the rig's ellipse at the printed load and friction: the cells that stick and those that slide, and the tractions along the middle.
The contact rolls to the right; what slides begins at the trailing edge, and spin moves it to one side.
*/

#include "report/answer.hpp"

#include "curve.hpp"
#include "rolling/rolling_contact.hpp"
#include "sections.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::rolling;

void creep_chapter::contact_answer(report::Item& item) {
  constexpr const char *patch = "patch", *middle = "middle";
  report::Answer answer{item,
                        {"creep_‰", "spin_1/m"},
                        {{.name = patch,
                          .x_label = "along rolling, mm",
                          .y_label = "across, mm",
                          .x_from = -1.6,
                          .x_to = 1.6,
                          .y_from = -1.1,
                          .y_to = 1.1,
                          .kind = "cells"},
                         {middle, "along rolling, mm", "traction, MPa", -1.6, 1.6, -500, 500},
                         {.name = "forces", .kind = "says"}}};
  RollingCase c = rig_case();
  const EllipseRolling contact(c.a / c.b, c.poisson, {.along = 14, .rows = 9});
  for (const double creep : {0.25, 0.5, 1., 2., 3., 4., 6.})
    for (const double spin : {0., 1., 3., 6., 12., 25.}) {
      c.creepage = {creep / 1000, 0, spin};
      const CreepForces f = contact.solve(c);
      if (!f.converged) throw std::runtime_error(f.reason);
      answer.at({creep, spin});
      const Tractions& t = f.tractions;
      for (Eigen::Index i = 0; i < t.x.size(); ++i) {
        const double x = t.x[i] / units::millimetre, y = t.y[i] / units::millimetre;
        answer.point(patch, t.stick[i] > 0 ? "sticks" : "slides", x, y);
        if (std::abs(y) > 1e-9) continue;
        answer.point(middle, "along", x, t.px[i] / units::megapascal);
        answer.point(middle, "across", x, t.py[i] / units::megapascal);
        answer.point(middle, "limit", x, t.bound[i] / units::megapascal);
      }
      answer.says("forces", "along rolling over µN", f.fx / (c.friction * c.load));
      answer.says("forces", "across over µN", f.fy / (c.friction * c.load));
      answer.says("forces", "area that sticks, %", 100 * f.stick_share);
    }
}
