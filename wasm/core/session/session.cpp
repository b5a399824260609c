#include "session/session.h"

#include <algorithm>

namespace whittle {

Status Session::load(TriangleMesh mesh) {
  *this = Session();
  Status status = validate(mesh);
  if (!status.ok()) return status;

  report_ = inspect(mesh);
  filePositions_ = mesh.positions;
  frame_ = UnitFrame::of(mesh.positions);
  rest_ = std::move(mesh);
  for (Index v = 0; v < rest_.vertexCount(); ++v) {
    rest_.positions.row(v) = frame_.toUnit(filePositions_.row(v).transpose()).transpose();
  }
  restart();
  return {};
}

Status Session::select(const std::string& method) {
  if (rest_.faceCount() == 0) return Status::failure(Code::noFaces, "no mesh is loaded");
  const MethodInfo* info = findMethod(method);
  if (!info) return Status::failure(Code::unknownMethod, "there is no method \"" + method + "\"");
  if (info == info_) return {};
  info_ = info;
  method_ = info->create();
  settings_ = Settings::defaults(info->parameters);
  stale_ = Stale::all;
  return {};
}

Status Session::requireMethod() const {
  return info_ ? Status{} : Status::failure(Code::unknownMethod, "no method is chosen");
}

Status Session::setNumber(const std::string& parameter, double value) {
  if (Status status = requireMethod(); !status.ok()) return status;
  for (std::size_t p = 0; p < info_->parameters.size(); ++p) {
    const ParameterInfo& info = info_->parameters[p];
    if (parameter != info.name || info.kind == ParameterKind::handles) continue;
    Status status = validateNumber(info, value);
    if (!status.ok() || settings_.numbers[p] == value) return status;
    settings_.numbers[p] = value;
    markStale(info.invalidates);
    return {};
  }
  return Status::failure(Code::badParameter, std::string(info_->id) + " has no parameter \"" + parameter + "\"");
}

Status Session::setHandles(Handles handles) {
  if (Status status = requireMethod(); !status.ok()) return status;
  Status status = validateHandles(handles, rest_.vertexCount());
  if (!status.ok()) return status;
  for (Index h = 0; h < handles.targets.rows(); ++h) {
    handles.targets.row(h) = frame_.toUnit(handles.targets.row(h).transpose()).transpose();
  }
  // Other targets for the same vertices leave the factorization as it is.
  markStale(handles.vertices == settings_.handles.vertices ? Stale::targets : Stale::system);
  settings_.handles = std::move(handles);
  return {};
}

void Session::restart() { positions_ = rest_.positions; }

Status Session::prepare() {
  if (Status status = requireMethod(); !status.ok()) return status;
  Status status = method_->prepare(rest_, settings_, stale_);
  if (!status.ok()) return status;
  stale_ = Stale::nothing;
  method_->begin(positions_);
  return {};
}

Status Session::step(StepReport& report) {
  if (Status status = requireMethod(); !status.ok()) return status;
  if (stale_ != Stale::nothing) {
    if (Status status = prepare(); !status.ok()) return status;
  }
  return method_->step(positions_, report);
}

void Session::copyPositions(double* into) const {
  Eigen::Map<Points> out(into, positions_.rows(), 3);
  for (Index v = 0; v < positions_.rows(); ++v) {
    if (positions_.row(v) == rest_.positions.row(v)) {
      out.row(v) = filePositions_.row(v);
    } else {
      out.row(v) = frame_.toFile(positions_.row(v).transpose()).transpose();
    }
  }
}

}  // namespace whittle
