#include <railbook/vehicle/car_families.hpp>

#include <cmath>

#include <railbook/units/input_error.hpp>

namespace railbook::vehicle {

namespace {

std::vector<Eigen::VectorXd> wheelset_rows(const FreightCar& car) {
  std::vector<Eigen::VectorXd> rows;
  for (const Wheelset& w : car.wheels) rows.emplace_back(w.lateral);
  return rows;
}

Dampers dampers_of(const FreightCar& car) {
  return {car.joint[0].damper / 2, car.joint[2].damper / 4, car.joint[3].damper,
          car.joint[5].damper};
}

bool same(const Dampers& a, const Dampers& b) {
  const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-12 * y; };
  return near(a.lateral, b.lateral) && near(a.vertical, b.vertical) && near(a.warp, b.warp) &&
         near(a.centre_plate, b.centre_plate);
}

// The matrices, rows and friction laws of another car; the tables stay.
void put(cycles::Oscillator& o, const FreightCar& car) {
  o.mass = car.mass;
  o.damping = car.suspension_damping;
  o.damping_by_speed = car.creep_damping;
  o.stiffness = car.suspension_stiffness + car.creep_stiffness;
  std::size_t c = 0;
  for (const Wheelset& w : car.wheels) {
    o.channels[c].row = w.lateral;
    o.channels[c++].force << w.g_r, w.g_d, w.g_phi;
  }
  for (const Joint& joint : car.joint)
    if (joint.friction > 0) {
      o.channels[c].row = joint.row;
      o.channels[c].force = -joint.row;
      o.channels[c++].law = cycles::saturation(joint.friction, joint.stick);
    }
}

}  // namespace

cycles::Family by_speed(const FreightCar& car, const wheelset::ConstraintFunctions& table,
                        const std::optional<CreepLimit>& creep) {
  cycles::Family family{car_on_track(car, table, 1),
                        [](cycles::Oscillator& o, double speed) {
                          o.inverse_speed = 1 / units::require_positive("speed", speed, "m/s");
                        },
                        wheelset_rows(car),
                        50,
                        {}};
  if (creep) limit_creep(family.oscillator, car, table, *creep);
  if (!table.symmetric()) family.rest = cycles::rest(family.oscillator);
  return family;
}

cycles::Family by_datum(const FreightCar& car, double CarParameters::*datum,
                        const wheelset::ConstraintFunctions& table, double speed,
                        const std::optional<CreepLimit>& creep) {
  const Dampers dampers = dampers_of(car);
  const bool own = !car.has_friction && !same(dampers, equivalent_dampers(car.data));
  cycles::Family family{
      car_on_track(car, table, speed),
      [=](cycles::Oscillator& o, double value) {
        CarParameters moved = car.data;
        moved.*datum = value;
        const FreightCar other =
            own ? assemble(moved, dampers)
                : assemble(moved, car.has_friction ? Suspension::friction : Suspension::dampers);
        put(o, other);
        if (!creep) return;
        o.couplings.clear();
        limit_creep(o, other, table, *creep);
      },
      wheelset_rows(car),
      std::abs(car.data.*datum),
      {}};
  if (creep) limit_creep(family.oscillator, car, table, *creep);
  if (!table.symmetric()) family.rest = cycles::rest(family.oscillator);
  return family;
}

}  // namespace railbook::vehicle
