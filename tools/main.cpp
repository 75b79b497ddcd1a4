// The command `railbook`: the suite's solvers on data of your own.
#include "plot/plot.hpp"
#include "tool/program.hpp"
#include "tools.hpp"

using namespace railbook;

std::filesystem::path tools::scripts(std::string_view tool) {
  return plot::shared("tools") / tool;
}

int main(int argc, char** argv) {
  return tool::run(
      argc, argv, "railbook", "wheel, rail and track: solvers for data of your own",
      {
          {"contact", "normal contact of bodies of your own", {contact_tool::solve_tool()}},
          {"hunting",
           "wheel and rail profiles, critical speeds, limit cycles",
           {hunting_tool::cycle_tool(), hunting_tool::geometry_tool(), hunting_tool::speed_tool()}},
          {"creep",
           "creep forces of rolling contact",
           {creep_tool::curve_tool(), creep_tool::table_tool()}},
          {"filters",
           "a track-geometry car: its record, and the geometry in it",
           {filters_tool::process_tool(), filters_tool::simulate_tool()}},
          {"psd",
           "track roughness by power spectral density",
           {psd_tool::classify_tool(), psd_tool::synthesize_tool()}},
          {"quality",
           "track as a vehicle feels it",
           {quality_tool::index_tool(), quality_tool::limit_tool()}},
          {"track",
           "stiffness of track, and the force over a joint",
           {track_tool::joint_tool(), track_tool::stiffness_tool()}},
      });
}
