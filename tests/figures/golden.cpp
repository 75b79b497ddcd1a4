#include "golden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "scene/image.hpp"

namespace railbook::figures {
namespace {

namespace fs = std::filesystem;

std::set<std::string> names_in(const fs::path& folder, const std::string& chapter,
                               const std::vector<std::string>& excluded) {
  std::set<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool timed = name.ends_with("-time.png");
    const bool listed = std::find(excluded.begin(), excluded.end(),
                                  fmt::format("{}/{}", chapter, name)) != excluded.end();
    const bool hidden = name.starts_with(".");
    if (entry.path().extension() == ".png" && !timed && !listed && !hidden) names.insert(name);
  }
  return names;
}

// Empty when the two are alike; fills in how far they are apart.
std::string fault_of(const fs::path& drawn, const fs::path& golden, std::string& measured) {
  try {
    const scene::Difference d =
        scene::compare(scene::read_png(drawn), scene::read_png(golden), levels);
    measured =
        fmt::format("{:.4f} % of the pixels off, by at most {} levels", 100.0 * d.share, d.largest);
    return d.share <= allowed_share ? ""
                                    : fmt::format("{}; allowed: {:.4f} % by more than {}", measured,
                                                  100.0 * allowed_share, levels);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
}

}  // namespace

std::vector<std::string> read_list(const fs::path& file) {
  std::vector<std::string> names;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    line.resize(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) names.push_back(line);
  }
  return names;
}

Report compare(const fs::path& drawn, const fs::path& golden,
               const std::vector<std::string>& excluded) {
  const std::string chapter = golden.filename().string();
  const std::set<std::string> have = names_in(drawn, chapter, excluded);
  const std::set<std::string> want = names_in(golden, chapter, excluded);
  Report report;
  if (have.empty() && want.empty()) {
    report.faults.push_back(
        fmt::format("no figures in {} nor in {}", drawn.string(), golden.string()));
  }
  for (const std::string& name : want) {
    if (!have.contains(name))
      report.faults.push_back(fmt::format("{}: committed, but not drawn any more", name));
  }
  for (const std::string& name : have) {
    if (!want.contains(name)) {
      report.faults.push_back(
          fmt::format("{}: drawn, but no golden is committed (accept-figures)", name));
      continue;
    }
    std::string measured;
    const std::string fault = fault_of(drawn / name, golden / name, measured);
    if (fault.empty()) {
      report.compared.push_back(fmt::format("{}: {}", name, measured));
    } else {
      report.faults.push_back(fmt::format("{}: {}", name, fault));
    }
  }
  return report;
}

}  // namespace railbook::figures
