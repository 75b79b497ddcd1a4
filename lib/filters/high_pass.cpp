#include <railbook/filters/high_pass.hpp>

#include <cmath>

#include <railbook/filters/chord_filter.hpp>
#include <railbook/units/constants.hpp>
#include <railbook/units/input_error.hpp>

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

// 1 - b as a sum of squares: no cancellation.
double one_minus_mean(int M, double theta) {
  double sum = 0;
  for (int j = 1; j <= M / 2; ++j) {
    const double s = std::sin(0.5 * j * theta);
    sum += s * s;
  }
  return 4 * sum / M;
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
  const double b = mean_gain(f.length, theta);
  double sum = 0;  // 1 - b^p = (1 - b)(1 + b + ...)
  for (int i = 0; i < f.passes; ++i) sum = 1 + b * sum;
  return std::pow(one_minus_mean(f.length, theta) * sum, f.stages);
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
  return {curve.begin(), curve.end()};
}

}  // namespace railbook::filters
