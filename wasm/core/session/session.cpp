#include "session/session.h"

#include <algorithm>

namespace whittle {

Status Session::load(TriangleMesh mesh, std::vector<Index> sourceVertices, std::vector<Index> sourceFaces) {
  *this = Session();
  sourceVertices_ = std::move(sourceVertices);
  sourceFaces_ = std::move(sourceFaces);
  Status status = validate(mesh);
  if (!status.ok()) return inFileNumbers(status);

  report_ = inspect(mesh);
  filePositions_ = mesh.positions;
  frame_ = UnitFrame::of(mesh);
  rest_ = std::move(mesh);
  for (Index v = 0; v < rest_.vertexCount(); ++v) {
    rest_.positions.row(v) = frame_.toUnit(filePositions_.row(v).transpose()).transpose();
    // Only a vertex without a face: it stays where it is, whatever that is.
    if (!rest_.positions.row(v).allFinite()) rest_.positions.row(v).setZero();
  }
  restart();
  return {};
}

Status Session::inFileNumbers(const Status& status) const {
  if (status.ok() || status.element.kind == Element::Kind::none) return status;
  const std::vector<Index>& source = status.element.kind == Element::Kind::vertex ? sourceVertices_ : sourceFaces_;
  const Index index = status.element.index;
  const bool isMapped = index >= 0 && index < static_cast<Index>(source.size());
  return status.numbered(isMapped ? source[index] : index);
}

Status Session::select(const std::string& method) {
  if (rest_.faceCount() == 0) return Status::failure(Code::noFaces, "no mesh is loaded");
  const MethodInfo* info = findMethod(method);
  if (!info) return Status::failure(Code::unknownMethod, "there is no method \"" + method + "\"");
  if (info == info_) return {};
  preparation_.reset();
  info_ = info;
  method_ = info->create();
  values_ = info->defaults();
  ordered_ = info->defaults();
  isOrderedOld_ = true;
  stale_ = Stale::all;
  return {};
}

Status Session::requireMethod() const {
  return info_ ? Status{} : Status::failure(Code::unknownMethod, "no method is chosen");
}

Status Session::set(const std::string& parameter, const RawValue& value) {
  if (Status status = requireMethod(); !status.ok()) return status;
  Stale made = Stale::nothing;
  const Status status =
      values_->set(parameter, value, {rest_.vertexCount(), rest_.faceCount(), frame_, &filePositions_}, made);
  if (!status.ok()) return inFileNumbers(status);
  if (made != Stale::nothing) markStale(made);
  return {};
}

void Session::markStale(Stale level) {
  isOrderedOld_ = true;
  // What a preparation has not come to it reads when it does.
  if (preparation_ && level >= preparation_->stale()) preparation_.reset();
  stale_ = std::max(stale_, level);
}

void Session::restart() { positions_ = rest_.positions; }

void Session::orderVertices(double& done) {
  if (!ordering_) {
    ordering_ = std::make_unique<VertexOrdering>(rest_);
    done = 0;
    return;
  }
  done = ordering_->next();
  if (done < 1) return;
  vertexOrder_ = ordering_->take();
  ordering_.reset();
  rest_ = vertexOrder_.ordered(rest_);
  positions_ = vertexOrder_.orderedRows(positions_);
  isOrderedOld_ = true;
}

Status Session::acceptMesh() const { return info_->acceptsMesh(vertexOrder_.asLoaded(rest_)); }

void Session::beginPreparing() {
  Plan plan(stale_);
  if (info_->acceptsMesh) plan.add(Stale::all, "checking the mesh", 5, [this](double&) { return acceptMesh(); });
  if (vertexOrder_.isAsLoaded())
    plan.add(Stale::all, "ordering the vertices", 40, [this](double& done) { orderVertices(done); });
  preparation_.emplace(plan.add(method_->plan(rest_, *ordered_, stale_)).stages());
}

Status Session::refreshValues() {
  if (!isOrderedOld_) return {};
  if (Status status = method_->check(*values_); !status.ok()) return status;
  ordered_->takeOrdered(*values_, vertexOrder_);
  isOrderedOld_ = false;
  return {};
}

Status Session::prepareNext(double& share) {
  share = 0;
  if (Status status = requireMethod(); !status.ok()) return status;
  if (stale_ != Stale::nothing) {
    if (Status status = refreshValues(); !status.ok()) return inFileNumbers(status);
    if (!preparation_) beginPreparing();
    if (Status status = preparation_->advance(); !status.ok()) {
      preparation_.reset();
      return inFileNumbers(status);
    }
    stale_ = preparation_->stale();
    share = preparation_->share();
    if (!preparation_->isDone()) return {};
    preparation_.reset();
  }
  share = 1;
  method_->begin(positions_);
  return {};
}

Status Session::prepare() {
  double share = 0;
  while (share < 1) {
    if (Status status = prepareNext(share); !status.ok()) return status;
  }
  return {};
}

const char* Session::stage() {
  if (!info_ || stale_ == Stale::nothing) return "";
  if (!preparation_) {
    if (!refreshValues().ok()) return "";  // `prepareNext` says why
    beginPreparing();
  }
  return preparation_->doing();
}

Status Session::step(StepReport& report) {
  if (Status status = requireMethod(); !status.ok()) return status;
  if (stale_ != Stale::nothing) {
    if (Status status = prepare(); !status.ok()) return status;
  }
  return method_->step(positions_, report);
}

std::vector<std::string> Session::warnings() const {
  return info_ ? method_->warnings(*values_) : std::vector<std::string>{};
}

std::vector<Field> Session::fields() const {
  return info_ && stale_ == Stale::nothing ? method_->fields() : std::vector<Field>{};
}

Status Session::copyField(const std::string& name, double* into) const {
  for (const Field& field : fields()) {
    if (name != field.name) continue;
    const bool isPerVertex = field.per == Field::Per::vertex, isOfLines = field.per == Field::Per::line;
    Scalars values(isPerVertex ? rest_.vertexCount() : isOfLines ? 2 * field.count : rest_.faceCount());
    field.write(values);
    if (isPerVertex) values = vertexOrder_.rowsAsLoaded(values);
    if (isOfLines) {
      for (double& vertex : values) vertex = vertexOrder_.vertexAt(static_cast<Index>(vertex));
    }
    Eigen::Map<Scalars>(into, values.size()) = values;
    return {};
  }
  return Status::failure(Code::badParameter, "there is no field \"" + name + "\" to show");
}

void Session::copyPositions(double* into) const {
  Eigen::Map<Points> out(into, positions_.rows(), 3);
  for (Index place = 0; place < positions_.rows(); ++place) {
    const Index v = vertexOrder_.vertexAt(place);
    if (positions_.row(place) == rest_.positions.row(place)) {
      out.row(v) = filePositions_.row(v);
    } else {
      out.row(v) = frame_.toFile(positions_.row(place).transpose()).transpose();
    }
  }
}

}  // namespace whittle
