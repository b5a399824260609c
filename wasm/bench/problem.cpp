#include "bench/problem.h"

#include <cmath>
#include <cstdio>

#include "bench/measure.h"

namespace whittle::bench {

namespace {

TriangleMesh readMesh(const char* path) {
  std::FILE* file = std::fopen(path, "rb");
  const auto read = [file](void* into, std::size_t bytes) {
    if (!file || std::fread(into, 1, bytes, file) != bytes) {
      require(Status::failure(Code::badParameter, "the mesh file cannot be read"));
    }
  };
  std::int32_t counts[2];
  read(counts, sizeof counts);
  TriangleMesh mesh{Points(counts[0], 3), Triangles(counts[1], 3)};
  read(mesh.positions.data(), sizeof(double) * mesh.positions.size());
  read(mesh.triangles.data(), sizeof(Index) * mesh.triangles.size());
  std::fclose(file);
  return mesh;
}

/// Both ends of the longest axis are held, the upper one turned by 60° about it and pushed aside.
Handles twist(const Points& positions) {
  const Eigen::RowVector3d low = positions.colwise().minCoeff();
  const Eigen::RowVector3d extent = positions.colwise().maxCoeff() - low;
  Index axis;
  extent.maxCoeff(&axis);
  const Mat3 turn = Eigen::AngleAxisd(EIGEN_PI / 3, Vec3::Unit(axis)).toRotationMatrix();
  const Vec3 push = 0.2 * Vec3::Unit((axis + 1) % 3);
  std::vector<Index> held;
  for (Index v = 0; v < positions.rows(); ++v) {
    const double height = (positions(v, axis) - low[axis]) / extent[axis];
    if (height < 0.1 || height > 0.9) held.push_back(v);
  }
  Handles handles{held, Points(held.size(), 3)};
  for (std::size_t h = 0; h < held.size(); ++h) {
    const Vec3 rest = positions.row(held[h]).transpose();
    const bool upper = (rest[axis] - low[axis]) / extent[axis] > 0.5;
    handles.targets.row(h) = (upper ? Vec3(turn * rest + push) : rest).transpose();
  }
  return handles;
}

Points sidesOfCube() {
  Points normals(6, 3);
  normals << Mat3::Identity(), -Mat3::Identity();
  return normals;
}

/// Waves along two axes, their texture laid on from the third.
TextureSlopes waves(const TriangleMesh& mesh) {
  TextureSlopes texture{CornerPairs(3 * mesh.faceCount(), 2), CornerPairs(3 * mesh.faceCount(), 2)};
  for (Index corner = 0; corner < 3 * mesh.faceCount(); ++corner) {
    const auto point = mesh.positions.row(mesh.triangles.data()[corner]);
    for (int axis = 0; axis < 2; ++axis) {
      texture.uvs(corner, axis) = static_cast<float>(point[axis]);
      texture.slopes(corner, axis) = static_cast<float>(0.3 * std::sin(40 * point[axis]));
    }
  }
  return texture;
}

Status chooseParameters(Session& session, const Problem& problem) {
  if (problem.method == "cubic") return session.set("lambda", encoded(problem.plain.cubeness));
  if (problem.method == "normalmap") return session.set("image", encoded(waves(problem.mesh)));
  if (problem.method == "polycube") return session.set("directions", encoded(GaussMapData{.normals = sidesOfCube()}));
  if (problem.method != "analogy") return {};
  if (Status status = session.set("lambda", encoded(problem.plain.strength)); !status.ok()) return status;
  return session.set("style", encoded(GaussMapData{.normals = problem.plain.style}));
}

}  // namespace

const std::vector<std::string>& problemNames() {
  static const std::vector<std::string> names = {"cubic", "analogy", "arap", "normalmap", "developable", "polycube"};
  return names;
}

bool Problem::hasPlainPath() const { return method == "cubic" || method == "analogy" || method == "arap"; }

Problem readProblem(const std::string& method, const char* path) {
  Problem problem{method, inUnitFrame(readMesh(path)), {}};
  if (method == "cubic") {
    problem.plain.cubeness = 0.4;
  } else if (method == "analogy") {
    problem.plain.strength = 1;
    problem.plain.style = sidesOfCube();
  } else if (method == "arap") {
    problem.plain.handles = twist(problem.mesh.positions);
  }
  return problem;
}

Status open(Session& session, const Problem& problem) {
  if (Status status = session.load(problem.mesh); !status.ok()) return status;
  if (Status status = session.select(problem.method); !status.ok()) return status;
  if (Status status = chooseParameters(session, problem); !status.ok()) return status;
  if (!problem.hasPlainPath()) return {};
  if (Status status = session.set("tolerance", encoded(0)); !status.ok()) return status;
  if (Status status = session.set("maxIterations", encoded(1e6)); !status.ok()) return status;
  return session.set("handles", encoded(problem.plain.handles));
}

}  // namespace whittle::bench
