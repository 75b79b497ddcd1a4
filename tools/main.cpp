// The command `railbook`: the suite's solvers on data of your own.
#include <fftw3.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>

#include <Eigen/Core>

#include <railbook/plot/plot.hpp>
#include <railbook/tool/program.hpp>

#include "tools.hpp"

using namespace railbook;

std::filesystem::path tools::scripts(std::string_view tool) {
  return plot::shared("tools") / tool;
}

namespace {

constexpr const char* help = R"help(From a recorder's file to a table of its sections and a picture:

  railbook quality index track.csv --speed 100km/h --column profile --out mine
  railbook psd classify track.csv --column profile --out mine

track.csv is a table with a line of headers, a column of positions and columns of heights, as distance_m,profile_mm or
"Distance [km]";"Profile (mm)". Quantities carry their unit: 0.5in, 60mph, 80kN. `railbook SUBJECT TOOL --help` lists a
tool's options, columns and an example. Examples are in ../share/railbook/examples beside the command's folder.
Exit status: 0 good, 1 a check failed or a method found no answer, 2 bad input or usage, 3 the outside failed (a full
disk, gnuplot).)help";

}  // namespace

int main(int argc, char** argv) {
  const tool::Program program{
      .name = "railbook",
      .about = "wheel, rail and track: solvers for data of your own",
      .version = RAILBOOK_VERSION,
      .libraries = {{"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                          EIGEN_MINOR_VERSION)},
                    {"GSL", gsl_version},
                    {"FFTW", fftw_version}},
      .help = help};
  return tool::run(
      argc, argv, program,
      {
          {"contact", "normal contact of bodies of your own", {contact_tool::solve_tool()}},
          {"hunting",
           "wheel and rail profiles, critical speeds, limit cycles",
           {hunting_tool::cycle_tool(), hunting_tool::geometry_tool(), hunting_tool::speed_tool()}},
          {"creep",
           "creep forces of rolling contact",
           {creep_tool::curve_tool(), creep_tool::history_tool(), creep_tool::table_tool()}},
          {"filters",
           "a track-geometry car: its record, and the geometry in it",
           {filters_tool::integrate_tool(), filters_tool::process_tool(),
            filters_tool::simulate_tool()}},
          {"psd",
           "track roughness by power spectral density",
           {psd_tool::classify_tool(), psd_tool::roughness_tool(), psd_tool::synthesize_tool()}},
          {"quality",
           "track as a vehicle feels it",
           {quality_tool::compare_tool(), quality_tool::index_tool(), quality_tool::limit_tool(),
            quality_tool::measures_tool()}},
          {"track",
           "stiffness of track, and the force over a joint",
           {track_tool::joint_tool(), track_tool::stiffness_tool()}},
          {"wheelrail",
           "wheel on rail: from profiles to patches and creep forces",
           {wheelrail_tool::contact_tool(), wheelrail_tool::table_tool(),
            wheelrail_tool::measure_tool()}},
          {"verify",
           "compare this installation with reference numbers",
           {verify_tool::verify_tool()}},
      });
}
