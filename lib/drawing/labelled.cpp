#include "drawing/labelled.hpp"

#include <filesystem>

#include "plot/plot.hpp"
#include "scene/image.hpp"
#include "table/csv.hpp"

namespace railbook::drawing {

void labelled(report::Item& item, const std::string& script, const scene::Scene& scene,
              const scene::Camera& camera, const scene::Size& size,
              const std::vector<Label>& labels) {
  item.script(script);
  report::Data& places = item.data("labels", {"x_px", "y_px", "label"});
  for (const Label& label : labels) {
    const Eigen::Vector2d at = scene::project(camera, size, label.at);
    places.add(at.x(), at.y(), label.text);
  }
  item.image([scene, camera, size, text = places.text(),
              script = item.sources() / script](const std::filesystem::path& png) {
    const auto picture = std::filesystem::path(png).replace_extension(".scene.png");
    const auto list = std::filesystem::path(png).replace_extension(".labels.csv");
    scene::write_png(scene::render(scene, camera, size), picture);
    table::write_file(list, text);
    plot::render(script, {picture, list}, png);
    std::filesystem::remove(picture);
    std::filesystem::remove(list);
  });
}

}  // namespace railbook::drawing
