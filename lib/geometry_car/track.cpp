#include <railbook/geometry_car/track.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <railbook/spectra/shaped_noise.hpp>
#include <railbook/spectra/track_spectrum.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::geometry_car {
namespace {

enum Stream : std::uint64_t { common = 11, opposite, centre_line, gage };

void require(const TrackDescription& t) {
  units::require_between("length of the track", t.length, 200, 1e6, "m");
  units::require_between("distance between samples", t.sample, 0.01, 10, "m");
  units::require_between("grid points a sample", t.substeps, 2, 1000);
  units::require_between("opposite share of the roughness", t.opposite_share, 0, 1);
  units::require_finite("dip", t.dip, "m");
  units::require_between("rail length", t.rail_length, 1, 1000, "m");
  units::require_between("smoothing of the joints", t.joint_smoothing, 1e-3, 1, "m");
  units::require_between("grade", t.grade, -0.1, 0.1);
  units::require_between("length of the vertical curve", t.vertical_curve, 10, units::infinity,
                         "m");
  units::require_between("gage", t.gage, 0.5, 3, "m");
  units::require_between("curvature", t.curvature, -0.02, 0.02, "1/m");
  units::require_between("superelevation", t.superelevation, -0.3, 0.3, "m");
  units::require_between("length of a spiral", t.spiral, 1, units::infinity, "m");
  units::require_between("begin of the curve over the length", t.curve_begin, 0, 1);
  units::require_non_negative("length of the curve", t.curve_length, "m");
  units::require_between("base", t.base, 0.5, 3, "m");
}

std::vector<double> noise(const Roughness& r, const TrackDescription& t, double spacing,
                          std::size_t size, Stream stream) {
  std::vector<double> z(size);
  if (units::require_non_negative("A", r.A, "m^2 cycle/m") == 0) return z;
  units::require_positive("phi_c", r.phi_c, "cycle/m");
  const spectra::TrackParameters parameters{.A = r.A, .phi_c = r.phi_c};
  spectra::ShapedNoise{{.density = [=](double phi) { return spectra::random_psd(parameters, phi); },
                        .spacing = spacing,
                        .low_cut = r.low_cut,
                        .detail = std::min(r.phi_c, 0.5 / spacing)},
                       num::RandomSource{t.seed, stream}}
      .add(z);
  return z;
}

// The rectified sine, joints at whole rails, as a mean over the smoothing length; crests at zero.
double joint(const TrackDescription& t, double x) {
  const auto sine = [](double turns) { return std::sin(units::pi * turns); };
  const double u = x / t.rail_length, from_joint = std::abs(u - std::round(u)),
               half = 0.5 * t.joint_smoothing / t.rail_length;
  if (from_joint >= half) return t.dip * (sine(from_joint) * sine(half) / (units::pi * half) - 1);
  const double ahead = sine(0.5 * (half + from_joint)), behind = sine(0.5 * (half - from_joint));
  return t.dip * ((ahead * ahead + behind * behind) / (units::pi * half) - 1);
}

double vertical(const TrackDescription& t, double x) {
  const double from_middle = x - 0.25 * t.length;
  const double half = 0.5 * t.vertical_curve;
  if (std::abs(from_middle) >= half) return t.grade * (std::abs(from_middle) - 0.5 * half);
  return t.grade * from_middle * from_middle / t.vertical_curve;
}

// Share of the full curvature and superelevation: 0 on the tangents, a ramp on the spirals.
double share_of_curve(const TrackDescription& t, double x) {
  const double begin = t.curve_begin * t.length;
  const double end = begin + 2 * t.spiral + t.curve_length;
  return std::clamp(std::min(x - begin, end - x) / t.spiral, 0.0, 1.0);
}

// The curvature integrated twice, over what lies before the curve, spiral, curve, spiral and the
// rest.
double bent(const TrackDescription& t, double x) {
  const double rate = t.curvature / t.spiral;
  const std::array<std::array<double, 2>, 5> parts{{{t.curve_begin * t.length, 0},
                                                    {t.spiral, rate},
                                                    {t.curve_length, 0},
                                                    {t.spiral, -rate},
                                                    {units::infinity, 0}}};
  double y = 0, heading = 0, curvature = 0;
  for (const auto& [length, change] : parts) {
    const double d = std::min(x, length);
    y += d * (heading + d * (curvature / 2 + d * change / 6));
    heading += d * (curvature + d * change / 2);
    curvature += d * change;
    if ((x -= d) <= 0) break;
  }
  return y;
}

}  // namespace

Track build(const TrackDescription& t) {
  require(t);
  Track track{t.sample / t.substeps, t.substeps, t.base, {}, {}, {}, {}};
  const double ds = track.spacing;
  const auto size = static_cast<std::size_t>(std::floor(t.length / ds)) + 1;
  Roughness both = t.surface, tilt = t.surface;
  both.A *= 1 - t.opposite_share;
  tilt.A *= t.opposite_share;
  tilt.low_cut = 1.0 / 60;
  const auto c = noise(both, t, ds, size, common), e = noise(tilt, t, ds, size, opposite);
  const auto line = noise(t.line, t, ds, size, centre_line);
  const auto wide = noise(t.gage_variation, t, ds, size, gage);
  for (auto* v : {&track.z_left, &track.z_right, &track.y_left, &track.y_right}) v->resize(size);
  const double outer = t.curvature < 0 ? 1 : -1;  // the left rail is the outer one in a right curve
  for (std::size_t i = 0; i < size; ++i) {
    const double x = static_cast<double>(i) * ds;
    const double share = share_of_curve(t, x), design = vertical(t, x) + c[i];
    const double lift = 0.5 * outer * t.superelevation * share;
    track.z_left[i] = design + lift + e[i] + joint(t, x);
    track.z_right[i] =
        design - lift - e[i] + joint(t, x + (t.staggered ? 0.5 * t.rail_length : 0.0));
    const double half = 0.5 * (t.gage + wide[i]), y = bent(t, x) + line[i];
    track.y_left[i] = y + half;
    track.y_right[i] = y - half;
  }
  return track;
}

Track turned(const Track& track) {
  Track back = track;
  back.z_left.assign(track.z_right.rbegin(), track.z_right.rend());
  back.z_right.assign(track.z_left.rbegin(), track.z_left.rend());
  back.y_left.assign(track.y_right.rbegin(), track.y_right.rend());
  back.y_right.assign(track.y_left.rbegin(), track.y_left.rend());
  for (auto* y : {&back.y_left, &back.y_right})
    for (double& value : *y) value = -value;
  return back;
}

}  // namespace railbook::geometry_car
