#pragma once

#include <stdint.h>

// The core's C interface: one opaque handle, flat arrays, no exceptions. Calls that can fail return 0 or an error code;
// whittle_code_name, whittle_message and whittle_element then tell what went wrong. Strings are UTF-8, NUL-terminated,
// and live until the next call on the same session.

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

/// The version of this interface, 4. A caller that was written for another refuses to go on.
WHITTLE_API int32_t whittle_abi_version(void);

WHITTLE_API WhittleSession* whittle_create(void);
WHITTLE_API void whittle_destroy(WhittleSession* session);

/// Takes a mesh: positions #V×3 and triangles #F×3, both copied.
/// @param source_vertices #V, the number that the file has for each vertex (of those that became one, the first); null
///   where it is the same. Sentences and elements of failures speak of these numbers.
/// @param source_faces #F, likewise of each face
WHITTLE_API int whittle_load(WhittleSession* session, const double* positions, int32_t vertex_count,
                             const int32_t* triangles, int32_t face_count, const int32_t* source_vertices,
                             const int32_t* source_faces);
/// Writes what the core says of the loaded mesh, 15 numbers: vertices, faces, components, vertices of a typical part, boundary edges, non-manifold
/// edges, degenerate faces, isolated vertices, far vertices, box min xyz, box max xyz.
WHITTLE_API void whittle_report(const WhittleSession* session, double* numbers);

WHITTLE_API int whittle_select(WhittleSession* session, const char* method);
/// Sets a parameter of any kind; nothing at all, an empty name and counts of 0, is its default. By kind:
///   number, integer   numbers x
///   flag              numbers 0 or 1
///   choice            name; where rows will do: numbers, three a row
///   vector            its numbers
///   rotation          numbers x y z w, of any length but zero
///   scalars           a number for each vertex
///   rotations         numbers x y z w for each vertex; four zeros say nothing of theirs
///   style             name "closest": numbers are normals, #N×3; name "vertex" or "face": indices are #P, then
///                     triangles #T×3, numbers are points on the sphere, #P×3, then a normal for each point or triangle
///   sphereField       indices are the width and height of a picture of the sphere, 2:1, numbers its pixels from 0 to 1, rows
///                     from the top
///   textureSlopes     numbers are texture coordinates, then slopes of the faces' corners, both 3·#F×2
///   handles           indices are vertices as they were loaded, numbers their targets, 3 each in the file's units; vertices
///                     at the end that have none stay where they are
///   planes            indices are, plane by plane, how many vertices it holds and these; numbers a normal of any length
///                     but zero and an offset for each, normal·x = offset in the file's units
WHITTLE_API int whittle_set_value(WhittleSession* session, const char* parameter, const char* name,
                                  const double* numbers, int32_t number_count, const int32_t* indices,
                                  int32_t index_count);

/// Back to the rest positions.
WHITTLE_API void whittle_restart(WhittleSession* session);
/// Does one stage of preparing, or some of it. After the last a run starts from the current positions.
/// @param share out: how far it is, 0 to 1; 1: prepared
WHITTLE_API int whittle_prepare(WhittleSession* session, double* share);
/// What the next call of whittle_prepare does, in a few words for people; "" when prepared.
WHITTLE_API const char* whittle_stage(WhittleSession* session);
/// One iteration. Writes the energy before the step and the relative displacement.
WHITTLE_API int whittle_step(WhittleSession* session, double* energy_change);
/// What became of the last step: "running", "converged", "iteration-limit" or "stalled".
WHITTLE_API const char* whittle_outcome(const WhittleSession* session);
/// Writes the current positions, #V×3.
WHITTLE_API void whittle_positions(const WhittleSession* session, double* positions);

/// How many warnings there are of the chosen values on this mesh.
WHITTLE_API int32_t whittle_warning_count(WhittleSession* session);
/// One of those that were last counted, a sentence.
WHITTLE_API const char* whittle_warning(const WhittleSession* session, int32_t index);
/// The fields that the prepared method can show, as JSON: [{"name", "label", "per": "vertex" or "face", "unit"}].
WHITTLE_API const char* whittle_fields(WhittleSession* session);
/// Writes a field, #V or #F numbers in the order in which they were loaded.
WHITTLE_API int whittle_field(WhittleSession* session, const char* name, double* values);

WHITTLE_API const char* whittle_code_name(int code);
WHITTLE_API const char* whittle_message(const WhittleSession* session);
/// The element that the last failure is about, a vertex by its number in the file, or −1.
WHITTLE_API int32_t whittle_element(const WhittleSession* session);

/// The method registry as JSON.
WHITTLE_API const char* whittle_methods(void);

#ifdef __cplusplus
}
#endif
