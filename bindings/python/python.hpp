// What the rooms' bindings share.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace railbook::python {

namespace py = pybind11;
using namespace pybind11::literals;

// An array that is read where it lies; one of another type or with steps is copied.
using Array = Eigen::Ref<const Eigen::VectorXd>;
inline std::span<const double> span_of(const Array& a) {
  return {a.data(), static_cast<std::size_t>(a.size())};
}
inline std::vector<double> vector_of(const Array& a) {
  return {a.data(), a.data() + a.size()};
}

// An array that owns the numbers of `values`, which are not copied.
inline py::array_t<double> array_of(std::vector<double> values) {
  auto* kept = new std::vector<double>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<double>*>(p); });
  return py::array_t<double>(static_cast<py::ssize_t>(kept->size()), kept->data(), owner);
}

// A computation that came to no answer: railbook.NumericalError.
class NumericalError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
template <class Result>
Result converged(Result result) {
  if (!result.converged) throw NumericalError(result.reason);
  return result;
}

// The interpreter's lock is given back while a solver runs.
using Unlocked = py::call_guard<py::gil_scoped_release>;

// The comment of a declaration in a public header, "contact/hertz.hpp hertz_from_force", or that at
// the head of the file, "contact/hertz.hpp". Looked up when the module is built (docstrings.py).
const char* doc(std::string_view place);

// A part of the module that can be imported by its own name, as railbook.contact.
py::module_ part(py::module_& whole, const char* name, const char* text);

void bind_contact(py::module_&);
void bind_rolling(py::module_&);
void bind_profiles(py::module_&);
void bind_wheel_contact(py::module_&);
void bind_vehicle(py::module_&);
void bind_track(py::module_&);
void bind_records(py::module_&);

}  // namespace railbook::python
