#include "methods/method.h"

namespace whittle {

const char* outcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::running: return "running";
    case Outcome::midway: return "midway";
    case Outcome::converged: return "converged";
    case Outcome::iterationLimit: return "iteration-limit";
    case Outcome::stalled: return "stalled";
  }
  return "running";
}

std::string describeFields(const std::vector<Field>& fields) {
  return jsonList(fields, [](const Field& field) {
    return Json()
        .add("name", std::string(field.name))
        .add("label", std::string(field.label))
        .add("per", std::string(field.per == Field::Per::vertex ? "vertex" : "face"))
        .add("unit", std::string(field.unit))
        .text();
  });
}

}  // namespace whittle
