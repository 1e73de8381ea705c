/* SPDX-License-Identifier: BSD-3-Clause */
/* libassay, API 1.0: the exact motion, stress and body force of an assay scene, inside another code.
 *
 *   assay_open            a scene's text or file -> a problem: motion, material, solution; made once
 *   assay_points_open     fixed reference points of it
 *   assay_eval            x, v, a, F, P, sigma, b of these points at a time
 *   assay_tractions       P N on surface elements with normals N
 *   assay_cells_open      hexahedra, or quadrilaterals in the plane; assay_cells_eval: means of b over them
 *   assay_mesh_open       a finite element mesh; assay_nodal_loads: its consistent nodal forces at a time
 *   assay_at_current      the same fields where only the current position is known
 *
 * Pure C11; also compiles as C++. SI units throughout. Every function returns a code, and fills *error if that is not
 * null. A handle that could not be made is null. Calls on one handle may come from any number of threads at once, with
 * times in any order: the answer is a function of the arguments alone, to the last bit. Closing a handle is the last
 * call on it, and null may be closed. Points, cells and meshes keep their problem alive.
 *
 * The library prints nothing, changes no signal, locale or folder, and never ends the process. It computes by the
 * default rules of floating-point numbers whatever those of the caller are, which stay. A material that is a UMAT, a
 * VUMAT or of MFront runs in processes of the program assay: the one that the library was installed or built with, else
 * $ASSAY_PROGRAM, else that of $PATH. A plug-in runs inside the host unless the scene says material.isolation: worker.
 * Link: cc code.c $(pkg-config --cflags --libs assay), or target assay::assay of find_package(assay). */
#ifndef ASSAY_H
#define ASSAY_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ASSAY_API_MAJOR 1
#define ASSAY_API_MINOR 0

#define ASSAY_API __attribute__((visibility("default")))

/* What a call returns. The first four are the exit codes of the program. */
enum {
  ASSAY_DONE = 0,
  ASSAY_FINDING = 1,    /* the material failed */
  ASSAY_BAD_INPUT = 2,  /* a scene, an argument */
  ASSAY_SYSTEM = 3,     /* memory, files, processes */
  ASSAY_BEYOND_END = 4, /* a time after assay_options.end, to which the response is tabulated */
  ASSAY_OUTSIDE = 5     /* some points lie where the motion is not defined: their numbers are NaN, the rest is there */
};

/* Structs begin with their size, which ASSAY_..._INIT sets: later headers append members. A library that is older than
 * the header refuses members that it does not know, unless they are zero. */

typedef struct assay_error {
  uint32_t struct_size;
  int32_t code;
  int32_t line, column; /* in file, from 1; 0: unknown */
  int64_t point;        /* number of the point, cell, node or element, from 0; -1: none */
  char file[256];       /* cut at its beginning where it is longer */
  char key[128];        /* of the scene, "motion.peak"; or the argument, "points.X" */
  char message[512];    /* one line, with all of the above */
} assay_error;
#define ASSAY_ERROR_INIT {sizeof(assay_error), 0, 0, 0, -1, {0}, {0}, {0}}

typedef struct assay_options {
  uint32_t struct_size;
  uint32_t api_major;
  const char *scene;       /* path of a scene, or null */
  const char *text;        /* its text instead; relative paths in it count from the working folder */
  size_t set_count;        /* changes of the scene, "key.path=value", as --set of the program */
  const char *const *sets;
  double end;              /* last time that will be asked for [s]; 0: time.end of the scene */
  int32_t threads;         /* with which the response is tabulated; 0: one */
} assay_options;
#define ASSAY_OPTIONS_INIT {sizeof(assay_options), ASSAY_API_MAJOR, NULL, NULL, 0, NULL, 0, 0}

typedef struct assay_problem assay_problem;
typedef struct assay_points assay_points;
typedef struct assay_cells assay_cells;
typedef struct assay_mesh assay_mesh;

/* Makes a problem: reads the scene, finds or compiles the material, tabulates its response. A motion that is not stable
 * for the material is a warning. */
ASSAY_API int assay_open(const assay_options *options, assay_problem **problem, assay_error *error);
ASSAY_API void assay_close(assay_problem *problem);

typedef struct assay_facts {
  uint32_t struct_size;
  int32_t dimension;     /* 2: plane strain, 3 */
  double end;            /* last time [s] */
  double period;         /* T of the motion [s] */
  double density;        /* rho0 [kg/m^3] */
  double wave_speed;     /* fastest of the material on the motion's path [m/s] */
  double particle_speed; /* fastest of the exact motion [m/s] */
} assay_facts;
#define ASSAY_FACTS_INIT {sizeof(assay_facts), 0, 0, 0, 0, 0, 0}
ASSAY_API int assay_get_facts(const assay_problem *problem, assay_facts *facts, assay_error *error);

/* Texts. size: of buffer; *needed, if not null: bytes that the whole takes, with its end. What does not fit is cut.
 * assay_describe: JSON, the resolved scene, its hash, version of the library, estimated error of the response.
 * assay_warnings: one sentence a line; empty where there is none. */
ASSAY_API int assay_describe(const assay_problem *problem, char *buffer, size_t size, size_t *needed);
ASSAY_API int assay_warnings(const assay_problem *problem, char *buffer, size_t size, size_t *needed);
ASSAY_API const char *assay_version(void); /* "0.2.0" */

/* A field of n points: component c of point p is data[p * point_stride + c * component_stride]; strides in doubles,
 * of any sign, and not 0 where several numbers are written. data null: not wanted. */
typedef struct assay_field {
  double *data;
  ptrdiff_t point_stride;
  ptrdiff_t component_stride;
} assay_field;

/* The same of given values. */
typedef struct assay_const_field {
  const double *data;
  ptrdiff_t point_stride;
  ptrdiff_t component_stride;
} assay_const_field;

/* What is wanted. Vectors have as many components as the problem has dimensions; F and P have nine, row-major; sigma
 * has six: 11, 22, 33, 12, 13, 23. */
typedef struct assay_view {
  uint32_t struct_size;
  uint32_t reserved;    /* 0 */
  int32_t *status;      /* of each point: 0, or ASSAY_OUTSIDE; null: not wanted */
  assay_field x;        /* position [m] */
  assay_field v;        /* velocity [m/s] */
  assay_field a;        /* acceleration [m/s^2] */
  assay_field F;        /* deformation gradient [1] */
  assay_field P;        /* first Piola-Kirchhoff stress [Pa] */
  assay_field sigma;    /* Cauchy stress [Pa] */
  assay_field b;        /* body force per mass, a - DIV(P)/rho0; without a where force.quasi_static is true [m/s^2] */
  assay_field b_static; /* without the inertia: -DIV(P)/rho0 [m/s^2] */
} assay_view;
/* With struct_size; all else null. */
#define ASSAY_NO_FIELD {NULL, 0, 0}
#define ASSAY_VIEW_INIT                                                                                          \
  {sizeof(assay_view), 0, NULL, ASSAY_NO_FIELD, ASSAY_NO_FIELD, ASSAY_NO_FIELD, ASSAY_NO_FIELD, ASSAY_NO_FIELD,  \
   ASSAY_NO_FIELD, ASSAY_NO_FIELD, ASSAY_NO_FIELD}

/* n reference points X, which are copied. With components == 3 in the plane the third is ignored.
 * components: 2 or 3, that X has. */
ASSAY_API int assay_points_open(const assay_problem *problem, size_t n, int components, const assay_const_field *X,
                                assay_points **points, assay_error *error);
ASSAY_API void assay_points_close(assay_points *points);

/* The fields of points first .. first + count - 1 at time t; data of a view is that of point `first`. Threads and ranks
 * may share one set. A time that is beyond the end by rounding, 1e-9 of it, is the end. Where the response is a
 * formula, time goes on beyond the end. */
ASSAY_API int assay_eval(const assay_points *points, double t, size_t first, size_t count, const assay_view *out,
                         assay_error *error);

/* Traction P N per reference area [Pa] of points first .. first + count - 1 at time t, N: the outward normals of the
 * reference surface there, of any length. */
ASSAY_API int assay_tractions(const assay_points *points, double t, size_t first, size_t count,
                              const assay_const_field *N, const assay_field *traction, assay_error *error);

/* n cells, 8 corners each in three dimensions, 4 in the plane (counterclockwise; in 3-D VTK's order of a hexahedron):
 * coordinate c of corner k of cell i is corners[(i * K + k) * dimension + c]. Cells that share corners to the last bit
 * share the forces on their faces. Their means of b carry no error of its derivative. */
ASSAY_API int assay_cells_open(const assay_problem *problem, size_t n, const double *corners, assay_cells **cells,
                               assay_error *error);
ASSAY_API void assay_cells_close(assay_cells *cells);
/* Means of b over the cells at time t [m/s^2]; volume: of each cell [m^3], or null. */
ASSAY_API int assay_cells_eval(const assay_cells *cells, double t, const assay_field *b, double *volume,
                               assay_error *error);

/* Consistent nodal forces of a mesh for the body force and the tractions on all of its outer faces, by the principle of
 * virtual work:
 *   f_I = integral of (rho0 a N_I + P Grad N_I) dV, quasi-static: without rho0 a                                   [N]
 * which asks for no derivative of P. In the plane per metre of thickness. */
enum { ASSAY_TRIANGLE = 5, ASSAY_QUADRILATERAL = 9, ASSAY_TETRAHEDRON = 10, ASSAY_HEXAHEDRON = 12 }; /* as VTK */
typedef struct assay_mesh_options {
  uint32_t struct_size;
  int32_t element;             /* ASSAY_HEXAHEDRON ...: linear elements, nodes in VTK's order */
  size_t nodes, elements;
  const double *X;             /* coordinate c of node i: X[i * dimension + c] [m] */
  const int64_t *connectivity; /* node k of element e, from 0 */
  int32_t gauss;               /* points along each direction; 0: as many as the element needs */
  int32_t quasi_static;        /* not 0: without inertia */
} assay_mesh_options;
#define ASSAY_MESH_OPTIONS_INIT {sizeof(assay_mesh_options), 0, 0, 0, NULL, NULL, 0, 0}
ASSAY_API int assay_mesh_open(const assay_problem *problem, const assay_mesh_options *mesh, assay_mesh **handle,
                              assay_error *error);
ASSAY_API void assay_mesh_close(assay_mesh *mesh);
ASSAY_API int assay_nodal_loads(const assay_mesh *mesh, double t, const assay_field *force, assay_error *error);

/* For codes that know current positions alone: X of n points that are at x at time t, by the inverse of the exact
 * motion, and the fields there. A particle that has left its exact path gets the force of another one: results of such
 * codes are to be marked. X: null, or with null data, where it is not wanted. */
ASSAY_API int assay_at_current(const assay_problem *problem, double t, size_t n, int components,
                               const assay_const_field *x, const assay_field *X, const assay_view *out,
                               assay_error *error);

#ifdef __cplusplus
}
#endif

#endif /* ASSAY_H */
