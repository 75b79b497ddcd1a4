/***
Below {{fig-09}} the wheel can be moved across the rail at the same approach: from the crown, where the contact is an ellipse, over the jump of the radius into the corner.
*/
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "contact/cg_fft.hpp"
#include "report/answer.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter {

namespace {

// The bodies of Example 2 touching `at` (m) to the right of the jump; x counts from there.
Gap gap_at(double at) {
  const auto radius = [](double x) { return x < 0 ? crown_radius : corner_radius; };
  const auto drop = [radius](double x) { return x * x / (2 * radius(x)); };
  const double height = drop(at), slope = at / radius(at);
  return [=](double x, double y) {
    return drop(at + x) - height - slope * x - x * x / (2 * tread_radius) +
           y * y / (2 * wheel_radius);
  };
}

// The two sides of the patch, row by row, as one closed line.
void add_outline(report::Answer& answer, const NormalContact& c, double at) {
  std::map<double, std::pair<double, double>> rows;
  for (Eigen::Index i = 0; i < c.x.size(); ++i) {
    const double left = c.x[i] - c.dx[i] / 2, right = c.x[i] + c.dx[i] / 2;
    const auto row = rows.try_emplace(c.y[i], left, right).first;
    row->second = {std::min(row->second.first, left), std::max(row->second.second, right)};
  }
  const auto point = [&](double x, double y) {
    answer.point("patch", "", (x + at) / inch, 1e-6 * std::round(1e6 * y / inch));  // 0, not 1e-9
  };
  for (const auto& [y, ends] : rows) point(ends.first, y);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) point(row->second.second, row->first);
  point(rows.begin()->second.first, rows.begin()->first);
}

}  // namespace

void place_answer(report::Item& item) {
  report::Answer answer{
      item,
      {"place_in"},
      {{"pressure along the axis", "across the rail from the jump, in", "pressure, 10⁵ psi", -1.2,
        0.6, 0, 6},
       {"patch", "across the rail from the jump, in", "along the rail, in", -1.2, 0.6, -0.5, 0.5},
       {.name = "result", .kind = "says"}}};
  for (const double place : {-0.6, -0.5, -0.4, -0.3, -0.2, -0.1, -0.05, 0.0, 0.05, 0.1, 0.2, 0.3}) {
    const double at = place * inch;
    CgFftOptions options;
    options.nx = options.ny = 63;
    if (std::abs(place) < 0.55) options.edge_x = -at;
    const NormalContact c = solve_cg_fft(gap_at(at), delta_2, modulus, options).contact;
    answer.at({place});
    const double middle = c.y.cwiseAbs().minCoeff();
    for (Eigen::Index i = 0; i < c.x.size(); ++i)
      if (std::abs(c.y[i] - middle) < 1e-9 * inch)
        answer.point("pressure along the axis", "", (c.x[i] + at) / inch, c.p[i] / (1e5 * psi));
    add_outline(answer, c, at);
    answer.says("result", "force, lbf", c.force / lbf);
    answer.says("result", "moment about the jump, in·lbf",
                (c.moment_y + at * c.force) / (inch * lbf));
    answer.says("result", "peak, 10⁵ psi", c.p_max / (1e5 * psi));
  }
}

}  // namespace railbook::contact_chapter
