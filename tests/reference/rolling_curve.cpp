// rolling_curve CSV ALLOWED CELLS...: the dimensionless creep curve of
// chapters/03-creep/data/contact-curve.csv once more: CONTACT's theory (half-spaces, constant
// tractions on square cells, steady rolling), a/b = 1.568, nu = 0.3, by relaxation cell by cell
// from the leading edge on, a part of each change at a time. Grids of so many cells along are
// extrapolated to none by a line in the cell's size. Nothing of lib/ is used. Ends with 1 when a
// value of the file is farther than ALLOWED.
//
//   reference_rolling_curve chapters/03-creep/data/contact-curve.csv 3e-2 9 13 19     (a quarter of
//   a second; 2.2e-2) reference_rolling_curve chapters/03-creep/data/contact-curve.csv 4e-3 21 31
//   41    (half a minute; 3.0e-3)
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846, a = 1.568, b = 1, nu = 0.3;

struct Matrix {
  double xx = 0, xy = 0, yy = 0;
};
// Displacement at the origin's distance (x, y) from the corner of a loaded quadrant: differences of
// four give a cell's.
Matrix corner(double x, double y) {
  const double r = std::hypot(x, y);
  const double in_x = y == 0 || x == 0 ? 0 : y * std::asinh(x / std::abs(y));
  const double in_y = y == 0 || x == 0 ? 0 : x * std::asinh(y / std::abs(x));
  const double rest = (1 - nu) * (in_x + in_y);  // of 1/r
  return {(rest + nu * in_x) / pi, -nu * r / pi, (rest + nu * in_y) / pi};
}
Matrix cell(double x, double y, double h) {
  const Matrix p = corner(x + h / 2, y + h / 2), q = corner(x - h / 2, y + h / 2),
               r = corner(x + h / 2, y - h / 2), s = corner(x - h / 2, y - h / 2);
  return {p.xx - q.xx - r.xx + s.xx, p.xy - q.xy - r.xy + s.xy, p.yy - q.yy - r.yy + s.yy};
}

struct Cell {
  int i, j;
  double bound, px = 0, py = 0;
};

// Shares of the friction at the creepages, on a grid of n cells along; NaN where the relaxation did
// not settle.
std::vector<double> solve(int n, const std::vector<double>& reduced) {
  const double h = 2 * a / n;
  const int rows = static_cast<int>(std::ceil(b / h)), most = std::max(n, 2 * rows + 1);
  std::vector<Cell> cells;  // the leading ones first
  double load = 0;
  for (int i = n - 1; i >= 0; --i)
    for (int j = -rows; j <= rows; ++j) {
      const double x = (i + 0.5) * h - a, y = j * h, left = 1 - x * x / (a * a) - y * y / (b * b);
      if (left <= 0) continue;
      cells.push_back({i, j, std::sqrt(left)});
      load += std::sqrt(left);
    }
  for (Cell& c : cells) c.bound /= load * h * h;  // together 1
  // What a cell's traction does to the slip of one (di, dj) away: [u(x) - u(x + h)]/h.
  const int width = 2 * most + 1;
  std::vector<Matrix> table(static_cast<std::size_t>(width) * static_cast<std::size_t>(width));
  const auto at = [&](int di, int dj) -> Matrix& {
    return table[static_cast<std::size_t>((di + most) * width + dj + most)];
  };
  for (int di = -most; di <= most; ++di)
    for (int dj = -most; dj <= most; ++dj) {
      const Matrix here = cell(di * h, dj * h, h), ahead = cell((di + 1) * h, dj * h, h);
      at(di, dj) = {(here.xx - ahead.xx) / h, (here.xy - ahead.xy) / h, (here.yy - ahead.yy) / h};
    }
  const Matrix own = at(0, 0);
  const double middle = (own.xx + own.yy) / 2;
  std::vector<double> shares;
  for (const double X : reduced) {
    const double creepage = X / (a * b);
    bool settled = false;
    for (int sweep = 0; sweep < 3000 && !settled; ++sweep) {
      double change = 0;
      for (Cell& c : cells) {
        double sx = creepage, sy = 0;  // the slip without its own traction
        for (const Cell& o : cells) {
          const Matrix& m = at(c.i - o.i, c.j - o.j);
          sx -= m.xx * o.px + m.xy * o.py;
          sy -= m.xy * o.px + m.yy * o.py;
        }
        sx += own.xx * c.px + own.xy * c.py;
        sy += own.xy * c.px + own.yy * c.py;
        const double det = own.xx * own.yy - own.xy * own.xy;
        double px = (own.yy * sx - own.xy * sy) / det, py = (own.xx * sy - own.xy * sx) / det;
        if (std::hypot(px, py) > c.bound) {  // slides: its traction along its slip
          double nx = px / std::hypot(px, py), ny = py / std::hypot(px, py);
          for (int k = 0; k < 30; ++k) {
            const double tx = sx - c.bound * ((own.xx - middle) * nx + own.xy * ny);
            const double ty = sy - c.bound * (own.xy * nx + (own.yy - middle) * ny);
            nx = tx / std::hypot(tx, ty), ny = ty / std::hypot(tx, ty);
          }
          px = c.bound * nx, py = c.bound * ny;
        }
        change = std::max(change, std::hypot(px - c.px, py - c.py) * a * b);
        c.px += 0.3 * (px - c.px), c.py += 0.3 * (py - c.py);  // in full they swing for ever
      }
      settled = change < 1e-7;
    }
    double sum = 0;
    for (const Cell& c : cells) sum += c.px * h * h;
    shares.push_back(settled ? sum : std::nan(""));
  }
  return shares;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) return 2;
  std::vector<double> X, held;
  std::ifstream in(arguments[1]);
  std::string line;
  while (std::getline(in, line)) {
    const auto comma = line.find(',');
    if (line.empty() || line[0] == '#' || line[0] == 'k' || comma == std::string::npos) continue;
    X.push_back(std::stod(line));
    held.push_back(std::stod(line.substr(comma + 1)));
  }
  std::vector<double> size;
  std::vector<std::vector<double>> found;
  for (int k = 3; k < count; ++k) {
    size.push_back(1 / std::atof(arguments[k]));
    found.push_back(solve(std::atoi(arguments[k]), X));
  }
  const double allowed = std::atof(arguments[2]), n = static_cast<double>(size.size());
  bool good = !X.empty();
  double worst = 0;
  for (std::size_t i = 0; i < X.size(); ++i) {
    double s = 0, f = 0, ss = 0, sf = 0;  // the line of least squares, at no size
    for (std::size_t k = 0; k < size.size(); ++k)
      s += size[k], f += found[k][i], ss += size[k] * size[k], sf += size[k] * found[k][i];
    const double limit = (f * ss - s * sf) / (n * ss - s * s), off = std::abs(limit - held[i]);
    std::printf("%-5g %.5f (%.5f on the finest) file %.5f\n", X[i], limit, found.back()[i],
                held[i]);
    worst = std::max(worst, off);
    good = good && off <= allowed;
  }
  std::printf("farthest %.1e, allowed %.1e\n", worst, allowed);
  return good ? 0 : 1;
}
