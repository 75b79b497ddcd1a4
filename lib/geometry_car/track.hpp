// The track under the geometry car: both rails in space, on a grid fine enough to be the truth.
//
// Axes: x along the track, y to the left, z up. Curvature is positive in a left-hand curve, roll
// and crosslevel where the left rail is higher. Lateral positions are unrolled: y'' is the
// curvature, so a chord stretched on y is the chord stretched on the rail.
#pragma once

#include <cstdint>
#include <vector>

#include <railbook/units/constants.hpp>

namespace railbook::geometry_car {

// A random part: S = A/phi^2 up to phi_c, A phi_c^2/phi^4 above, level below low_cut (m^2 cycle/m,
// cycle/m).
struct Roughness {
  double A = 0;
  double phi_c = 0.13;
  double low_cut = 1.0 / 600;
};

struct TrackDescription {
  double length = 8192 * units::foot;  // m
  std::uint64_t seed = 1;

  // Heights. The common part moves both rails; the opposite one raises the left and lowers the
  // right by as much.
  Roughness surface{5e-7, 0.13, 1.0 / 600};
  double opposite_share = 0.2;  // of A that is opposite; that part is level below 1/60 cycle/m
  double dip = 5.5e-3;          // of the joints, m
  double rail_length = 39 * units::foot;
  bool staggered = true;         // joints of the right rail half a rail behind those of the left
  double joint_smoothing = 0.1;  // m: the kink is a mean over this length
  double grade = 0.005;          // -grade before, +grade after the vertical curve
  double vertical_curve = 300;   // its length, m; its middle is at a quarter of the track

  // Lateral.
  Roughness line{1e-7, 0.13, 1.0 / 200};  // centre line
  Roughness gage_variation{4e-8, 0.13, 1.0 / 30};
  double gage = 56.5 * units::inch;
  double curvature = -4 * units::degree / (100 * units::foot);  // of the curve, 1/m; 0: tangent
  double superelevation = 4 * units::inch;                      // of the outer rail in it
  double spiral = 300 * units::foot;
  double curve_begin = 0.5;                 // of the length: where the first spiral begins
  double curve_length = 800 * units::foot;  // between the spirals
  double base = 59.5 * units::inch;         // over which superelevation is counted

  int substeps = 16;            // grid points a foot
  double sample = units::foot;  // distance between samples, m
};

// Values at s = i * spacing, i = 0 ... size() - 1. Between grid points the rails are straight.
struct Track {
  double spacing = 0;  // m
  int substeps = 16;   // grid points a sample
  double base = 0;
  std::vector<double> z_left, z_right, y_left, y_right;

  std::size_t size() const { return z_left.size(); }
  double length() const { return static_cast<double>(size() - 1) * spacing; }
};

// Builds the track; without its random parts to 1e-14 of grade, dips, superelevation and curve.
// Throws InputError naming a value that is out of range: length at least 200 m, positive spacings
// and lengths, A >= 0, corners below the grid's Nyquist wavenumber.
Track build(const TrackDescription& description);

// The same track met from the other end: x runs backwards and left and right change places.
Track turned(const Track& track);

}  // namespace railbook::geometry_car
