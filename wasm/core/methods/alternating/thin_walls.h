#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/box_tree.h"
#include "methods/alternating/point_rows.h"
#include "methods/alternating/rest_surface.h"

namespace whittle {

/// Two plane sides of a shape that lie close behind each other, such as the faces of a plate, an arm or a floor. No term
/// of the energy knows of the other side, so nothing but these keeps a wall that is pulled along as thick as it is.
struct ThinWall {
  Index sides[2];  // plane sides, by their numbers
  Vec3 normal;     // of the first
};

/// The middle of a face and the point of the other side that lies behind it.
struct WallTie {
  Index wall;
  Index face, behind;
  Vec3 weights;  // of the point, in the face behind
};

/// How thick a shape is at the middle of a face, whether it is flat there or not.
struct ThicknessProbe {
  Index face, behind;
  Vec3 weights;  // of the point behind, in the face there
};

struct ThinWalls {
  std::vector<Index> sideOf;  // #F, the plane side that each face is of
  std::vector<ThinWall> walls;
  std::vector<WallTie> ties;
  std::vector<ThicknessProbe> probes;  // of some faces, where it is thin
};

/// Finds thin walls: from the middle of each face straight through, the first face met must be of a plane side that looks
/// the other way, within 3°, nearer than half of what either side measures. Goes slice by slice.
class ThinWallSearch {
 public:
  /// @param surface in the unit frame, to be kept by the caller until the end
  explicit ThinWallSearch(const RestSurface& surface);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  ThinWalls take() { return std::move(result_); }

 private:
  void joinSides();
  struct Behind {
    Index face = -1;  // none within reach
    double distance;
    Vec3 weights;
  };
  /// What is met first from the middle of a face straight through.
  Behind lookThrough(Index face, double reach) const;
  void tie(Index face);
  void probe(Index face);
  Index wallOf(Index side, Index behind, const Vec3& normal);

  const RestSurface& surface_;
  ThinWalls result_;
  std::vector<double> extents_;  // of each side, the root of its area; by the first face's number
  std::vector<std::vector<Index>> wallsOfSide_;
  std::unique_ptr<BoxTree> tree_;
  bool isTreeGrown_ = false;
  Index next_ = 0;
};

/// Sides of which handles ask so different moves, across a wall in the unit frame, are moved apart or together.
constexpr double kMovedApart = 1e-3;

/// Which walls are to stay as thick as they are, one flag each: not those whose sides handles move apart or together.
std::vector<bool> keptWalls(const ThinWalls& walls, const RestSurface& surface, const std::vector<PointRow>& handles);

/// Rows that keep these walls' thickness.
void addWallRows(const ThinWalls& walls, const std::vector<bool>& kept, const RestSurface& surface,
                 std::vector<PointRow>& rows);

}  // namespace whittle
