// railbook.profiles and railbook.wheelset: profiles, where two of them touch, and conicity.
#include <optional>

#include <railbook/profiles/depth_profile.hpp>
#include <railbook/profiles/field_profile.hpp>
#include <railbook/profiles/measured_curve.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/wheelset/conicity.hpp>
#include <railbook/wheelset/paper_pairs.hpp>
#include <railbook/wheelset/tabulate.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace profiles;
using namespace wheelset;

Body body_of(const std::string& name) {
  if (name != "wheel" && name != "rail")
    throw InputError("body is \"" + name + "\"; allowed: wheel, rail");
  return name == "wheel" ? Body::wheel : Body::rail;
}

Eigen::MatrixXd matrix_of(const std::vector<Point>& points) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(points.size()), 2);
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    m.row(i) << points[static_cast<std::size_t>(i)].u, points[static_cast<std::size_t>(i)].z;
  return m;
}

// Checked points of a file's text, and all that is to be said of them.
struct ReadProfile {
  std::string format;
  Eigen::MatrixXd points;
  std::vector<std::string> warnings, left_out;
};

void append(std::vector<std::string>& texts, const std::vector<PointsWarning>& warnings) {
  for (const PointsWarning& w : warnings) texts.push_back(w.text);
}

void append(ReadProfile& read, CheckedPoints checked) {
  read.points = matrix_of(checked.points);
  append(read.warnings, checked.warnings);
  append(read.left_out, checked.left_out);
}

std::vector<Point> points_of(const Eigen::MatrixX2d& m) {
  std::vector<Point> points;
  for (Eigen::Index i = 0; i < m.rows(); ++i) points.push_back({m(i, 0), m(i, 1)});
  return points;
}

ReadProfile checked_points(const Eigen::MatrixX2d& points, const std::string& body) {
  ReadProfile read;
  append(read, check_points(points_of(points), body_of(body)));
  return read;
}

ReadProfile read_text(const std::string& text, const std::string& body) {
  auto field = parse_field_profile(text, body_of(body));
  if (!field)
    throw InputError(
        "profile: the text is of no known form; allowed: MiniProf, Simpack, VAMPIRE, plain "
        "columns of numbers");
  ReadProfile read;
  read.format = std::move(field->format);
  append(read.warnings, field->warnings);
  append(read.left_out, field->left_out);
  append(read, check_points(std::move(field->points), body_of(body)));
  return read;
}

Curve curve_through(const Eigen::MatrixX2d& m, std::optional<double> noise) {
  std::vector<Point> points = points_of(m);
  const double smoothing = noise ? *noise : 3 * scatter(points);
  return measured_curve(std::move(points), smoothing < 1e-9 ? 0 : smoothing).curve;
}

const NamedPair& paper_pair(const std::string& key) {
  for (const NamedPair& p : paper_pairs)
    if (key == p.key) return p;
  throw InputError("pair is \"" + key + "\"; allowed: new, cn, heumann");
}

}  // namespace

void bind_profiles(py::module_& whole) {
  auto m = part(whole, "profiles", doc("profiles/field_profile.hpp"));
  py::class_<ReadProfile>(m, "ReadProfile",
                          "points (n rows of inward and height [m]), format, warnings and what was "
                          "left out of a file.")
      .def_readonly("format", &ReadProfile::format)
      .def_readonly("points", &ReadProfile::points)
      .def_readonly("warnings", &ReadProfile::warnings)
      .def_readonly("left_out", &ReadProfile::left_out);
  m.def("read_text", &read_text, "text"_a, "body"_a, Unlocked(),
        doc("profiles/field_profile.hpp parse_field_profile"));
  m.def("check", &checked_points, "points"_a, "body"_a, Unlocked(),
        doc("profiles/profile_points.hpp check_points"));
  py::class_<Curve>(m, "Curve", doc("profiles/curve.hpp"))
      .def("height", py::vectorize([](const Curve* c, double u) { return c->height(u); }), "u"_a)
      .def("angle", py::vectorize([](const Curve* c, double u) { return c->angle(u); }), "u"_a)
      .def_property_readonly("ends",
                             [](const Curve& c) { return std::pair(c.start().u, c.end().u); });
  m.def("curve", &curve_through, "points"_a, "noise"_a = py::none(), Unlocked(),
        doc("profiles/measured_curve.hpp measured_curve"));
  m.def(
      "rail_60e1", [] { return rail_60e1(Rail60::drawing); },
      doc("profiles/depth_profile.hpp rail_60e1"));
  py::class_<Profile>(m, "Profile", doc("profiles/depth_profile.hpp"))
      .def(py::init<const Curve&>(), "curve"_a)
      .def("depth", py::vectorize([](const Profile* p, double y) { return p->at(y).depth; }), "y"_a)
      .def("slope", py::vectorize([](const Profile* p, double y) { return p->at(y).slope; }), "y"_a)
      .def_property_readonly("ends", [](const Profile& p) { return std::pair(p.from(), p.to()); });
  m.def("s1002", &s1002, doc("profiles/depth_profile.hpp s1002"));

  auto w = part(whole, "wheelset", doc("wheelset/wheelset_contact.hpp"));
  w.def("placed_wheel", &placed_wheel, "wheel"_a, "from_centre"_a,
        doc("wheelset/wheelset_contact.hpp placed_wheel"));
  w.def("placed_rail", &placed_rail, "rail"_a, "gauge"_a, "gauge_depth"_a, "cant"_a,
        "depth_below_end"_a = 0.0, doc("wheelset/wheelset_contact.hpp placed_rail"));
  py::class_<Point>(w, "Point", "A place in the plane across the track [m].")
      .def_readonly("u", &Point::u)
      .def_readonly("z", &Point::z);
  py::class_<SideContact>(w, "SideContact", doc("wheelset/wheelset_contact.hpp SideContact"))
      .def_readonly("radius", &SideContact::radius)
      .def_readonly("delta", &SideContact::delta)
      .def_readonly("on_wheel", &SideContact::on_wheel)
      .def_readonly("on_rail", &SideContact::on_rail)
      .def_readonly("at_end", &SideContact::at_end);
  py::class_<WheelsetContact>(w, "WheelsetContact",
                              doc("wheelset/wheelset_contact.hpp WheelsetContact"))
      .def_readonly("x", &WheelsetContact::x)
      .def_readonly("roll", &WheelsetContact::roll)
      .def_readonly("left", &WheelsetContact::left)
      .def_readonly("right", &WheelsetContact::right);
  py::class_<WheelsetOnTrack>(w, "WheelsetOnTrack",
                              doc("wheelset/wheelset_contact.hpp with_radius"))
      .def(py::init([](const Curve& wheel, const Curve& rail, double radius) {
             return with_radius(wheel, rail, radius);
           }),
           "wheel"_a, "rail"_a, "radius"_a)
      .def(
          "contact",
          [](const WheelsetOnTrack& pair, double x, bool level) {
            const WheelsetContact c = level ? pair.level_contact(x) : pair.contact(x);
            if (!c.converged) throw NumericalError("wheelset: no contact of both wheels there");
            return c;
          },
          "x"_a, "level"_a = false, Unlocked(),
          "Where both wheels touch with the wheelset displaced by x [m]; `level`: without roll.")
      .def(
          "tabulate",
          [](const WheelsetOnTrack& pair, double half_spacing, double end, double step,
             double average, bool level) {
            return tabulate(pair, {half_spacing, end, step, average, level});
          },
          "half_spacing"_a, "end"_a, "step"_a, "average"_a = 0.0, "level"_a = false, Unlocked(),
          doc("wheelset/tabulate.hpp tabulate"));
  py::class_<ConstraintFunctions>(w, "ConstraintFunctions",
                                  doc("wheelset/constraint_functions.hpp ConstraintFunctions"))
      .def_readonly("half_spacing", &ConstraintFunctions::half_spacing)
      .def_readonly("radius", &ConstraintFunctions::radius)
      .def("R", py::vectorize([](const ConstraintFunctions* c, double x) { return c->at(x).R; }),
           "x"_a)
      .def("D", py::vectorize([](const ConstraintFunctions* c, double x) { return c->at(x).D; }),
           "x"_a)
      .def("Phi",
           py::vectorize([](const ConstraintFunctions* c, double x) { return c->at(x).Phi; }),
           "x"_a)
      .def_property_readonly("end", &ConstraintFunctions::end);
  w.def(
      "paper_wheelset", [](const std::string& key) { return paper_pair(key).pair(); }, "key"_a,
      "One of the paper's wheelsets on its track: new, cn or heumann.");
  w.def(
      "paper_pair", [](const std::string& key) { return paper_pair(key).table(); }, "key"_a,
      "The constraint functions of one of the paper's pairs: new, cn or heumann.");
  py::class_<Conicity>(w, "Conicity", doc("wheelset/conicity.hpp Conicity"))
      .def_readonly("amplitude", &Conicity::amplitude)
      .def_readonly("kinematic", &Conicity::kinematic)
      .def_readonly("harmonic", &Conicity::harmonic)
      .def_readonly("regression", &Conicity::regression)
      .def_readonly("wavelength", &Conicity::wavelength)
      .def_readonly("centre", &Conicity::centre)
      .def_readonly("oscillates", &Conicity::oscillates);
  w.def("conicity", &conicity, "pair"_a, "amplitude"_a, doc("wheelset/conicity.hpp conicity"));
}

}  // namespace railbook::python
