#include <railbook/records/places.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace railbook::records {

void PlaceMap::add(std::size_t sample, std::span<const double> positions) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (nodes_.empty()) {
    nodes_.push_back({static_cast<double>(sample++), direction_ * positions.front()});
    last_ = nodes_.back();
    positions = positions.subspan(1);
  }
  Node from = nodes_.back(), last = last_;
  double low = low_, high = high_;
  for (const double position : positions) {
    const Node here{static_cast<double>(sample++), direction_ * position};
    double share = 1 / (here.sample - from.sample), slope = (here.position - from.position) * share;
    if (slope < low || slope > high) {
      nodes_.push_back(from = last);
      low = -infinity;
      high = infinity;
      share = 1 / (here.sample - from.sample);
      slope = (here.position - from.position) * share;
    }
    low = std::max(low, slope - 0.5 * spacing_ * share);
    high = std::min(high, slope + 0.5 * spacing_ * share);
    last = here;
  }
  last_ = last;
  low_ = low;
  high_ = high;
}

void PlaceMap::jump(std::size_t sample, double position) {
  if (last_.sample > nodes_.back().sample) nodes_.push_back(last_);
  nodes_.push_back({static_cast<double>(sample), direction_ * position, true});
  last_ = nodes_.back();
  low_ = -std::numeric_limits<double>::infinity();
  high_ = -low_;
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
  double length = 0, steps = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].jump) continue;
    length += std::abs(nodes[i].position - nodes[i - 1].position);
    steps += nodes[i].sample - nodes[i - 1].sample;
  }
  worst.overall = steps > 0 ? length / steps : spacing_;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].jump) continue;
    const double count = nodes[i].sample - nodes[i - 1].sample;
    const double spacing = std::abs(nodes[i].position - nodes[i - 1].position) / count;
    const double share =
        std::abs(spacing / worst.overall - 1) - 1 / count;  // nodes are rounded, too
    if (share > worst.share)
      worst = {share, direction_ * nodes[i - 1].position, direction_ * nodes[i].position, spacing,
               worst.overall};
  }
  return worst;
}

}  // namespace railbook::records
