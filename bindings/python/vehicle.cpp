// railbook.vehicle: critical speeds and limit cycles of the freight car of nine coordinates.
#include <array>
#include <railbook/units/input_error.hpp>
#include <railbook/vehicle/cycle_branch.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace vehicle;

// Half gauge and wheel radius are those of the geometry.
QuasiLinearCar car_on(CarParameters data, const wheelset::ConstraintFunctions& pair,
                      bool friction) {
  data.half_gauge = pair.half_spacing;
  data.wheel_radius = pair.radius;
  return {assemble(data, friction ? Suspension::friction : Suspension::dampers), pair};
}

// A branch of limit cycles as arrays, a value a point.
struct Branch {
  std::vector<double> speed, amplitude, frequency;
  std::vector<bool> stable;
  std::string end;
};

Branch limit_cycles(const QuasiLinearCar& car, double lowest, double highest) {
  const auto hopf = hopf_points(car, lowest, highest);
  if (hopf.empty())
    throw NumericalError("limit cycles: the car has no critical speed in the range");
  const CycleBranch found = trace_from(car, hopf.front(), {});
  Branch branch;
  branch.end = to_string(found.end);
  for (const CyclePoint& p : found.points) {
    branch.speed.push_back(p.motion.speed);
    branch.amplitude.push_back(p.largest);
    branch.frequency.push_back(p.motion.lambda.imag());
    branch.stable.push_back(p.stable);
  }
  return branch;
}

}  // namespace

void bind_vehicle(py::module_& whole) {
  auto m = part(whole, "vehicle", doc("vehicle/linear_stability.hpp"));
  py::class_<CarParameters> parameters(m, "CarParameters",
                                       doc("vehicle/car_parameters.hpp CarParameters"));
  parameters.def(py::init([](const py::kwargs& data) {
    CarParameters car;
    py::object self = py::cast(&car, py::return_value_policy::reference);
    for (const auto& [name, value] : data) self.attr(py::str(name)) = value;
    require_valid(car);
    return car;
  }));
  for (const CarDatum& datum : car_data()) {
    std::string name = datum.key;
    for (char& c : name)
      if (c == '-') c = '_';
    parameters.def_property(
        name.c_str(), [member = datum.member](const CarParameters& c) { return c.*member; },
        [member = datum.member](CarParameters& c, double value) { c.*member = value; }, datum.name);
  }
  py::class_<QuasiLinearCar>(m, "Car", doc("vehicle/quasi_linear.hpp"))
      .def(py::init(&car_on), "parameters"_a, "pair"_a, "friction"_a = false);
  py::class_<HopfPoint>(m, "CriticalSpeed", "A speed at which an oscillation has no damping.")
      .def_property_readonly(
          "speed", [](const HopfPoint& h) { return h.motion.speed; }, "[m/s]")
      .def_property_readonly(
          "frequency", [](const HopfPoint& h) { return h.motion.lambda.imag(); }, "[rad/s]")
      .def_property_readonly(
          "shape", [](const HopfPoint& h) { return Eigen::VectorXcd(h.motion.shape); },
          "The nine coordinates, the largest wheelset 1.")
      .def_property_readonly("grows_above",
                             [](const HopfPoint& h) { return h.rate_by_speed.real() > 0; });
  m.def("critical_speeds", &hopf_points, "car"_a, "lowest"_a = 1.0, "highest"_a = 120.0, Unlocked(),
        doc("vehicle/linear_stability.hpp hopf_points"));
  py::class_<Branch>(m, "Branch", "The limit cycles along a branch, as arrays of a value a point.")
      .def_property_readonly(
          "speed", [](const Branch& b) { return array_of(b.speed); }, "[m/s]")
      .def_property_readonly(
          "amplitude", [](const Branch& b) { return array_of(b.amplitude); },
          "of the largest wheelset [m]")
      .def_property_readonly(
          "frequency", [](const Branch& b) { return array_of(b.frequency); }, "[rad/s]")
      .def_readonly("stable", &Branch::stable)
      .def_readonly("end", &Branch::end);
  m.def("limit_cycles", &limit_cycles, "car"_a, "lowest"_a = 1.0, "highest"_a = 120.0, Unlocked(),
        doc("vehicle/cycle_branch.hpp"));
}

}  // namespace railbook::python
