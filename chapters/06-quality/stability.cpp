/*** A row *holds* when the number is right to the error shown, *refused* when the program says why it has none, *degraded* when it is usable and marked, and *fails* when it is wrong without a
word. Where a row names the formula as printed or a plain search, that is what the numbers would have been.
*/
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "nonlinear.hpp"
#include "num/fp_trap.hpp"
#include "quality/descriptor_filter.hpp"
#include "quality/spreading.hpp"
#include "units/input_error.hpp"

namespace railbook::quality_chapter {

using namespace railbook;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void judge(report::Item& item, const char* id, const std::string& what, const char* stress,
           const std::string& result, double error, double allowed) {
  item.stability(id, what, stress, result, error, error <= allowed ? "holds" : "fails");
}

template <class Call>
void expect_refusal(report::Item& item, const char* id, const char* what, const char* stress,
                    const Call& call) {
  try {
    call();
    item.stability(id, what, stress, "no refusal", none, "fails");
  } catch (const InputError& error) {
    item.stability(id, what, stress, error.what(), none, "refused");
  }
}

void gain_rows(report::Item& item) {
  for (const double rho : {0.01, 0.001, 1e-6}) {
    const double peak = quality::stroke_peak(rho).gain,
                 direct = quality::stroke_gain({1, rho}, quality::stroke_peak(rho).ratio);
    double searched = 0;
    for (int i = 1; i <= 1000; ++i)
      searched = std::max(searched, quality::stroke_gain({1, rho}, 0.00237 * i));
    judge(
        item, fmt::format("rho-{:g}", rho).c_str(), fmt::format("damping {:g}", rho),
        "peak narrower than any grid",
        fmt::format("T_max = {:.8g}; a search over 1000 frequencies finds {:.3g}", peak, searched),
        std::abs(direct / peak - 1), 1e-9);
  }
  for (const double rho : {0.5, 0.7, 0.7071}) {
    const auto peak = quality::stroke_peak(rho);
    const double other = 1 / std::sqrt((1 - std::sqrt(2.0) * rho) * (1 + std::sqrt(2.0) * rho));
    judge(item, fmt::format("rho-{:g}", rho).c_str(), fmt::format("damping {:g}", rho),
          "the peak leaves for infinity: λ_p ill-conditioned",
          fmt::format("T_max − 1 = {:.3g} at η = {:.5g}", peak.gain - 1, peak.ratio),
          std::abs(peak.ratio / other - 1), 1e-9);
  }
  const double over = quality::stroke_gain({1, 3}, 1e3);
  judge(item, "rho-3", "damping 3", "no peak at all",
        fmt::format("T(1000) = {:.8f}, from below 1", over),
        std::abs(over * std::sqrt(std::pow(1 - 1e-6, 2) + 36e-6) - 1), 1e-12);
  std::string naive;
  {
    const num::FpTrapsOff off;  // infinity over infinity, on purpose
    volatile double eta = 1e80;
    const double e4 = eta * eta * eta * eta;
    const double square = e4 / (e4 + 2 * (2 * 0.04 - 1) * eta * eta + 1);
    naive = square == square ? fmt::format("{}", std::sqrt(square)) : "no number";
  }
  judge(item, "eta-1e80", "η = 10⁸⁰", "η⁴ overflows",
        fmt::format("T = {:.15g}; (4) as printed gives {}", quality::stroke_gain({1, 0.2}, 1e80),
                    naive),
        std::abs(quality::stroke_gain({1, 0.2}, 1e80) - 1), 1e-15);
  const double standing = quality::allowed_amplitude(severity(inch_limit, 0, 0.1));
  judge(item, "standing", "speed 0", "0/0 in A = x₀/T",
        fmt::format("allowed amplitude {}", standing), std::isinf(standing) ? 0 : 1, 1e-15);
  expect_refusal(item, "undamped", "damping 0", "unbounded peak", [] {
    static_cast<void>(quality::stroke_gain({1, 0}, 1));
  });
}

void force_rows(report::Item& item) {
  const quality::Car light = quality::make_car(0, 7000, {2, 0.5}),
                     almost = quality::make_car(1e-9, 7000, {2, 0.5});
  const double a = std::abs(quality::force_gain(light, 5)),
               b = std::abs(quality::force_gain(almost, 5));
  judge(item, "no-wheel", "wheel without mass", "(6) as printed is 0·∞",
        fmt::format("|G/Z| = {:.8g} N/m at 5 Hz", a), std::abs(a / b - 1), 1e-10);
  const quality::ForceLimit weak{quality::make_car(800, 7000, {2, 0.05}), wheel_force_limit};
  double worst = 0, searched = 0;
  for (int i = 1; i <= 20000; ++i)
    searched = std::max(searched, severity_at(weak, track_speed * i / 20000, 0.1));
  worst = severity(weak, track_speed, 0.1);
  judge(item, "weak", "car A with damping 0.05, 10 m", "curves cross, the envelope has a peak",
        fmt::format("allowed {:.4g} cm; at full speed alone {:.4g} cm", 1 / worst / cm,
                    1 / severity_at(weak, track_speed, 0.1) / cm),
        std::abs(searched / worst - 1), 1e-5);
  expect_refusal(item, "loaded", "loaded 100-ton car", "static load above the limit",
                 [&] { static_cast<void>(force_margin(car(item, "C"))); });
}

void stop_rows(report::Item& item) {
  const quality::Track track{{{peak_amplitude(), peak_frequency(), 0}}, 0};
  for (const double kappa : {1e4, 1e6, 1e8}) {
    const auto r = quality::run(stopped(kappa), track, {}, 60, {.watch_from = 40, .audit = true});
    judge(item, fmt::format("kappa-{:.0e}", kappa).c_str(), fmt::format("κ = {:.0e}", kappa),
          "impact limit; an integrator's step falls with κ^−½",
          fmt::format("stroke {:.5f} cm, {} switches in {} pieces", r.largest / cm,
                      r.switches.size(), r.pieces),
          r.energy.defect(), 1e-9);
  }
  const quality::Track ramp{track.waves, 60};
  for (const double miss : {-1e-12, 0.0, 1e-12}) {
    const quality::StoppedBody grazing{roll, inch_limit.stroke * (1 + miss), 100};
    const auto r = quality::run(grazing, ramp, quality::at_rest(ramp), 180, {.watch_from = 120});
    judge(item, fmt::format("graze{:+.0e}", miss).c_str(),
          fmt::format("gap = settled stroke × (1 {:+.0e}), κ = 100, ramp", miss),
          "grazing: switch and turning point fall together",
          fmt::format("stroke {:.10f} cm, {} switches{}", r.largest / cm, r.switches.size(),
                      r.complete ? "" : ", incomplete"),
          r.complete ? std::abs(r.largest / inch_limit.stroke - 1) : 1, 1e-10);
  }
  const quality::StoppedBody touching{roll, inch_limit.stroke, 100};
  const auto hit = quality::run(touching, track, {}, 180, {.watch_from = 120, .audit = true});
  judge(item, "graze-sudden", "gap = settled stroke, κ = 100, sudden start",
        "the overshoot hits the stop",
        fmt::format("a second steady motion: stroke {:.5f} cm, {} switches", hit.largest / cm,
                    hit.switches.size()),
        hit.energy.defect(), 1e-9);
  const quality::StoppedBody heavy{{0.5, 20}, inch_limit.stroke / 2, 10};
  const quality::Track slow{{{0.3, 0.2, 0}}, 0};
  const auto r = quality::run(heavy, slow, {}, 400, {.watch_from = 300, .audit = true});
  judge(item, "heavy", "damping 20 of critical", "exp and cosh of hundreds",
        fmt::format("stroke {:.5f} cm, {} switches", r.largest / cm, r.switches.size()),
        r.energy.defect(), 1e-9);
  expect_refusal(item, "forever", "a run of 30 years", "more pieces than memory or patience",
                 [&] { static_cast<void>(quality::run(stopped(10), track, {}, 1e9)); });
}

void filter_rows(report::Item& item) {
  const quality::Envelope envelope{{level_limit(), {}, track_speed}};
  const auto taps = quality::design_filter(envelope, {.spacing = 0.2});
  std::vector<double> z(30000);
  const auto largest = [&](const quality::FilterTaps& t) {
    double worst = 0;
    for (const double p : quality::filter(t, z)) worst = std::max(worst, std::abs(p));
    return worst;
  };
  std::fill(z.begin(), z.end(), 1000.0);
  judge(item, "offset", "track 1000 m above datum", "62 500 times the limit",
        fmt::format("descriptor {:.1e}", largest(taps)), largest(taps), 1e-6);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = 0.02 * 0.2 * static_cast<double>(i);
  judge(item, "grade", "a grade of 2 %, 6 km", "120 m of height",
        fmt::format("descriptor {:.1e}", largest(taps)), largest(taps), 1e-6);
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] = 5 * std::sin(2 * units::pi * 0.2 * static_cast<double>(i) / 2000);
  const double wanted = 5 * envelope(1.0 / 2000);
  double middle = 0;
  const auto p = quality::filter(taps, z);
  for (std::size_t i = 10000; i < 20000; ++i) middle = std::max(middle, std::abs(p[i]));
  item.stability("hill", "waves of 2 km and 5 m", "longer than the filter's reach",
                 fmt::format("descriptor {:.4f}, exact {:.4f}", middle, wanted),
                 std::abs(middle / wanted - 1),
                 std::abs(middle / wanted - 1) < 0.01 ? "holds" : "degraded");
  z.assign(300, 0.0);
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] = flat_level * std::sin(2 * units::pi * static_cast<double>(i) / 150);
  item.stability("short", "a record of 60 m, two waves of 30 m on the envelope",
                 "ends are continued, not known",
                 fmt::format("descriptor {:.3f}; the tool marks all of it", largest(taps)),
                 std::abs(largest(taps) - 1), "degraded");
  expect_refusal(item, "nyquist", "shortest wave 0.3 m at 0.2-m samples", "below two samples", [&] {
    static_cast<void>(quality::design_filter(envelope, {.spacing = 0.2, .shortest = 0.3}));
  });
}

void spreading_rows(report::Item& item) {
  quality::Profile spike{-1, 2.0 / 400, std::vector<double>(401, 0.0)};
  spike.height[200] = 1 / spike.width;  // area 1 in one cell
  const auto s = spread({}, spike, 1e-9, 1, 200);
  const double height = s.profile.height[200];
  judge(item, "spike", "blob from a single cell", "h³ from 8·10⁶ to 0.5",
        fmt::format("top at t = 1: {:.5f}, exact {:.5f}; area {:.15g}", height,
                    quality::blob_height(0, 1), area(s.profile)),
        s.converged ? std::abs(height / quality::blob_height(0, 1) - 1) : 1, 0.01);
  const auto one = spread({}, spike, 1e-9, 1, 1);
  item.stability("one-step", "the same in one step", "step 10⁹ times the initial time",
                 one.converged ? fmt::format("top {:.3f}", one.profile.height[200])
                               : "not converged: heights below zero",
                 none, one.converged ? "fails" : "refused");
}

void table_stability(report::Item& item) {
  gain_rows(item);
  force_rows(item);
  stop_rows(item);
  filter_rows(item);
  spreading_rows(item);
  item.reconstructed("not in the paper");
}

}  // namespace

void add_stability(report::Chapter& chapter) {
  chapter.table("stability", "Stiff, extreme and impossible cases", table_stability);
}

}  // namespace railbook::quality_chapter
