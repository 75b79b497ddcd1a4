#include <cmath>
#include <limits>

#include <railbook/geometry_car/detail/run.hpp>

namespace railbook::geometry_car {

Measurement truth(const Track& track, const Processing& p) {
  const auto step = static_cast<std::size_t>(track.substeps);
  const auto at_marks = [&](const Column& fine) {
    Column marks;
    for (std::size_t i = 0; i < fine.size(); i += step) marks.push_back(fine[i]);
    return marks;
  };
  const Column z_left = at_marks(track.z_left), z_right = at_marks(track.z_right);
  const Column y_left = at_marks(track.y_left), y_right = at_marks(track.y_right);
  const std::size_t n = z_left.size();
  Measurement m;
  for (auto& values : m.values) values.assign(n, std::numeric_limits<double>::quiet_NaN());
  m.speed.assign(n, std::numeric_limits<double>::quiet_NaN());
  m.runs = 1;
  Column heading(n, std::numeric_limits<double>::quiet_NaN()), turn = heading;
  const auto span = std::lround(p.layout.truck_spacing / p.layout.sample);
  for (std::size_t k = 0; k < n; ++k) {
    m.mark.push_back(static_cast<long>(k));
    m[Parameter::gage][k] = y_left[k] - y_right[k];
    m[Parameter::crosslevel][k] = z_left[k] - z_right[k];
    if (const auto back = k - static_cast<std::size_t>(span); back < k)
      heading[k] =
          0.5 * (y_left[k] + y_right[k] - y_left[back] - y_right[back]) / p.layout.truck_spacing;
    if (k > 0) turn[k] = heading[k] - heading[k - 1];
  }
  m[Parameter::curvature] =
      mean_curvature(turn, p, std::lround(0.5 * p.layout.truck_spacing / p.layout.sample));
  const auto stretch = static_cast<std::size_t>(p.curvature_mean), half = stretch / 2;
  m[Parameter::curvature_rate] = change_over(m[Parameter::curvature], stretch);
  for (double& value : m[Parameter::curvature_rate])
    value /= 2 * static_cast<double>(half) * p.layout.sample;
  m[Parameter::warp] =
      change_over(m[Parameter::crosslevel], 2 * static_cast<std::size_t>(p.chain.half_chord));
  const auto chord = [&](const Column& rail, Parameter offset, Parameter curve) {
    auto both = long_chord(short_chords(rail), p);
    m[offset] = std::move(both.chord);
    m[curve] = std::move(both.space_curve);
  };
  chord(z_left, Parameter::profile_left, Parameter::surface_left);
  chord(z_right, Parameter::profile_right, Parameter::surface_right);
  chord(y_left, Parameter::alignment_left, Parameter::line_left);
  chord(y_right, Parameter::alignment_right, Parameter::line_right);
  return m;
}

}  // namespace railbook::geometry_car
