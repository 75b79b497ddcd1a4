/***
### Mode shapes

{{fig-12}} is the paper's Figure 12: for new wheels, each motion over that of the rear truck, and the frequency, against amplitude.
On the tread nothing changes, as the cone is straight. When the flange is met the shape changes abruptly.

The paper's "limiting mode with flange contact" is fishtailing: the rear truck swings, the front truck and the body hardly move. It is not on the branch that begins at the first
critical speed, whose trucks stay together all the way (thick lines). It is on the **second** family (thin lines). Why the paper's curve leads from one to
the other is shown in the next section: its algorithm loses the first branch at 0.40 in and finds the second above.

{{fig-12}}

{{mode-claims}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "items.hpp"
#include "study.hpp"

namespace railbook::hunting_chapter {

using namespace dynamics;

namespace {

// |q_k| / |X_TR| as in the paper's figure; angles in rad a foot of X_TR.
double relative(const CyclePoint& p, int coordinate) {
  const double ratio = std::abs(p.motion.shape[coordinate]) / std::abs(p.motion.shape[X_TR]);
  const bool angle = coordinate != X_TF && coordinate != X_C;
  return angle ? ratio * units::foot : ratio;
}

void add_curve(report::Data& data, const CycleBranch& branch) {
  for (const auto& p : branch.points)
    data.add(p.largest / units::inch, relative(p, X_TF), relative(p, X_C), relative(p, TH_TR),
             relative(p, TH_WR), relative(p, TH_C), relative(p, PHI_C), p.motion.lambda.imag());
}

const std::vector<std::string> columns{"A_in",  "X_TF", "X_C",   "TH_TR",
                                       "TH_WR", "TH_C", "PHI_C", "omega"};

void figure_12(report::Item& item) {
  item.reconstructed("profiles and equivalent dampers are ours; the paper's curves are lost");
  add_curve(item.data(columns), study("new").branches[0]);
  add_curve(item.data("second", columns), study("new").branches[1]);
}

const CyclePoint tread(const std::string& key) {
  const Study& s = study(key);
  return cycles_at_amplitude(s.car, s.branches[0], 0.1 * units::inch).at(0);
}

void mode_claims(report::Item& item) {
  const auto printed = item.printed("modes.csv");
  item.columns({"claim", "printed", "computed"});
  item.reconstructed("profiles and equivalent dampers are ours");
  item.expect_checks(9);
  const auto claim = [&](const std::string& key, bool holds, const std::string& numbers) {
    const std::string& what = printed.at(key, "what");
    const std::string& said = printed.at(key, "printed");
    item.add_row({what, said, fmt::format("{}: {}", holds ? "yes" : "no", numbers)});
    item.check_text(key, what, said, holds ? "yes" : "no");
  };
  for (const char* key : {"new", "cn", "heumann"}) {
    const auto p = tread(key);
    const double body = relative(p, X_C), front = relative(p, X_TF);
    const double trucks = std::min(front, 1 / front);
    claim(fmt::format("body-{}", key), std::string{"new"} == key ? body > 0.5 : body < 0.1,
          fmt::format("{:.3f}", body));
    claim(fmt::format("trucks-{}", key), trucks > 0.9, fmt::format("{:.3f}", trucks));
  }
  const auto fresh = tread("new"), worn = tread("cn");
  claim("yaw-and-warp",
        relative(worn, TH_TR) > relative(fresh, TH_TR) &&
            relative(worn, TH_WR) > relative(fresh, TH_WR),
        fmt::format("yaw {:.3f} and warp {:.3f} rad/ft, new; {:.3f} and {:.3f}, CN A",
                    relative(fresh, TH_TR), relative(fresh, TH_WR), relative(worn, TH_TR),
                    relative(worn, TH_WR)));
  const Study& s = study("new");
  double least = 1e9, most = 0;
  for (const auto& p : s.branches[0].points)
    if (p.neutral) {
      least = std::min(least, relative(p, X_C));
      most = std::max(most, relative(p, X_C));
    }
  claim("constant-on-tread", most - least < 1e-6,
        fmt::format("X_C/X_TR {:.6f} to {:.6f}", least, most));
  const auto fish = cycles_at_amplitude(s.car, s.branches[1], 0.48 * units::inch).at(0);
  claim("fishtailing", relative(fish, X_TF) < 0.1 && relative(fish, X_C) < 0.2,
        fmt::format("second family at 0.48 in: X_TF {:.3f}, X_C {:.3f} of X_TR",
                    relative(fish, X_TF), relative(fish, X_C)));
}

}  // namespace

void add_modes(report::Chapter& chapter) {
  chapter.figure("fig-12", "Mode shapes with new wheels against amplitude (the paper's Fig. 12)",
                 figure_12);
  chapter.table("mode-claims", "What the text says of mode shapes", mode_claims);
}

}  // namespace railbook::hunting_chapter
