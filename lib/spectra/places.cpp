#include "spectra/places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace railbook::spectra {

void PlaceMap::add(std::size_t sample, double position) {
  position *= direction_;
  const Node here{static_cast<double>(sample), position};
  if (nodes_.empty()) {
    nodes_.push_back(here);
    low_ = -std::numeric_limits<double>::infinity();
    high_ = -low_;
  } else {
    const double half = 0.5 * spacing_;
    const auto slope = [&](double off) {
      return (position + off - nodes_.back().position) / (here.sample - nodes_.back().sample);
    };
    if (slope(0) < low_ || slope(0) > high_) {
      nodes_.push_back(last_);
      low_ = -std::numeric_limits<double>::infinity();
      high_ = -low_;
    }
    low_ = std::max(low_, slope(-half));
    high_ = std::min(high_, slope(half));
  }
  last_ = here;
}

std::vector<PlaceMap::Node> PlaceMap::all_nodes() const {
  std::vector<Node> nodes = nodes_;
  if (!nodes.empty() && last_.sample > nodes.back().sample) nodes.push_back(last_);
  return nodes;
}

double PlaceMap::at(std::size_t sample) const {
  return direction_ * ahead(sample);
}

// In the direction of travel.
double PlaceMap::ahead(std::size_t sample) const {
  const auto x = static_cast<double>(sample);
  if (nodes_.empty()) return first_ + spacing_ * x;
  if (x >= last_.sample) return last_.position + spacing_ * (x - last_.sample);
  auto next = std::upper_bound(nodes_.begin(), nodes_.end(), x,
                               [](double value, const Node& n) { return value < n.sample; });
  if (next == nodes_.begin())
    return nodes_.front().position - spacing_ * (nodes_.front().sample - x);
  const Node to = next == nodes_.end() ? last_ : *next, from = *--next;
  const double share = (x - from.sample) / (to.sample - from.sample);
  return from.position + share * (to.position - from.position);
}

PlaceMap::Unevenness PlaceMap::unevenness() const {
  const std::vector<Node> nodes = all_nodes();
  Unevenness worst;
  if (nodes.size() < 2) return worst;
  worst.overall = (nodes.back().position - nodes.front().position) /
                  (nodes.back().sample - nodes.front().sample);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double count = nodes[i].sample - nodes[i - 1].sample;
    const double spacing = (nodes[i].position - nodes[i - 1].position) / count;
    const double share =
        std::abs(spacing / worst.overall - 1) - 1 / count;  // nodes are rounded, too
    if (share > worst.share)
      worst = {share, direction_ * nodes[i - 1].position, direction_ * nodes[i].position, spacing,
               worst.overall};
  }
  return worst;
}

}  // namespace railbook::spectra
