// The module `railbook`: its parts, its version, and how errors come out of it.
#include <exception>

#include <railbook/units/input_error.hpp>

#include "python.hpp"

namespace railbook::python {

py::module_ part(py::module_& whole, const char* name, const char* text) {
  py::module_ m = whole.def_submodule(name, text);
  py::module_::import("sys").attr("modules")[py::str("railbook." + std::string(name))] = m;
  return m;
}

}  // namespace railbook::python

PYBIND11_MODULE(railbook, m) {
  using namespace railbook;
  m.doc() =
      "Wheel, rail and track: the solvers of the command railbook.\n\n"
      "All quantities are SI: m, N, Pa, kg, s, rad. Bad input is a ValueError that names the "
      "quantity, its value and\nthe allowed range; a computation that comes to no answer is a "
      "railbook.NumericalError.";
  m.attr("__version__") = RAILBOOK_VERSION;
  m.attr("__path__") = python::py::list();  // `import railbook.contact` asks for it
  python::py::register_exception<python::NumericalError>(m, "NumericalError", PyExc_RuntimeError);
  python::py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const InputError& e) {
      PyErr_SetString(PyExc_ValueError, e.what());
    }
  });
  python::bind_contact(m);
  python::bind_rolling(m);
  python::bind_profiles(m);
  python::bind_wheel_contact(m);
  python::bind_vehicle(m);
  python::bind_track(m);
  python::bind_records(m);
}
