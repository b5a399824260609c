#pragma once

#include <stdint.h>

// The core's C interface: one opaque handle, flat arrays, no exceptions. Calls that can fail return 0 or an error code;
// whittle_code_name, whittle_message and whittle_element then tell what went wrong. Strings are UTF-8, NUL-terminated, and
// live until the next call on the same session.

#ifdef __EMSCRIPTEN__
#include <emscripten/emscripten.h>
#define WHITTLE_API EMSCRIPTEN_KEEPALIVE
#else
#define WHITTLE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct WhittleSession WhittleSession;

WHITTLE_API WhittleSession* whittle_create(void);
WHITTLE_API void whittle_destroy(WhittleSession* session);

/// Takes a mesh: positions #V×3 and triangles #F×3, both copied.
WHITTLE_API int whittle_load(WhittleSession* session, const double* positions, int32_t vertex_count,
                             const int32_t* triangles, int32_t face_count);
/// Writes what the core says of the loaded mesh, 14 numbers: vertices, faces, components, boundary edges, non-manifold
/// edges, degenerate faces, duplicate faces, isolated vertices, box min xyz, box max xyz.
WHITTLE_API void whittle_report(const WhittleSession* session, double* numbers);

WHITTLE_API int whittle_select(WhittleSession* session, const char* method);
/// Sets a number, a choice by the index of its name, or a flag as 0 or 1.
WHITTLE_API int whittle_set_number(WhittleSession* session, const char* parameter, double value);
/// Sets a list of numbers, as its kind has it: for each vertex one (scalars) or a quaternion x y z w (rotations; one of zeros says
/// nothing), a vector, a quaternion, or the rows of a matrix in place of a choice's name. Count 0 unsets what need not be.
WHITTLE_API int whittle_set_scalars(WhittleSession* session, const char* parameter, const double* values, int32_t count);
/// Sets a style. Kind 0: the closest of #normals×3. Kind 1: points #points×3 on the sphere, triangles #triangles×3, a normal for each
/// point; kind 2: a normal for each triangle. Any other kind: none.
WHITTLE_API int whittle_set_style(WhittleSession* session, const char* parameter, int32_t kind, const double* normals,
                                  int32_t normal_count, const double* points, int32_t point_count, const int32_t* triangles,
                                  int32_t triangle_count);
/// Sets a texture's relief: texture coordinates and slopes of the faces' corners, both 3·#F×2; face_count 0: none.
WHITTLE_API int whittle_set_relief(WhittleSession* session, const char* parameter, const float* uvs, const float* slopes,
                                   int32_t face_count);
/// Holds `count` vertices at targets (#count×3, file units); count 0 frees all.
WHITTLE_API int whittle_set_handles(WhittleSession* session, const int32_t* vertices, const double* targets, int32_t count);

WHITTLE_API void whittle_restart(WhittleSession* session);
WHITTLE_API int whittle_prepare(WhittleSession* session);
/// One iteration. Writes outcome (0 running, 1 converged, 2 iteration limit, 3 stalled), energy before the step and
/// relative displacement.
WHITTLE_API int whittle_step(WhittleSession* session, double* outcome_energy_change);
/// Writes the current positions, #V×3.
WHITTLE_API void whittle_positions(const WhittleSession* session, double* positions);

WHITTLE_API const char* whittle_code_name(int code);
WHITTLE_API const char* whittle_message(const WhittleSession* session);
/// The element that the last failure is about, or −1.
WHITTLE_API int32_t whittle_element(const WhittleSession* session);

/// The method registry as JSON.
WHITTLE_API const char* whittle_methods(void);

#ifdef __cplusplus
}
#endif
