/*** ## The patches on the wheel

{{scene}}

The slender patch lies on the slope that leads to the flange, where the wheel curves sharply and the
rail too. The tractions on both patches point mostly across, away from the flange: the wheelset is
yawed, so it rolls in another direction than it travels. The longest line of the slender patch is
1.5 mm long and stands for {{longest-line}}.

{{fold}}
*/
#include <cmath>
#include <vector>

#include <railbook/scene/colour_map.hpp>
#include <railbook/scene/labelled.hpp>
#include <railbook/scene/shapes.hpp>

#include "case_a.hpp"
#include "sections.hpp"

using namespace railbook;
using namespace railbook::profiles;
using namespace railbook::wheel_contact;
using namespace railbook::wheel_on_rail_chapter;
using Eigen::Index;
using Eigen::Vector3d;

namespace {

constexpr double mm = units::millimetre;
constexpr double scale_end = 1600 * units::megapascal;  // of the colours, as in wheel.gp

// As much as a picture shows, so that the tables of cells stay small.
double drawn(double length) {
  return std::round(1e4 * length / mm) / 1e4;
}
double drawn_pressure(double pressure) {
  return std::round(10 * pressure / units::megapascal) / 10;
}

const Wheel& fifth_wheel(const report::Item& item) {
  static const Wheel fifth = wheel_of(item.printed("case-a.csv"), "right", 5);
  return fifth;
}

// Places of a drawing, across and up or along [mm], or a gap [µm].
struct Place {
  double across, other;
};
using Places = std::vector<Place>;

double from_rail(double y) {
  return (y - rail_origin) / mm;
}

struct Sections {
  Places wheel, rail, gap;
};
Sections sections_of(const PlacedWheel& placed, double z) {
  Sections s;
  for (const PlacedWheel::Point& p : find_contact(placed).locus) {
    s.wheel.push_back({from_rail(p.at.y()), -(p.at.z() + z) / mm});
    const double left = (p.gap - z) / units::micrometre;
    if (std::abs(left) < 500) s.gap.push_back({from_rail(p.at.y()), left});
  }
  const Profile& head = placed.pair->rail;
  for (int k = 0; k <= 300; ++k) {
    const double y = head.from() + (head.to() - head.from()) * k / 300;
    s.rail.push_back({from_rail(y), -head.at(y).depth / mm});
  }
  return s;
}

// The ellipse as Hertz's strips have it, a closed line.
Places outline_of(const std::vector<Strip>& strips) {
  Places line;
  line.reserve(2 * strips.size() + 1);
  for (const Strip& s : strips) line.push_back({s.t / mm, (s.x + s.half_length) / mm});
  for (auto s = strips.rbegin(); s != strips.rend(); ++s)
    line.push_back({s->t / mm, (s->x - s->half_length) / mm});
  line.push_back(line.front());
  return line;
}

// The cells that bear, in the patch's own plane.
struct Cell {
  double across, along, pressure;  // m, Pa
};
std::vector<Cell> cells_of(const PatchResult& p) {
  std::vector<Cell> cells;
  for (Index k = 0; k < p.pressure.size(); ++k)
    if (p.pressure[k] > 0)
      cells.push_back({p.grid.y(k / p.grid.nx), p.grid.x(k % p.grid.nx), p.pressure[k]});
  return cells;
}

const char* const within_a_cell = "pressures beside the edge of the contact end within a cell";

// Wheel and rail in section, what lies between them, and the patches below.
void draw_pair(report::Item& item) {
  item.added("the right wheel of the benchmark at a shift of 5 mm, by this program");
  const Wheel& fifth = fifth_wheel(item);
  const WheelResult& found = solved(fifth, Method::full);
  const Sections s = sections_of(PlacedWheel(pair(), pose_of(fifth)), found.z);
  report::Data& section = item.data({"across_mm", "up_mm"});
  report::Data& rail = item.data("rail", {"across_mm", "up_mm"});
  report::Data& gap = item.data("gap", {"across_mm", "gap_um"});
  for (const Place& p : s.wheel) section.add(p.across, p.other);
  for (const Place& p : s.rail) rail.add(p.across, p.other);
  for (const Place& p : s.gap) gap.add(p.across, p.other);
  gap.holds_to("gap_um", 1e-3, 0.02, "the depth is found to a hundred thousandth of the load");
  report::Data& patches = item.data("patches", {"across_mm", "up_mm", "angle_rad", "load_N"});
  report::Data& cells = item.data("cells", {"across_mm", "along_mm", "dy_mm", "dx_mm", "p_MPa"});
  for (const PatchResult& p : found.patches) {
    const Frame& f = p.patch.frame;
    patches.add(from_rail(f.origin.y()), -f.origin.z() / mm, f.angle, p.load);
    for (const Cell& c : cells_of(p))
      cells.add(drawn(f.origin.y() - rail_origin + c.across * std::cos(f.angle)),
                drawn(f.origin.x() + c.along), drawn(p.grid.dy * std::cos(f.angle)),
                drawn(p.grid.dx), drawn_pressure(c.pressure));
  }
  patches.holds_to("load_N", 1e-3, 1, "the depth is found to a hundred thousandth of the load");
  cells.holds_to("p_MPa", 1e-3, 1, within_a_cell);
}

// Each in its own plane, with the outline that Hertz's ellipse would have.
void fig_patches(report::Item& item) {
  item.added("the benchmark is of later date than the papers of this book");
  const table::CsvTable table = item.printed("case-a.csv");
  report::Data& cells = item.data({"shift_mm", "across_mm", "along_mm", "p_MPa"});
  report::Data& ellipse = item.data("hertz", {"shift_mm", "across_mm", "along_mm"});
  report::Data& grids = item.data("grids", {"shift_mm", "dy_mm", "dx_mm"});
  for (const int shift : {0, 2, 4, 6, 8}) {
    const Wheel wheel = wheel_of(table, "right", shift);
    const PatchResult& p = solved(wheel, Method::full).patches.front();
    for (const Cell& c : cells_of(p))
      cells.add(shift, drawn(c.across), drawn(c.along), drawn_pressure(c.pressure));
    grids.add(shift, p.grid.dy / mm, p.grid.dx / mm);
    for (const Place& at : outline_of(solved(wheel, Method::hertz).patches.front().strips.strips))
      ellipse.add(shift, at.across, at.other);
    ellipse.gap();
  }
  for (const char* place : {"across_mm", "along_mm"})
    cells.holds_to(
        place, 1e-6, 1e-5,
        "the cells follow the depth, which is found to a hundred thousandth of the load");
  cells.holds_to("p_MPa", 1e-3, 1, within_a_cell);
}

// In the picture: along, to the left, up [mm], from the middle of the first patch.
struct Drawing {
  Vector3d middle;
  scene::Point operator()(const Vector3d& track) const {
    const Vector3d d = (track - middle) / mm;
    return {d.x(), -d.y(), -d.z()};
  }
};

// The pressure at a place in space, 0 outside of all patches.
double pressure_at(const WheelResult& wheel, const Vector3d& at) {
  for (const PatchResult& p : wheel.patches) {
    const Vector3d d = at - p.patch.frame.origin;
    const auto i = static_cast<Index>(std::floor((d.x() - p.grid.x0) / p.grid.dx));
    const auto j =
        static_cast<Index>(std::floor((d.dot(p.patch.frame.across()) - p.grid.y0) / p.grid.dy));
    if (i < 0 || j < 0 || i >= p.grid.nx || j >= p.grid.ny) continue;
    if (const double found = p.pressure[j * p.grid.nx + i]; found > 0) return found;
  }
  return 0;
}

// The wheel's own surface, one of revolution, coloured where it bears.
scene::Mesh wheel_surface(const Pose& pose, const WheelResult& wheel, const Drawing& place) {
  const PlacedWheel placed(pair(), pose);
  const Vector3d centre(0, pose.y, wheel.z - pair().radius);
  const Index across = 400, along = 160;
  scene::Mesh mesh = scene::surface(Eigen::VectorXd::LinSpaced(across, 0, 1),
                                    Eigen::VectorXd::LinSpaced(along, 0, 1),
                                    Eigen::MatrixXd::Zero(across, along), 0, 1);
  for (Index i = 0; i < across; ++i)
    for (Index j = 0; j < along; ++j) {
      const double s = -0.0345 + 0.0215 * static_cast<double>(i) / (across - 1);
      const double turn = 0.003 + 0.021 * (2 * static_cast<double>(j) / (along - 1) - 1);
      const double r = pair().radius + pair().wheel.at(s).depth;
      const Vector3d at =
          centre +
          placed.turn * Vector3d(r * std::sin(turn), pair().half_spacing + s, r * std::cos(turn));
      const double p = pressure_at(wheel, at);
      mesh.vertices.row(i * along + j) = place(at).transpose();
      mesh.colours.row(i * along + j) =
          (p > 0 ? scene::viridis(p, 0.0, scale_end) : scene::steel).transpose();
    }
  return mesh;
}

// Tractions on the wheel at every sixth cell, a little in front of it.
scene::Lines tractions(const WheelResult& wheel, const Drawing& place) {
  scene::Lines arrows{scene::Points(0, 3), scene::Segments(0, 2), {0.84, 0.37, 0.0}, 2};
  const double longest = 1.5 * mm / wheel.patches.front().largest_shear;
  for (const PatchResult& p : wheel.patches) {
    const auto& t = p.forces.tractions;
    for (Index k = 0; k < t.x.size(); ++k) {
      if (std::lround((t.x[k] - p.grid.x0) / p.grid.dx) % 6 != 0 ||
          std::lround((t.y[k] - p.grid.y0) / p.grid.dy) % 6 != 0)
        continue;
      const Frame& f = p.patch.frame;
      const Vector3d from =
          f.origin + t.x[k] * Vector3d::UnitX() + t.y[k] * f.across() + 0.2 * mm * f.normal();
      const Vector3d pull = -longest * (t.px[k] * Vector3d::UnitX() + t.py[k] * f.across());
      const auto n = arrows.vertices.rows();
      arrows.vertices.conservativeResize(n + 2, 3);
      arrows.vertices.row(n) = place(from).transpose();
      arrows.vertices.row(n + 1) = place(from + pull).transpose();
      arrows.segments.conservativeResize(n / 2 + 1, 2);
      arrows.segments.row(n / 2) << int(n), int(n + 1);
    }
  }
  return arrows;
}

void draw_scene(report::Item& item) {
  item.added("the same wheel as in the drawing at the head of the page");
  const Wheel& fifth = fifth_wheel(item);
  const WheelResult& wheel = solved(fifth, Method::full);
  const Drawing place{wheel.patches.front().patch.frame.origin};
  const auto on_tread = [&](double across, double along) {
    const double depth = pair().wheel.at(across).depth;
    return place({along, fifth.y + pair().half_spacing + across, wheel.z + depth});
  };
  scene::Scene s;
  s.meshes.push_back(wheel_surface(pose_of(fifth), wheel, place));
  s.lines.push_back(tractions(wheel, place));
  scene::Lines rolling{scene::Points(4, 3), scene::Segments(3, 2), {0, 0, 0}, 3};
  rolling.vertices.row(0) = on_tread(-0.0145, -0.013).transpose();
  rolling.vertices.row(1) = on_tread(-0.0145, -0.006).transpose();
  rolling.vertices.row(2) = on_tread(-0.0140, -0.007).transpose();
  rolling.vertices.row(3) = on_tread(-0.0150, -0.007).transpose();
  rolling.segments << 0, 1, 1, 2, 1, 3;
  s.lines.push_back(rolling);
  item.value("longest-line", wheel.patches.front().largest_shear / units::megapascal, "MPa",
             "{:.0f}");
  const scene::Size size{860, 560};
  const auto camera = scene::looking_at(s, {0.35, -0.75, -0.9}, size, true);
  scene::labelled(item, "wheel.gp", s, camera, size,
                  {{on_tread(-0.0340, 0.0030), "to the flange"},
                   {on_tread(-0.0145, -0.005), "rolling"},
                   {on_tread(-0.0182, -0.0055), "1.5 kN"},
                   {on_tread(-0.0290, -0.0015), "8.2 kN"}});
}

}  // namespace

const report::Section opening{report::figure("pair", draw_pair),
                              report::figure("fig-patches", fig_patches)};

const report::Section drawn{report::figure("scene", draw_scene)};
