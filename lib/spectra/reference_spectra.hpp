// Reference spectra of track irregularity, to draw behind one's own and to compare with.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace railbook::spectra {

// A one-sided density of the irregularity over wavenumber, m^2/(cycle/m), where it is meant to
// hold. Each is in at least one open code named by `source`; none could be checked against the body
// that set it.
struct Reference {
  std::string name;     // "german-low"
  std::string channel;  // "vertical" or "lateral"
  std::string source;
  double low = 0, high = 0;  // cycle/m
  std::function<double(double phi)> density;
};

// German low and high disturbance (ERRI B176), FRA classes 1 to 6 in the form with A_v and in the
// one of Hamid and Yang, and Chinese ballastless high-speed track (TB/T 3352-2014). The two FRA
// sets differ by a factor of two and more in density; both are given by name. Left out for want of
// a second source: lateral A_a of FRA classes 1 to 4, Braun's spectra, the British ones.
const std::vector<Reference>& references();

// By name and channel; throws InputError naming those there are.
const Reference& reference(std::string_view name, std::string_view channel = "vertical");

}  // namespace railbook::spectra
