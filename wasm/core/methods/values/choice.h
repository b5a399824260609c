#pragma once

#include "base/json.h"
#include "methods/values/raw_value.h"

namespace whittle {

/// The names of an enum's values, in the order in which people are offered them.
template <typename Enum>
using Choices = std::vector<std::pair<const char*, Enum>>;

/// One of several named ways: its name.
template <typename Enum>
struct ChoiceKind {
  using Value = Enum;
  static constexpr const char* kName = "choice";
  Choices<Enum> choices;

  Status read(const RawValue& raw, const MeshContext&, Enum& value) const {
    for (const auto& [name, choice] : choices) {
      if (!raw.numbers.empty() || !raw.indices.empty() || std::string(name) != raw.name) continue;
      value = choice;
      return {};
    }
    return raw.refused("must be one of " + names());
  }

  void describe(Enum usual, Json& json) const {
    for (const auto& [name, choice] : choices) {
      if (choice == usual) json.add("default", std::string(name));
    }
    json.addJson("choices", jsonList(choices, [](const auto& choice) { return jsonString(choice.first); }));
  }

 private:
  std::string names() const {
    std::string list;
    for (const auto& choice : choices) list += (list.empty() ? "" : ", ") + std::string(choice.first);
    return list;
  }
};

}  // namespace whittle
