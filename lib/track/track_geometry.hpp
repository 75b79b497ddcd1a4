// Vertical geometry of the rail's running surface: jointed rail as a rectified sine, measured
// profiles, and the idealized cross-level spectrum. Heights are positive downwards (a dip),
// distances along the track.
#pragma once

#include <span>
#include <variant>
#include <vector>

namespace railbook::track {

struct SurfacePoint {
  double z = 0;      // [m], positive down
  double slope = 0;  // dz/dx
};

// z = A (1 - |sin(pi x / L)|): dips of depth A [m] with a cusp at the joints x = 0, +-L, ... [m].
// To rounding of A (1 + |x|/L); |x|/L below 1e15. Depth and length are checked by require_valid.
struct RectifiedSine {
  double depth = 0;
  double length = 0;
  // A piece is the smooth arc between two joints; `at` continues the arc's formula beyond its ends.
  long piece(double x) const;
  SurfacePoint at(double x, long piece) const;
  double total_angle() const;  // between the tangents at a joint, 2 pi A / L [rad]
};

// Coefficient of cos(2 pi n x / L) in the rectified sine of depth 1, n >= 1: (4 / pi) / (4 n^2 -
// 1); for n = 0 the mean, 1 - 2 / pi. To rounding; throws InputError unless n is in [0, 1e6].
double rectified_sine_harmonic(int n);

// Between its samples a measured profile is a natural cubic spline, continuous to the second
// derivative, or a polygon.
enum class Between { spline, lines };

class SampledProfile {
 public:
  // x [m] strictly ascending by 1e-9 at least, within 1e6, z [m] within 1e3, 4 to 1e8 samples.
  // Throws InputError naming what is wrong. To rounding of the largest height and bend.
  SampledProfile(std::vector<double> x, std::vector<double> z, Between between = Between::spline);
  long piece(double x) const;  // the interval; x outside the samples belongs to the first or last
  SurfacePoint at(double x, long piece) const;
  double first() const { return x_.front(); }
  double last() const { return x_.back(); }
  std::span<const double> knots() const { return x_; }
  std::span<const double> heights() const { return z_; }
  Between between() const { return between_; }

 private:
  void bend_as_spline();

  Between between_;
  std::vector<double> x_, z_, bend_;  // bend: second derivative at the samples
};

using Surface = std::variant<RectifiedSine, SampledProfile>;
SurfacePoint surface_at(const Surface& surface, double x);
// Abscissae in (low, high) where pieces meet, ascending; exact. The rail's length positive, low and
// high finite.
std::vector<double> breakpoints(const Surface& surface, double low, double high);
// True when the slope jumps at the breakpoints.
bool has_cusps(const Surface& surface);
// Throws InputError unless depth is finite and length positive (a sampled profile is checked when
// made).
void require_valid(const Surface& surface);

// Left and right rail of a track with half-staggered joints (the right one's joints half a rail
// later), as what a vehicle feels: bounce (l + r) / 2 and roll (l - r) / 2.
struct BounceRoll {
  double bounce = 0;
  double roll = 0;
};
BounceRoll half_staggered(const RectifiedSine& rail, double x);

// Amplitudes of cos(2 pi n x / L), n = 0 ... count - 1, of one period of samples (a multiple of the
// wanted count or more; error by aliasing only): a discrete Fourier transform, to rounding. Throws
// InputError unless count is in [1, half of the samples].
std::vector<double> cosine_amplitudes(std::span<const double> samples, int count);

// The idealized cross-level spectrum, one-sided over cycles per metre [m^2 / (1/m)]:
//   S = A f2^2 / ((f^2 + f1^2) (f^2 + f2^2)).
// Reconstructed: the curve of the paper's Figure 6 is not in the text. Defaults are the class 6
// values of the FRA roughness family quoted by Fryba (Dynamics of Railway Bridges, 1996).
struct CrossLevelSpectrum {
  double roughness = 0.98e-8;  // A [m]
  double low_break = 0.0233;   // f1 [1/m]
  double high_break = 0.131;   // f2 [1/m]
  // At wavenumber >= 0 [cycles/m]; its integral over wavenumbers [m^2], 0 <= low <= high <
  // infinity. Both to rounding, equal breaks, narrow bands and tails too. They throw InputError
  // unless so, and the breaks positive.
  double density(double wavenumber) const;
  double variance(double low, double high) const;
};

}  // namespace railbook::track
