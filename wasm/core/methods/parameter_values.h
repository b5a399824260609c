#pragma once

#include <memory>
#include <string>
#include <vector>

#include "methods/parameter.h"

namespace whittle {

/// The values of a method's parameters, whatever struct they are in.
class ParameterValues {
 public:
  virtual ~ParameterValues() = default;

  /// Sets one. Fails with `badParameter` where there is none of this name, or as its kind does.
  /// @param made out: what that makes stale
  Status set(const std::string& parameter, const RawValue& raw, const MeshContext& mesh, Stale& made);

  /// Becomes values of the same method with what belongs to vertices put into their order.
  void takeOrdered(const ParameterValues& values, const VertexOrder& order);

  /// The parameters, for TypeScript to hold against its descriptors: [{"name", "kind", "invalidates", "default", "min",
  /// "max", "choices", "maxRows"}], each only where it applies.
  std::string describe() const;

 protected:
  /// A parameter of a struct that is known by its address only.
  using Bound = Parameter<void>;

  explicit ParameterValues(std::vector<Bound> parameters) : parameters_(std::move(parameters)) {}

  virtual char* address() = 0;
  virtual const char* usualAddress() const = 0;
  virtual void assign(const ParameterValues& values) = 0;

 private:
  std::vector<Bound> parameters_;
};

/// Values of the parameters that are bound to a P.
template <typename P>
class BoundValues final : public ParameterValues {
 public:
  explicit BoundValues(const ParameterList<P>& parameters) : ParameterValues(erased(parameters)) {}

  const P& values() const { return values_; }

 private:
  static std::vector<Bound> erased(const ParameterList<P>& parameters) {
    std::vector<Bound> list;
    for (const auto& [name, offset, invalidates, kind] : parameters) list.push_back({name, offset, invalidates, kind});
    return list;
  }

  char* address() override { return reinterpret_cast<char*>(&values_); }
  const char* usualAddress() const override { return reinterpret_cast<const char*>(&usual_); }
  void assign(const ParameterValues& values) override { values_ = static_cast<const BoundValues&>(values).values_; }

  P values_;
  const P usual_{};
};

}  // namespace whittle
