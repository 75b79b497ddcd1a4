/***
### Which formulas lose digits, and which keep them?

Rounding makes each number wrong by about $10^{-16}$ of itself. A difference of two numbers that
are nearly equal keeps that error and loses the numbers. Three such differences stand in the
formulas of this book. The offset of a chord has the gain $1-\cos\theta$, which is small for long
waves. The answer of a first-order filter to a constant holds $1-e^{-\kappa}$, which is small
where the car is fast. A second-order filter next to critical damping has
$(e^{-(\sigma-w)T}-e^{-(\sigma+w)T})/2w$ with a small $w$. Each has a form that subtracts nothing.

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

// Each point is the largest of thirty arguments beside it.
void lost_digits(report::Item& item) {
  item.added("not in the paper");
  report::Data& data = item.data({"x", "formula", "plain", "kept"});
  data.holds_to("plain", 10, 1e-15, "rounding errors");
  data.holds_to("kept", 10, 1e-15, "rounding errors");
  double worst_plain = 0, worst_kept = 0;
  for (const Formula& f : formulas) {
    for (int i = -32; i <= 0; ++i) {
      double plain = 0, kept = 0;
      for (int k = 0; k < 30; ++k) {
        const double x = std::pow(10, 0.25 * i + 0.008 * k);
        const Long truth = f.truth(x);
        const auto off = [&](double found) {
          return static_cast<double>(std::abs(found / truth - 1));
        };
        plain = std::max(plain, off(f.plain(x)));
        kept = std::max(kept, off(f.kept(x)));
      }
      data.add(std::pow(10, 0.25 * i), f.name, plain, kept);
      worst_plain = std::max(worst_plain, plain);
      worst_kept = std::max(worst_kept, kept);
    }
    data.gap();
  }
  item.expect_checks(1);
  item.at_most("kept", "largest relative error of the forms that are used", "", worst_kept, 1e-15,
               "a few roundings of a double");
  item.value("digits-answer",
             fmt::format("The forms that subtract keep {} digits at worst, those that are used "
                         "{:.0f}.",
                         worst_plain >= 1 ? "no" : fmt::format("{:.0f}", -std::log10(worst_plain)),
                         std::floor(-std::log10(worst_kept))));
}

}  // namespace

const report::Section digits{
    report::figure("lost-digits",
                   "A difference of nearly equal numbers loses digits, a form without one keeps "
                   "them. Largest relative error against the argument: $\\theta$, $\\kappa$ or "
                   "$wT$.",
                   lost_digits)};

}  // namespace railbook::filters_chapter
