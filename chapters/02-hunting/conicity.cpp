/***
### Equivalent conicity

One number often stands for all this: the cone that would make a free wheelset weave with the same wavelength. A
wheelset that follows its rolling radii moves along the track by $y''=-R(y)/r_0$, and from the wavelength $L$ at
amplitude $A$ Klingel's formula turned round gives

$$\lambda_e(A)=\Big(\frac{2\pi}{L}\Big)^2 a\,r_0,$$

the definition of EN 15302. Two shortcuts are common: the describing function of $R$ (its first harmonic, which is
what Figure 7 of the paper plots and its text calls conicity), and the slope of a straight line fitted to $r_L-r_R$.

{{fig-conicity}}

{{conicity-table}}

On the tread the first two agree within {{tread-difference}}, and the fitted line follows within a few percent.
At the flange they do not: at {{flange-at}} the new wheel
has {{flange-kinematic}} by wavelength, {{flange-harmonic}} by the first harmonic and {{flange-regression}} by the
fitted line, and which of them a limit cycle feels is a question of the car's dynamics, not of geometry. The dip of
the Heumann wheel to {{heumann-dip}} near {{heumann-dip-at}} is what the paper blames for that wheel's low limit cycle
without flange contact.
*/

#include "wheelrail/conicity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "items.hpp"
#include "units/constants.hpp"

using namespace railbook;
using namespace railbook::hunting_chapter;
using namespace railbook::wheelrail;
using units::inch;
using units::millimetre;

namespace {

void conicity_figure(report::Item& item) {
  report::Data& data = item.data(
      {"amplitude_mm", "new", "new_harmonic", "cn", "cn_harmonic", "heumann", "heumann_harmonic"});
  double dip = 1, dip_at = 0, difference = 0;
  for (int i = 1; i <= 375; ++i) {
    const double A = 0.002 * inch * i;
    const Conicity n = conicity(new_wheel_table(), A), c = conicity(cn_table(), A),
                   h = conicity(heumann_table(), A);
    data.add(A / millimetre, n.kinematic, n.harmonic, c.kinematic, c.harmonic, h.kinematic,
             h.harmonic);
    if (A < 0.3 * inch && h.harmonic < dip) dip = h.harmonic, dip_at = A;
    if (A < 0.25 * inch)
      for (const auto& at : {n, c, h})
        difference = std::max(difference, std::abs(at.harmonic / at.kinematic - 1));
  }
  const double A = 12 * millimetre;
  const Conicity at = conicity(new_wheel_table(), A);
  item.value("flange-at", A / millimetre, "mm", "{:.0f}");
  item.value("flange-kinematic", at.kinematic, "", "{:.3f}");
  item.value("flange-harmonic", at.harmonic, "", "{:.3f}");
  item.value("flange-regression", at.regression, "", "{:.3f}");
  item.value("heumann-dip", dip, "", "{:.3f}");
  item.value("heumann-dip-at", dip_at / inch, "in", "{:.2f}");
  item.value("tread-difference", 100 * difference, "%", "{:.1f}");
  item.reconstructed("not in the paper; from reconstructed profiles");
}

void conicity_table(report::Item& item) {
  item.columns({"amplitude, mm", "new: λ_e", "first harmonic", "fitted line", "CN: λ_e",
                "first harmonic", "fitted line", "Heumann: λ_e", "first harmonic", "fitted line"});
  for (const double A : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 15.0}) {
    std::vector<std::string> row{fmt::format("{:.0f}", A)};
    for (const NamedPair& named : paper_pairs) {
      const Conicity c = conicity(named.table(), A * millimetre);
      for (const double value : {c.kinematic, c.harmonic, c.regression})
        row.push_back(fmt::format("{:.4f}", value));
    }
    item.add_row(row);
  }
  item.reconstructed("not in the paper; from reconstructed profiles");
}

}  // namespace

void hunting_chapter::add_conicity(report::Chapter& chapter) {
  chapter.figure("fig-conicity", "Equivalent conicity against amplitude", conicity_figure);
  chapter.table("conicity-table", "Equivalent conicity by three definitions", conicity_table);
}
