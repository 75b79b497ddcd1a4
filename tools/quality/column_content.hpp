// What a column of level or alignment holds: the rail, a band of it, or its offsets from a chord.
#pragma once

#include <optional>
#include <string>

#include <railbook/quality/measure.hpp>

namespace railbook::quality_tool {

struct ColumnContent {
  std::optional<filters::Chord> offset;  // its chord of no length where only the header says so
  std::optional<filters::Band> band;
  std::string band_name;  // as given

  bool whole() const { return !offset && !band; }

  // What is to be done to the column for a measure of the rail; nothing where that is lost.
  std::optional<quality::Measure> for_measure(const quality::Measure& wanted) const {
    using quality::Measure;
    if (whole()) return wanted;
    Measure held = wanted, rest = wanted;
    held.kind = offset ? Measure::Kind::chord : Measure::Kind::band;
    held.chord = offset.value_or(filters::Chord{});
    held.band = band.value_or(filters::Band{});
    if (!held.is_like(wanted)) return std::nullopt;
    rest.kind = Measure::Kind::channel;
    return rest;
  }
};

}  // namespace railbook::quality_tool
