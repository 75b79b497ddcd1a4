#include <railbook/vehicle/freight_car.hpp>

#include <railbook/num/dense_lu.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::vehicle {

namespace {

Vector9 unit(int coordinate) {
  return Vector9::Unit(coordinate);
}

// +1 for the front truck and leading wheelsets, -1 for the rear truck and trailing wheelsets.
double sign(int i) {
  return i == 0 ? 1.0 : -1.0;
}
Vector9 truck_lateral(int truck) {
  return unit(X_TF + truck);
}
Vector9 truck_yaw(int truck) {
  return unit(TH_TF + truck);
}
Vector9 warp(int truck) {
  return unit(TH_WF + truck);
}
Vector9 axle_yaw(int truck) {
  return truck_yaw(truck) + warp(truck);
}
// The bolster goes with the body, at the depth h_2 below its centre of gravity.
Vector9 bolster_lateral(const CarParameters& p, int truck) {
  return unit(X_C) + sign(truck) * p.half_truck_distance * unit(TH_C) +
         p.bolster_depth * unit(PHI_C);
}

Matrix9 mass_matrix(const CarParameters& p) {
  Matrix9 m = Matrix9::Zero();
  const auto body = [&](double inertia, const Vector9& motion) {
    m += inertia * motion * motion.transpose();
  };
  for (int i = 0; i < wheelsets; ++i) {
    body(p.wheelset_mass, wheelset_lateral(p, i));
    body(p.wheelset_yaw_inertia, wheelset_yaw(i));
  }
  for (int truck = 0; truck < 2; ++truck) {
    body(2 * p.sideframe_mass, truck_lateral(truck));
    body(2 * p.sideframe_mass, p.half_sideframe_spacing * axle_yaw(truck));
    body(2 * p.sideframe_yaw_inertia, truck_yaw(truck));
    body(p.bolster_mass, bolster_lateral(p, truck));
    body(p.bolster_yaw_inertia, axle_yaw(truck));
    body(p.bolster_roll_inertia, unit(PHI_C));
  }
  body(p.body_mass, unit(X_C));
  body(p.body_yaw_inertia, unit(TH_C));
  body(p.body_roll_inertia, unit(PHI_C));
  return m;
}

void add_creep(const CarParameters& p, FreightCar& car) {
  car.creep_stiffness.setZero();
  car.creep_damping.setZero();
  const double a2f33 = p.half_gauge * p.half_gauge * p.f33;
  const double load = axle_load(p);
  for (int i = 0; i < wheelsets; ++i) {
    const Vector9 b = wheelset_lateral(p, i), t = wheelset_yaw(i);
    car.creep_stiffness += 2 * (p.f12 * t - p.f11 * b) * t.transpose();
    car.creep_damping +=
        2 * (p.f11 * b * b.transpose() + p.f12 * (b * t.transpose() - t * b.transpose()) +
             (a2f33 + p.f22) * t * t.transpose());
    car.wheels[static_cast<std::size_t>(i)] = {
        .lateral = b,
        .yaw = t,
        .g_r = -2 * a2f33 / p.wheel_radius * t,
        .g_d = (2 * p.f12 / p.wheel_radius - load) * b + 2 * p.f22 / p.wheel_radius * t,
        .g_phi = -load * b};
  }
}

// Springs, dampers and frictions of the seven joints; those of one kind that move alike are lumped.
std::array<Joint, joints> joint_list(const CarParameters& p, const Dampers& c) {
  const auto lateral = [&](const char* name, int truck) {
    return Joint{name,
                 truck_lateral(truck) - bolster_lateral(p, truck),
                 2 * p.lateral_stiffness,
                 2 * c.lateral,
                 2 * p.lateral_friction,
                 p.stick_speed};
  };
  const auto warping = [&](const char* name, int truck) {
    return Joint{name, warp(truck), p.warp_stiffness, c.warp, p.warp_friction, p.stick_rate};
  };
  const auto plate = [&](const char* name, int truck) {
    return Joint{name,           axle_yaw(truck) - unit(TH_C), 0.0,
                 c.centre_plate, p.centre_plate_friction,      p.stick_rate};
  };
  return {lateral("front lateral", 0),
          lateral("rear lateral", 1),
          Joint{"vertical", p.half_sideframe_spacing * unit(PHI_C), 4 * p.vertical_stiffness,
                4 * c.vertical, 4 * p.vertical_friction, p.stick_speed},
          warping("front warp", 0),
          warping("rear warp", 1),
          plate("front centre plate", 0),
          plate("rear centre plate", 1)};
}

FreightCar build(const CarParameters& data, const Dampers& dampers, bool friction) {
  require_valid(data);
  FreightCar car;
  car.data = data;
  car.has_friction = friction;
  car.mass = mass_matrix(data);
  add_creep(data, car);
  car.joint = joint_list(data, dampers);
  car.suspension_stiffness.setZero();
  car.suspension_damping.setZero();
  for (auto& joint : car.joint) {
    (friction ? joint.damper : joint.friction) = 0;
    const Matrix9 square = joint.row * joint.row.transpose();
    car.suspension_stiffness += joint.spring * square;
    car.suspension_damping += joint.damper * square;
  }
  return car;
}

}  // namespace

Vector9 wheelset_lateral(const CarParameters& data, int i) {
  return truck_lateral(i / 2) + sign(i % 2) * data.half_wheelbase * truck_yaw(i / 2);
}

Vector9 wheelset_yaw(int i) {
  return axle_yaw(i / 2);
}

FreightCar assemble(const CarParameters& data, Suspension suspension) {
  require_valid(data);
  return build(data, equivalent_dampers(data), suspension == Suspension::friction);
}

FreightCar assemble(const CarParameters& data, const Dampers& dampers) {
  units::require_non_negative("lateral damper", dampers.lateral, "N s/m");
  units::require_non_negative("vertical damper", dampers.vertical, "N s/m");
  units::require_non_negative("warp damper", dampers.warp, "N m s/rad");
  units::require_non_negative("centre-plate damper", dampers.centre_plate, "N m s/rad");
  return build(data, dampers, false);
}

CarAtSpeed at_speed(const FreightCar& car, double speed) {
  units::require_positive("speed", speed, "m/s");
  num::DenseLu mass;
  mass.factor(car.mass);
  CarAtSpeed result;
  result.speed = speed;
  result.half_gauge = car.data.half_gauge;
  result.has_friction = car.has_friction;
  result.damping = mass.solve(car.suspension_damping + car.creep_damping / speed);
  result.stiffness = mass.solve(car.suspension_stiffness + car.creep_stiffness);
  for (std::size_t i = 0; i < wheelsets; ++i) {
    result.lateral[i] = car.wheels[i].lateral;
    result.g_r[i] = mass.solve(car.wheels[i].g_r);
    result.g_d[i] = mass.solve(car.wheels[i].g_d);
    result.g_phi[i] = mass.solve(car.wheels[i].g_phi);
  }
  for (std::size_t j = 0; j < joints; ++j) {
    result.joint_row[j] = car.joint[j].row;
    result.joint_force[j] = mass.solve(car.joint[j].row);
    result.friction[j] = car.joint[j].friction;
    result.stick[j] = car.joint[j].stick;
  }
  return result;
}

}  // namespace railbook::vehicle
