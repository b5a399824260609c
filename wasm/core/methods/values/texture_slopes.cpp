#include "methods/values/texture_slopes.h"

namespace whittle {

Status TextureSlopesKind::read(const RawValue& raw, const MeshContext& mesh, Value& value) const {
  if (!raw.isNumbers(raw.numbers.size() / 4 * 4))
    return raw.refused("must have two coordinates and two slopes for each corner");
  using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
  const Eigen::Index corners = static_cast<Eigen::Index>(raw.numbers.size() / 4);
  TextureSlopes texture{Eigen::Map<const Pairs>(raw.numbers.data(), corners, 2).cast<float>(),
                        Eigen::Map<const Pairs>(raw.numbers.data() + 2 * corners, corners, 2).cast<float>()};
  if (value && *value == texture) return {};
  if (Status status = validateTextureSlopes(texture, mesh.faceCount); !status.ok()) return status;
  value = std::make_shared<const TextureSlopes>(std::move(texture));
  return {};
}

EncodedValue encoded(const TextureSlopes& texture) { return EncodedValue().append(texture.uvs).append(texture.slopes); }

}  // namespace whittle
