/***
## From stone to springs

The foundation modulus of a given track is seldom known. The paper builds it from parts that can be
known ({{fig-02}}). Under each rail seat, where the rail rests on a tie, lie a pad (if any), the
tie, the ballast (a bed of stone) and the subgrade (the ground), as springs in series. With ties a
distance $l_t$ apart and a stiffness $k$ of the rail seat,

$$K=\frac{k}{l_t}, \tag{3}$$

$$\frac1k=\frac1{k_{pad}}+\frac1{k_{tie}}+\frac2{k_{bs}}, \tag{4}$$

$$\frac1{k_{bs}}=\frac1{k_b}+\frac1{k_s}, \tag{5}$$

where $k_{pad}$ and $k_{tie}$ are the stiffnesses of pad and tie and $k_{bs}$ that of the bed, of
ballast $k_b$ and subgrade $k_s$ in series (all in lbf/in). The factor 2 is empirical. The ground is
continuous, so a tie sinks about twice as far when its neighbours are loaded too as it does alone.
Separate springs would not do this, and the bed is therefore taken half as stiff.

{{fig-02}}

The model assumes that only a pyramid of the ballast carries load. Its sides are at the friction
angle $\alpha$ (20° in the paper) to the vertical, and at each depth the pressure is uniform. The
subgrade is a bed of springs $K_0$ below the pyramid's base:

$$k_b=\frac{C(l-w)E_b}{\ln\dfrac{l\,(w+Ch)}{w\,(l+Ch)}},\qquad C=2\tan\alpha, \tag{6}$$

$$k_s=K_0(l+Ch)(w+Ch), \tag{7}$$

for a loaded area $l\times w$ below the rail seat, a depth $h$ of the ballast and its Young's
modulus $E_b$; $K_0$ is the pressure on the subgrade for each inch that it yields. For a square area
($l=w$) and for vertical sides ($\alpha=0$) the printed form (6) is 0/0, although nothing special
happens to the ballast there. The function `stiffness_chain` therefore takes the ballast's
compliance (its `ballast_compliance`) from

$$\frac1{k_b}=\frac{h}{E_b\,w\,(l+Ch)}\cdot\frac{\ln(1+\chi)}{\chi},\qquad \chi=\frac{Ch\,(l-w)}{w\,(l+Ch)},$$

which is (6) rearranged and has a value in both cases.

{{code: track/stiffness_chain.cpp stiffness_chain}}

{{chain: checks}}

{{chain}} is our *typical track*. Every length and modulus in it but the 20° is assumed: ordinary
values, chosen so that zero deflection is at ten feet.

Two things stand out. The subgrade decides: on this track the ballast is {{soil-softer}} times as
stiff as the subgrade, and even on the stiffest soil that this page tries, 460 lbf/in³, it is more
than three times as stiff. And
deeper ballast makes *stiffer* track although it adds a spring in series, because the pyramid
spreads the load over more soil: 14 in of it instead of 12 give {{deeper}} more $K_r$. Once the
pyramids of neighbouring ties meet, here at {{overlap}} of ballast, the model counts the stone and
the soil of their overlap twice, and is too stiff.
*/
#include <fmt/format.h>

#include <cmath>

#include <railbook/num/quadrature.hpp>
#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>
#include <railbook/track/typical_track.hpp>

#include "sections.hpp"

namespace railbook::track_chapter {

using namespace track;

double printed_ballast_stiffness(const TieSupport& s) {
  const double l = s.loaded_length, w = s.tie_width, spread = 2 * std::tan(s.friction_angle);
  const double reach = spread * s.ballast_depth;
  return spread * (l - w) * s.ballast_modulus / std::log(l * (w + reach) / (w * (l + reach)));
}

double ballast_by_slices(const TieSupport& s) {
  const double spread = 2 * std::tan(s.friction_angle);
  const auto slice = [&](double z) {
    return 1 / (s.ballast_modulus * (s.loaded_length + spread * z) * (s.tie_width + spread * z));
  };
  return 1 / num::integrate(slice, 0, s.ballast_depth, 1e-13).value;
}

namespace {

constexpr double tie_height = 7, rail_height = 7.1, wheel_radius = 18;

// Three ties with their pyramids, the rail and a wheel. x along the rail, z = 0 at the rail's foot.
scene::Scene track_scene(const TieSupport& support) {
  const double in = units::inch, pitch = support.tie_spacing / in, w = support.tie_width / in,
               l = support.loaded_length / in, h = support.ballast_depth / in,
               spread = 2 * std::tan(support.friction_angle) * h;
  scene::Scene s;
  for (int i = -1; i <= 1; ++i) {
    const double x = i * pitch;
    s.meshes.push_back(scene::box({x - w / 2, -25, -tie_height}, {x + w / 2, 25, 0}, scene::wood));
    s.meshes.push_back(scene::frustum({x, 0}, {w + spread, l + spread}, -tie_height - h, {w, l},
                                      -tie_height, scene::stone));
  }
  s.meshes.push_back(scene::box({-1.7 * pitch, -27, -tie_height - h - 6},
                                {1.7 * pitch, 27, -tie_height - h}, scene::soil));
  s.meshes.push_back(scene::extrusion(scene::rail_section(rail_height, 3, 1.8, 0.7, 6, 1),
                                      -1.7 * pitch, 1.7 * pitch, scene::steel));
  // Hub, web, flange and tread from the gauge side, with the stub of an axle.
  const scene::Outline wheel{{0, 0},    {0, 4.6},    {1.8, 5.4}, {1.8, 14.0}, {0, 15.4},
                             {0, 19.0}, {1.2, 19.0}, {1.25, 18}, {5.2, 18},   {5.2, 0}};
  s.meshes.push_back(scene::revolution({0, -2.8, rail_height + wheel_radius}, {0, 1, 0}, wheel));
  s.meshes.push_back(scene::cylinder({0, -14, rail_height + wheel_radius},
                                     {0, -2, rail_height + wheel_radius}, 3.4));
  return s;
}

// The chain beside it, one spring a part, stacked on the level of the subgrade.
void add_chain_of_springs(scene::Scene& s, double x, std::vector<scene::Label>& labels) {
  const auto plate = [&](double z, double half, const scene::Colour& colour) {
    s.meshes.push_back(scene::box({x - half, -half, z - 0.7}, {x + half, half, z}, colour));
  };
  const char* names[] = {"subgrade  k_s/2", "ballast  k_b/2", "tie  k_{tie}", "pad  k_{pad}"};
  const scene::Colour colours[] = {scene::soil, scene::stone, scene::wood, scene::steel};
  double z = -25;
  plate(z, 11, scene::soil);
  for (int i = 0; i < 4; ++i) {
    const double top = z + 10.5;
    s.meshes.push_back(scene::spring({x, 0, z}, {x, 0, top - 0.7}, 3.0, 0.55, 4, colours[i]));
    plate(top, i == 3 ? 7 : 4.5, i == 3 ? scene::steel : colours[i]);
    labels.push_back({{x - 23, 0, z + 5}, names[i]});
    z = top;
  }
  s.meshes.push_back(
      scene::extrusion(scene::rail_section(rail_height, 3, 1.8, 0.7, 6, 1), x - 7, x + 7));
  s.meshes.back().vertices.col(2).array() += z;
}

void draw_steps(report::Item& item) {
  item.sketch(
      "drawn to scale from the assumed typical track; the paper's drawing is not in the copy");
  std::vector<scene::Label> labels{{{9, -3, 40}, "wheel P"},
                                   {{-31, -3, 4.5}, "rail EI"},
                                   {{-21.5, -25, -3.5}, "tie"},
                                   {{-8, -22, -14.5}, "ballast pyramid"},
                                   {{-31, -27, -22}, "subgrade K_0"}};
  auto drawing = track_scene(typical_support());
  add_chain_of_springs(drawing, 66, labels);
  const scene::Size size{1000, 650};
  const auto camera = scene::looking_at(drawing, {0.35, -2.0, 0.55}, size, true);
  scene::labelled(item, "fig-02.gp", drawing, camera, size, labels);
}

void chain_table(report::Item& item) {
  item.rebuilt("the paper gives the formulas and the friction angle, no other datum");
  const auto support = typical_support();
  const auto chain = stiffness_chain(support);
  const auto beam = typical_beam();
  item.columns({"part", "from", {"value", "{:.1f}"}, "unit"});
  item.add_row("tie", "assumed", support.tie_stiffness / lb_per_in, "lbf/in");
  item.add_row("ballast", "(6): 30 × 9 in, 12 in deep, 30 000 psi, all assumed; 20°",
               chain.ballast / lb_per_in, "lbf/in");
  item.add_row("subgrade", "(7): 100 lbf/in³ assumed", chain.subgrade / lb_per_in, "lbf/in");
  item.add_row("ballast on subgrade", "(5)", chain.bed / lb_per_in, "lbf/in");
  item.add_row("rail seat", "(4)", chain.seat / lb_per_in, "lbf/in");
  item.add_row("foundation modulus K", "(3): ties 19.5 in apart, assumed",
               chain.foundation_modulus / units::psi, "psi");
  const auto& rail = typical_rail();
  item.add_row("under one wheel K_r",
               fmt::format("(2): 132RE, assumed; E = {:.0f}×10⁶ psi, I = {:.1f} in⁴",
                           rail.bending_stiffness() / rail.second_moment / units::psi / 1e6,
                           rail.second_moment / std::pow(units::inch, 4)),
               beam.point_stiffness() / lb_per_in, "lbf/in");
  item.expect_checks(2);
  const double slices = ballast_by_slices(support) / 1e6;
  item.agree("ballast", "ballast pyramid k_b, (6) rearranged", "MN/m", chain.ballast / 1e6, slices,
             1e-11, "slices of the pyramid, integrated");
  item.agree("ballast-as-printed", "ballast pyramid k_b, (6) as printed", "MN/m",
             printed_ballast_stiffness(support) / 1e6, slices, 1e-11,
             "slices of the pyramid, integrated");
  auto deeper = support;
  deeper.ballast_depth = 14 * units::inch;
  const double stiffer = stiffness_chain(deeper).foundation_modulus / chain.foundation_modulus;
  item.value("deeper", 100 * (std::pow(stiffer, 0.75) - 1), "%", "{:.0f}");
  item.value("soil-softer", chain.ballast / chain.subgrade, "", "{:.0f}");
  item.value("overlap", overlap_depth(support) / units::inch, "inches", "{:.1f}");
}

}  // namespace

const report::Section chain{report::figure("fig-02", draw_steps),
                            report::table("chain", chain_table)};

}  // namespace railbook::track_chapter
