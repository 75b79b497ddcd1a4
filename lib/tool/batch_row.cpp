#include <algorithm>
#include <utility>

#include <railbook/tool/batch.hpp>

namespace railbook::tool {

void Row::add(std::string key, double value) {
  cells_.push_back({std::move(key), "", value, false});
}

void Row::add(std::string key, std::string text) {
  cells_.push_back({std::move(key), std::move(text), 0, true});
}

void Row::warn(const std::string& key) {
  for (Cell& cell : cells_)
    if (cell.key == "warnings") {
      if ((";" + cell.text + ";").find(";" + key + ";") != std::string::npos) return;
      cell.text += (cell.text.empty() ? "" : ";") + key;
      return;
    }
  add("warnings", key);
}

}  // namespace railbook::tool
