#include <railbook/tool/out_folder.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <railbook/plot/plot.hpp>
#include <railbook/tool/session.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::tool {

OutFolder::OutFolder(const Destination& destination, std::vector<std::string> names)
    : destination_(destination), names_(std::move(names)) {
  if (destination_.figure) {
    if (destination_.folder || destination_.no_figures)
      throw InputError(std::string{"figure is given with "} +
                       (destination_.folder ? "out" : "no-figures") + "; allowed: one of them");
    if (files::is_standard_output(*destination_.figure) && session().json)
      throw InputError("figure is - with json; allowed: one answer on standard output");
    session().taken = files::is_standard_output(*destination_.figure);
    files_.reserve(names_.size());
    figure_.emplace(*destination_.figure);
    destination_.folder = scratch_.emplace().path();
    return;
  }
  if (!destination_.folder) return;
  const std::filesystem::path& folder = *destination_.folder;
  if (folder.empty()) throw InputError("out is empty; allowed: the name of a folder");
  if (files::is_standard_output(folder))
    throw InputError("out is " + files::quoted_name(folder) +
                     ", standard output; allowed: the name of a folder (./- for one called -)");
  files::require_no_link(folder);
  files_.reserve(names_.size());  // references to its elements are given out
  files::require_makeable(folder);
  for (const std::string& name : names_) files::require_replaceable(folder / name);
}

OutFolder::~OutFolder() = default;

files::OutFile& OutFolder::stream(const std::string& name) {
  if (std::find(names_.begin(), names_.end(), name) == names_.end() || drawable_.count(name) > 0)
    throw std::logic_error("file " + name + " was not announced, or is there already");
  if (!made_ && !figure_) made_.emplace(*destination_.folder);
  files_.emplace_back(*destination_.folder / name);
  drawable_[name].clear();
  return files_.back();
}

void OutFolder::add(const std::string& name, std::string_view text) {
  files::OutFile& file = stream(name);
  file.write(text);
  drawable_[name] = file.staged();
}

void OutFolder::scratch(const std::string& name, std::string_view text) {
  if (!scratch_) scratch_.emplace();
  drawable_[name] = scratch_->write(name, text);
}

void OutFolder::figure(const std::filesystem::path& script, const std::vector<std::string>& data,
                       const std::string& png) {
  if (destination_.no_figures || (figure_ && drawn_)) return;
  std::vector<std::filesystem::path> paths;
  paths.reserve(data.size());
  for (const std::string& name : data) paths.push_back(drawable_.at(name));
  const bool svg = figure_ && destination_.figure->extension() == ".svg";
  const std::string picture = svg ? plot::draw_svg(script, paths, plot::EmptyCurve::skip)
                                  : plot::draw(script, paths, plot::EmptyCurve::skip);
  drawn_ = true;
  if (figure_)
    figure_->write(picture);
  else
    add(png, picture);
}

void OutFolder::commit() {
  if (figure_ && !drawn_) throw InputError("figure is given, but there is nothing to draw");
  if (figure_) figure_->commit();
  if (made_) {
    files::commit(files_);
    made_->keep();
  }
}

}  // namespace railbook::tool
