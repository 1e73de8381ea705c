/* SPDX-License-Identifier: BSD-3-Clause */
/* The tutorial model with a mistake in its components, which the parameter `fault` chooses. */
#include <math.h>
#include <stdlib.h>

#include "harness/assay_material.h"
#include "tests/adapters/foreign/component_faults.h"

extern const assay_material* assay_builtin_neo_hookean(uint32_t host_major, uint32_t index);
ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index);

typedef struct {
  void* right;
  enum component_fault fault;
} Model;

static const assay_parameter parameters[] = {
    {"E", "Pa", NAN, 1e-300, 1e300, "Young's modulus"},
    {"nu", "1", 0.3, -0.999999, 0.499999999, "Poisson's ratio"},
    {"fault", "1", no_fault, no_fault, five_percent_in_33, "which mistake, by its number; 0: none"},
};

static const assay_material* right_model(void) { return assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0); }

static void* create(const double* p, char* message) {
  Model* self = malloc(sizeof *self);
  if (self == NULL) return NULL;
  self->right = right_model()->create(p, message);
  self->fault = (enum component_fault)p[2];
  if (self->right != NULL) return self;
  free(self);
  return NULL;
}

static void destroy(void* self) {
  right_model()->destroy(((Model*)self)->right);
  free(self);
}

static void update(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
                   int32_t* status, double* dt_factor, char* message) {
  static const size_t row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
  const Model* model = self;
  right_model()->update(model->right, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (size_t p = 0; p < n; ++p) {
    double stress[6];
    for (size_t c = 0; c < 6; ++c) stress[c] = cauchy[(3 * row[c] + column[c]) * n + p];
    plant_fault(model->fault, stress);
    for (size_t c = 0; c < 6; ++c) {
      cauchy[(3 * row[c] + column[c]) * n + p] = cauchy[(3 * column[c] + row[c]) * n + p] = stress[c];
    }
  }
}

/* None of the extensions: what they say is right, and what is wrong is to be seen by the stress alone. */
const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table;
  const assay_material* right = assay_builtin_neo_hookean(host_major, index);
  if (right == NULL) return NULL;
  table = *right;
  table.name = "component_faults";
  table.parameter_count = sizeof parameters / sizeof *parameters;
  table.parameters = parameters;
  table.create = create;
  table.destroy = destroy;
  table.update = update;
  table.extension = NULL;
  return &table;
}
