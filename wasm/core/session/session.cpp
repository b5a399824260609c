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

template <typename Fits>
Status Session::find(const std::string& parameter, Fits fits, std::size_t& place) const {
  if (Status status = requireMethod(); !status.ok()) return status;
  for (place = 0; place < info_->parameters.size(); ++place) {
    const ParameterInfo& info = info_->parameters[place];
    if (parameter == info.name && fits(info)) return {};
  }
  return Status::failure(Code::badParameter, std::string(info_->id) + " has no parameter \"" + parameter + "\" of this kind");
}

Status Session::setNumber(const std::string& parameter, double value) {
  std::size_t p;
  if (Status status = find(parameter, [](const auto& info) { return info.isNumber(); }, p); !status.ok()) return status;
  const ParameterInfo& info = info_->parameters[p];
  Status status = validateNumber(info, value);
  if (!status.ok() || settings_.numbers[p] == value) return status;
  settings_.numbers[p] = value;
  markStale(info.invalidates);
  return {};
}

Status Session::setScalars(const std::string& parameter, const Scalars& values) {
  std::size_t p;
  if (Status status = find(parameter, [](const auto& info) { return info.isScalars(); }, p); !status.ok()) return status;
  const ParameterInfo& info = info_->parameters[p];
  Status status = validateScalars(info, values, rest_.vertexCount());
  if (!status.ok()) return status;
  Scalars& present = settings_.scalars[p];
  if (present.size() == values.size() && present == values) return {};
  present = values;
  markStale(info.invalidates);
  return {};
}

Status Session::setStyle(const std::string& parameter, const std::optional<GaussMapData>& data) {
  std::size_t p;
  const auto fits = [](const auto& info) { return info.kind == ParameterKind::style; };
  if (Status status = find(parameter, fits, p); !status.ok()) return status;
  const bool isSame = settings_.style ? data && settings_.style->data() == *data : !data;
  if (isSame) return {};
  if (data) {
    if (Status status = validateGaussMap(*data); !status.ok()) return status;
  }
  settings_.style = data ? std::make_shared<const GaussMap>(*data) : nullptr;
  markStale(info_->parameters[p].invalidates);
  return {};
}

Status Session::setTextureSlopes(const std::string& parameter, std::optional<TextureSlopes> slopes) {
  std::size_t p;
  const auto fits = [](const auto& info) { return info.kind == ParameterKind::textureSlopes; };
  if (Status status = find(parameter, fits, p); !status.ok()) return status;
  const bool isSame = settings_.textureSlopes ? slopes && *settings_.textureSlopes == *slopes : !slopes;
  if (isSame) return {};
  if (slopes) {
    if (Status status = validateTextureSlopes(*slopes, rest_.faceCount()); !status.ok()) return status;
  }
  settings_.textureSlopes = slopes ? std::make_shared<const TextureSlopes>(std::move(*slopes)) : nullptr;
  markStale(info_->parameters[p].invalidates);
  return {};
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

void Session::orderVertices() {
  vertexOrder_ = VertexOrder::of(rest_);
  rest_ = vertexOrder_.ordered(rest_);
  restart();
}

Status Session::prepare() {
  if (Status status = requireMethod(); !status.ok()) return status;
  if (stale_ == Stale::all && info_->acceptsMesh) {
    if (Status status = info_->acceptsMesh(vertexOrder_.inFileOrder(rest_)); !status.ok()) return status;
  }
  if (vertexOrder_.isFileOrder()) orderVertices();
  Status status = method_->prepare(rest_, vertexOrder_.ordered(settings_, info_->parameters), stale_);
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
