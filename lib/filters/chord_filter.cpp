#include <railbook/filters/chord_filter.hpp>

#include <algorithm>
#include <cmath>

#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::filters {
namespace {

std::size_t checked(int half_chord) {
  return static_cast<std::size_t>(
      units::require_between("half chord in samples", half_chord, 1, 1e6));
}

void require_window(std::size_t samples, std::size_t window) {
  units::require_between("samples of the record", static_cast<double>(samples),
                         static_cast<double>(window), units::infinity);
}

}  // namespace

double mean_gain(int M, double theta) {
  const double x = 0.5 * std::remainder(theta, 2 * units::pi);
  const double below = M * std::sin(x);
  // A whole turn moves an even M to the other sign.
  const double turns = std::nearbyint((0.5 * theta - x) / units::pi);
  const double sign = M % 2 == 0 && std::fmod(turns, 2.0) != 0 ? -1 : 1;
  return sign * (below == 0 ? 1 : std::sin(M * x) / below);
}

template <class Number>
std::vector<Number> running_sum(std::span<const Number> x, int length, std::size_t restart) {
  const std::size_t n = checked(length);
  require_window(x.size(), n);
  std::vector<Number> out(x.size() - n + 1);
  if (restart == 0) restart = out.size();
  for (std::size_t begin = 0; begin < out.size(); begin += restart) {
    Number sum{};
    for (std::size_t j = 0; j < n; ++j) sum += x[begin + j];
    out[begin] = sum;
    const std::size_t end = std::min(begin + restart, out.size());
    for (std::size_t i = begin + 1; i < end; ++i) {
      sum += x[i + n - 1] - x[i - 1];
      out[i] = sum;
    }
  }
  return out;
}

template std::vector<float> running_sum(std::span<const float>, int, std::size_t);
template std::vector<double> running_sum(std::span<const double>, int, std::size_t);
template std::vector<std::uint64_t> running_sum(std::span<const std::uint64_t>, int, std::size_t);

spectra::ChordOffsets to_chord(std::span<const double> x, int half_chord) {
  const std::size_t n = checked(half_chord);
  require_window(x.size(), 2 * n - 1);
  std::vector<double> clean(x.begin(), x.end());
  std::vector<std::size_t> holes;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    if (std::isfinite(clean[i])) continue;
    holes.push_back(i);
    clean[i] = 0;
  }
  const auto once = running_sum<double>(clean, half_chord);
  spectra::ChordOffsets result{n - 1, running_sum<double>(once, half_chord)};
  std::size_t masked =
      0;  // outputs before this one are settled; hole i spoils outputs i - (2n - 2) ... i
  for (const std::size_t hole : holes) {
    const std::size_t end = std::min(hole + 1, result.offset.size());
    for (std::size_t i = std::max(masked, hole - std::min(hole, 2 * n - 2)); i < end; ++i)
      result.offset[i] = units::nan;
    masked = end;
  }
  return result;
}

}  // namespace railbook::filters
