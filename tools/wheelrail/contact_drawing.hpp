// What `wheelrail contact` writes and draws beside its summary.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <railbook/tool/out_folder.hpp>
#include <railbook/wheel_contact/stress.hpp>

namespace railbook::wheelrail_tool {

struct Side {
  std::string name;
  double sign;  // 1 right, -1 left, whose wheel is solved in the mirror
  const wheel_contact::WheelResult& wheel;
  std::vector<wheel_contact::PatchStress> stress;  // of every patch of the full theory
  Side(const char* name, double sign, const wheel_contact::WheelResult& wheel,
       const wheel_contact::WheelInput& input);
};

// One cell a row; in the patch's frame, across > 0 to the right.
std::string cells_csv(const std::array<Side, 2>& sides);

// The cells in the track's axes [m] for ParaView and its like: pressure_MPa, shear_MPa on the rail,
// the number of the patch, and the side, 1 right and -1 left. VTK's XML form for polygons, as
// its file formats are published (docs.vtk.org).
std::string cells_vtp(const std::array<Side, 2>& sides);

// wheelset-contact.png: both sections with their patches, and the pressures from above.
void draw(const wheel_contact::ProfilePair& left, const wheel_contact::ProfilePair& right,
          const wheel_contact::Pose& pose, const std::array<Side, 2>& sides, tool::OutFolder& out);

}  // namespace railbook::wheelrail_tool
