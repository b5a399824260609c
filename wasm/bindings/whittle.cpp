#include "whittle.h"

#include "session/session.h"

using namespace whittle;

struct WhittleSession {
  Session session;
  Status last;
  Outcome outcome = Outcome::running;
  std::vector<std::string> warnings;
  std::string fields;

  int keep(Status status) {
    last = std::move(status);
    return static_cast<int>(last.code);
  }
};

int32_t whittle_abi_version() { return 4; }

WhittleSession* whittle_create() { return new WhittleSession; }

void whittle_destroy(WhittleSession* session) { delete session; }

int whittle_load(WhittleSession* session, const double* positions, int32_t vertex_count, const int32_t* triangles,
                 int32_t face_count, const int32_t* source_vertices, const int32_t* source_faces) {
  std::vector<Index> vertices, faces;
  if (source_vertices) vertices.assign(source_vertices, source_vertices + vertex_count);
  if (source_faces) faces.assign(source_faces, source_faces + face_count);
  return session->keep(session->session.load(
      {Eigen::Map<const Points>(positions, vertex_count, 3), Eigen::Map<const Triangles>(triangles, face_count, 3)},
      std::move(vertices), std::move(faces)));
}

void whittle_report(const WhittleSession* session, double* numbers) {
  const MeshReport& r = session->session.report();
  const double all[] = {double(r.vertices),
                        double(r.faces),
                        double(r.components),
                        double(r.typicalPart),
                        double(r.boundaryEdges),
                        double(r.nonManifoldEdges),
                        double(r.degenerateFaces),
                        double(r.isolatedVertices),
                        double(r.farVertices),
                        r.min.x(),
                        r.min.y(),
                        r.min.z(),
                        r.max.x(),
                        r.max.y(),
                        r.max.z()};
  std::copy(std::begin(all), std::end(all), numbers);
}

int whittle_select(WhittleSession* session, const char* method) {
  return session->keep(session->session.select(method));
}

int whittle_set_value(WhittleSession* session, const char* parameter, const char* name, const double* numbers,
                      int32_t number_count, const int32_t* indices, int32_t index_count) {
  RawValue value;
  value.name = name;
  value.numbers = {numbers, static_cast<std::size_t>(number_count)};
  value.indices = {indices, static_cast<std::size_t>(index_count)};
  return session->keep(session->session.set(parameter, value));
}

void whittle_restart(WhittleSession* session) { session->session.restart(); }

int whittle_prepare(WhittleSession* session, double* share) {
  return session->keep(session->session.prepareNext(*share));
}

const char* whittle_stage(WhittleSession* session) { return session->session.stage(); }

int whittle_step(WhittleSession* session, double* energy_change) {
  StepReport report;
  const int code = session->keep(session->session.step(report));
  session->outcome = report.outcome;
  energy_change[0] = report.energy;
  energy_change[1] = report.change;
  return code;
}

const char* whittle_outcome(const WhittleSession* session) { return outcomeName(session->outcome); }

void whittle_positions(const WhittleSession* session, double* positions) { session->session.copyPositions(positions); }

int32_t whittle_warning_count(WhittleSession* session) {
  session->warnings = session->session.warnings();
  return static_cast<int32_t>(session->warnings.size());
}

const char* whittle_warning(const WhittleSession* session, int32_t index) { return session->warnings[index].c_str(); }

const char* whittle_fields(WhittleSession* session) {
  session->fields = describeFields(session->session.fields());
  return session->fields.c_str();
}

int whittle_field(WhittleSession* session, const char* name, double* values) {
  return session->keep(session->session.copyField(name, values));
}

const char* whittle_code_name(int code) { return codeName(static_cast<Code>(code)); }

const char* whittle_message(const WhittleSession* session) { return session->last.message.c_str(); }

int32_t whittle_element(const WhittleSession* session) { return session->last.element.index; }

const char* whittle_methods() {
  static const std::string json = describeMethods();
  return json.c_str();
}
