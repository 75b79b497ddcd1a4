// railbook.contact: Hertz's closed form, and frictionless contact on a grid.
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <railbook/contact/bodies.hpp>
#include <railbook/contact/cg_fft.hpp>
#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/units/input_error.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace contact;

constexpr double straight = std::numeric_limits<double>::infinity();

NormalContact solve(const Body& one, const Body& two, double modulus, std::optional<double> load,
                    std::optional<double> approach, long cells, double angle) {
  if (load.has_value() == approach.has_value())
    throw InputError("contact: give either load or approach");
  const TouchingBodies bodies = join_bodies(one, two, angle);
  CgFftOptions options;
  options.nx = options.ny = cells;
  options.search = bodies.search;
  return converged((load ? solve_cg_fft_load(bodies.gap, *load, modulus, options)
                         : solve_cg_fft(bodies.gap, *approach, modulus, options))
                       .contact);
}

}  // namespace

void bind_contact(py::module_& whole) {
  auto m = part(whole, "contact", doc("contact/normal_contact.hpp"));
  py::class_<Material>(m, "Material", doc("contact/material.hpp Material"))
      .def(py::init([](double young, double poisson) {
             return Material{young, poisson};
           }),
           "young"_a, "poisson"_a)
      .def_readwrite("young", &Material::young)
      .def_readwrite("poisson", &Material::poisson)
      .def_property_readonly("shear_modulus", &Material::shear_modulus);
  m.attr("default_steel") = default_steel;
  m.def("effective_modulus", &effective_modulus, "one"_a = default_steel, "two"_a = default_steel,
        doc("contact/material.hpp effective_modulus"));

  py::class_<RelativeCurvature>(m, "RelativeCurvature",
                                doc("contact/geometry.hpp RelativeCurvature"))
      .def(py::init([](double a, double b, double angle) {
             return RelativeCurvature{a, b, angle};
           }),
           "a"_a, "b"_a, "angle"_a = 0.0)
      .def_readwrite("a", &RelativeCurvature::a)
      .def_readwrite("b", &RelativeCurvature::b)
      .def_readwrite("angle", &RelativeCurvature::angle);
  py::class_<HertzContact>(m, "HertzContact", doc("contact/hertz.hpp HertzContact"))
      .def_readonly("curvature", &HertzContact::curvature)
      .def_readonly("a", &HertzContact::a)
      .def_readonly("b", &HertzContact::b)
      .def_readonly("approach", &HertzContact::approach)
      .def_readonly("force", &HertzContact::force)
      .def_readonly("p_max", &HertzContact::p_max);
  m.def("hertz_from_force", &hertz_from_force, "curvature"_a, "effective_modulus"_a, "force"_a,
        doc("contact/hertz.hpp hertz_from_force"));
  m.def("hertz_from_approach", &hertz_from_approach, "curvature"_a, "effective_modulus"_a,
        "approach"_a, doc("contact/hertz.hpp hertz_from_approach"));
  m.def("hertz_pressure", py::vectorize([](const HertzContact* c, double x, double y) {
          return hertz_pressure(*c, x, y);
        }),
        "contact"_a, "x"_a, "y"_a, doc("contact/hertz.hpp hertz_pressure"));

  py::class_<Body>(m, "Body", doc("contact/bodies.hpp Body"))
      .def(py::init([](double radius_x, double radius_y, std::optional<Eigen::VectorXd> x,
                       std::optional<Eigen::VectorXd> depth) {
             if (x.has_value() != depth.has_value())
               throw InputError("body: a profile has both x and depth");
             Body body{.radius_x = radius_x, .radius_y = radius_y};
             if (x) body.profile = DepthPoints{std::move(*x), std::move(*depth)};
             return body;
           }),
           py::kw_only(), "radius_x"_a = straight, "radius_y"_a = straight, "x"_a = py::none(),
           "depth"_a = py::none(),
           "By the radii across (x) and along the rail (y), or by a profile across the rail: depth "
           "into the body\nat rising x, as arrays.")
      .def_readonly("radius_x", &Body::radius_x)
      .def_readonly("radius_y", &Body::radius_y);
  py::class_<NormalContact>(m, "NormalContact", doc("contact/normal_contact.hpp NormalContact"))
      .def_readonly("x", &NormalContact::x)
      .def_readonly("y", &NormalContact::y)
      .def_readonly("dx", &NormalContact::dx)
      .def_readonly("dy", &NormalContact::dy)
      .def_readonly("p", &NormalContact::p)
      .def_readonly("approach", &NormalContact::approach)
      .def_readonly("force", &NormalContact::force)
      .def_readonly("moment_x", &NormalContact::moment_x)
      .def_readonly("moment_y", &NormalContact::moment_y)
      .def_readonly("p_max", &NormalContact::p_max)
      .def_readonly("area", &NormalContact::area)
      .def_property_readonly("ends",
                             [](const NormalContact& c) {
                               return std::array{c.x_min, c.x_max, c.y_min, c.y_max};
                             })
      .def_readonly("force_error", &NormalContact::force_error)
      .def_readonly("p_max_error", &NormalContact::p_max_error)
      .def_readonly("iterations", &NormalContact::iterations)
      .def_readonly("reason", &NormalContact::reason);
  m.def("solve", &solve, "one"_a, "two"_a, "effective_modulus"_a, py::kw_only(),
        "load"_a = py::none(), "approach"_a = py::none(), "cells"_a = 128, "angle"_a = 0.0,
        Unlocked(), doc("contact/cg_fft.hpp solve_cg_fft"));
}

}  // namespace railbook::python
