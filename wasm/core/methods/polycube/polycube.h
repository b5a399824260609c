#pragma once

#include <memory>
#include <optional>

#include "constraints/contact_search.h"
#include "constraints/gauge.h"
#include "geometry/cotangent.h"
#include "geometry/smooth_fans.h"
#include "linear/sparse_cholesky.h"
#include "methods/method.h"
#include "methods/parts.h"
#include "methods/polycube/ring_smoothing.h"
#include "methods/stopping_rule.h"
#include "targets/gauss_map.h"

namespace whittle {

struct PolyCubeParameters {
  std::shared_ptr<const GaussMap> directions;  // what normals turn to; has to be given
  double lambda = 1;                           // λ, Eq. 4
  double smoothing = 0.2;                      // share of the way by which corners of bad triangles are smoothed, §5.1
  int maxIterations = 50;
  Parts parts = Parts::together;  // whether those that touch are tied
};

/// PolyCube deformation and its kin for other sets of directions (2021, §5.1): face normals turn to the closest of a
/// few directions, and nothing keeps the details of the input, because every iteration starts anew from what the last
/// one left as its rest shape:
///
///     min over R, u of Σ_f Σ_{e∈f} c_e |R_f d_e − u_e|² + λ a_f |R_f n_f − t_f|²  (FARAP, Eq. 4)
///
/// with edges d, cotangents, normals, areas and targets t_f of the present shape, t_f the closest direction to what the
/// normals of a face and of its corners say together. There the local step has a closed form; the global one factors the
/// present Laplacian on the pattern of the input's. Parts that touch are tied by `Attachments`, which pull towards the
/// distances that the input has. Each part, or tied group, keeps its centre.
/// Normals soon lie right and the shape still drifts, so the number of iterations says when to stop.
class PolyCube : public MethodOf<PolyCubeParameters> {
 public:
  Status check(const PolyCubeParameters& values) const override;
  std::vector<Stage> plan(const TriangleMesh& rest, const PolyCubeParameters& values, Stale stale) override;
  /// Every run starts from the rest shape: where it ends depends on the way.
  void begin(Points& positions) override;
  Status step(Points& positions, StepReport& report) override;

 private:
  void measure(const TriangleMesh& rest);
  void findContacts(double& done);
  void beginSystem(Parts parts);
  void analyzeSystem(double& done);
  /// The present Laplacian, with the ties.
  const SparseMatrix& system();
  /// Turns every face as far to its target as its edges let it: collects what that asks of the vertices; returns the
  /// energy.
  double rotateFaces(const Points& positions);
  /// What of a face with normal n is looked up among the directions: n and the normals of its corners' smooth fans together. One that
  /// looks another way than all around it would pull a tab or a notch out of them that no iteration takes back.
  Vec3 aroundFace(Index f, const Vec3& n) const;
  /// Moves the vertices to the minimum for these rotations.
  Status globalStep(Points& positions);
  double relativeDisplacement(const Points& positions) const;

  PolyCubeParameters values_;
  StoppingRule stopping_;

  // Prepared once per mesh
  const TriangleMesh* rest_ = nullptr;
  Components components_;
  std::unique_ptr<ContactSearch> contactSearch_;  // while it goes on
  Attachments contacts_;

  // Prepared once for what parts do
  Attachments attachments_;  // the contacts, or none where parts are free
  SparseMatrix ties_;        // their lower triangle, if there are any
  SparseMatrix tiedSystem_;
  std::optional<Gauge> gauge_;
  std::optional<LaplacianPattern> laplacian_;
  SparseCholesky cholesky_;
  RingSmoothing ringSmoothing_;
  SmoothFans fans_;

  // What the present shape says
  CornerScalars halfCotangents_;
  Points moves_;       // #V×3: what the rotations ask for, then by how much the vertices move
  Points fanNormals_;  // #fans×3
  Scalars fanAreas_;   // #fans, scratch
  Points previous_;
  Points displacements_;  // from rest
};

/// Rotation change R − I of a face with unit normal n that is drawn to the unit normal t: R about n × t maximises
/// tr(R (I − n nᵀ)) + λ tᵀ R n. Exactly zero where n is t or λ is 0; also where t is −n, from which no way leads.
Mat3 rotationChangeToward(const Vec3& n, const Vec3& t, double lambda);

/// Registry line of the method `polycube`.
MethodInfo polycubeMethod();

}  // namespace whittle
