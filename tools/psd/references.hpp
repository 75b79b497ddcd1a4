// Reference spectra, to be compared with and drawn behind one's own.
#pragma once

#include <string>
#include <vector>

#include <railbook/spectra/spectrum_fit.hpp>
#include <railbook/spectra/welch.hpp>
#include <railbook/tool/summary.hpp>

namespace railbook::psd_tool {

// The rms of both in the waves of 3 to 25 m, where all references hold; of a chord offset, where
// the chord sees them.
void add_references(tool::Summary& summary, const std::vector<std::string>& references,
                    const spectra::Spectrum& own, const spectra::FitOptions& options);

// A block of points for each, between two wavenumbers (cycle/m).
std::string reference_table(const std::vector<std::string>& references, double low, double high);

}  // namespace railbook::psd_tool
