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
  const auto nameOf = [](Field::Per per) {
    constexpr const char* kNames[] = {"vertex", "face", "line"};
    return std::string(kNames[static_cast<int>(per)]);
  };
  return jsonList(fields, [&](const Field& field) {
    Json json;
    json.add("name", std::string(field.name))
        .add("label", std::string(field.label))
        .add("per", nameOf(field.per))
        .add("unit", std::string(field.unit));
    if (field.per == Field::Per::line) json.add("count", field.count);
    return json.text();
  });
}

}  // namespace whittle
