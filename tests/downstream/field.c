/* SPDX-License-Identifier: BSD-3-Clause */
/* Somebody else's code: the body force of a vortex at one of its points. */
#include <assay.h>
#include <stdio.h>

int main(void) {
  const double X[2] = {1, .1};
  double b[2] = {0, 0};
  const assay_const_field places = {X, 2, 1};
  assay_options options = ASSAY_OPTIONS_INIT;
  assay_error error = ASSAY_ERROR_INIT;
  assay_view view = ASSAY_VIEW_INIT;
  assay_problem *problem = NULL;
  assay_points *points = NULL;

  options.text = "motion: {type: vortex}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n";
  view.b.data = b, view.b.point_stride = 2, view.b.component_stride = 1;
  if (assay_open(&options, &problem, &error) ||
      assay_points_open(problem, 1, 2, &places, &points, &error) || assay_eval(points, .3, 0, 1, &view, &error)) {
    printf("%s\n", error.message);
    return error.code;
  }
  printf("libassay %s: b = %g %g\n", assay_version(), b[0], b[1]);
  assay_points_close(points);
  assay_close(problem);
  return 0;
}
