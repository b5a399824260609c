// What a method's struct, its lines and the kinds of its values make of what comes in from outside.
#include <doctest/doctest.h>

#include <limits>

#include "methods/parameter_values.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

enum class Colour { red, green };

struct Group {
  int count = 7;
};

/// One of each kind.
struct Everything {
  double number = 0.5;
  bool flag = true;
  Colour colour = Colour::green;
  NameOrRows<Colour> matrix;
  Eigen::Vector2d pair{1, 2};
  Quaternion rotation = kIdentityQuaternion;
  Scalars scalars;
  Quaternions rotations;
  std::shared_ptr<const GaussMap> style;
  std::shared_ptr<const TextureSlopes> texture;
  std::shared_ptr<const SphereField> field;
  Handles handles;
  Planes planes;
  Group group{9};
};

ParameterList<Everything> everything() {
  using P = Everything;
  const ChoiceKind<Colour> colours{{{"red", Colour::red}, {"green", Colour::green}}};
  return withGroup<P, Group>(
      {bind("number", &P::number, Stale::weights, NumberKind{{0, 1}}),
       bind("flag", &P::flag, Stale::targets, FlagKind{}), bind("colour", &P::colour, Stale::all, colours),
       bind("matrix", &P::matrix, Stale::weights, ChoiceOrRowsKind<Colour>{colours, 2}),
       bind("pair", &P::pair, Stale::weights, VectorKind<2>{{0, 10}}),
       bind("rotation", &P::rotation, Stale::weights, RotationKind{}),
       bind("scalars", &P::scalars, Stale::weights, ScalarsKind{{0, 10}}),
       bind("rotations", &P::rotations, Stale::weights, RotationsKind{}),
       bind("style", &P::style, Stale::weights, StyleKind{}),
       bind("texture", &P::texture, Stale::weights, TextureSlopesKind{}),
       bind("field", &P::field, Stale::weights, SphereFieldKind{}),
       bind("handles", &P::handles, Stale::system, HandlesKind{}),
       bind("planes", &P::planes, Stale::system, PlanesKind{})},
      &P::group, {bind("count", &Group::count, Stale::targets, IntegerKind{{0, 20}})});
}

/// Values of everything on a grid of 2×2 vertices.
struct Bench {
  BoundValues<Everything> values{everything()};
  TriangleMesh mesh = grid(2);

  /// Sets one and says what that makes stale.
  Stale set(const char* parameter, const RawValue& raw) {
    Stale made = Stale::all;
    REQUIRE(values.set(parameter, raw, context(), made).ok());
    return made;
  }
  Status refusal(const char* parameter, const RawValue& raw) {
    Stale made = Stale::nothing;
    return values.set(parameter, raw, context(), made);
  }
  MeshContext context() const { return {mesh.vertexCount(), mesh.faceCount(), UnitFrame::of(mesh), &mesh.positions}; }
};

GaussMapData tetrahedron(GaussMapData::Kind kind) {
  GaussMapData data;
  data.kind = kind;
  data.points.resize(4, 3);
  data.points << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  data.normals = -data.points;
  data.triangles.resize(4, 3);
  data.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  if (kind == GaussMapData::Kind::closest) data.points.resize(0, 3), data.triangles.resize(0, 3);
  return data;
}

TextureSlopes textureOn(const TriangleMesh& mesh) {
  TextureSlopes texture{CornerPairs(3 * mesh.faceCount(), 2), CornerPairs::Constant(3 * mesh.faceCount(), 2, 0.25f)};
  for (Index c = 0; c < texture.uvs.rows(); ++c) {
    texture.uvs.row(c) = mesh.positions.row(mesh.triangles.data()[c]).head<2>().cast<float>();
  }
  return texture;
}

}  // namespace

TEST_CASE("every kind takes its value, notices the same one, and nothing at all is the default") {
  Bench bench;
  const Scalars four = Scalars::LinSpaced(4, 1, 4), sixteen = Scalars::LinSpaced(16, 1, 16);
  const struct {
    const char* parameter;
    EncodedValue value;
    Stale made = Stale::nothing;
  } cases[] = {{"number", encoded(0.75), Stale::weights},
               {"flag", encoded(0), Stale::targets},
               {"colour", encoded("red"), Stale::all},
               {"matrix", encoded(Scalars::LinSpaced(6, 1, 6)), Stale::weights},
               {"pair", encoded(Eigen::Vector2d(3, 4)), Stale::weights},
               {"rotation", encoded(Quaternion(1, 0, 0, 0)), Stale::weights},
               {"scalars", encoded(four), Stale::weights},
               {"rotations", encoded(sixteen), Stale::weights},
               {"style", encoded(tetrahedron(GaussMapData::Kind::closest)), Stale::weights},
               {"texture", encoded(textureOn(bench.mesh)), Stale::weights},
               {"field", encoded(SphereField{2, Scalars::LinSpaced(8, 0, 1)}), Stale::weights},
               {"handles", encoded(Handles{{2}, Points::Ones(1, 3)}), Stale::system},
               {"planes", encoded(Planes{{{2, 3}, Vec3(1, 2, 3), 4}}), Stale::system},
               {"count", encoded(8), Stale::targets}};
  for (const auto& one : cases) {
    INFO(one.parameter);
    CHECK(bench.set(one.parameter, one.value) == one.made);
    CHECK(bench.set(one.parameter, one.value) == Stale::nothing);
  }
  const Everything& set = bench.values.values();
  CHECK(set.number == 0.75);
  CHECK(!set.flag);
  CHECK(set.colour == Colour::red);
  CHECK(set.matrix.rows(1, 0) == 4);
  CHECK(set.pair == Eigen::Vector2d(3, 4));
  CHECK(set.rotation == Quaternion(1, 0, 0, 0));
  CHECK(set.scalars == four);
  CHECK(set.rotations(1, 0) == 5);
  CHECK(set.style->data() == tetrahedron(GaussMapData::Kind::closest));
  CHECK(*set.texture == textureOn(bench.mesh));
  CHECK(set.field->values[7] == 1);
  CHECK(set.handles.vertices == std::vector<Index>{2});
  CHECK(set.planes.at(0).vertices == std::vector<Index>{2, 3});
  CHECK(set.group.count == 8);

  for (const auto& one : cases) {
    INFO(one.parameter);
    CHECK(bench.set(one.parameter, RawValue{}) == one.made);
  }
  CHECK(set.number == 0.5);
  CHECK(set.colour == Colour::green);
  CHECK(set.matrix.isNamed());
  CHECK(set.scalars.size() == 0);
  CHECK(!set.style);
  CHECK(!set.field);
  CHECK(set.handles.vertices.empty());
  CHECK(set.planes.empty());
  CHECK(set.group.count == 9);  // what the method has for a default, not what the group has
}

TEST_CASE("a style comes through in each of its forms") {
  using Kind = GaussMapData::Kind;
  for (const Kind kind : {Kind::closest, Kind::perVertex, Kind::perFace}) {
    Bench bench;
    bench.set("style", encoded(tetrahedron(kind)));
    CHECK(bench.values.values().style->data() == tetrahedron(kind));
  }
}

TEST_CASE("handles have their targets in the unit frame, and other targets leave the system as it is") {
  Bench bench;
  const Points target = Points::Constant(1, 3, 2);
  bench.set("handles", encoded(Handles{{2}, target}));
  const Vec3 expected = bench.context().frame.toUnit(target.row(0).transpose());
  CHECK(bench.values.values().handles.targets.row(0).transpose() == expected);
  CHECK(bench.set("handles", encoded(Handles{{2}, 2 * target})) == Stale::targets);
  CHECK(bench.set("handles", encoded(Handles{{3}, 2 * target})) == Stale::system);
  // Without a target a vertex has its own place for one.
  bench.set("handles", EncodedValue{"", {1, 2, 3}, {3, 1}});
  const Vec3 place = UnitFrame::of(bench.mesh).toUnit(bench.mesh.positions.row(1).transpose());
  CHECK(bench.values.values().handles.targets.row(1).transpose() == place);
}

TEST_CASE("planes stand in the unit frame, and those that are shifted leave the system as it is") {
  Bench bench;
  const Vec3 normal(0.5, -2, 1), point(3, 1, -4);
  bench.set("planes", encoded(Planes{{{2}, normal, normal.dot(point)}, {{}, Vec3::UnitX(), 1}}));
  const Planes& planes = bench.values.values().planes;
  REQUIRE(planes.size() == 2);
  CHECK(planes[0].normal.norm() == doctest::Approx(1).epsilon(1e-15));
  CHECK(planes[0].normal.dot(bench.context().frame.toUnit(point)) == doctest::Approx(planes[0].offset).epsilon(1e-15));
  CHECK(bench.set("planes", encoded(Planes{{{2}, normal, 7}, {{}, Vec3::UnitX(), 2}})) == Stale::targets);
  CHECK(bench.set("planes", encoded(Planes{{{2}, normal, 7}, {{1}, Vec3::UnitX(), 2}})) == Stale::system);
  CHECK(bench.set("planes", encoded(Planes{{{2}, -normal, 7}, {{1}, Vec3::UnitX(), 2}})) == Stale::system);
  CHECK(bench.set("planes", encoded(Planes{{{2}, -normal, 7}})) == Stale::system);
}

TEST_CASE("what a kind cannot read is refused with the parameter's name, and the value stays") {
  Bench bench;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [&](const char* parameter, const EncodedValue& value) {
    const Status status = bench.refusal(parameter, value);
    INFO(parameter << ": " << status.message);
    CHECK((status.code == Code::badParameter || status.code == Code::badHandles || status.code == Code::badPlanes));
    CHECK(status.message.size() > 15);
  };
  for (const double bad : {-0.1, 1.1, nan}) refuses("number", encoded(bad));
  refuses("number", encoded("half"));
  refuses("number", encoded(Eigen::Vector2d(0, 0)));
  refuses("count", encoded(2.5));
  refuses("count", encoded(21));
  refuses("flag", encoded(0.5));
  CHECK(bench.refusal("colour", encoded("blue")).message == "colour must be one of red, green");
  refuses("colour", encoded(0));
  refuses("matrix", encoded("blue"));
  refuses("matrix", encoded(Scalars::Ones(9)));
  refuses("matrix", encoded(Scalars::Zero(3)));
  refuses("pair", encoded(Vec3(1, 2, 3)));
  refuses("pair", encoded(Eigen::Vector2d(1, 11)));
  refuses("rotation", encoded(Quaternion(0, 0, 0, 0)));
  refuses("scalars", encoded(Scalars::Ones(3)));
  CHECK(bench.refusal("scalars", encoded(Eigen::Vector4d(1, 1, -1, 1))).element.index == 2);
  refuses("rotations", encoded(Scalars::Ones(4)));
  refuses("style", encoded("round"));
  refuses("style", encoded("closest"));
  refuses("style", EncodedValue{"vertex", {1, 0, 0}, {2, 0, 0, 0}});
  refuses("style", EncodedValue{"vertex", {1, 0, 0, 1, 0, 0}, {1, 0, 0}});
  refuses("texture", encoded(Scalars::Ones(7)));
  refuses("texture", encoded(Scalars::Ones(8)));
  refuses("field", encoded(SphereField{2, Scalars::Zero(9)}));
  refuses("field", encoded(SphereField{1, Scalars::Zero(2)}));
  refuses("field", encoded(SphereField{2, Scalars::Constant(8, 1.01)}));
  CHECK(bench.refusal("field", encoded(SphereField{2, Scalars::Unit(8, 5) * nan})).element.index == 0);
  refuses("field", EncodedValue{"", std::vector<double>(8), {8, 1}});
  refuses("field", encoded(Scalars::Zero(8)));
  refuses("handles", encoded(Handles{{4}, Points::Zero(1, 3)}));
  refuses("handles", EncodedValue{"", {0, 0}, {1}});
  refuses("handles", EncodedValue{"", {0, 0, 0, 0, 0, 0}, {1}});
  refuses("planes", encoded(Planes{{{4}, Vec3::UnitX(), 0}}));
  refuses("planes", encoded(Planes{{{-1}, Vec3::UnitX(), 0}}));
  refuses("planes", encoded(Planes{{{1}, Vec3::Zero(), 0}}));
  refuses("planes", encoded(Planes{{{1}, Vec3::UnitX(), nan}}));
  refuses("planes", encoded(Planes{{{1}, Vec3::UnitX(), 0}, {{1}, Vec3::UnitX(), 0.001}}));
  refuses("planes", EncodedValue{"", {1, 0, 0, 0}, {2, 1}});
  refuses("planes", EncodedValue{"", {1, 0, 0, 0}, {-1}});
  refuses("planes", EncodedValue{"", {1, 0, 0}, {1, 1}});
  refuses("planes", EncodedValue{"", {1, 0, 0, 0, 1, 0, 0, 0}, {1, 1}});
  refuses("colours", encoded("red"));
  const Everything usual, &values = bench.values.values();
  CHECK(values.number == usual.number);
  CHECK(values.colour == usual.colour);
  CHECK(values.matrix == usual.matrix);
  CHECK(values.handles.vertices.empty());
  CHECK(values.planes.empty());
}

TEST_CASE("what belongs to vertices goes into their order, all else stays") {
  Bench bench;
  bench.set("number", encoded(0.25));
  bench.set("scalars", encoded(Scalars::LinSpaced(4, 0, 3)));
  bench.set("rotations", encoded(Scalars::LinSpaced(16, 0, 15)));
  bench.set("handles", encoded(Handles{{1, 3}, Points::Zero(2, 3)}));
  bench.set("planes", encoded(Planes{{{1, 3}, Vec3::UnitZ(), 0}}));
  const VertexOrder order({2, 0, 3, 1});
  BoundValues<Everything> ordered(everything());
  ordered.takeOrdered(bench.values, order);
  const Everything& values = ordered.values();
  CHECK(values.number == 0.25);
  CHECK(values.group.count == 9);
  for (Index place = 0; place < 4; ++place) {
    CHECK(values.scalars[place] == order.vertexAt(place));
    CHECK(values.rotations(place, 3) == 4 * order.vertexAt(place) + 3);
  }
  CHECK(values.handles.vertices == std::vector<Index>{3, 2});
  CHECK(values.planes[0].vertices == std::vector<Index>{3, 2});
}

TEST_CASE("parameters describe themselves") {
  const std::string json = BoundValues<Everything>(everything()).describe();
  const auto has = [&](const char* text) { return json.find(text) != std::string::npos; };
  CHECK(has(R"({"name":"number","kind":"number","invalidates":"weights","default":0.5,"min":0,"max":1})"));
  CHECK(has(R"({"name":"flag","kind":"flag","invalidates":"targets","default":true})"));
  CHECK(has(R"({"name":"colour","kind":"choice","invalidates":"all","default":"green","choices":["red","green"]})"));
  CHECK(has(
      R"({"name":"matrix","kind":"choice","invalidates":"weights","default":"red","choices":["red","green"],"maxRows":2})"));
  CHECK(has(R"({"name":"pair","kind":"vector","invalidates":"weights","default":[1,2],"min":0,"max":10})"));
  CHECK(has(R"({"name":"rotation","kind":"rotation","invalidates":"weights","default":[0,0,0,1]})"));
  CHECK(has(R"({"name":"scalars","kind":"scalars","invalidates":"weights","min":0,"max":10})"));
  CHECK(has(R"({"name":"texture","kind":"textureSlopes","invalidates":"weights"})"));
  CHECK(has(R"({"name":"count","kind":"integer","invalidates":"targets","default":9,"min":0,"max":20})"));
}
