#include <fmt/format.h>

#include <cmath>

#include <railbook/units/constants.hpp>

#include "tools.hpp"
#include "wheelrail/contact_drawing.hpp"

namespace railbook::wheelrail_tool {

using namespace profiles;
using namespace wheel_contact;
using units::megapascal;
using units::millimetre;

Side::Side(const char* of, double s, const WheelResult& w, const WheelInput& input)
    : name(of), sign(s), wheel(w) {
  if (input.method != Method::full) return;
  for (const PatchResult& p : wheel.patches) stress.push_back(stresses(p, input));
}

namespace {

struct Cell {
  double x, y, dx, dy, pressure, px = 0, py = 0, stick = 0, von_mises = units::nan;
};

std::vector<Cell> cells_of(const Side& side, std::size_t number) {
  const PatchResult& p = side.wheel.patches[number];
  const rolling::Tractions& t = p.forces.tractions;
  const bool full = !side.stress.empty();
  const contact::Grid& grid = full ? side.stress[number].grid : p.grid;
  const auto below = [&](Eigen::Index cell) {
    return full ? side.stress[number].rail.below[cell] : units::nan;
  };
  std::vector<Cell> cells;
  // FASTSIM's bound is a parabola: the strips say the pressure.
  const auto pressure = [&](Eigen::Index i) {
    if (full) return t.bound[i] / p.friction;
    const auto& strips = p.strips.strips;
    const Strip& s =
        strips[static_cast<std::size_t>(i) * strips.size() / static_cast<std::size_t>(t.x.size())];
    return p.strips.pressure(s, t.x[i] - s.x);
  };
  for (Eigen::Index i = 0; i < t.x.size(); ++i) {
    const Eigen::Index cell = full ? std::lround((t.y[i] - grid.y(0)) / grid.dy) * grid.nx +
                                         std::lround((t.x[i] - grid.x(0)) / grid.dx)
                                   : 0;
    cells.push_back(
        {t.x[i], t.y[i], t.dx[i], t.dy[i], pressure(i), t.px[i], t.py[i], t.stick[i], below(cell)});
  }
  if (!cells.empty()) return cells;
  // Without friction there are no tractions.
  for (Eigen::Index k = 0; k < p.pressure.size(); ++k)
    if (p.pressure[k] > 0)
      cells.push_back({grid.x(k % grid.nx), grid.y(k / grid.nx), grid.dx, grid.dy, p.pressure[k], 0,
                       0, 0, below(k)});
  constexpr int along = 40;
  for (const Strip& s : p.strips.strips)
    for (int k = 0; !full && k < along; ++k) {
      const double dx = 2 * s.half_length / along, x = (k + 0.5) * dx - s.half_length;
      cells.push_back({s.x + x, s.t, dx, p.strips.width, p.strips.pressure(s, x)});
    }
  return cells;
}

}  // namespace

std::string cells_csv(const std::array<Side, 2>& sides) {
  std::string text =
      "wheel,patch,along_mm,across_mm,pressure_MPa,shear_x_MPa,shear_y_MPa,stick,"
      "rail_von_mises_MPa\n";
  for (const Side& side : sides)
    for (std::size_t k = 0; k < side.wheel.patches.size(); ++k)
      for (const Cell& c : cells_of(side, k))
        text += fmt::format(
            "{},{},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:g},{}\n", side.name, k + 1,
            c.x / millimetre, side.sign * c.y / millimetre, c.pressure / megapascal,
            c.px / megapascal, side.sign * c.py / megapascal, c.stick,
            std::isfinite(c.von_mises) ? fmt::format("{:.5g}", c.von_mises / megapascal) : "");
  return text;
}

std::string cells_vtp(const std::array<Side, 2>& sides) {
  std::string points, cells, ends, pressures, tractions, numbers, wheels;
  int count = 0;
  for (const Side& side : sides) {
    const auto vector = [&](const Eigen::Vector3d& v, double unit) {
      return fmt::format("{:.7g} {:.7g} {:.7g}\n", v.x() / unit, side.sign * v.y() / unit,
                         v.z() / unit);
    };
    for (std::size_t k = 0; k < side.wheel.patches.size(); ++k) {
      const Frame& frame = side.wheel.patches[k].patch.frame;
      for (const Cell& c : cells_of(side, k)) {
        constexpr std::array<std::array<double, 2>, 4> corners{
            {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
        for (const auto& [x, y] : corners)
          points += vector(frame.origin + (c.x + x * c.dx) * Eigen::Vector3d::UnitX() +
                               (c.y + y * c.dy) * frame.across(),
                           1);
        cells +=
            fmt::format("{} {} {} {}\n", 4 * count, 4 * count + 1, 4 * count + 2, 4 * count + 3);
        ends += fmt::format("{}\n", 4 * ++count);
        pressures += fmt::format("{:.7g}\n", c.pressure / megapascal);
        tractions += vector(c.px * Eigen::Vector3d::UnitX() + c.py * frame.across(), megapascal);
        numbers += fmt::format("{}\n", k + 1);
        wheels += fmt::format("{:g}\n", side.sign);
      }
    }
  }
  const auto array = [](const char* type, const char* attributes, const std::string& text) {
    return fmt::format("<DataArray type=\"{}\" {} format=\"ascii\">\n{}</DataArray>\n", type,
                       attributes, text);
  };
  return fmt::format(
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" "
             "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
             "NumberOfPolys=\"{}\">\n<Points>\n",
             4 * count, count) +
         array("Float64", "NumberOfComponents=\"3\"", points) + "</Points>\n<Polys>\n" +
         array("Int32", "Name=\"connectivity\"", cells) + array("Int32", "Name=\"offsets\"", ends) +
         "</Polys>\n<CellData Scalars=\"pressure_MPa\" Vectors=\"shear_MPa\">\n" +
         array("Float64", "Name=\"pressure_MPa\"", pressures) +
         array("Float64", "Name=\"shear_MPa\" NumberOfComponents=\"3\"", tractions) +
         array("Int32", "Name=\"patch\"", numbers) + array("Int32", "Name=\"side\"", wheels) +
         "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

void draw(const ProfilePair& left, const ProfilePair& right, const Pose& pose,
          const std::array<Side, 2>& sides, tool::OutFolder& out) {
  std::string section = "part,y_mm,z_mm\n";
  std::string patches = "side,y_mm,z_mm,half_y_mm,half_z_mm,normal_y,normal_z,angle_deg\n";
  std::string cells = "side,across_mm,along_mm,half_across_mm,half_along_mm,p_MPa\n";
  for (int number = 1; const Side& side : sides) {
    const ProfilePair& pair = side.sign > 0 ? right : left;
    const auto point = [&](int part, double y, double z) {
      section +=
          fmt::format("{},{:.6g},{:.6g}\n", part, side.sign * y / millimetre, z / millimetre);
    };
    constexpr int steps = 400;
    for (int k = 0; k <= steps; ++k) {
      const double y = pair.rail.from() + (pair.rail.to() - pair.rail.from()) * k / steps;
      point(2 * number - 1, y, pair.rail.at(y).depth);
    }
    // The wheel where it comes nearest to the rail.
    for (const auto& p :
         find_contact(PlacedWheel(pair, side.sign > 0 ? pose : mirrored(pose))).locus)
      point(2 * number, p.at.y(), p.at.z() + side.wheel.z);
    for (std::size_t k = 0; k < side.wheel.patches.size(); ++k) {
      const Frame& frame = side.wheel.patches[k].patch.frame;
      double half = 0;
      for (const Cell& c : cells_of(side, k)) {
        half = std::max(half, std::abs(c.y) + c.dy / 2);
        cells += fmt::format(
            "{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", number,
            side.sign * (frame.origin.y() + c.y * std::cos(frame.angle)) / millimetre,
            (frame.origin.x() + c.x) / millimetre, c.dy / 2 * std::cos(frame.angle) / millimetre,
            c.dx / 2 / millimetre, c.pressure / megapascal);
      }
      const Eigen::Vector3d across = half * frame.across(), normal = frame.normal();
      patches += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.1f}\n", number,
                             side.sign * frame.origin.y() / millimetre,
                             frame.origin.z() / millimetre, side.sign * across.y() / millimetre,
                             across.z() / millimetre, side.sign * normal.y(), normal.z(),
                             side.sign * frame.angle * 180 / units::pi);
    }
    ++number;
  }
  out.scratch("section.csv", section);
  out.scratch("frames.csv", patches);
  out.scratch("cells.csv", cells);
  out.figure(tools::scripts("wheelrail") / "contact.gp", {"section.csv", "frames.csv", "cells.csv"},
             "wheelset-contact.png");
}

}  // namespace railbook::wheelrail_tool
