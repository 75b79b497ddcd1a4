#include "filters/high_pass.hpp"

#include <cmath>

#include "filters/chord_filter.hpp"
#include "units/constants.hpp"
#include "units/input_error.hpp"

namespace railbook::filters {
namespace {

using Word = std::uint64_t;  // wraps: sums and differences are exact modulo 2^64

Word power(const HighPass& f) {
  Word m = 1;
  for (int i = 0; i < f.passes; ++i) m *= static_cast<Word>(f.length);
  return m;
}

// M^p delta - box^p.
std::vector<Word> high_pass_words(const HighPass& f) {
  require_valid(f);
  std::vector<Word> box{1};
  for (int pass = 0; pass < f.passes; ++pass) {
    std::vector<Word> wider(box.size() + static_cast<std::size_t>(f.length) - 1);
    for (std::size_t i = 0; i < box.size(); ++i)
      for (std::size_t j = 0; j < static_cast<std::size_t>(f.length); ++j) wider[i + j] += box[i];
    box = std::move(wider);
  }
  for (Word& w : box) w = -w;
  box[box.size() / 2] += power(f);
  return box;
}

std::vector<std::int64_t> as_signed(const std::vector<Word>& words) {
  return {words.begin(), words.end()};
}

std::vector<double> over_power(const std::vector<std::int64_t>& numerators, const HighPass& f) {
  std::vector<double> taps(numerators.size());
  const auto scale = static_cast<double>(power(f));
  for (std::size_t i = 0; i < taps.size(); ++i)
    taps[i] = static_cast<double>(numerators[i]) / scale;
  return taps;
}

std::vector<double> convolve(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

// 1 - b^p = (1 - b)(1 + b + ...); `first` is what stands for 1 - b.
double geometric(const HighPass& f, double theta, double first) {
  const double b = mean_gain(f.length, theta);
  double sum = 0;
  for (int i = 0; i < f.passes; ++i) sum = 1 + b * sum;
  return first * sum;
}

// 1 - b and (1 - b)/(1 - cos theta) as sums of squares: no cancellation.
double one_minus_mean(int M, double theta) {
  double sum = 0;
  for (int j = 1; j <= M / 2; ++j) {
    const double s = std::sin(0.5 * j * theta);
    sum += s * s;
  }
  return 4 * sum / M;
}
double one_minus_mean_over_chord(int M, double theta) {
  double sum = 0;
  for (int j = 1; j <= M / 2; ++j) sum += short_to_long_gain(j, theta);
  return 2 * sum / M;
}

}  // namespace

void require_valid(const HighPass& f) {
  units::require_between("length of the mean in samples", f.length, 3, 10001);
  if (f.length % 2 == 0)
    throw InputError{"length of the mean is " + std::to_string(f.length) +
                     " samples; allowed: odd numbers"};
  units::require_between("passes", f.passes, 1, 8);
  units::require_between("stages", f.stages, 1, 2);
  units::require_between("length^passes", std::pow(f.length, f.passes), 0, 0x1p53);
}

std::size_t reach(const HighPass& f) {
  require_valid(f);
  return static_cast<std::size_t>(f.length / 2) * static_cast<std::size_t>(f.passes) *
         static_cast<std::size_t>(f.stages);
}

double high_pass_gain(const HighPass& f, double theta) {
  require_valid(f);
  return std::pow(geometric(f, theta, one_minus_mean(f.length, theta)), f.stages);
}

double space_curve_gain(const HighPass& f, double theta) {
  require_valid(f);
  const double one = geometric(f, theta, one_minus_mean_over_chord(f.length, theta));
  return f.stages == 1 ? one : one * high_pass_gain({f.length, f.passes, 1}, theta);
}

std::vector<std::int64_t> high_pass_integers(const HighPass& f) {
  return as_signed(high_pass_words(f));
}

std::vector<std::int64_t> space_curve_integers(const HighPass& f) {
  const std::vector<Word> hp = high_pass_words(f);
  std::vector<Word> curve(hp.size() - 2);
  Word before = 0, now = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {  // -(second difference) of half the curve is hp
    const Word next = 2 * now - before - hp[i];
    curve[i] = 2 * next;
    before = now;
    now = next;
  }
  return as_signed(curve);
}

std::vector<double> high_pass_taps(const HighPass& f) {
  const auto one = over_power(high_pass_integers(f), f);
  return f.stages == 1 ? one : convolve(one, one);
}

std::vector<double> space_curve_taps(const HighPass& f) {
  const auto one = over_power(space_curve_integers(f), f);
  return f.stages == 1 ? one : convolve(one, over_power(high_pass_integers(f), f));
}

}  // namespace railbook::filters
