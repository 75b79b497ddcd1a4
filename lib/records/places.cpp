#include <railbook/records/places.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <railbook/num/pairs.hpp>

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
  for (std::size_t i = 0; i < positions.size();) {
    const auto next = positions.subspan(i, std::min<std::size_t>(64, positions.size() - i));
    i += next.size();
    if (next.size() == 64 && pass(from, sample, next, low, high)) {
      sample += next.size();
      last = {static_cast<double>(sample - 1), direction_ * next.back()};
      continue;
    }
    for (const double position : next) {
      const Node here{static_cast<double>(sample++), direction_ * position};
      double share = 1 / (here.sample - from.sample),
             slope = (here.position - from.position) * share;
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
  }
  last_ = last;
  low_ = low;
  high_ = high;
}

// Whether all slopes from a node to an even number of positions keep to the bounds, those that the
// positions themselves set among them: then the bounds become these.
bool PlaceMap::pass(const Node& from, std::size_t sample, std::span<const double> positions,
                    double& low, double& high) const {
  const double first = static_cast<double>(sample) - from.sample;
  num::Pair count{first, first + 1}, lowest = num::both(low), highest = num::both(high);
  num::Pair least = num::both(std::numeric_limits<double>::infinity()), most = -least;
  for (std::size_t i = 0; i < positions.size(); i += 2, count += 2) {
    const num::Pair share = 1 / count, half = 0.5 * spacing_ * share;
    const num::Pair slope = (direction_ * num::pair_at(&positions[i]) - from.position) * share;
    least = num::smaller(slope, least);
    most = num::larger(slope, most);
    lowest = num::larger(slope - half, lowest);
    highest = num::smaller(slope + half, highest);
  }
  const double new_low = std::max(lowest[0], lowest[1]);
  const double new_high = std::min(highest[0], highest[1]);
  if (std::min(least[0], least[1]) < new_low || std::max(most[0], most[1]) > new_high) return false;
  low = new_low;
  high = new_high;
  return true;
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
