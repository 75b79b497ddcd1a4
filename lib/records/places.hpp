// Where the samples of a record lie: their positions as straight pieces, true to half a spacing.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace railbook::records {

// Keeps a new piece only where the positions leave the present one by over half a spacing (the
// swinging door of Bristol 1990): two nodes for an even record, whatever its length or the rounding
// of its positions.
class PlaceMap {
 public:
  // A record that begins at `first` and goes on evenly; towards smaller positions where `direction`
  // is -1.
  explicit PlaceMap(double spacing = 1, double first = 0, double direction = 1)
      : spacing_(spacing), first_(direction * first), direction_(direction) {}

  // The positions (m) of a sample and those that follow it, given in the record's order.
  void add(std::size_t sample, std::span<const double> positions);
  void add(std::size_t sample, double position) { add(sample, {&position, 1}); }
  // The same for a sample that does not follow evenly from the one before.
  void jump(std::size_t sample, double position);

  // The position (m) of any sample, true to half a spacing; beyond the last one given, on at the
  // spacing.
  double at(std::size_t sample) const;

  // Where the spacing leaves that of the record as a whole: by how much at most (a share, rounding
  // of the positions allowed for), and between which positions.
  struct Unevenness {
    double share = 0;                 // 0.01: samples 1 % farther apart, or nearer
    double from = 0, to = 0;          // m
    double spacing = 0, overall = 0;  // m
  };
  Unevenness unevenness() const;

 private:
  struct Node {
    double sample, position;
    bool jump = false;  // from the node before
  };
  std::vector<Node> all_nodes() const;
  bool pass(const Node& from, std::size_t sample, std::span<const double> positions, double& low,
            double& high) const;

  double ahead(std::size_t sample) const;

  double spacing_, first_, direction_;
  std::vector<Node> nodes_;  // begin of each piece
  Node last_{};
  double low_ = -std::numeric_limits<double>::infinity(),
         high_ = -low_;  // slopes from the last node that keep all its samples
};

}  // namespace railbook::records
