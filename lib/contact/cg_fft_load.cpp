#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/cg_fft.hpp"
#include "units/input_error.hpp"

namespace railbook::contact {
namespace {

// The approach at which the force is the load, as a secant in log(force) against log(approach).
struct LoadSearch {
  const Gap& gap;
  double load, effective_modulus;
  double approach = 1e-7;  // [m], a start; the force may be off by any factor
  double slope = 1.5;      // d log F / d log delta: 3/2 for smooth bodies, 1 for a flat punch
  long work = 0;
  int iterations = 0;

  // Solves until the force is within `tolerance` of the load, at most 40 times; `found` says whether it was.
  CgFft refine(const CgFftOptions& options, double tolerance, bool& found) {
    double last_log_force = 0, last_log_approach = 0;
    for (int k = 0;; ++k) {
      CgFft result = solve_cg_fft(gap, approach, effective_modulus, options);
      work += result.contact.work;
      iterations += result.contact.iterations;
      if (result.contact.force <= 0 && k < 40) {  // too little even for one cell
        approach *= 10;
        continue;
      }
      const double log_force = std::log(result.contact.force / load);
      found = std::abs(log_force) <= tolerance;
      if (found || k == 40) return result;
      const double log_approach = std::log(approach);
      // Near the end the two forces differ by the solver's own noise: keep the slope.
      if (k > 0 && std::abs(log_approach - last_log_approach) > 1e-4)
        slope =
            std::clamp((log_force - last_log_force) / (log_approach - last_log_approach), 0.5, 3.0);
      last_log_force = log_force, last_log_approach = log_approach;
      approach *= std::exp(-log_force / slope);
    }
  }
};

}  // namespace

CgFft solve_cg_fft_load(const Gap& gap, double load, double effective_modulus,
                        const CgFftOptions& options) {
  units::require_positive("load", load, "N");
  CgFftOptions coarse = options;
  coarse.nx = std::min<Eigen::Index>(options.nx, 32);
  coarse.ny = std::min<Eigen::Index>(options.ny, 32);
  LoadSearch search{gap, load, effective_modulus};
  bool found = false;
  (void)search.refine(coarse, 1e-2, found);
  CgFft result = search.refine(options, 1e-7, found);
  result.contact.work = search.work;
  result.contact.iterations = search.iterations;
  if (!found) {
    result.contact.converged = false;
    result.contact.reason = fmt::format("no approach gives the load; the last force was {:.9g} N",
                                        result.contact.force);
  }
  return result;
}

}  // namespace railbook::contact
