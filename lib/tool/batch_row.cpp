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

void Row::flag(const std::string& key) {
  for (Cell& cell : cells_)
    if (cell.key == "flags") {
      if ((";" + cell.text + ";").find(";" + key + ";") != std::string::npos) return;
      cell.text += (cell.text.empty() ? "" : ";") + key;
      return;
    }
  add("flags", key);
}

}  // namespace railbook::tool
