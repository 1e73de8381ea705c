/* SPDX-License-Identifier: BSD-3-Clause */
/* A code that was compiled against the header of API 1.0, which lies beside it and never changes: the library of today
 * must serve it, and its structs must be as they were. */
#include "assay.h"

#include <stdio.h>
#include <string.h>

#define LIES(TYPE, MEMBER, OFFSET) \
  _Static_assert(offsetof(TYPE, MEMBER) == (OFFSET), #TYPE "." #MEMBER " has moved")
#define IS_LONG(TYPE, SIZE) _Static_assert(sizeof(TYPE) == (SIZE), #TYPE " has another size")

/* of 64-bit systems */
LIES(assay_error, code, 4);
LIES(assay_error, line, 8);
LIES(assay_error, point, 16);
LIES(assay_error, file, 24);
LIES(assay_error, key, 280);
LIES(assay_error, message, 408);
IS_LONG(assay_error, 920);
LIES(assay_options, api_major, 4);
LIES(assay_options, scene, 8);
LIES(assay_options, text, 16);
LIES(assay_options, set_count, 24);
LIES(assay_options, sets, 32);
LIES(assay_options, end, 40);
LIES(assay_options, threads, 48);
IS_LONG(assay_options, 56);
LIES(assay_facts, dimension, 4);
LIES(assay_facts, end, 8);
LIES(assay_facts, particle_speed, 40);
IS_LONG(assay_facts, 48);
IS_LONG(assay_field, 24);
IS_LONG(assay_const_field, 24);
LIES(assay_view, status, 8);
LIES(assay_view, x, 16);
LIES(assay_view, F, 88);
LIES(assay_view, b, 160);
LIES(assay_view, b_static, 184);
IS_LONG(assay_view, 208);
LIES(assay_mesh_options, element, 4);
LIES(assay_mesh_options, nodes, 8);
LIES(assay_mesh_options, X, 24);
LIES(assay_mesh_options, connectivity, 32);
LIES(assay_mesh_options, gauss, 40);
LIES(assay_mesh_options, quasi_static, 44);
IS_LONG(assay_mesh_options, 48);
_Static_assert(ASSAY_DONE == 0 && ASSAY_FINDING == 1 && ASSAY_BAD_INPUT == 2 && ASSAY_SYSTEM == 3 &&
                   ASSAY_BEYOND_END == 4 && ASSAY_OUTSIDE == 5,
               "codes have changed");

static int fail(const char *call, const assay_error *error) {
  printf("%s: %d: %s\n", call, error->code, error->message);
  return 1;
}

int main(void) {
  const double X[4] = {.9, .2, .8, .1}, corners[8] = {.8, .1, .9, .1, .9, .2, .8, .2}, N[4] = {1, 0, 0, 1};
  const int64_t nodes[4] = {0, 1, 2, 3};
  const assay_const_field places = {X, 2, 1}, normals = {N, 2, 1};
  double b[4], t[4], mean[2], force[8], back[4], volume;
  const assay_field field = {b, 2, 1}, tractions = {t, 2, 1}, means = {mean, 2, 1}, forces = {force, 2, 1},
                    from = {back, 2, 1};
  assay_view view = ASSAY_VIEW_INIT;
  assay_options options = ASSAY_OPTIONS_INIT;
  assay_facts facts = ASSAY_FACTS_INIT;
  assay_error error = ASSAY_ERROR_INIT;
  assay_mesh_options mesh = {sizeof(assay_mesh_options), ASSAY_QUADRILATERAL, 4, 1, NULL, NULL, 0, 0};
  assay_problem *problem = NULL;
  assay_points *points = NULL;
  assay_cells *cells = NULL;
  assay_mesh *handle = NULL;
  char words[64];
  size_t needed = 0;

  options.text = "motion: {type: vortex, amplitude: {type: sine, peak: 1}}\n"
                 "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\nforce: {cache: false}\n";
  mesh.X = corners, mesh.connectivity = nodes;
  if (assay_open(&options, &problem, &error)) return fail("open", &error);
  if (assay_get_facts(problem, &facts, &error)) return fail("facts", &error);
  if (assay_points_open(problem, 2, 2, &places, &points, &error)) return fail("points", &error);
  if (assay_cells_open(problem, 1, corners, &cells, &error)) return fail("cells", &error);
  if (assay_mesh_open(problem, &mesh, &handle, &error)) return fail("mesh", &error);
  if (assay_describe(problem, words, sizeof words, &needed) || needed < sizeof words) return fail("describe", &error);
  if (assay_warnings(problem, words, sizeof words, &needed)) return fail("warnings", &error);
  assay_close(problem); /* the others keep it alive */
  view.b = field;
  if (assay_eval(points, .3, 0, 2, &view, &error)) return fail("eval", &error);
  if (assay_tractions(points, .3, 0, 2, &normals, &tractions, &error)) return fail("tractions", &error);
  if (assay_cells_eval(cells, .3, &means, &volume, &error)) return fail("cells", &error);
  if (assay_nodal_loads(handle, .3, &forces, &error)) return fail("loads", &error);
  assay_points_close(points);
  assay_cells_close(cells);
  assay_mesh_close(handle);
  if (assay_open(&options, &problem, &error)) return fail("open", &error);
  if (assay_at_current(problem, 0, 2, 2, &places, &from, &view, &error)) return fail("at_current", &error);
  assay_close(problem);
  printf("assay %s: %s\n", assay_version(), b[0] == b[0] && back[0] == X[0] ? "served" : "wrong numbers");
  return !(b[0] == b[0] && back[0] == X[0]);
}
