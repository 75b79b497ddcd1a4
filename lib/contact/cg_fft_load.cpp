#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <railbook/contact/cg_fft.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::contact {
namespace {

constexpr double tolerance = 1e-7;  // on the force

// The approach at which the force is the load, as a secant in log(force) against log(approach).
struct LoadSearch {
  const Gap& gap;
  double load, effective_modulus;
  double approach = 1e-7;  // [m], a start; the force may be off by any factor
  double slope = 1.5;      // d log F / d log delta: 3/2 for smooth bodies, 1 for a flat punch
  long work = 0;
  int iterations = 0;

  CgFft solve(double at, const CgFftOptions& options) {
    CgFft result = solve_cg_fft(gap, at, effective_modulus, options);
    work += result.contact.work;
    iterations += result.contact.iterations;
    return result;
  }

  // Solves until the force is within `enough` of the load, at most 40 times, and returns the best
  // answer; `miss` says how far its force is from the load. One answer is held at a time: it is
  // large, and the best is nearly always the last.
  CgFft refine(const CgFftOptions& options, double enough, double& miss) {
    CgFft result;
    double best = 0, best_error = 0, last_log_force = 0, last_log_approach = units::nan;
    miss = units::infinity;
    for (int k = 0, since_best = 0; k <= 40; ++k) {
      result = {};
      result = solve(approach, options);
      if (result.contact.force <= 0) {  // too little even for one cell
        approach *= 10;
        continue;
      }
      const double log_force = std::log(result.contact.force / load);
      const double log_approach = std::log(approach);
      ++since_best;
      if (std::abs(log_force) < miss) {
        miss = std::abs(log_force);
        best = approach, best_error = result.contact.force_error;
        since_best = 0;
      }
      // On a grid too coarse for the contact the force jumps, by less than its error, as the grid
      // is fitted anew.
      if (miss <= enough || (since_best >= 8 && miss < best_error)) break;
      // Near the end the two forces differ by the solver's own noise: keep the slope.
      if (std::isgreater(std::abs(log_approach - last_log_approach), 1e-4))
        slope =
            std::clamp((log_force - last_log_force) / (log_approach - last_log_approach), 0.5, 3.0);
      last_log_force = log_force, last_log_approach = log_approach;
      approach *= std::exp(-log_force / slope);
    }
    if (result.contact.approach != best && best > 0) result = {}, result = solve(best, options);
    return result;
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
  double miss = 0;
  const double start = search.refine(coarse, 1e-2, miss).contact.approach;
  if (miss < 1) search.approach = start;
  CgFft result = search.refine(options, tolerance, miss);
  NormalContact& contact = result.contact;
  contact.work = search.work;
  contact.iterations = search.iterations;
  if (miss <= tolerance) return result;
  if (miss < std::min(contact.force_error, 0.5)) {
    if (contact.reason.empty())
      contact.reason = fmt::format(
          "the load is met to {:.1g} of it only, less than the error of the grid", miss);
    return result;
  }
  contact.converged = false;
  contact.reason =
      fmt::format("no approach gives the load; the nearest force was {:.9g} N", contact.force);
  return result;
}

}  // namespace railbook::contact
