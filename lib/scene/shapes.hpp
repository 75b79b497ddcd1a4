// The bodies the chapters draw. Each returns a Mesh of one colour (set `colours` and `by` for more)
// whose sharp edges have their vertices twice, so that round parts shade smoothly and flat ones
// stay flat. Lengths in the scene's unit. All throw InputError for a size that is not positive and
// finite.
#pragma once

#include <railbook/scene/scene.hpp>

namespace railbook::scene {

inline const Colour steel{0.62, 0.65, 0.70};
inline const Colour wood{0.55, 0.38, 0.22};
inline const Colour stone{0.60, 0.58, 0.55};
inline const Colour soil{0.72, 0.60, 0.42};

// Corners (x0, y0) and (x1, y1) of one rectangle a row: x0, x1, y0, y1 with x0 < x1 and y0 < y1.
using Rectangles = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
// Points in a plane, one a row.
using Outline = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

// A box with edges along the axes, between two opposite corners.
Mesh box(const Point& low, const Point& high, const Colour& colour = stone);

// A pyramid without its top: rectangles of size `bottom` at height `z0` and `top` at `z1`, both
// centred on (x, y). The load-spreading pyramid under a tie has the larger one at the bottom; z0 <
// z1.
Mesh frustum(const Eigen::Vector2d& centre, const Eigen::Vector2d& bottom, double z0,
             const Eigen::Vector2d& top, double z1, const Colour& colour = stone);

// A bar along x from x0 to x1 with a constant cross-section: a simple polygon of (y, z), either way
// round, hollows allowed. Throws InputError when the polygon crosses itself or has no area.
Mesh extrusion(const Outline& section, double x0, double x1, const Colour& colour = steel);

// Cross-section of a rail as an I: foot on (y, z) = (0, 0), for `extrusion`.
//   extrusion(rail_section(0.172, 0.074, 0.045, 0.017, 0.150, 0.025), 0.0, 3.0)
Outline rail_section(double height, double head_width, double head_depth, double web_thickness,
                     double foot_width, double foot_depth);

// A body of revolution about the line from `start` along `axis` (any length but zero): the
// outline's rows are (distance along the axis, radius >= 0); it is closed when it begins and ends
// at radius 0.
Mesh revolution(const Point& start, const Point& axis, const Outline& outline,
                const Colour& colour = steel);

// A closed cylinder.
Mesh cylinder(const Point& from, const Point& to, double radius, const Colour& colour = steel);

// Outline for `revolution` of a wheel: a disc of `tread_radius` and `width` from distance 0, whose
// flange
// (`flange_height` above the tread) takes the first `flange_width` of it.
Outline wheel_outline(double tread_radius, double width, double flange_height, double flange_width);

// A coil spring between two points: straight leads over a tenth of the length at both ends, `turns`
// between. The wire has the radius `wire`, its centre line the radius `coil`.
Mesh spring(const Point& from, const Point& to, double coil, double wire, int turns,
            const Colour& colour = steel);

// A column of constant height over each rectangle, from the plane z = 0 to z = heights[i] (> 0; a
// height of 0 draws nothing), coloured by the rows of `colours`: cells of constant pressure.
//   columns(cells, p / p.maxCoeff(), viridis(p, 0.0, p.maxCoeff()))
Mesh columns(const Rectangles& cells, const Eigen::VectorXd& heights, const Points& colours);

// A smooth surface z over a grid: z(i, j) at (x[i], y[j]); quads with a NaN corner are left out, so
// a contact patch may have any outline. Colours follow z from `low` to `high` by viridis.
Mesh surface(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const Eigen::MatrixXd& z,
             double low, double high);

// The four sides of each rectangle at height z: a mesh drawn on its base plane.
Lines rectangle_edges(const Rectangles& cells, double z);

}  // namespace railbook::scene
