#include "methods/parameter_values.h"

namespace whittle {

Status ParameterValues::set(const std::string& parameter, const RawValue& raw, const MeshContext& mesh, Stale& made) {
  for (const Bound& bound : parameters_) {
    if (parameter != bound.name) continue;
    RawValue named = raw;
    named.parameter = bound.name;
    return bound.kind->set(address() + bound.offset, usualAddress() + bound.offset, named, mesh, bound.invalidates,
                           made);
  }
  return Status::failure(Code::badParameter, "there is no parameter \"" + parameter + "\"");
}

void ParameterValues::takeOrdered(const ParameterValues& values, const VertexOrder& order) {
  assign(values);
  for (const Bound& bound : parameters_) bound.kind->order(address() + bound.offset, order);
}

std::string ParameterValues::describe() const {
  return jsonList(parameters_, [&](const Bound& bound) {
    Json json;
    json.add("name", std::string(bound.name)).add("kind", std::string(bound.kind->name()));
    json.add("invalidates", std::string(staleName(bound.invalidates)));
    bound.kind->describe(usualAddress() + bound.offset, json);
    return json.text();
  });
}

}  // namespace whittle
