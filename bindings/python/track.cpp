// railbook.track: a rail on its foundation, and the force of a wheel over a joint.
#include <railbook/track/beam_on_foundation.hpp>
#include <railbook/track/impact_check.hpp>
#include <railbook/track/wheel_on_track.hpp>
#include <railbook/units/input_error.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace track;

CheckedImpact joint_passage(const ImpactModel& model, const Surface& surface, double speed,
                            double duration, double tolerance) {
  CheckedImpact found = simulate_checked(
      model, surface, speed,
      {.tolerance = tolerance, .start = default_start(surface), .end_time = duration});
  if (found.history.status != ImpactStatus::complete)
    throw NumericalError("impact: " + std::string(to_string(found.history.status)));
  return found;
}

}  // namespace

void bind_track(py::module_& whole) {
  auto m = part(whole, "track", doc("track/impact.hpp"));
  py::class_<WinklerBeam>(m, "WinklerBeam", doc("track/beam_on_foundation.hpp WinklerBeam"))
      .def(py::init([](double bending, double foundation) {
             return WinklerBeam{bending, foundation};
           }),
           "bending_stiffness"_a, "foundation_modulus"_a)
      .def_readwrite("bending_stiffness", &WinklerBeam::bending_stiffness)
      .def_readwrite("foundation_modulus", &WinklerBeam::foundation_modulus)
      .def("beta", &WinklerBeam::beta)
      .def("point_stiffness", &WinklerBeam::point_stiffness)
      .def("deflection", py::vectorize([](const WinklerBeam* beam, double force, double x) {
             return beam_state(*beam, force, x).deflection;
           }),
           "force"_a, "x"_a, doc("track/beam_on_foundation.hpp beam_state"))
      .def("moment", py::vectorize([](const WinklerBeam* beam, double force, double x) {
             return beam_state(*beam, force, x).moment;
           }),
           "force"_a, "x"_a);

  py::class_<RailOnBed>(m, "RailOnBed", doc("track/lumped.hpp RailOnBed"))
      .def_readwrite("rail_mass", &RailOnBed::rail_mass)
      .def_readwrite("rail_stiffness", &RailOnBed::rail_stiffness)
      .def_readwrite("rail_damping", &RailOnBed::rail_damping)
      .def_readwrite("bed_mass", &RailOnBed::bed_mass)
      .def_readwrite("bed_stiffness", &RailOnBed::bed_stiffness)
      .def_readwrite("bed_damping", &RailOnBed::bed_damping);
  py::class_<ImpactModel>(m, "ImpactModel", doc("track/impact.hpp ImpactModel"))
      .def(py::init(&typical_impact), doc("track/wheel_on_track.hpp typical_impact"))
      .def_readwrite("wheel_mass", &ImpactModel::wheel_mass)
      .def_readwrite("static_load", &ImpactModel::static_load)
      .def_readwrite("hertz_constant", &ImpactModel::hertz_constant)
      .def_readwrite("track", &ImpactModel::track);
  py::class_<RectifiedSine>(m, "RectifiedSine", doc("track/track_geometry.hpp RectifiedSine"))
      .def(py::init([](double depth, double length) {
             return RectifiedSine{depth, length};
           }),
           "depth"_a, "length"_a);
  py::class_<SampledProfile>(m, "SampledProfile", doc("track/track_geometry.hpp SampledProfile"))
      .def(py::init([](const Array& x, const Array& z) {
             return SampledProfile(vector_of(x), vector_of(z));
           }),
           "x"_a, "z"_a);
  py::class_<ForceExtremum>(m, "ForceExtremum")
      .def_readonly("time", &ForceExtremum::time)
      .def_readonly("force", &ForceExtremum::force);
  py::class_<ImpactPeaks>(m, "ImpactPeaks", doc("track/impact_peaks.hpp ImpactPeaks"))
      .def_readonly("has_first", &ImpactPeaks::has_first)
      .def_readonly("first", &ImpactPeaks::first)
      .def_readonly("second", &ImpactPeaks::second)
      .def_readonly("late", &ImpactPeaks::late)
      .def_readonly("mean", &ImpactPeaks::mean)
      .def_readonly("least", &ImpactPeaks::least)
      .def_readonly("lost_for", &ImpactPeaks::lost_for);
  py::class_<CheckedImpact>(m, "Passage", doc("track/impact_check.hpp CheckedImpact"))
      .def_property_readonly("begin", [](const CheckedImpact& p) { return p.history.begin(); })
      .def_property_readonly("end", [](const CheckedImpact& p) { return p.history.end(); })
      .def("force",
           py::vectorize([](const CheckedImpact* p, double t) { return p->history.force(t); }),
           "t"_a, "The wheel/rail force [N] at times t [s] from the joint.")
      .def(
          "state",
          [](const CheckedImpact& p, double t) { return Eigen::VectorXd(p.history.state(t)); },
          "t"_a, "w, w', r, r', b, b' of wheel, rail and bed [m, m/s].")
      .def_readonly("peaks", &CheckedImpact::peaks)
      .def_readonly("change", &CheckedImpact::change);
  m.def("joint_passage", &joint_passage, "model"_a, "surface"_a, "speed"_a, "duration"_a = 0.06,
        "tolerance"_a = 1e-8, Unlocked(), doc("track/impact_check.hpp simulate_checked"));
}

}  // namespace railbook::python
