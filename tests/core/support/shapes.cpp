#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace whittle::testing {

namespace {

TriangleMesh assemble(const std::vector<Vec3>& points, const std::vector<std::array<Index, 3>>& faces) {
  TriangleMesh mesh{Points(points.size(), 3), Triangles(faces.size(), 3)};
  for (std::size_t v = 0; v < points.size(); ++v) mesh.positions.row(v) = points[v].transpose();
  for (std::size_t f = 0; f < faces.size(); ++f) mesh.triangles.row(f) << faces[f][0], faces[f][1], faces[f][2];
  return mesh;
}

/// Two triangles for each cell of a grid of `columns` vertices per row.
std::vector<std::array<Index, 3>> gridFaces(Index rows, Index columns) {
  std::vector<std::array<Index, 3>> faces;
  for (Index r = 0; r + 1 < rows; ++r) {
    for (Index c = 0; c + 1 < columns; ++c) {
      const Index corner = r * columns + c;
      faces.push_back({corner, corner + 1, corner + columns + 1});
      faces.push_back({corner, corner + columns + 1, corner + columns});
    }
  }
  return faces;
}

}  // namespace

TriangleMesh sphere(int levels) {
  std::vector<Vec3> points = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                              -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  std::vector<std::array<Index, 3>> faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                             {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
      if (isNew) points.push_back((points[a] + points[b]).normalized());
      return entry->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& face : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}) finer.push_back(face);
    }
    faces = finer;
  }
  return assemble(points, faces);
}

TriangleMesh grid(int n) {
  std::vector<Vec3> points;
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) points.emplace_back(c / (n - 1.0), r / (n - 1.0), 0);
  }
  return assemble(points, gridFaces(n, n));
}

TriangleMesh moebiusStrip(int n) {
  constexpr int kAcross = 4;
  std::vector<Vec3> points;
  for (int r = 0; r < n; ++r) {
    const double turn = 2 * EIGEN_PI * r / n;
    for (int c = 0; c < kAcross; ++c) {
      const double s = c / (kAcross - 1.0) - 0.5;
      const double radius = 1 + s * std::cos(turn / 2);
      points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), s * std::sin(turn / 2));
    }
  }
  auto faces = gridFaces(n, kAcross);
  for (int c = 0; c + 1 < kAcross; ++c) {  // closed with a half twist: the first row comes back mirrored
    const Index a = (n - 1) * kAcross + c;
    const Index b = kAcross - 1 - c;
    faces.push_back({a, a + 1, b - 1});
    faces.push_back({a, b - 1, b});
  }
  return assemble(points, faces);
}

namespace {

/// Squares of a grid, each cut in two, whose corners are vertices once.
class Squares {
 public:
  /// Adds the square at the near or far end of an axis, counter-clockwise seen from outside.
  void add(std::array<int, 3> corner, int axis, bool isFar) {
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    const std::array<int, 3> first = corner;
    Index quad[4];
    for (int k = 0; k < 4; ++k) {
      corner[u] = first[u] + (k == 1 || k == 2);
      corner[w] = first[w] + (k >= 2);
      quad[isFar ? k : 3 - k] = vertex(corner);
    }
    faces_.push_back({quad[0], quad[1], quad[2]});
    faces_.push_back({quad[0], quad[2], quad[3]});
  }
  TriangleMesh mesh(int across) {
    for (Vec3& point : points_) point /= across;
    return assemble(points_, faces_);
  }

 private:
  Index vertex(const std::array<int, 3>& at) {
    const auto [entry, isNew] = known_.try_emplace(at, static_cast<Index>(points_.size()));
    if (isNew) points_.push_back(Vec3(at[0], at[1], at[2]));
    return entry->second;
  }

  std::map<std::array<int, 3>, Index> known_;
  std::vector<Vec3> points_;
  std::vector<std::array<Index, 3>> faces_;
};

}  // namespace

TriangleMesh longBox(int along, int across) {
  const std::array<int, 3> cells = {along, across, across};
  Squares squares;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    for (int i = 0; i < 2 * cells[u] * cells[w]; ++i) {
      const bool isFar = i % 2;
      std::array<int, 3> corner{};
      corner[axis] = isFar ? cells[axis] : 0;
      corner[u] = i / 2 % cells[u];
      corner[w] = i / 2 / cells[u];
      squares.add(corner, axis, isFar);
    }
  }
  return squares.mesh(across);
}

TriangleMesh blocks(const std::vector<std::array<int, 3>>& cubes, int across) {
  Squares squares;
  for (const std::array<int, 3>& cube : cubes) {
    for (int side = 0; side < 6; ++side) {
      const int axis = side / 2, u = (axis + 1) % 3, w = (axis + 2) % 3;
      std::array<int, 3> beside = cube;
      beside[axis] += side % 2 ? 1 : -1;
      if (std::find(cubes.begin(), cubes.end(), beside) != cubes.end()) continue;
      for (int i = 0; i < across * across; ++i) {
        std::array<int, 3> corner = {across * cube[0], across * cube[1], across * cube[2]};
        corner[axis] += side % 2 ? across : 0;
        corner[u] += i % across;
        corner[w] += i / across;
        squares.add(corner, axis, side % 2);
      }
    }
  }
  return squares.mesh(across);
}

TriangleMesh prism(int sides, double turn) {
  std::vector<Vec3> points = {{0, 0, 0}, {0, 0, 1.5}};
  std::vector<std::array<Index, 3>> faces;
  for (int k = 0; k < sides; ++k) {
    const double angle = turn + 2 * EIGEN_PI * k / sides;
    for (const double z : {0.0, 1.5}) points.emplace_back(std::cos(angle), std::sin(angle), z);
    const Index low = 2 + 2 * k, next = 2 + 2 * ((k + 1) % sides);
    faces.push_back({low, next, next + 1});
    faces.push_back({low, next + 1, low + 1});
    faces.push_back({0, next, low});
    faces.push_back({1, low + 1, next + 1});
  }
  return assemble(points, faces);
}

TriangleMesh torus(int n) {
  TriangleMesh mesh{Points(n * n, 3), Triangles(2 * n * n, 3)};
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const double a = 2 * EIGEN_PI * r / n, b = 2 * EIGEN_PI * c / n, radius = 1 + 0.4 * std::cos(b);
      mesh.positions.row(r * n + c) << radius * std::cos(a), radius * std::sin(a), 0.4 * std::sin(b);
      const Index p = r * n + c, right = r * n + (c + 1) % n, up = (r + 1) % n * n + c,
                  across = (r + 1) % n * n + (c + 1) % n;
      mesh.triangles.row(2 * p) << p, up, across;
      mesh.triangles.row(2 * p + 1) << p, across, right;
    }
  }
  return mesh;
}

TriangleMesh animal(int levels) {
  TriangleMesh mesh = sphere(levels);
  struct Bump {
    Vec3 towards;
    double height, sharpness;
  };
  const Bump bumps[] = {
      {{0.7, 0.7, 0.1}, 0.9, 6}, {{0.45, 1, 0.35}, 0.7, 30}, {{0.4, 1, -0.2}, 0.7, 30}, {{-1, 0.1, 0.1}, 0.4, 20}};
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions.row(v).transpose();
    double radius = 1;
    for (const Bump& bump : bumps)
      radius += bump.height * std::exp(bump.sharpness * (p.dot(bump.towards.normalized()) - 1));
    mesh.positions.row(v) = radius * Eigen::RowVector3d(p.x(), 0.8 * p.y(), 0.7 * p.z());
  }
  return mesh;
}

Index shuffledPlace(Index v, Index count) {
  return static_cast<Index>((static_cast<std::int64_t>(v) * 101 + 7) % count);
}

TriangleMesh shuffled(const TriangleMesh& mesh) {
  TriangleMesh result = mesh;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    result.positions.row(shuffledPlace(v, mesh.vertexCount())) = mesh.positions.row(v);
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner) {
    result.triangles.data()[corner] = shuffledPlace(mesh.triangles.data()[corner], mesh.vertexCount());
  }
  return result;
}

TriangleMesh together(const TriangleMesh& first, const TriangleMesh& second, const Vec3& offset) {
  TriangleMesh mesh{Points(first.vertexCount() + second.vertexCount(), 3),
                    Triangles(first.faceCount() + second.faceCount(), 3)};
  mesh.positions << first.positions, second.positions.rowwise() + offset.transpose();
  mesh.triangles << first.triangles, (second.triangles.array() + first.vertexCount()).matrix();
  return mesh;
}

TriangleMesh bent(TriangleMesh mesh) {
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions.row(v).transpose();
    mesh.positions.row(v) << p.x() + 0.2 * std::sin(2 * p.y()), p.y() * (1.3 + 0.3 * p.z()),
        p.z() + 0.1 * p.x() * p.x();
  }
  return mesh;
}

Mat3 someRotation() { return Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(); }

Mat3 Noise::matrix() {
  Mat3 M;
  for (int i = 0; i < 9; ++i) M(i / 3, i % 3) = (*this)();
  return M;
}

Mat3 Noise::rotation() {
  Eigen::Quaterniond q{(*this)(), (*this)(), (*this)(), (*this)()};
  return q.normalized().toRotationMatrix();
}

Vec3 Noise::direction() {
  const Vec3 v{(*this)(), (*this)(), (*this)()};
  return v.normalized();
}

Mat3 Noise::withSingularValues(const Vec3& values) {
  const Mat3 U = rotation(), V = rotation();
  return U * values.asDiagonal() * V;
}

}  // namespace whittle::testing
