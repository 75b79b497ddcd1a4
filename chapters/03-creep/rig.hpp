// The sections of the chapter, and what they share: the paper's rig, two wheels pressed together,
// rolling along x, axles along y, and Kalker's curve for it.
#pragma once

#include <railbook/contact/hertz.hpp>
#include <railbook/contact/material.hpp>
#include <railbook/report/chapter.hpp>
#include <railbook/rolling/contact.hpp>
#include <railbook/rolling/force_table.hpp>
#include <railbook/units/constants.hpp>

namespace railbook::creep_chapter {

extern const report::Section rig, replica, appendices, full_theory, experiment, state, area_law;
extern const report::Section cost, extremes;  // study/

inline constexpr double centimetre = 0.01;  // m

// Radii after five hours of running (Appendix B, diameters halved), the ellipse of the text, and
// the largest coefficient of friction of the state that is printed.
inline constexpr double small_radius = 0.201097 / 2;
inline constexpr double big_radius = 0.898957 / 2;
inline constexpr double axis_ratio = 1.568;

// The one reading that is printed, of Appendix B: speeds [rpm], creep by equation (1) and the
// friction.
inline constexpr double small_rpm = 442.6, big_rpm = 99.2;
inline constexpr double printed_creep = 1 - small_radius / big_radius * small_rpm / big_rpm;
inline constexpr double printed_friction = 0.3;

// Not printed: steel as in chapter 01.
inline constexpr contact::Material steel{207e9, 0.3};
inline constexpr double poisson = steel.poisson, shear_modulus = steel.shear_modulus();

// "1000 lb" as the paper turns it into newtons: .45359 kg and 9.81 m/s^2.
inline constexpr double paper_pound_force = 0.45359 * 9.81;
inline constexpr double paper_load = 1000 * paper_pound_force;

// E* of steel on steel [Pa].
inline double modulus() {
  return contact::effective_modulus(steel, steel);
}

// 1/(1/R_S + 1/R_B) in the plane of rolling [m].
inline constexpr double rolling_radius = 1 / (1 / small_radius + 1 / big_radius);

// The profile radius [m] of the small wheel that gives the ellipse its ratio of axes, with the
// major axis along rolling or across. The big wheel is a cylinder.
double profile_radius(bool major_along_rolling);

// Hertz's ellipse [m] at `load` [N] for a profile radius; a is the semi-axis along rolling, b
// across.
contact::HertzContact rig_contact(double load, double profile);

// G a b/N by Hertz's area at `load`: X = this times creep/mu_c.
double hertz_group(double load, bool major_along_rolling = true);

// The ellipse and the load of the rig by the rolling solver, mu = 0.3, without creepage.
rolling::RollingCase rig_case();

// Kalker's curve for the rig's ellipse by the full theory, mu/mu_c over X = G a b xi/(mu_c N) from
// 0 to 2, as a table that is linear between its nodes.
rolling::ForceTable curve_table(int nodes, const rolling::RollingOptions& options,
                                double ratio = axis_ratio);

// From such a table, to about 2e-4; odd in X, and beyond X = 2 the value there.
double master_curve(double x, bool major_along_rolling = true);

// What the errors of Appendix A make of the creep, at their worst and if they are independent; then
// the same if the speeds are counts of teeth in a second and their errors rpm.
struct CreepError {
  double worst = 0, independent = 0;
  double worst_by_teeth = 0, independent_by_teeth = 0;
};
CreepError appendix_a_error();

// Relative standard deviation, in a synthetic test at 1000 lbf, of the area factor that is fitted
// to the points, and of the measured area.
struct ReductionError {
  double fitted = 0, measured = 0;
};
ReductionError reduction_error();

}  // namespace railbook::creep_chapter
