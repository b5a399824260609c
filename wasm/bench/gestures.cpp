#include "bench/gestures.h"

#include <algorithm>
#include <cmath>

#include "bench/patches.h"

namespace whittle::bench {

namespace {

constexpr double kQuarter = EIGEN_PI / 2;
constexpr int kHoles = 5;
constexpr double kHole = 0.25, kThickness = 0.2;  // of squares of side 1

/// How many edges of about a length there are along a line, a multiple of `step`.
int count(double line, double edge, int step) {
  return step * std::max(1, static_cast<int>(std::lround(line / edge / step)));
}

/// The point at a share of the way around a square of side 1, from its corner (½, −½).
Vec3 onSquare(double u) {
  const double side = std::min(3.0, std::floor(4 * u + 1e-9)), along = 4 * u - side - 0.5;
  return Eigen::AngleAxisd(kQuarter * side, Vec3::UnitZ()) * Vec3(0.5, along, 0);
}
Vec3 onCircle(double u) {
  return Vec3(std::cos(4 * kQuarter * u - kQuarter / 2), std::sin(4 * kQuarter * u - kQuarter / 2), 0);
}

TriangleMesh plate(double edge) {
  Patches patches;
  const int around = count(4, edge, 4), layers = count(0.36, 0.7 * edge, 2), deep = count(kThickness, edge, 2);
  for (int hole = 0; hole < kHoles; ++hole) {
    const Vec3 middle(hole, 0, 0), up(0, 0, kThickness);
    const auto between = [=](double u, double v) -> Vec3 {
      const double wrapped = u - std::floor(u);
      return middle + (1 - v) * kHole * onCircle(wrapped) + v * onSquare(wrapped);
    };
    patches.addStaggered(around, layers, [=](double u, double v) -> Vec3 { return between(-u, v) + up; });
    patches.addStaggered(around, layers, between);
    patches.addStaggered(around, deep,
                         [=](double u, double v) -> Vec3 { return middle + kHole * onCircle(-u) + v * up; });
    for (int side = 0; side < 4; ++side) {
      const bool isInside = (side == 0 && hole < kHoles - 1) || (side == 2 && hole > 0);
      if (isInside) continue;
      patches.add(around / 4, deep,
                  [=](double u, double v) -> Vec3 { return middle + onSquare((side + u * (1 - 1e-12)) / 4) + v * up; });
    }
  }
  return patches.welded();
}

constexpr double kRadius = 0.3, kHeight = 2;

/// A disc with a rim of so many even steps, and a square in its middle.
void addDisc(Patches& patches, int around, double edge, bool isUp, const Vec3& middle) {
  constexpr double kSquare = 0.8;  // of the radius
  const auto between = [=](double u, double v) -> Vec3 {
    const double wrapped = u - std::floor(u);
    return middle + kRadius * ((1 - v) * kSquare * onSquare(wrapped) + v * onCircle(wrapped));
  };
  patches.addStaggered(around, count(0.5 * kRadius, edge, 2),
                       [=](double u, double v) -> Vec3 { return between(isUp ? -u : u, v); });
  patches.add(around / 4, around / 4, [=](double u, double v) -> Vec3 {
    return middle + kRadius * kSquare * Vec3((isUp ? u : v) - 0.5, (isUp ? v : u) - 0.5, 0);
  });
}

TriangleMesh cylinder(double edge) {
  Patches patches;
  const int around = count(4 * kQuarter * kRadius, edge, 8), rows = count(kHeight, 0.866 * edge, 2);
  const Vec3 top(0, 0, kHeight);
  patches.addStaggered(around, rows, [=](double u, double v) -> Vec3 { return kRadius * onCircle(u) + v * top; });
  addDisc(patches, around, edge, true, top);
  addDisc(patches, around, edge, false, Vec3::Zero());
  return patches.welded();
}

/// An L of two arms of length 1, a quarter thick and half as wide.
TriangleMesh bracket(double edge) {
  Patches patches;
  const Vec3 wide(0, 0.5, 0);
  const int across = count(0.5, edge, 1);
  const std::vector<Vec3> outline = {{0, 0, 0},       {0.25, 0, 0}, {1, 0, 0}, {1, 0, 0.25},
                                     {0.25, 0, 0.25}, {0.25, 0, 1}, {0, 0, 1}, {0, 0, 0.25}};
  const int few = count(0.25, edge, 1), many = count(0.75, edge, 1);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 from = outline[i], to = outline[(i + 1) % outline.size()];
    patches.add(across, (to - from).norm() > 0.5 ? many : few,
                [=](double u, double v) -> Vec3 { return from + v * (to - from) + u * wide; });
  }
  const auto addFlat = [&](const Vec3& corner, double width, double height) {
    const int m = width > 0.5 ? many : few, n = height > 0.5 ? many : few;
    patches.add(m, n, [=](double u, double v) -> Vec3 { return corner + Vec3(u * width, 0, v * height); });
    patches.add(n, m, [=](double u, double v) -> Vec3 { return corner + wide + Vec3(v * width, 0, u * height); });
  };
  addFlat(Vec3::Zero(), 0.25, 0.25);
  addFlat({0.25, 0, 0}, 0.75, 0.25);
  addFlat({0, 0, 0.25}, 0.25, 0.75);
  return patches.welded();
}

TriangleMesh ball(double edge) {
  Patches patches;
  const int steps = count(kQuarter / 2, edge, 2);
  for (int side = 0; side < 6; ++side) {
    const Mat3 turn = side < 4 ? Eigen::AngleAxisd(kQuarter * side, Vec3::UnitX()).toRotationMatrix()
                               : Eigen::AngleAxisd(kQuarter * (2 * side - 9), Vec3::UnitY()).toRotationMatrix();
    patches.add(steps, steps, [=](double u, double v) -> Vec3 {
      const double x = std::tan(kQuarter * (u - 0.5)), y = std::tan(kQuarter * (v - 0.5));
      return turn * (0.5 * Vec3(x, y, 1).normalized());
    });
  }
  return patches.welded();
}

/// A shape of about so many faces.
TriangleMesh sized(TriangleMesh (*shape)(double edge), Index faces) {
  double edge = 0.1;
  TriangleMesh best = shape(edge);
  for (int round = 0; round < 4; ++round) {
    TriangleMesh mesh = shape(edge);
    edge *= std::sqrt(static_cast<double>(mesh.faceCount()) / faces);
    if (std::abs(mesh.faceCount() - faces) < std::abs(best.faceCount() - faces)) best = std::move(mesh);
  }
  return best;
}

/// Holds the vertices that `holds` takes and moves them to where `move` says.
template <typename Holds, typename Move>
Gesture gesture(std::string name, TriangleMesh mesh, Holds holds, Move move) {
  Gesture result{std::move(name), std::move(mesh), {}};
  const Points& positions = result.mesh.positions;
  for (Index v = 0; v < result.mesh.vertexCount(); ++v) {
    if (holds(Vec3(positions.row(v).transpose()))) result.handles.vertices.push_back(v);
  }
  result.handles.targets.resize(static_cast<Index>(result.handles.vertices.size()), 3);
  for (Index h = 0; h < result.handles.targets.rows(); ++h)
    result.handles.targets.row(h) = move(Vec3(positions.row(result.handles.vertices[h]).transpose())).transpose();
  return result;
}

/// Both ends of an axis are held, and the upper one goes out by a factor.
Gesture lengthened(std::string name, const TriangleMesh& mesh, int axis, double factor, double handleRadius = 10) {
  const double low = mesh.positions.col(axis).minCoeff(), high = mesh.positions.col(axis).maxCoeff();
  return gesture(
      std::move(name), mesh,
      [=](const Vec3& p) {
        const bool isEnd = p[axis] < low + 1e-6 || p[axis] > high - 1e-6;
        return isEnd && (p - p[axis] * Vec3::Unit(axis)).norm() < handleRadius;
      },
      [=](Vec3 p) -> Vec3 { return p + (p[axis] > high - 1e-6 ? (factor - 1) * (high - low) : 0) * Vec3::Unit(axis); });
}

}  // namespace

Gesture plateGesture(Index faces) { return lengthened("plate, longer", sized(plate, faces), 0, 1.6); }

std::vector<Gesture> gestures(Index faces) {
  constexpr double kPoint = 1e-6;
  std::vector<Gesture> all = {plateGesture(faces)};
  all.push_back(lengthened("plate, shorter", all[0].mesh, 0, 0.7));
  const TriangleMesh tube = sized(cylinder, faces);
  all.push_back(lengthened("cylinder by its caps", tube, 2, 1.6));
  all.push_back(lengthened("cylinder by two points", tube, 2, 1.6, kPoint));
  all.push_back(gesture(
      "arm of a bracket", sized(bracket, faces), [](const Vec3& p) { return p.x() > 1 - 1e-6 || p.z() > 1 - 1e-6; },
      [](const Vec3& p) -> Vec3 { return p + (p.x() > 1 - 1e-6 ? 0.6 : 0) * Vec3::UnitX(); }));
  all.push_back(lengthened("ball by its poles", sized(ball, faces), 2, 1.5, kPoint));
  return all;
}

}  // namespace whittle::bench
