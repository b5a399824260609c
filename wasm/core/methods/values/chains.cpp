#include "methods/values/chains.h"

namespace whittle {

Status ChainsKind::read(const RawValue& raw, const MeshContext& mesh, VertexChains& value) const {
  VertexChains chains;
  std::size_t first = 0;
  while (first < raw.indices.size() && raw.indices[first] >= 0) {
    const std::size_t end = first + 1 + static_cast<std::size_t>(raw.indices[first]);
    if (end > raw.indices.size()) break;
    chains.emplace_back(raw.indices.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                        raw.indices.begin() + static_cast<std::ptrdiff_t>(end));
    first = end;
  }
  if (raw.hasName() || first != raw.indices.size() || !raw.numbers.empty())
    return raw.refused("must have for each line its count of vertices and these");
  for (const std::vector<Index>& chain : chains) {
    for (const Index v : chain) {
      if (v < 0 || v >= mesh.vertexCount)
        return Status::failure(Code::badParameter, "a line goes through vertex {}, which does not exist",
                               Element::vertex(v));
    }
  }
  value = std::move(chains);
  return {};
}

void ChainsKind::order(const VertexOrder& order, VertexChains& value) const {
  for (std::vector<Index>& chain : value) {
    for (Index& v : chain) v = order.placeOf(v);
  }
}

EncodedValue encoded(const VertexChains& chains) {
  EncodedValue value;
  for (const std::vector<Index>& chain : chains) {
    value.indices.push_back(static_cast<Index>(chain.size()));
    value.indices.insert(value.indices.end(), chain.begin(), chain.end());
  }
  return value;
}

}  // namespace whittle
