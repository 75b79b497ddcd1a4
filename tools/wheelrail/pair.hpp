// Wheel, rail, materials and friction as options of a tool.
#pragma once

#include <string>
#include <vector>

#include <railbook/tool/options.hpp>
#include <railbook/tool/summary.hpp>
#include <railbook/wheel_contact/wheel.hpp>

#include "pair_options.hpp"

namespace railbook::wheelrail_tool {

struct PairOptions : tools::PairOptions {
  std::string head = "60E1";
  double speed = 0;
  std::string method = "full";
  long cells = 40;
  wheel_contact::WheelInput wheel_input;
};

void add_pair_options(tool::OptionParser& parser, PairOptions& options, bool several = false);
// Both sides as right ones: the left one in the mirror.
struct ReadPair {
  wheel_contact::ProfilePair left, right;
  std::vector<profiles::ProfileFit> fits;  // of the profiles that came from files
  double radius() const { return 0.5 * (left.radius + right.radius); }
};
// Throws InputError naming a file and what is wrong with it, and when the wheelset does not fit
// between the rails.
ReadPair read_pair(const PairOptions& options);
// The same with each profile from a file met twice as closely: how much an answer depends on the
// smoothing.
ReadPair half_as_smooth(const PairOptions& options);
// Whether a patch of a wheel, shifted outwards, lies on a suspected place of the wheel's profile or
// next to it. (A rail's place in the track is not known in its file's coordinates.)
bool stands_on(const PairOptions& options, tools::Side side,
               const wheel_contact::WheelResult& wheel, double shift,
               const profiles::ProfileFit& fit, const profiles::PointsWarning& warning);
// With the scatter, the smoothing and the distance of the points of profiles from files.
void describe_pair(tool::Summary& answer, const PairOptions& options,
                   const std::vector<profiles::ProfileFit>& fits);
wheel_contact::WheelInput wheel_input(const PairOptions& options);
wheel_contact::Method method_of(const std::string& name);

}  // namespace railbook::wheelrail_tool
