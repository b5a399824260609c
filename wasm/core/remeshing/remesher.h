#pragma once

#include <array>
#include <memory>
#include <vector>

#include "remeshing/clean.h"

namespace whittle {

struct RemeshSettings {
  double edge = 0;           // length of edges where nothing curves, in the mesh's units
  double featureAngle = 35;  // degrees by which faces bend at a crease
  std::vector<std::array<Index, 2>> creases = {}, smoothEdges = {};  // pairs of vertices, marked by hand
};

/// Isotropic remeshing that keeps features: edges are split, collapsed and flipped and vertices smoothed until faces are
/// near equilateral and of one size, finer where the surface curves. Creases, borders and edges of three and more faces
/// stay on their own lines, to half a thousandth of the mesh's longest side; corners stay in place; all else stays on the
/// surface. Parts stay apart. Goes slice by slice.
class Remesher {
 public:
  /// @param mesh without slivers (see `clean`), to be kept by the caller until the end
  Remesher(const TriangleMesh& mesh, RemeshSettings settings);
  ~Remesher();

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  /// What came of it, once all is done; what it left of slivers is mended as far as that can be.
  CleanMesh take();

 private:
  struct Pass {
    enum class Kind { measure, grade, split, collapse, flip, smooth } kind;
    double scale = 1;
  };
  struct Shape;  // what is known of the mesh

  void study();  // a piece of it
  void plan();
  void work();
  /// Elements that the pass goes over.
  Index count(const Pass& pass) const;
  void apply(const Pass& pass, Index element);

  const TriangleMesh& mesh_;
  RemeshSettings settings_;
  std::unique_ptr<Shape> shape_;
  std::vector<Pass> passes_;
  std::size_t pass_ = 0;
  Index next_ = 0, end_ = 0;  // element of the pass
};

}  // namespace whittle
