/***
{{fold}}
*/

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

#include "vehicles.hpp"

namespace railbook::hunting_chapter {

namespace {

// A point from above: x forward, y to the left.
struct Spot {
  double x, y;
};

// A body's own axes: where its origin is, and its yaw.
struct Frame {
  Spot origin;
  double yaw;
  Spot at(double ahead, double left) const {
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {origin.x + ahead * c - left * s, origin.y + ahead * s + left * c};
  }
};

class Plan {
 public:
  Plan(report::Data& data, const CarParameters& car) : data_(data), car_(car) {}

  void draw(const Vector9& q) {
    for (const int t : {0, 1}) draw_truck(q[X_TF + t], q[TH_TF + t], q[TH_WF + t], side(t));
    const double l = car_.half_truck_distance + 1.3, b = 1.4;
    const Frame body{{0, q[X_C]}, q[TH_C]};
    add("body", {body.at(l, b), body.at(-l, b), body.at(-l, -b), body.at(l, -b), body.at(l, b)});
  }

 private:
  static double side(int truck) { return truck == 0 ? 1 : -1; }

  void add(const char* part, std::initializer_list<Spot> spots) {
    for (const Spot& s : spots) data_.add(part, s.x / foot, s.y / foot);
    data_.gap();
  }

  // A parallelogram: the side frames yaw by `yaw`, the axles by `yaw + warp`.
  void draw_truck(double lateral, double yaw, double warp, double side) {
    const double d = car_.half_sideframe_spacing, l = car_.half_wheelbase, r = car_.wheel_radius;
    const Frame truck{{side * car_.half_truck_distance, lateral}, yaw};
    for (const double end : {1.0, -1.0}) {
      const Frame axle{truck.at(end * l, 0), yaw + warp};
      add("axle", {axle.at(0, -d), axle.at(0, d)});
      for (const double left : {car_.half_gauge, -car_.half_gauge})
        add("wheel", {axle.at(-r, left), axle.at(r, left)});
    }
    const Frame across{truck.origin, yaw + warp};
    for (const double left : {d, -d}) {
      const Frame frame{across.at(0, left), yaw};
      add("frame", {frame.at(-l - 0.18, 0), frame.at(l + 0.18, 0)});
    }
  }

  report::Data& data_;
  const CarParameters& car_;
};

// Arrows, measures and names of the coordinates, in feet.
class Marks {
 public:
  Marks(report::Data& marks, report::Data& arcs) : marks_(marks), arcs_(arcs) {}

  void line(const char* kind, Spot from, Spot along) {
    marks_.add(kind, from.x / foot, from.y / foot, along.x / foot, along.y / foot, "");
  }
  void name(const std::string& text, Spot at) {
    marks_.add("label", at.x / foot, at.y / foot, 0.0, 0.0, text);
  }
  // From the direction `straight` to a direction `angle` further.
  void angle(Spot at, double length, double straight, double angle) {
    const Frame from{at, straight}, to{at, straight + angle};
    const auto ray = [&](const Frame& f) {
      const Spot end = f.at(length, 0);
      line("thin", at, {end.x - at.x, end.y - at.y});
    };
    ray(from), ray(to);
    for (int i = 0; i <= 12; ++i) {
      const Spot s = Frame{at, straight + angle * i / 12}.at(0.95 * length, 0);
      arcs_.add(s.x / foot, s.y / foot);
    }
    arcs_.gap();
  }

 private:
  report::Data &marks_, &arcs_;
};

void name_truck(Marks& marks, const CarParameters& car, int truck, double lateral, double yaw,
                double warp) {
  const double end = truck == 0 ? 1 : -1, c = end * car.half_truck_distance,
               d = car.half_sideframe_spacing, l = car.half_wheelbase;
  const char* const of = truck == 0 ? "F" : "R";
  marks.line("arrow", {c, 0}, {0, lateral});
  marks.name(fmt::format("X_{{T{}}}", of), {c + 0.1, 0.5 * lateral});
  const Frame body{{c, lateral}, yaw}, across{{c, lateral}, yaw + warp};
  // The left side frame against straight ahead, seen at the truck's outer end.
  const Spot inner = Frame{across.at(0, d), yaw}.at(-end * (l + 0.18), 0);
  marks.angle(inner, 2.93, truck == 0 ? 0 : units::pi, yaw);
  marks.name(fmt::format("θ_{{T{}}}", of),
             {inner.x + end * 2.93 + (truck == 0 ? 0.08 : -0.61), inner.y + end * 1.28 * yaw});
  // The inner axle against the normal of the side frames.
  const Frame axle{body.at(-end * l, 0), yaw + warp};
  const Spot low = axle.at(0, -d);
  marks.angle(low, 1.25, yaw + units::pi / 2, warp);
  marks.name(fmt::format("θ_{{W{}}}", of),
             {low.x - 1.19 * std::sin(yaw + warp) + (truck == 0 ? -0.8 : 0.15), low.y + 1.1});
}

void drawing(report::Item& item) {
  item.added("lengths to scale, motions enlarged; the modes are computed with our profiles");
  const CarParameters car;
  // Large motions of all nine coordinates but the roll, to name them.
  Vector9 q;
  q << 0.4, -0.3, 0.17, -0.13, 0.16, -0.14, 0.3, 0.05, 0;
  Plan(item.data({"part", "x_ft", "y_ft"}), car).draw(q);
  const std::array<const char*, 2> names{"together", "opposed"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Vector9c& shape = vehicle("new").hopf.at(k).motion.shape;
    const Vector9c turned = shape * (std::abs(shape[X_TF]) / shape[X_TF]);
    const double largest = std::max(std::abs(shape[X_TF]), std::abs(shape[X_TR]));
    Plan(item.data(names.at(k), {"part", "x_ft", "y_ft"}), car)
        .draw(turned.real() * (0.52 / largest));
  }
  report::Data& lines = item.data("marks", {"kind", "x_ft", "y_ft", "dx_ft", "dy_ft", "text"});
  report::Data& arcs = item.data("arcs", {"x_ft", "y_ft"});
  Marks marks(lines, arcs);
  for (const int t : {0, 1}) name_truck(marks, car, t, q[X_TF + t], q[TH_TF + t], q[TH_WF + t]);
  marks.line("arrow", {0, 0}, {0, q[X_C]});
  marks.name("X_C", {-0.58, 0.6 * q[X_C]});
  marks.angle({0, q[X_C]}, 2.74, 0, q[TH_C]);
  marks.name("θ_C", {2.8, q[X_C] + 0.06});
  marks.line("measure", {0, -1.71}, {car.half_truck_distance, 0});
  marks.name("L_C", {0.5 * car.half_truck_distance - 0.15, -1.45});
  marks.line("measure", {-car.half_truck_distance - car.half_wheelbase, -1.92},
             {2 * car.half_wheelbase, 0});
  marks.name("2L_T", {-car.half_truck_distance - 0.21, -1.7});
}

}  // namespace

const report::Section drawings{report::figure("drawing", drawing)};

}  // namespace railbook::hunting_chapter
