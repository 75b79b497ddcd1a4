// railbook.spectra and railbook.filters: a record to its spectrum, class, bands and chords.
#include <railbook/filters/wavelength_band.hpp>
#include <railbook/spectra/classify.hpp>
#include <railbook/spectra/synthetic_track.hpp>
#include <railbook/spectra/welch.hpp>

#include "python.hpp"

namespace railbook::python {
namespace {

using namespace spectra;

py::array_t<double> filtered(const filters::FilterTaps& taps, const Array& record) {
  std::vector<double> out;
  {
    const py::gil_scoped_release unlocked;
    out = filters::filter(taps, span_of(record));
  }
  return array_of(std::move(out));
}

}  // namespace

void bind_records(py::module_& whole) {
  auto m = part(whole, "spectra", doc("spectra/welch.hpp"));
  py::class_<Spectrum>(m, "Spectrum", doc("spectra/welch.hpp Spectrum"))
      .def_readonly("df", &Spectrum::df)
      .def_readonly("density", &Spectrum::density)
      .def_readonly("segments", &Spectrum::segments)
      .def_readonly("averages", &Spectrum::averages)
      .def_property_readonly("frequency", [](const Spectrum& s) {
        return Eigen::VectorXd(Eigen::VectorXd::LinSpaced(
            s.density.size(), 0, s.df * static_cast<double>(s.density.size() - 1)));
      });
  m.def(
      "welch",
      [](const Array& record, double spacing, std::size_t segment, std::size_t parts) {
        return welch(span_of(record), spacing, {.segment = segment, .parts = parts});
      },
      "record"_a, "spacing"_a, "segment"_a = 4096, "parts"_a = 2, Unlocked(),
      doc("spectra/welch.hpp Welch"));

  py::class_<Estimate>(m, "Estimate", doc("spectra/spectrum_fit.hpp Estimate"))
      .def_readonly("value", &Estimate::value)
      .def_readonly("error", &Estimate::error);
  py::class_<SpectrumFit>(m, "SpectrumFit", doc("spectra/spectrum_fit.hpp SpectrumFit"))
      .def_readonly("A", &SpectrumFit::A)
      .def_readonly("phi_c", &SpectrumFit::phi_c)
      .def_readonly("steep", &SpectrumFit::steep)
      .def_readonly("Q_1", &SpectrumFit::Q_1)
      .def_readonly("B_printed", &SpectrumFit::B_printed)
      .def_readonly("B_exact", &SpectrumFit::B_exact)
      .def_readonly("line_significant", &SpectrumFit::line_significant)
      .def_readonly("misfit", &SpectrumFit::misfit);
  m.def(
      "fit",
      [](const Spectrum& spectrum, double rail_length, double low, double high) {
        FitOptions options;
        options.rail_length = rail_length, options.low = low, options.high = high;
        SpectrumFit found = fit_track_spectrum(spectrum, options);
        if (!found.converged) throw NumericalError("spectrum: the noise could not be fitted");
        return found;
      },
      "spectrum"_a, "rail_length"_a, "low"_a = 0.01, "high"_a = 1.2, Unlocked(),
      doc("spectra/spectrum_fit.hpp fit_track_spectrum"));
  py::class_<Classification>(m, "Classification", doc("spectra/classify.hpp Classification"))
      .def_readonly("track_class", &Classification::track_class)
      .def_readonly("deviation", &Classification::deviation)
      .def_readonly("random", &Classification::random)
      .def_readonly("periodic", &Classification::periodic)
      .def_readonly("margin", &Classification::margin)
      .def_readonly("to_next", &Classification::to_next);
  m.def(
      "classify", [](double A, double B) { return classify(A, B); }, "A"_a, "B_printed"_a,
      doc("spectra/classify.hpp classify"));
  m.def(
      "class_probabilities", [](const SpectrumFit& fit) { return class_probabilities(fit); },
      "fit"_a, doc("spectra/classify.hpp class_probabilities"));
  m.def(
      "synthesize",
      [](std::size_t samples, double spacing, std::uint64_t seed, double A, double phi_c,
         double rail_length, double dip) {
        SyntheticTrack track;
        track.spacing = spacing, track.seed = seed, track.A = A, track.phi_c = phi_c;
        track.rail_length = rail_length, track.dip = dip;
        return array_of(synthesize(track, samples));
      },
      "samples"_a, py::kw_only(), "spacing"_a, "seed"_a = 1, "A"_a, "phi_c"_a = no_corner,
      "rail_length"_a = 39 * units::foot, "dip"_a = 0.0,
      doc("spectra/synthetic_track.hpp SyntheticTrack"));

  auto f = part(whole, "filters", doc("filters/wavelength_band.hpp"));
  f.def(
      "band",
      [](const Array& record, double spacing, const std::string& name, int passes) {
        return filtered(filters::band_taps(filters::parse_band("band", name), passes, spacing),
                        record);
      },
      "record"_a, "spacing"_a, "name"_a, "passes"_a = 2,
      doc("filters/wavelength_band.hpp band_taps"));
  f.def(
      "chord",
      [](const Array& record, double spacing, double chord) {
        return filtered(filters::chord_taps(chord, spacing), record);
      },
      "record"_a, "spacing"_a, "chord"_a, doc("filters/wavelength_band.hpp chord_taps"));
}

}  // namespace railbook::python
