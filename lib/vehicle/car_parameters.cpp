#include <railbook/vehicle/car_parameters.hpp>

#include <array>

#include <railbook/units/input_error.hpp>

namespace railbook::vehicle {

namespace {

using units::foot, units::lbf, units::slug;
using P = CarParameters;

constexpr units::Dimension inertia = units::mass * units::area;
constexpr units::Dimension stiffness_of_angle = units::moment / units::angle;
constexpr units::Dimension rate = units::angle / units::time;
constexpr Origin printed = Origin::printed, restored = Origin::restored,
                 reconstructed = Origin::reconstructed;
constexpr double slug_ft2 = slug * foot * foot;

constexpr std::array data{
    CarDatum{"body-mass", "m_C", "car body", &P::body_mass, units::mass, "slug", slug, true,
             restored, "our text shows \"noi.\""},
    CarDatum{"bolster-mass", "m_B", "bolster", &P::bolster_mass, units::mass, "slug", slug, false,
             printed, ""},
    CarDatum{"sideframe-mass", "m_F", "side frame", &P::sideframe_mass, units::mass, "slug", slug,
             false, printed, ""},
    CarDatum{"wheelset-mass", "m_w", "wheelset", &P::wheelset_mass, units::mass, "slug", slug, true,
             printed, ""},
    CarDatum{"body-yaw-inertia", "I_{Cy}", "car body, yaw", &P::body_yaw_inertia, inertia,
             "slug ft²", slug_ft2, true, printed, ""},
    CarDatum{"body-roll-inertia", "I_{Cz}", "car body, roll", &P::body_roll_inertia, inertia,
             "slug ft²", slug_ft2, true, printed, ""},
    CarDatum{"bolster-yaw-inertia", "I_{By}", "bolster, yaw", &P::bolster_yaw_inertia, inertia,
             "slug ft²", slug_ft2, false, printed, ""},
    CarDatum{"bolster-roll-inertia", "I_{Bz}", "bolster, roll", &P::bolster_roll_inertia, inertia,
             "slug ft²", slug_ft2, false, printed, ""},
    CarDatum{"sideframe-yaw-inertia", "I_{Fy}", "side frame, yaw", &P::sideframe_yaw_inertia,
             inertia, "slug ft²", slug_ft2, true, printed, ""},
    CarDatum{"wheelset-yaw-inertia", "I_{wy}", "wheelset, yaw", &P::wheelset_yaw_inertia, inertia,
             "slug ft²", slug_ft2, true, printed, ""},
    CarDatum{"lateral-stiffness", "K_x", "lateral, a side frame", &P::lateral_stiffness,
             units::stiffness, "lb/ft", lbf / foot, false, printed, ""},
    CarDatum{"vertical-stiffness", "K_y", "vertical, a side frame", &P::vertical_stiffness,
             units::stiffness, "lb/ft", lbf / foot, false, printed, ""},
    CarDatum{"warp-stiffness", "K_{\\theta W}", "warp, a truck", &P::warp_stiffness,
             stiffness_of_angle, "ft lb/rad", foot* lbf, false, restored,
             "the exponent is illegible; only 6 gives 145 ft/s and 12 rad/s together"},
    CarDatum{"lateral-friction", "F_{0x}", "lateral friction, a side frame", &P::lateral_friction,
             units::force, "lb", lbf, false, printed, ""},
    CarDatum{"vertical-friction", "F_{0y}", "vertical friction, a side frame",
             &P::vertical_friction, units::force, "lb", lbf, false, printed, ""},
    CarDatum{"warp-friction", "T_{0W}", "warp friction, a truck", &P::warp_friction, units::moment,
             "ft lb", foot* lbf, false, printed, ""},
    CarDatum{"centre-plate-friction", "T_{0\\theta}", "centre-plate friction, a truck",
             &P::centre_plate_friction, units::moment, "ft lb", foot* lbf, false, printed, ""},
    CarDatum{"stick-speed", "\\varepsilon_x", "regularization of lateral and vertical friction",
             &P::stick_speed, units::speed, "ft/s", foot, true, reconstructed,
             "ours; the paper's friction is a sign function"},
    CarDatum{"stick-rate", "\\varepsilon_\\theta", "regularization of warp and centre plate",
             &P::stick_rate, rate, "rad/s", 1.0, true, reconstructed,
             "ours; the paper's friction is a sign function"},
    CarDatum{"damper-frequency", "\\omega_c", "frequency of the equivalent dampers",
             &P::damper_frequency, rate, "rad/s", 1.0, true, reconstructed,
             "constant in the paper, value not given"},
    CarDatum{"damper-travel", "A_c", "travel of the equivalent dampers", &P::damper_travel,
             units::length, "in", units::inch, true, reconstructed,
             "constant in the paper, value not given"},
    CarDatum{"damper-angle", "\\theta_c", "angle of the equivalent dampers", &P::damper_angle,
             units::angle, "rad", 1.0, true, reconstructed,
             "constant in the paper, value not given"},
    CarDatum{"f11", "f_{11}", "lateral creep, a wheel", &P::f11, units::force, "lb", lbf, true,
             restored, "the exponent is illegible; Kalker's theory asks for 6"},
    CarDatum{"f12", "f_{12}", "lateral/spin creep, a wheel", &P::f12, units::moment, "ft lb",
             foot* lbf, false, printed, ""},
    CarDatum{"f22", "f_{22}", "spin creep, a wheel", &P::f22, units::force* units::area, "ft² lb",
             foot* foot* lbf, false, restored,
             "our text has 2.1; the printed f11 and f12 ask for 42.3 by Kalker's theory"},
    CarDatum{"f33", "f_{33}", "longitudinal creep, a wheel", &P::f33, units::force, "lb", lbf, true,
             restored, "the exponent is illegible; Kalker's theory asks for 6"},
    CarDatum{"half-gauge", "a", "half distance of the contact points", &P::half_gauge,
             units::length, "ft", foot, true, printed,
             "called half the gauge; it is the half distance of the rail heads"},
    CarDatum{"half-sideframe-spacing", "d", "half distance of the side frames",
             &P::half_sideframe_spacing, units::length, "ft", foot, true, printed, ""},
    CarDatum{"wheel-radius", "r_0", "wheel radius", &P::wheel_radius, units::length, "ft", foot,
             true, printed, ""},
    CarDatum{"half-wheelbase", "L_T", "half wheelbase of a truck", &P::half_wheelbase,
             units::length, "ft", foot, true, printed, ""},
    CarDatum{"half-truck-distance", "L_C", "half distance of the trucks", &P::half_truck_distance,
             units::length, "ft", foot, true, printed, ""},
    CarDatum{"bolster-depth", "h_2", "bolster below the body's centre of gravity",
             &P::bolster_depth, units::length, "ft", foot, false, printed, ""},
};

double mean_over_cycle(double level, double frequency, double amplitude) {
  return 4 * level / (units::pi * frequency * amplitude);
}

}  // namespace

std::span<const CarDatum> car_data() {
  return data;
}

void require_valid(const CarParameters& car) {
  for (const auto& datum : data) {
    const double value = car.*datum.member;
    const std::string unit = units::si_name(datum.dimension);
    if (datum.positive)
      units::require_positive(datum.key, value, unit);
    else
      units::require_non_negative(datum.key, value, unit);
  }
}

Dampers equivalent_dampers(const CarParameters& car) {
  const auto at = [&](double level, double amplitude) {
    return mean_over_cycle(level, car.damper_frequency, amplitude);
  };
  return {.lateral = at(car.lateral_friction, car.damper_travel),
          .vertical = at(car.vertical_friction, car.damper_travel),
          .warp = at(car.warp_friction, car.damper_angle),
          .centre_plate = at(car.centre_plate_friction, car.damper_angle)};
}

double axle_load(const CarParameters& car) {
  const double mass =
      car.body_mass + 2 * car.bolster_mass + 4 * car.sideframe_mass + 4 * car.wheelset_mass;
  return units::standard_gravity * mass / 4;
}

}  // namespace railbook::vehicle
