#include "whittle.h"

#include "session/session.h"

using namespace whittle;

struct WhittleSession {
  Session session;
  Status last;

  int keep(Status status) {
    last = std::move(status);
    return static_cast<int>(last.code);
  }
};

WhittleSession* whittle_create() { return new WhittleSession; }

void whittle_destroy(WhittleSession* session) { delete session; }

int whittle_load(WhittleSession* session, const double* positions, int32_t vertex_count, const int32_t* triangles,
                 int32_t face_count) {
  return session->keep(session->session.load({Eigen::Map<const Points>(positions, vertex_count, 3),
                                              Eigen::Map<const Triangles>(triangles, face_count, 3)}));
}

void whittle_report(const WhittleSession* session, double* numbers) {
  const MeshReport& r = session->session.report();
  const double all[] = {double(r.vertices),         double(r.faces),           double(r.components),
                        double(r.boundaryEdges),    double(r.nonManifoldEdges), double(r.degenerateFaces),
                        double(r.duplicateFaces),   double(r.isolatedVertices), r.min.x(), r.min.y(), r.min.z(),
                        r.max.x(), r.max.y(), r.max.z()};
  std::copy(std::begin(all), std::end(all), numbers);
}

int whittle_select(WhittleSession* session, const char* method) { return session->keep(session->session.select(method)); }

int whittle_set_number(WhittleSession* session, const char* parameter, double value) {
  return session->keep(session->session.setNumber(parameter, value));
}

int whittle_set_scalars(WhittleSession* session, const char* parameter, const double* values, int32_t count) {
  return session->keep(session->session.setScalars(parameter, Eigen::Map<const Scalars>(values, count)));
}

int whittle_set_style(WhittleSession* session, const char* parameter, int32_t kind, const double* normals, int32_t normal_count,
                      const double* points, int32_t point_count, const int32_t* triangles, int32_t triangle_count) {
  if (kind < 0 || kind > 2) return session->keep(session->session.setStyle(parameter, std::nullopt));
  return session->keep(session->session.setStyle(
      parameter, GaussMapData{static_cast<GaussMapData::Kind>(kind), Eigen::Map<const Points>(normals, normal_count, 3),
                              Eigen::Map<const Points>(points, point_count, 3),
                              Eigen::Map<const Triangles>(triangles, triangle_count, 3)}));
}

int whittle_set_relief(WhittleSession* session, const char* parameter, const float* uvs, const float* slopes, int32_t face_count) {
  if (face_count == 0) return session->keep(session->session.setTextureSlopes(parameter, std::nullopt));
  return session->keep(session->session.setTextureSlopes(parameter, TextureSlopes{Eigen::Map<const CornerPairs>(uvs, 3 * face_count, 2),
                                                                    Eigen::Map<const CornerPairs>(slopes, 3 * face_count, 2)}));
}

int whittle_set_handles(WhittleSession* session, const int32_t* vertices, const double* targets, int32_t count) {
  return session->keep(session->session.setHandles(
      {std::vector<Index>(vertices, vertices + count), Eigen::Map<const Points>(targets, count, 3)}));
}

void whittle_restart(WhittleSession* session) { session->session.restart(); }

int whittle_prepare(WhittleSession* session) { return session->keep(session->session.prepare()); }

int whittle_step(WhittleSession* session, double* outcome_energy_change) {
  StepReport report;
  const int code = session->keep(session->session.step(report));
  outcome_energy_change[0] = static_cast<double>(report.outcome);
  outcome_energy_change[1] = report.energy;
  outcome_energy_change[2] = report.change;
  return code;
}

void whittle_positions(const WhittleSession* session, double* positions) { session->session.copyPositions(positions); }

const char* whittle_code_name(int code) { return codeName(static_cast<Code>(code)); }

const char* whittle_message(const WhittleSession* session) { return session->last.message.c_str(); }

int32_t whittle_element(const WhittleSession* session) { return session->last.element; }

const char* whittle_methods() {
  static const std::string json = describeMethods();
  return json.c_str();
}
