// Points of the figures, picked out of results that others computed.
#pragma once

#include <utility>
#include <vector>

#include "contact/countaxi.hpp"
#include "contact/hertz.hpp"
#include "contact/punch.hpp"
#include "sections.hpp"

namespace railbook::contact_chapter::draw {

double centre(const ColumnMesh&, Eigen::Index column);  // its x [m]
// The pressure along the x axis: x [m] rising, p [Pa], from end to end.
std::vector<std::pair<double, double>> axis_line(const NormalContact&);

// The largest difference between the cells' pressures and Hertz's ellipsoid, as a share of its peak.
double off_ellipsoid(const NormalContact&, const HertzContact&);

void gap_before_and_after(report::Item&, const Gap&, const NormalContact&, double reach);  // Fig. 1
void boundary_update(report::Item&, const CountactStep&, const ColumnMesh& next);          // Fig. 2
void column_under_origin(report::Item&, const CountactStep&, bool parabolas);      // Figs 3, 4
void profiles(report::Item&, const RailWheel&, double from, double to);            // Figs 6, 8
void mesh_development(report::Item&, const CountactResult&, const HertzContact&);  // Fig. 7
void axis_pressure(report::Data&, const NormalContact&);                           // Fig. 9
void patch(report::Item&, const NormalContact&, const Gap&);                       // Fig. 10
void in_space(report::Item&, const NormalContact&, const Gap&);                    // scene.cpp
void punch(report::Item&, const RingContact&, const PunchContact&);                // Fig. 14

}  // namespace railbook::contact_chapter::draw
