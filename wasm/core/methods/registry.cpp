#include "methods/registry.h"

#include <cstdio>

#include "methods/local_global/arap.h"
#include "methods/local_global/cubic/cubic.h"
#include "methods/local_global/normal_driven/analogy.h"
#include "methods/local_global/normal_driven/developable.h"
#include "methods/local_global/normal_driven/normal_map.h"
#include "methods/polycube/polycube.h"
#include "methods/spherical/conformal_flow.h"

namespace whittle {

namespace {

constexpr const char* kKindNames[] = {"number", "integer", "choice", "flag",   "vector", "rotation",
                                      "scalars", "rotations", "style", "textureSlopes", "handles"};
constexpr const char* kStaleNames[] = {"nothing", "targets", "weights", "system", "all"};

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string repeated(double value, Index count) {
  std::string json = "[";
  for (Index k = 0; k < count; ++k) json += (k ? "," : "") + number(value);
  return json + "]";
}

std::string describe(const ParameterInfo& info) {
  std::string json = "{\"name\":" + quoted(info.name) + ",\"kind\":" + quoted(kKindNames[static_cast<int>(info.kind)]) +
                     ",\"invalidates\":" + quoted(kStaleNames[static_cast<int>(info.invalidates)]);
  if (info.kind == ParameterKind::choice) {
    json += ",\"default\":" + quoted(info.choices[static_cast<std::size_t>(info.defaultValue)]) + ",\"choices\":[";
    for (std::size_t c = 0; c < info.choices.size(); ++c) json += (c ? "," : "") + quoted(info.choices[c]);
    json += "]";
    if (info.count > 0) json += ",\"maxRows\":" + std::to_string(info.count);
  } else if (info.kind == ParameterKind::flag) {
    json += info.defaultValue != 0 ? ",\"default\":true" : ",\"default\":false";
  } else if (info.kind == ParameterKind::rotation) {
    json += ",\"default\":[0,0,0,1]";
  } else if (info.isNumber() || info.kind == ParameterKind::vector || info.kind == ParameterKind::scalars) {
    if (info.isNumber()) json += ",\"default\":" + number(info.defaultValue);
    if (info.kind == ParameterKind::vector) json += ",\"default\":" + repeated(info.defaultValue, info.count);
    json += ",\"min\":" + number(info.min) + ",\"max\":" + number(info.max);
  }
  return json + "}";
}

}  // namespace

const std::vector<MethodInfo>& methodRegistry() {
  static const std::vector<MethodInfo> methods = {cubicMethod(),     analogyMethod(), polycubeMethod(), developableMethod(),
                                                  normalmapMethod(), arapMethod(),    sphericalMethod()};
  return methods;
}

const MethodInfo* findMethod(const std::string& id) {
  for (const MethodInfo& method : methodRegistry()) {
    if (id == method.id) return &method;
  }
  return nullptr;
}

std::string describeMethods() {
  std::string json = "[";
  for (const MethodInfo& method : methodRegistry()) {
    if (json.size() > 1) json += ",";
    json += "{\"id\":" + quoted(method.id) + ",\"parameters\":[";
    for (std::size_t p = 0; p < method.parameters.size(); ++p) json += (p ? "," : "") + describe(method.parameters[p]);
    json += "]}";
  }
  return json + "]";
}

}  // namespace whittle
