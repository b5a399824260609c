#pragma once

#include "constraints/attachments.h"
#include "constraints/straight_chains.h"
#include "methods/alternating/reshape_run.h"
#include "remeshing/scaffold.h"
#include "remeshing/transfer.h"

namespace whittle {

/// The row of a handle on a vertex of the input, as it lies on the working mesh. With the place of the vertex at rest for
/// target, its residual at rest is how far off the working mesh the vertex lies.
PointRow handleRow(const TriangleMesh& input, const DerivedMesh& working, const Transfer& transfer, Index vertex);

/// How chains are kept straight. What is found may bend by 2° at rest, and must not jump as soon as something moves.
struct Straightness {
  bool asAtRest = false;  // as straight as they are, and not straighter
  /// Whether only what is across a chain counts (Eq. 22 counts all). All holds each chain to an even stretch over its
  /// whole length: half a bar could not be held while its end is pulled.
  bool isAcross = true;
};

/// Rows that keep chains of the working mesh's vertices straight.
void addStraightRows(const VertexChains& chains, const Straightness& straightness, const RestSurface& surface,
                     std::vector<PointRow>& rows);
/// Rows that keep parts that touch in touch.
void addAttachmentRows(const std::vector<Attachment>& attachments, const Points& rest, std::vector<PointRow>& rows);
/// Rows that keep the edges of a scaffold, weakly.
void addScaffoldRows(const Scaffold& scaffold, const Points& rest, std::vector<PointRow>& rows);
/// Rows that hold a vertex of each part that nothing ties to a handle where it is.
void addPins(const RestSurface& surface, const std::vector<PointRow>& handles, std::vector<PointRow>& rows);

}  // namespace whittle
