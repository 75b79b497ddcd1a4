#include <railbook/report/run_folder.hpp>

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include <railbook/files/out_file.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const fs::path& file) {
  throw InputError(fmt::format(
      "file {}: no earlier run of this chapter made it, and it stays; allowed: a folder without it",
      files::quoted_name(file)));
}

// The files that a record names, in a folder of results and one of figures.
void add_files_of(const Json& record, const std::string& chapter, std::set<std::string>& names) {
  const auto add = [&](const char* kind, const Json& name) {
    if (name.is_string())
      names.insert(fmt::format("{}/{}/{}", kind, chapter, name.get<std::string>()));
  };
  add("results", "checks.csv");
  for (const Json& item : record.value("items", Json::array())) {
    if (!item.is_object()) continue;
    add("figures", item.value("png", Json()));
    if (const Json id = item.value("id", Json()); id.is_string())
      add("figures", id.get<std::string>() + ".svg");
    for (const Json& csv : item.value("csv", Json::array())) add("results", csv);
  }
}

}  // namespace

std::set<std::string> RunFolder::known_files() const {
  std::set<std::string> names;
  std::ifstream lines(list());
  for (std::string line; std::getline(lines, line);) names.insert(line);
  std::ifstream text(record());
  if (!text) return names;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("chapter", Json()) != chapter_) refuse(record());
  add_files_of(json, chapter_, names);
  return names;
}

RunFolder::RunFolder(fs::path out, std::string chapter, bool anew)
    : out_(std::move(out)), chapter_(std::move(chapter)) {
  if (out_.empty()) throw InputError("out is empty; allowed: the name of a folder");
  files::MadeFolder made_results(results()), made_figures(figures());
  known_ = known_files();
  std::set<std::string> there;
  for (const fs::path& folder : {results(), figures()})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().lexically_relative(out_).generic_string();
      if (known_.count(name) == 0 || !fs::is_regular_file(entry.symlink_status()))
        refuse(entry.path());
      there.insert(name);
    }
  if (anew) {
    forget_record();
    for (const std::string& name : there) files::remove(out_ / name);
    files::remove(list());
    known_.clear();
  }
  made_results.keep();
  made_figures.keep();
}

void RunFolder::forget_record() const {
  for (const fs::path& file : {record(), summary()}) files::remove(file);
}

void RunFolder::announce(const fs::path& file) {
  const std::string name = file.lexically_relative(out_).generic_string();
  if (known_.count(name) > 0) return;
  if (fs::exists(fs::symlink_status(file))) refuse(file);
  known_.insert(name);
  files::write(list(), fmt::format("{}\n", fmt::join(known_, "\n")));
}

}  // namespace railbook::report
