/***
### Which formulas lose digits, and which keep them?

Rounding makes each number wrong by about $10^{-16}$ of itself. A difference of two numbers that are
nearly equal keeps this error, while the difference itself is small. Three such differences stand in
the formulas of this book. Each has a form that subtracts nothing:

* The offset of a chord has the gain $1-\cos\theta$, which is small for long waves. It is computed
  as $2\sin^2(\theta/2)$.
* The answer of a first-order filter to a constant contains $1-e^{-\kappa}$, which is small where
  the car is fast. The function `expm1` of the C library computes it without the difference.
* A second-order filter next to critical damping forgets at two rates, $\sigma-w$ and $\sigma+w$
  with a small $w$, and contains $(e^{-(\sigma-w)T}-e^{-(\sigma+w)T})/2w$. It is computed as
  $e^{-\sigma T}\sinh(wT)/w$.

{{lost-digits}}

{{digits-answer}}
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sections.hpp"

namespace railbook::filters_chapter {
namespace {

using Long = long double;

// A formula in its plain form and as the library has it, with the truth in extended precision.
struct Formula {
  const char* name;
  double (*plain)(double);
  double (*kept)(double);
  Long (*truth)(Long);
};

constexpr double sigma = 1;  // sigma T of the second-order filter

const Formula formulas[] = {
    {"cosine", [](double x) { return 1 - std::cos(x); },
     [](double x) { return 2 * std::pow(std::sin(x / 2), 2); },
     [](Long x) { return 2 * std::pow(std::sin(x / 2), 2); }},
    {"exponential", [](double x) { return 1 - std::exp(-x); },
     [](double x) { return -std::expm1(-x); }, [](Long x) { return -std::expm1(-x); }},
    {"damping",
     [](double x) { return (std::exp(-(sigma - x)) - std::exp(-(sigma + x))) / (2 * x); },
     [](double x) { return std::exp(-sigma) * std::sinh(x) / x; },
     [](Long x) { return std::exp(-Long{sigma}) * std::sinh(x) / x; }}};

// The largest relative errors of both forms among thirty arguments from x on.
struct LostDigits {
  double plain = 0, kept = 0;
};
LostDigits largest_errors(const Formula& f, int quarter_decade) {
  LostDigits worst;
  for (int k = 0; k < 30; ++k) {
    const double x = std::pow(10, 0.25 * quarter_decade + 0.008 * k);
    const Long truth = f.truth(x);
    const auto off = [&](double found) { return static_cast<double>(std::abs(found / truth - 1)); };
    worst.plain = std::max(worst.plain, off(f.plain(x)));
    worst.kept = std::max(worst.kept, off(f.kept(x)));
  }
  return worst;
}

void lost_digits(report::Item& item) {
  item.added("not in the paper");
  report::Data& data = item.data({"x", "formula", "plain", "kept"});
  data.holds_to("plain", 10, 1e-15, "rounding errors");
  data.holds_to("kept", 10, 1e-15, "rounding errors");
  double worst_plain[std::size(formulas)] = {}, worst_kept = 0;
  for (std::size_t n = 0; n < std::size(formulas); ++n) {
    const Formula& f = formulas[n];
    for (int i = -32; i <= 0; ++i) {
      const auto [plain, kept] = largest_errors(f, i);
      data.add(std::pow(10, 0.25 * i), f.name, plain, kept);
      worst_plain[n] = std::max(worst_plain[n], plain);
      worst_kept = std::max(worst_kept, kept);
    }
    data.gap();
  }
  item.expect_checks(1);
  item.at_most("kept", "largest relative error of the forms that are used", "", worst_kept, 1e-15,
               "a few roundings of a double");
  item.value(
      "digits-answer",
      fmt::format("At an argument of 10⁻⁸ the cosine's difference keeps {} digits and "
                  "the other two keep {:.0f}; the forms that are used keep {:.0f} everywhere.",
                  worst_plain[0] >= 1 ? "no" : fmt::format("{:.0f}", -std::log10(worst_plain[0])),
                  std::floor(-std::log10(std::max(worst_plain[1], worst_plain[2]))),
                  std::floor(-std::log10(worst_kept))));
}

}  // namespace

const report::Section digits{report::figure("lost-digits", lost_digits)};

}  // namespace railbook::filters_chapter
