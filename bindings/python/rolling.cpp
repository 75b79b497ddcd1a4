// railbook.rolling: creep forces by the fast theories and the full one, coefficients and tables.
#include <railbook/rolling/creep_laws.hpp>
#include <railbook/rolling/fastsim.hpp>
#include <railbook/rolling/force_table.hpp>
#include <railbook/rolling/kalker_coefficients.hpp>
#include <railbook/rolling/theory.hpp>
#include <railbook/units/input_error.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace rolling;

CreepForces creep_forces(const RollingCase& c, const std::string& theory, long cells) {
  check(c);
  return converged(solver(theory, c.a / c.b, c.poisson, cells)(c));
}

CreepForces fastsim_tractions(const RollingCase& c, int along, int strips) {
  check(c);
  return converged(fastsim_grid(c, kalker_table(c.a / c.b, c.poisson),
                                {.along = along, .strips = strips, .keep_tractions = true}));
}

// One contact, many creepages: what depends on the ellipse alone is made once.
class Ellipse {
 public:
  Ellipse(RollingCase c, const std::string& theory, long cells)
      : case_(std::move(c)),
        solve_((check(case_), solver(theory, case_.a / case_.b, case_.poisson, cells))) {}
  Eigen::MatrixXd forces(const Array& longitudinal, const Array& lateral, const Array& spin) const {
    const Eigen::Index n = longitudinal.size();
    if (lateral.size() != n || spin.size() != n)
      throw InputError("creepages: longitudinal, lateral and spin are not of one length");
    Eigen::MatrixXd out(n, 3);
    RollingCase c = case_;
    for (Eigen::Index i = 0; i < n; ++i) {
      c.creepage = {longitudinal[i], lateral[i], spin[i]};
      const CreepForces f = converged(solve_(c));
      out.row(i) << f.fx, f.fy, f.mz;
    }
    return out;
  }

 private:
  RollingCase case_;
  Solver solve_;
};

ForceTable force_table(const std::string& theory, double poisson, const ForceTableAxes& axes,
                       long cells) {
  return {axes, [=](double ratio) {
            return shares_of(solver(theory, ratio, poisson, cells), ratio, poisson);
          }};
}

}  // namespace

void bind_rolling(py::module_& whole) {
  auto m = part(whole, "rolling", doc("rolling/case.hpp"));
  py::class_<Creepage>(m, "Creepage", doc("rolling/case.hpp Creepage"))
      .def(py::init([](double x, double y, double spin) {
             return Creepage{x, y, spin};
           }),
           "longitudinal"_a = 0.0, "lateral"_a = 0.0, "spin"_a = 0.0)
      .def_readwrite("longitudinal", &Creepage::longitudinal)
      .def_readwrite("lateral", &Creepage::lateral)
      .def_readwrite("spin", &Creepage::spin);
  py::class_<RollingCase>(m, "RollingCase", doc("rolling/case.hpp RollingCase"))
      .def(py::init([](double a, double b, double load, double shear_modulus, double poisson,
                       double friction, const Creepage& creepage) {
             const RollingCase c{a, b, load, shear_modulus, poisson, friction, creepage};
             check(c);
             return c;
           }),
           py::kw_only(), "a"_a, "b"_a, "load"_a, "shear_modulus"_a, "poisson"_a, "friction"_a,
           "creepage"_a = Creepage{})
      .def_readwrite("a", &RollingCase::a)
      .def_readwrite("b", &RollingCase::b)
      .def_readwrite("load", &RollingCase::load)
      .def_readwrite("shear_modulus", &RollingCase::shear_modulus)
      .def_readwrite("poisson", &RollingCase::poisson)
      .def_readwrite("friction", &RollingCase::friction)
      .def_readwrite("creepage", &RollingCase::creepage);
  py::class_<Tractions>(m, "Tractions", doc("rolling/case.hpp Tractions"))
      .def_readonly("x", &Tractions::x)
      .def_readonly("y", &Tractions::y)
      .def_readonly("dx", &Tractions::dx)
      .def_readonly("dy", &Tractions::dy)
      .def_readonly("px", &Tractions::px)
      .def_readonly("py", &Tractions::py)
      .def_readonly("bound", &Tractions::bound)
      .def_readonly("stick", &Tractions::stick);
  py::class_<CreepForces>(m, "CreepForces", doc("rolling/case.hpp CreepForces"))
      .def_readonly("fx", &CreepForces::fx)
      .def_readonly("fy", &CreepForces::fy)
      .def_readonly("mz", &CreepForces::mz)
      .def_readonly("stick_share", &CreepForces::stick_share)
      .def_readonly("error", &CreepForces::error)
      .def_readonly("mz_error", &CreepForces::mz_error)
      .def_property_readonly("warning", [](const CreepForces& f) { return std::string(f.warning); })
      .def_readonly("reason", &CreepForces::reason)
      .def_readonly("tractions", &CreepForces::tractions);
  m.attr("theories") = theory_names();
  m.def("reduced_creepage", &reduced_creepage, "case"_a, doc("rolling/case.hpp reduced_creepage"));
  m.def("creep_forces", &creep_forces, "case"_a, "theory"_a = "full", "cells"_a = 24, Unlocked(),
        doc("rolling/theory.hpp solver"));
  m.def("fastsim", &fastsim_tractions, "case"_a, "along"_a = 40, "strips"_a = 40, Unlocked(),
        doc("rolling/fastsim.hpp fastsim_grid"));
  py::class_<Ellipse>(
      m, "Ellipse",
      "A contact ellipse by one theory; what does not depend on the creepages is made once.")
      .def(py::init<RollingCase, const std::string&, long>(), "case"_a, "theory"_a = "full",
           "cells"_a = 24, Unlocked())
      .def("forces", &Ellipse::forces, "longitudinal"_a, "lateral"_a, "spin"_a, Unlocked(),
           "Forces of n creepages: an array of n rows of fx [N], fy [N], mz [N m].");

  py::class_<ComputedCoefficients>(m, "KalkerCoefficients",
                                   doc("rolling/kalker_coefficients.hpp ComputedCoefficients"))
      .def_readonly("c11", &ComputedCoefficients::c11)
      .def_readonly("c22", &ComputedCoefficients::c22)
      .def_readonly("c23", &ComputedCoefficients::c23)
      .def_readonly("c32", &ComputedCoefficients::c32)
      .def_readonly("c33", &ComputedCoefficients::c33)
      .def_readonly("error", &ComputedCoefficients::error);
  m.def("kalker_coefficients", &kalker_coefficients, "axis_ratio"_a, "poisson"_a, "degree"_a = 16,
        Unlocked(), doc("rolling/kalker_coefficients.hpp kalker_coefficients"));

  py::class_<ForceTableAxes>(m, "ForceTableAxes", doc("rolling/force_table.hpp ForceTableAxes"))
      .def(py::init<>())
      .def_readwrite("ratio_from", &ForceTableAxes::ratio_from)
      .def_readwrite("ratio_to", &ForceTableAxes::ratio_to)
      .def_readwrite("ratios", &ForceTableAxes::ratios)
      .def_readwrite("reach", &ForceTableAxes::reach)
      .def_readwrite("spin_reach", &ForceTableAxes::spin_reach)
      .def_readwrite("longitudinal", &ForceTableAxes::longitudinal)
      .def_readwrite("lateral", &ForceTableAxes::lateral)
      .def_readwrite("spin", &ForceTableAxes::spin);
  py::class_<ForceTable>(m, "ForceTable", doc("rolling/force_table.hpp ForceShares"))
      .def(py::init(&force_table), "theory"_a = "fastsim", "poisson"_a = 0.28,
           "axes"_a = ForceTableAxes{}, "cells"_a = 24, Unlocked(), doc("rolling/force_table.hpp"))
      .def(
          "at",
          [](const ForceTable& table, double ratio, double x, double y, double spin) {
            const ForceShares s = table.at(ratio, {x, y, spin});
            return std::array{s.fx, s.fy, s.mz};
          },
          "axis_ratio"_a, "longitudinal"_a, "lateral"_a, "spin"_a,
          "Shares (fx, fy, mz) of the friction bound at reduced creepages.")
      .def(
          "bound",
          [](const ForceTable& table, double ratio, double x, double y, double spin) {
            const InterpolationBound bound = table.bound(ratio, {x, y, spin});
            return std::array{bound.force, bound.moment};
          },
          "axis_ratio"_a, "longitudinal"_a, "lateral"_a, "spin"_a,
          "Estimated bounds (force, moment) of the error of interpolation of at(), as shares.");
}

}  // namespace railbook::python
