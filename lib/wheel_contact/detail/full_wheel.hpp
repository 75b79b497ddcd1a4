// One wheel's patches at a depth: what is given, and the full theory on them.
#pragma once

#include <memory>
#include <vector>

#include <railbook/rolling/material_pair.hpp>
#include <railbook/rolling/unlike_materials.hpp>
#include <railbook/wheel_contact/detail/cells.hpp>
#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::wheel_contact {

// What does not change while the wheel is lowered.
struct Work {
  const PlacedWheel& wheel;
  const ContactSearch& touch;
  const WheelInput& input;
  rolling::MaterialPair material;
};

// The case of a patch's friction at the depth z; fills its creepages and friction.
rolling::RollingCase case_of(const Work& w, PatchResult& p, double z);
// Vertical force on the rail, with what friction bears.
double vertical_force(const std::vector<PatchResult>& all);
void add_warnings(const Work& w, WheelResult& out);

struct Full {
  const Work& w;
  double z0 = 0;  // at which the frames are made and the overlaps hold
  std::vector<PatchResult> all{};
  std::vector<std::unique_ptr<Cells>> cells{};
  double down = 0;                    // below z0
  std::vector<PatchResult> coarse{};  // on half the cells along and across
  std::vector<rolling::RollingSeries> rolled{}, rolled_coarse{};
  double slip_tolerance = 1e-7;
  // The load's change with the depth, over what it were with friction's shares as they are.
  double response = 1;

  // Each says why it failed; nullptr: it did not. From patches near the depth z0, with the errors;
  // on planes and cells anew near the last solution; in another pose near by, on the cells as they
  // are; and with tractions as sharp as an answer's.
  const char* solve();
  const char* solve_again();
  const char* solve_nearby();
  const char* refine();

 private:
  bool press();
  bool balance(double tolerance, double target = 1);
  void lower_frames();
  void mesh(Eigen::Index nx, Eigen::Index ny);
  void describe();
  bool roll(std::vector<PatchResult>& patches, std::vector<rolling::RollingSeries>& series);
  void state_errors();
  void forget_unloaded();
  bool touches_edge() const;
  const char* place_planes();
  const char* fit_grid();
  const char* settle_friction(double tolerance);
};

}  // namespace railbook::wheel_contact
