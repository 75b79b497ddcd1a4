#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include <railbook/files/out_file.hpp>
#include <railbook/scene/image.hpp>

#include "golden.hpp"

namespace railbook::figures {
namespace {

namespace fs = std::filesystem;

bool one_colour(const scene::Image& image) {
  for (std::size_t i = 3; i < image.rgb.size(); ++i)
    if (image.rgb[i] != image.rgb[i - 3]) return false;
  return true;
}

// Empty when the two are alike; fills in how far they are apart.
std::string picture_fault(const fs::path& drawn, const fs::path& golden, bool pixels,
                          std::string& measured) {
  const scene::Image have = scene::read_png(drawn);
  const scene::Image want = scene::read_png(golden);
  if (pixels) {
    const scene::Difference d = scene::compare(have, want, levels);
    measured =
        fmt::format("{:.4f} % of the pixels off, by at most {} levels", 100.0 * d.share, d.largest);
    return d.share <= allowed_share ? ""
                                    : fmt::format("{}; allowed: {:.4f} % by more than {}", measured,
                                                  100.0 * allowed_share, levels);
  }
  measured = "drawn, and of the golden's size";
  if (have.size != want.size)
    return fmt::format("{} by {} pixels, the golden has {} by {}", have.size.width,
                       have.size.height, want.size.width, want.size.height);
  return one_colour(have) ? "the picture is empty" : "";
}

// Compares one file of the run with the golden of its name, and adds what it finds.
template <class Fault>
void compare_file(const fs::path& drawn, const fs::path& golden, Report& report, Fault&& fault) {
  const std::string name = drawn.filename().string();
  std::string measured = "data agree";
  std::string wrong;
  try {
    wrong = fs::exists(golden) ? fault(drawn, golden, measured)
                               : "drawn, but no golden is committed (accept-figures)";
  } catch (const std::exception& error) {
    wrong = error.what();
  }
  (wrong.empty() ? report.compared : report.faults)
      .push_back(fmt::format("{}: {}", name, wrong.empty() ? measured : wrong));
}

// Whether a figure has a golden at all; one drawn from data that no two runs share has none.
bool has_golden(const Drawn& drawn, const Figure& figure) {
  for (const std::string& csv : figure.csv)
    if (!is_compared(drawn.data / csv)) return false;
  return true;
}

bool is_fixed(const Drawn& drawn, const Figure& figure) {
  return std::all_of(figure.csv.begin(), figure.csv.end(),
                     [&](const std::string& csv) { return fixes_the_picture(drawn.data / csv); });
}

// What the golden folder should hold besides its README.md.
std::set<std::string> golden_names(const Drawn& drawn) {
  std::set<std::string> names;
  for (const Figure& figure : drawn.figures) {
    if (!has_golden(drawn, figure)) continue;
    names.insert(figure.png);
    names.insert(figure.csv.begin(), figure.csv.end());
  }
  return names;
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != "README.md" && !name.starts_with('.')) names.push_back(name);
  }
  return names;
}

std::string gallery_page(const Drawn& drawn) {
  std::string page = fmt::format(
      "# [{0}](../../chapters/{0}): {1}\n\nWhat the program drew, and from which data, when these "
      "were last accepted with "
      "`make accept-figures`.\n",
      drawn.chapter, drawn.title);
  for (const Figure& figure : drawn.figures) {
    if (!has_golden(drawn, figure)) continue;
    page += fmt::format("\n**{0}**\n\n![{0}]({1})\n", figure.caption, figure.png);
  }
  return page;
}

}  // namespace

Drawn read_run(const fs::path& out, const std::string& chapter) {
  const fs::path file = out / "results" / (chapter + ".json");
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (json.is_discarded()) throw std::runtime_error(file.string() + ": no record of a whole run");
  Drawn drawn{chapter, json.at("title"), out / "figures" / chapter, out / "results" / chapter, {}};
  for (const auto& item : json.at("items")) {
    Figure figure;
    figure.png = item.value("png", "");
    figure.drawn = !item.contains("not_drawn");
    if (!figure.drawn) figure.png = item.at("id").get<std::string>() + ".png";
    if (figure.png.empty()) continue;
    if (item.contains("csv") && item["csv"].is_array())
      figure.csv = item["csv"].get<std::vector<std::string>>();
    figure.caption = fmt::format("{}: {}", item.at("id").get<std::string>(),
                                 item.at("title").get<std::string>());
    drawn.figures.push_back(std::move(figure));
  }
  return drawn;
}

Report compare_data(const fs::path& data, const fs::path& golden) {
  Report report;
  for (const std::string& name : files_in(golden))
    if (name.ends_with(".csv"))
      compare_file(
          data / name, golden / name, report,
          [](const fs::path& a, const fs::path& b, std::string&) { return data_fault(a, b); });
  if (report.compared.empty() && report.faults.empty())
    report.faults.push_back(golden.string() + ": no data");
  return report;
}

Report compare(const Drawn& drawn, const fs::path& golden, bool pixels) {
  Report report;
  if (drawn.figures.empty()) report.faults.push_back(drawn.chapter + ": no figures in its record");
  for (const Figure& figure : drawn.figures) {
    if (!has_golden(drawn, figure)) continue;
    for (const std::string& csv : figure.csv) {
      compare_file(
          drawn.data / csv, golden / csv, report,
          [](const fs::path& a, const fs::path& b, std::string&) { return data_fault(a, b); });
    }
    if (figure.drawn)
      compare_file(drawn.pictures / figure.png, golden / figure.png, report,
                   [&](const fs::path& a, const fs::path& b, std::string& measured) {
                     return picture_fault(a, b, pixels && is_fixed(drawn, figure), measured);
                   });
  }
  const std::set<std::string> names = golden_names(drawn);
  for (const std::string& name : files_in(golden))
    if (!names.contains(name))
      report.faults.push_back(name + ": committed, but not drawn any more");
  return report;
}

Report accept(const Drawn& drawn, const fs::path& golden) {
  Report done;
  fs::create_directories(golden);
  const std::set<std::string> names = golden_names(drawn);
  for (const std::string& name : files_in(golden)) {
    if (names.contains(name)) continue;
    fs::remove(golden / name);
    done.compared.push_back(name + ": removed");
  }
  for (const std::string& name : names) {
    const bool data = name.ends_with(".csv");
    const fs::path from = (data ? drawn.data : drawn.pictures) / name;
    const fs::path to = golden / name;
    Report one;
    compare_file(from, to, one, [&](const fs::path& a, const fs::path& b, std::string& measured) {
      return data ? data_fault(a, b) : picture_fault(a, b, true, measured);
    });
    if (one.faults.empty()) continue;
    if (data) {
      files::write(to, golden_text(from));
    } else {
      fs::copy_file(from, to, fs::copy_options::overwrite_existing);
    }
    done.compared.push_back(one.faults[0]);
  }
  files::write(golden / "README.md", gallery_page(drawn));
  return done;
}

}  // namespace railbook::figures
