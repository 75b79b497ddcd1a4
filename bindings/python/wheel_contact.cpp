// railbook.wheel_contact: from two profiles and a pose to patches, pressures, creepages and forces.
#include <string>
#include <utility>
#include <vector>

#include <railbook/contact/material.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/warning.hpp>
#include <railbook/wheel_contact/wheel.hpp>
#include <railbook/wheelset/wheelset_contact.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace wheel_contact;

Method method_of(const std::string& name) {
  if (name == "hertz") return Method::hertz;
  if (name == "strips") return Method::strips;
  if (name == "full") return Method::full;
  throw InputError("method is \"" + name + "\"; allowed: hertz, strips, full");
}

WheelInput input_of(double load, double speed, double angular_velocity, const Friction& friction,
                    const contact::Material& wheel, const contact::Material& rail,
                    const std::string& method, long cells) {
  WheelInput input;
  input.wheel = wheel, input.rail = rail;
  input.load = load, input.speed = speed, input.angular_velocity = angular_velocity;
  input.friction = friction;
  input.method = method_of(method);
  input.along = input.across = cells;
  return input;
}

}  // namespace

void bind_wheel_contact(py::module_& whole) {
  auto m = part(whole, "wheel_contact", doc("wheel_contact/wheel.hpp"));
  py::class_<Friction>(m, "Friction", doc("wheel_contact/wheel.hpp Friction"))
      .def(py::init(
               [](double coefficient, double share, double speed, std::optional<double> flange) {
                 return Friction{coefficient, share, speed, flange};
               }),
           "coefficient"_a = 0.3, "high_speed_share"_a = 1.0, "speed"_a = 1.0,
           "flange"_a = py::none())
      .def_readwrite("coefficient", &Friction::coefficient)
      .def_readwrite("high_speed_share", &Friction::high_speed_share)
      .def_readwrite("speed", &Friction::speed)
      .def_readwrite("flange", &Friction::flange);
  py::class_<Pose>(m, "Pose", doc("wheel_contact/find_contact.hpp Pose"))
      .def(py::init([](double y, double yaw, double roll) {
             return Pose{y, yaw, roll};
           }),
           "y"_a = 0.0, "yaw"_a = 0.0, "roll"_a = 0.0)
      .def_readwrite("y", &Pose::y)
      .def_readwrite("yaw", &Pose::yaw)
      .def_readwrite("roll", &Pose::roll);
  py::class_<ProfilePair>(m, "ProfilePair", doc("wheel_contact/find_contact.hpp ProfilePair"))
      .def(py::init([](const profiles::Profile& wheel, const profiles::Profile& rail, double radius,
                       double half_spacing) {
             ProfilePair pair{wheel, rail, radius, half_spacing};
             require_fit(pair);
             return pair;
           }),
           "wheel"_a, "rail"_a, "radius"_a = 0.460, "half_spacing"_a = 0.750)
      .def_readonly("wheel", &ProfilePair::wheel)
      .def_readonly("rail", &ProfilePair::rail)
      .def_readonly("radius", &ProfilePair::radius)
      .def_readonly("half_spacing", &ProfilePair::half_spacing);
  m.def(
      "s1002_on_60e1",
      [](double cant, bool benchmark) {
        return s1002_on_60e1(cant,
                             benchmark ? profiles::Rail60::benchmark : profiles::Rail60::drawing);
      },
      "cant"_a = 1.0 / 40, "benchmark"_a = false,
      doc("wheel_contact/find_contact.hpp s1002_on_60e1"));
  m.def("mirrored", &mirrored, "pose"_a);
  m.def("rigid_roll", py::overload_cast<const ProfilePair&, double, double>(&rigid_roll), "pair"_a,
        "y"_a, "yaw"_a, Unlocked(), doc("wheel_contact/find_contact.hpp rigid_roll"));

  py::class_<PatchResult>(m, "PatchResult", doc("wheel_contact/wheel.hpp PatchResult"))
      .def_property_readonly("origin", [](const PatchResult& p) { return p.patch.frame.origin; })
      .def_property_readonly("angle", [](const PatchResult& p) { return p.patch.frame.angle; })
      .def_readonly("load", &PatchResult::load)
      .def_readonly("approach", &PatchResult::approach)
      .def_readonly("p_max", &PatchResult::p_max)
      .def_readonly("p_max_error", &PatchResult::p_max_error)
      .def_readonly("area", &PatchResult::area)
      .def_readonly("forces", &PatchResult::forces)
      .def_readonly("creepage", &PatchResult::creepage)
      .def_readonly("friction", &PatchResult::friction)
      .def_readonly("wear_number", &PatchResult::wear_number)
      .def_property_readonly(
          "x",
          [](const PatchResult& p) {
            Eigen::VectorXd x(p.grid.nx);
            for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = p.grid.x(i);
            return x;
          },
          "Cell centres along the rail [m], of the full method.")
      .def_property_readonly(
          "y",
          [](const PatchResult& p) {
            Eigen::VectorXd y(p.grid.ny);
            for (Eigen::Index j = 0; j < y.size(); ++j) y[j] = p.grid.y(j);
            return y;
          },
          "Cell centres across it [m], of the full method.")
      .def_property_readonly(
          "pressure",
          [](py::object self) {
            const auto& p = self.cast<const PatchResult&>();
            return py::array_t<double>({p.pressure.size() == 0 ? 0 : p.grid.ny, p.grid.nx},
                                       p.pressure.data(), self);
          },
          "Pressures [Pa] of the full method, a row for each y; the array lies where the result "
          "does.");
  py::class_<WheelResult>(m, "WheelResult", doc("wheel_contact/wheel.hpp WheelResult"))
      .def_readonly("z", &WheelResult::z)
      .def_readonly("patches", &WheelResult::patches)
      .def_readonly("force", &WheelResult::force)
      .def_readonly("axle_moment", &WheelResult::axle_moment)
      .def_property_readonly(
          "warnings",
          [](const WheelResult& r) {
            std::vector<std::pair<std::string, std::string>> all;
            for (const units::Warning& w : r.warnings) all.emplace_back(w.key, w.text);
            return all;
          },
          "What to know before trusting it: pairs of a key and a text.");
  m.def(
      "solve_wheel",
      [](const ProfilePair& pair, const Pose& pose, double load, double speed,
         double angular_velocity, const Friction& friction, const contact::Material& wheel,
         const contact::Material& rail, const std::string& method, long cells) {
        return converged(solve_wheel(
            pair, pose,
            input_of(load, speed, angular_velocity, friction, wheel, rail, method, cells)));
      },
      "pair"_a, "pose"_a, py::kw_only(), "load"_a, "speed"_a, "angular_velocity"_a,
      "friction"_a = Friction{}, "wheel"_a = contact::default_steel,
      "rail"_a = contact::default_steel, "method"_a = "full", "cells"_a = 40, Unlocked(),
      doc("wheel_contact/wheel.hpp solve_wheel"));
  py::class_<WheelsetResult>(m, "WheelsetResult", doc("wheel_contact/wheel.hpp WheelsetResult"))
      .def_readonly("pose", &WheelsetResult::pose)
      .def_readonly("angular_velocity", &WheelsetResult::angular_velocity)
      .def_readonly("left", &WheelsetResult::left)
      .def_readonly("right", &WheelsetResult::right);
  m.def(
      "solve_wheelset",
      [](const ProfilePair& pair, const Pose& pose, double load, double speed,
         const Friction& friction, const contact::Material& wheel, const contact::Material& rail,
         const std::string& method, long cells) {
        return converged(solve_wheelset(
            pair, pose, input_of(load, speed, 0, friction, wheel, rail, method, cells)));
      },
      "pair"_a, "pose"_a, py::kw_only(), "load"_a, "speed"_a, "friction"_a = Friction{},
      "wheel"_a = contact::default_steel, "rail"_a = contact::default_steel, "method"_a = "full",
      "cells"_a = 40, Unlocked(), doc("wheel_contact/wheel.hpp solve_wheelset"));
}

}  // namespace railbook::python
