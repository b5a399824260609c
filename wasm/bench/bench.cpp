// Runs one method natively on a mesh from standard input and prints its times as JSON. The input is raw: int32 vertex and
// face counts, float64 positions #V×3, int32 triangles #F×3.
//
// usage: whittle-bench METHOD LAMBDA ITERATIONS < mesh

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "session/session.h"

using namespace whittle;

namespace {

double milliseconds() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

bool read(void* into, std::size_t bytes) { return std::fread(into, 1, bytes, stdin) == bytes; }

bool readMesh(TriangleMesh& mesh) {
  std::int32_t counts[2];
  if (!read(counts, sizeof counts)) return false;
  mesh.positions.resize(counts[0], 3);
  mesh.triangles.resize(counts[1], 3);
  return read(mesh.positions.data(), sizeof(double) * mesh.positions.size()) &&
         read(mesh.triangles.data(), sizeof(Index) * mesh.triangles.size());
}

int fail(const Status& status) {
  std::fprintf(stderr, "%s: %s\n", codeName(status.code), status.message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  TriangleMesh mesh;
  if (argc != 4 || !readMesh(mesh)) return fail({Code::badParameter, "usage: whittle-bench METHOD LAMBDA ITERATIONS < mesh"});
  Session session;
  if (Status status = session.load(std::move(mesh)); !status.ok()) return fail(status);
  if (Status status = session.select(argv[1]); !status.ok()) return fail(status);
  if (std::strcmp(argv[1], "arap") != 0) {
    if (Status status = session.setNumber("lambda", std::atof(argv[2])); !status.ok()) return fail(status);
  }
  if (Status status = session.setNumber("tolerance", 0); !status.ok()) return fail(status);

  const double start = milliseconds();
  if (Status status = session.prepare(); !status.ok()) return fail(status);
  const double prepared = milliseconds();
  StepReport report;
  const int iterations = std::atoi(argv[3]);
  for (int k = 0; k < iterations; ++k) {
    if (Status status = session.step(report); !status.ok()) return fail(status);
  }
  const double done = milliseconds();
  std::printf("{\"prepare\":%.4f,\"iteration\":%.4f,\"energy\":%.17g}\n", prepared - start, (done - prepared) / iterations,
              report.energy);
  return 0;
}
