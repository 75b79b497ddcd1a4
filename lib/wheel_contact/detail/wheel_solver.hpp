// One wheel solved again and again, in poses close to one another.
#pragma once

#include <memory>

#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::wheel_contact {

class WheelSolver {
 public:
  WheelSolver(const ProfilePair& pair, const WheelInput& input);
  ~WheelSolver();

  // As solve_wheel, but for a load that it refuses; by the full theory the tractions start from
  // those of the last solution. A step on the way to another pose finds the tractions to 1e-5 of
  // the slip, where an answer has 1e-7.
  enum class Purpose { answer, step };
  WheelResult solve(const Pose& pose, double angular_velocity, Purpose purpose);
  // By strips whose load does not jump, see semi_hertzian().
  void use_continuous_strips();
  // By the full theory from the last solution as a start: the depth, the forces and the moment,
  // without errors and warnings. Again: on planes and cells made anew. Nearby: on those that there
  // are; not converged where the contact has come to the edge of the cells.
  WheelResult solve_again(const Pose& pose, double angular_velocity);
  WheelResult solve_nearby(const Pose& pose, double angular_velocity);
  // The last solution to the accuracy of an answer, with errors and warnings.
  WheelResult refine();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// Throws InputError when a wheel did not converge because no contact without friction bears so
// much.
void require_bearable(const WheelInput& input, const WheelResult& wheel);

}  // namespace railbook::wheel_contact
