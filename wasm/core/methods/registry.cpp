#include "methods/registry.h"

#include "methods/alternating/reshape.h"
#include "methods/local_global/arap.h"
#include "methods/local_global/cubic/cubic.h"
#include "methods/local_global/normal_driven/analogy.h"
#include "methods/local_global/normal_driven/developable.h"
#include "methods/local_global/normal_driven/normal_map.h"
#include "methods/plastic/plastic.h"
#include "methods/polycube/polycube.h"
#include "methods/spherical/conformal_flow.h"

namespace whittle {

const std::vector<MethodInfo>& methodRegistry() {
  static const std::vector<MethodInfo> methods = {cubicMethod(),       analogyMethod(),   polycubeMethod(),
                                                  developableMethod(), normalmapMethod(), reshapeMethod(),
                                                  plasticMethod(),     arapMethod(),      sphericalMethod()};
  return methods;
}

const MethodInfo* findMethod(const std::string& id) {
  for (const MethodInfo& method : methodRegistry()) {
    if (id == method.id) return &method;
  }
  return nullptr;
}

std::string describeMethods() {
  return jsonList(methodRegistry(), [](const MethodInfo& method) {
    return Json().add("id", std::string(method.id)).addJson("parameters", method.defaults()->describe()).text();
  });
}

}  // namespace whittle
