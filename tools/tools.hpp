// The tools of the command `railbook`: each is a file of its own, tools/NAME/VERB.cpp.
#pragma once

#include <filesystem>
#include <string_view>

#include <railbook/tool/options.hpp>

namespace railbook::tools {

// The folder of a tool's gnuplot scripts: scripts("contact") / "solve.gp".
std::filesystem::path scripts(std::string_view tool);

}  // namespace railbook::tools

namespace railbook {
namespace contact_tool {
tool::Tool solve_tool();
}
namespace hunting_tool {
tool::Tool cycle_tool();
tool::Tool geometry_tool();
tool::Tool speed_tool();
}  // namespace hunting_tool
namespace creep_tool {
tool::Tool curve_tool();
tool::Tool history_tool();
tool::Tool table_tool();
}  // namespace creep_tool
namespace filters_tool {
tool::Tool integrate_tool();
tool::Tool process_tool();
tool::Tool simulate_tool();
}  // namespace filters_tool
namespace psd_tool {
tool::Tool classify_tool();
tool::Tool roughness_tool();
tool::Tool synthesize_tool();
}  // namespace psd_tool
namespace quality_tool {
tool::Tool index_tool();
tool::Tool limit_tool();
tool::Tool compare_tool();
tool::Tool measures_tool();
}  // namespace quality_tool
namespace wheelrail_tool {
tool::Tool contact_tool();
tool::Tool measure_tool();
tool::Tool table_tool();
}  // namespace wheelrail_tool
namespace track_tool {
tool::Tool joint_tool();
tool::Tool stiffness_tool();
}  // namespace track_tool
namespace verify_tool {
tool::Tool verify_tool();
}  // namespace verify_tool
}  // namespace railbook
