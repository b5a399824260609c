#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <vector>

#include "methods/stale.h"
#include "methods/values/kinds.h"

namespace whittle {

/// What a kind of value has to offer. Where it belongs to vertices it has `order(const VertexOrder&, Value&)` too, and
/// where more is to be said than that different values make stale what the parameter invalidates, `changed(before, now,
/// invalidates)`.
template <typename Kind>
concept ValueKind = requires(const Kind& kind, const RawValue& raw, const MeshContext& mesh,
                             typename Kind::Value& value, Json& json) {
  { Kind::kName } -> std::convertible_to<const char*>;
  { kind.read(raw, mesh, value) } -> std::same_as<Status>;
  kind.describe(value, json);
};

/// A kind of value whatever its type: values go by their addresses, so that the code of a kind is there once and not
/// for each parameter of each method, which would be half the module.
class AnyKind {
 public:
  virtual ~AnyKind() = default;

  /// Reads a value, or takes the usual one. Fails as the kind does; the value is then as it was.
  /// @param invalidates what a change of the parameter makes stale
  /// @param made out: what this change does
  virtual Status set(void* value, const void* usual, const RawValue& raw, const MeshContext& mesh, Stale invalidates,
                     Stale& made) const = 0;
  virtual void order(void* value, const VertexOrder& order) const = 0;
  virtual const char* name() const = 0;
  virtual void describe(const void* usual, Json& json) const = 0;
};

template <ValueKind Kind>
class KindOf final : public AnyKind {
 public:
  using Value = typename Kind::Value;

  explicit KindOf(Kind kind) : kind_(std::move(kind)) {}

  Status set(void* value, const void* usual, const RawValue& raw, const MeshContext& mesh, Stale invalidates,
             Stale& made) const override {
    Value& present = *static_cast<Value*>(value);
    Value next = raw.isEmpty() ? *static_cast<const Value*>(usual) : present;
    if (!raw.isEmpty()) {
      if (Status status = kind_.read(raw, mesh, next); !status.ok()) return status;
    }
    if constexpr (requires { kind_.changed(present, next, invalidates); }) {
      made = kind_.changed(present, next, invalidates);
    } else {
      made = present == next ? Stale::nothing : invalidates;
    }
    present = std::move(next);
    return {};
  }
  void order(void* value, const VertexOrder& order) const override {
    if constexpr (requires(Value & v) { kind_.order(order, v); }) kind_.order(order, *static_cast<Value*>(value));
  }
  const char* name() const override { return Kind::kName; }
  void describe(const void* usual, Json& json) const override {
    kind_.describe(*static_cast<const Value*>(usual), json);
  }

 private:
  Kind kind_;
};

/// One parameter of the methods whose parameters are a P: the line that binds a name to a member, what a change of it
/// makes stale and the kind of its value. Its default is the member's initialiser.
template <typename P>
struct Parameter {
  const char* name;
  std::ptrdiff_t offset;  // of the member, in bytes
  Stale invalidates;
  std::shared_ptr<const AnyKind> kind;
};

template <typename P>
using ParameterList = std::vector<Parameter<P>>;

/// Where a member lies in a P.
template <typename P, typename Member>
std::ptrdiff_t offsetOf(Member P::*member) {
  const P values{};
  return reinterpret_cast<const char*>(&(values.*member)) - reinterpret_cast<const char*>(&values);
}

template <typename P, typename Value, ValueKind Kind>
requires std::same_as<Value, typename Kind::Value> Parameter<P> bind(const char* name, Value P::*member,
                                                                     Stale invalidates, Kind kind) {
  return {name, offsetOf(member), invalidates, std::make_shared<KindOf<Kind>>(std::move(kind))};
}

/// The parameters of a method, with those of a group that it has as a member behind its own.
template <typename P, typename Group>
ParameterList<P> withGroup(ParameterList<P> own, Group P::*member, const ParameterList<Group>& group) {
  for (const auto& [name, offset, invalidates, kind] : group)
    own.push_back({name, offsetOf(member) + offset, invalidates, kind});
  return own;
}

}  // namespace whittle
