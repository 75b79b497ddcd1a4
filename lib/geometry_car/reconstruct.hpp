// From the sensors to track geometry, as the paper describes it: hybrid filters, corrections,
// chords.
//
//   const Measurement m = reconstruct(record, Processing{.layout = car.layout});
//   m[Parameter::profile_left][k]      // m, at foot mark m.mark[k]
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <railbook/filters/geometry_chain.hpp>
#include <railbook/filters/hybrid_filter.hpp>
#include <railbook/geometry_car/car.hpp>
#include <railbook/geometry_car/record.hpp>
#include <railbook/geometry_car/track.hpp>

namespace railbook::geometry_car {

enum class Parameter {
  gage,
  curvature,       // mean over the trucks' spacing and a further stretch, 1/m
  curvature_rate,  // its change over that stretch, 1/m^2
  crosslevel,      // left above right
  warp,            // change of crosslevel over the long chord
  profile_left,    // mid-chord offsets
  profile_right,
  alignment_left,
  alignment_right,
  surface_left,  // pseudo space curves of profile and alignment
  surface_right,
  line_left,
  line_right,
};
inline constexpr std::size_t parameters = 13;

// What is known of a parameter: its name in files, unit there, and the speeds (m/s) below which the
// paper calls it degraded and not to be relied upon.
struct ParameterInfo {
  Parameter parameter;
  std::string_view name, unit;
  double si;
  double degraded_below, unreliable_below;
};
const std::array<ParameterInfo, parameters>& parameter_list();

// The corrections of the paper; switched off only to see what they are worth.
struct Corrections {
  bool truck_motion = true;       // of curvature: body against trucks
  bool centrifugal = true;        // of the inclinometer: speed times yaw rate
  bool yaw_centre = true;         // of the inclinometer: it sits before the middle of the car
  bool roll_acceleration = true;  // of the inclinometer: it sits above the rails
  bool gyro = true;               // of crosslevel: the fast part of the roll
  bool vertical_attitude =
      true;  // of profile: gravity and centrifugal acceleration on a leaning body
  bool transducer_place = true;  // of profile: transducers not over the rails
  bool gravity = true;           // of alignment: the beam rolls with the track
  bool beam_height = true;       // of alignment: accelerometer above the plane of the rails
};

struct Processing {
  Layout layout = {};
  filters::GeometryChainOptions chain = {};  // long chord and high-pass of profile and alignment
  filters::Decay decay = filters::Decay::exact;
  bool local = false;             // G with the last interval only, as if the speed were constant
  double roll_corner = 1.25 / 4;  // Hz: two octaves below the lateral mode
  int roll_poles = 2;             // of the inclinometer's path, besides the analog filter
  int curvature_mean = 51;        // samples, odd, 3 to 1001
  double fastest = 150;           // m/s: a row that would mean more is rejected
  double steepest = 0.01;         // grade of the line, for the quality of profile at changing speed
  Corrections corrections = {};
  // What examine() takes out; without, it is kept and doubted.
  bool mask_jumps = true, mask_still = true;
  std::vector<double> grade = {};  // slope of the rails ahead of each mark from 0 on: only for the
                                   // size of what its lack costs
};

// Rows as in the record. NaN where a window is not complete or holds a sample that is missing.
struct Measurement {
  std::vector<long> mark;
  std::vector<double> speed;  // m/s over the last foot, its sign the direction; NaN if unknown
  std::array<std::vector<double>, parameters> values;
  std::size_t rejected = 0;  // rows with a time that cannot be
  std::size_t runs = 0;      // stretches without a gap or a reversal

  std::size_t size() const { return mark.size(); }
  std::vector<double>& operator[](Parameter p) { return values[static_cast<std::size_t>(p)]; }
  const std::vector<double>& operator[](Parameter p) const {
    return values[static_cast<std::size_t>(p)];
  }
};

// Works through every run of the record in the order of time, forwards or backwards. A row whose
// time since the row before is zero, negative, NaN or too short is rejected (a short one counts for
// the next row), a jump or a turn of the marks begins a new run, a missing value masks what depends
// on it; crosslevel, and with it warp and alignment, begins when the roll filter has settled (4 s
// with the defaults) after the start or a gap. Throws InputError when no run has the samples the
// composite filter needs (663 with the defaults: 661 short chords), and on a processing that does
// not make sense. With ideal sensors, on tracks as the default one, at steady 7 to 40 m/s, root
// mean square errors are below 2.5 mm of crosslevel, 3 mm of warp, 2e-5 1/m of curvature, 2.5e-6
// 1/m^2 of its rate, 0.1 mm of profile, 0.8 mm of its space curve, rounding of gage; of alignment
// see levelling_error().
Measurement reconstruct(const Record& record, const Processing& processing);

// What an ideal instrument would answer at each mark: the same chords, means and filters on the
// true rails, to 1e-11 of their size.
Measurement truth(const Track& track, const Processing& processing);

// What a change of speed may cost a long chord of length L on a grade (m), for the car does not
// know the grade: the acceleration grade * dV/dt, taken for one of the track, is an offset of grade
// |dV/dt| L^2/(8 V^2). It is a bound but for the high-pass, which takes off what stays.
double braking_error(double grade, double rate, double chord, double speed);
inline constexpr double braking_degrades = 0.2e-3, braking_spoils = 1.6e-3;  // m, ours

// What an error of the crosslevel may cost a long chord of alignment (m): gravity on a false lean
// is taken for a curve. Largest seen over 7 to 30 m/s with ideal sensors on the default track and a
// chord of 18.9 m, where it falls with the speed, as the crosslevel's error grows with it; 6.3 mm
// at 7 m/s. On 30 other tracks up to 1.1 of it.
double levelling_error(double chord, double speed);
inline constexpr double levelling_degrades = 2e-3, levelling_spoils = 8e-3;  // m, ours

// Is a value to be trusted? By the slowest speed in its window and the paper's limits; profile, and
// its space curve, also by the braking error, with the change of speed over the long chord;
// alignment, and its space curve, also by the levelling error.
enum class Quality : unsigned char { good, degraded, unreliable, missing };
std::vector<Quality> quality(const Measurement& measurement, Parameter parameter,
                             const Processing& processing);

}  // namespace railbook::geometry_car
