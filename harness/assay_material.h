/* SPDX-License-Identifier: BSD-3-Clause */
/* The assay material ABI, version 1.2: the only header that a plug-in needs.
 *
 * A plug-in is a shared library that exports one symbol, `assay_material_entry`. It returns tables of metadata and
 * functions. Pure C11; also compiles as C++17 and C++20. SI units throughout.
 *
 * Arrays of n points are component-major: component c of point p is a[c * n + p]. Tensors have nine components,
 * row-major (11,12,13,21,22,23,31,32,33); symmetric tensors kept in the state have six (11,22,33,12,13,23), plain
 * shear components, no factors. 1 <= n <= ASSAY_BATCH_MAX. Inputs and outputs never alias; 8-byte alignment is all
 * that is promised. No exception and no longjmp may cross this interface. Tables and strings live as long as the
 * process; libraries are never closed.
 */
#ifndef ASSAY_MATERIAL_H
#define ASSAY_MATERIAL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ASSAY_ABI_MAJOR 1
#define ASSAY_ABI_MINOR 2
#define ASSAY_BATCH_MAX 4096
#define ASSAY_MESSAGE_SIZE 512
#define ASSAY_ENTRY_SYMBOL "assay_material_entry"

#if defined(_WIN32)
#define ASSAY_EXPORT __declspec(dllexport)
#else
#define ASSAY_EXPORT __attribute__((visibility("default")))
#endif

/* Status of a point after `update`, and of a call. */
enum { ASSAY_FAILED = -1, ASSAY_DOUBTFUL = 0, ASSAY_GOOD = 1 };

/* One parameter. A default that is NaN makes the parameter required. Bounds are inclusive; +-infinity for none. */
typedef struct assay_parameter {
  const char *name;
  const char *unit; /* "Pa", "1", "s", ... */
  double default_value;
  double lower;
  double upper;
  const char *doc; /* one line */
} assay_parameter;

/* Kind of a state variable: 1, 3, 6 or 9 components. */
enum { ASSAY_SCALAR = 0, ASSAY_VECTOR = 1, ASSAY_SYMMETRIC_TENSOR = 2, ASSAY_TENSOR = 3 };

/* Role of a state variable under a superposed rotation of the frame. */
enum {
  ASSAY_ROLE_PLAIN = 0,           /* rotates as a tensor of its kind */
  ASSAY_ROLE_ROTATES_ITSELF = 1,  /* the model keeps it in a frame of its own: not to be rotated by the host */
  /* vector: unit reference direction of the material, filled by the host; of several the second lies a right angle
   * about E3 further (E1 where the first is along E3), the third at right angles to both */
  ASSAY_ROLE_DIRECTION = 2,
  /* since 1.2. scalar: a field of the surroundings, as temperature, that the host prescribes. initial_state writes its
   * usual value. In a step state0 holds its value at t, and state1 holds on entry that at t + dt, which stays there */
  ASSAY_ROLE_FIELD = 3
};

/* One state variable; they lie one after another, in declared order, in the state array. */
typedef struct assay_state_variable {
  const char *name;
  const char *unit;
  int32_t kind;
  int32_t role;
  const char *doc;
} assay_state_variable;

/* Material symmetry; of ASSAY_ANISOTROPIC the extension assay.symmetry/1 can say more. */
enum { ASSAY_ISOTROPIC = 0, ASSAY_CYLINDRICALLY_ORTHOTROPIC = 1, ASSAY_ANISOTROPIC = 2 };

/* Flags, or-ed together. */
enum {
  ASSAY_NON_SMOOTH = 1u << 0,     /* the response has kinks (yield, cracks) */
  ASSAY_RATE_DEPENDENT = 1u << 1, /* the response depends on dt, not on the path alone */
  ASSAY_THREAD_SAFE = 1u << 2,    /* `update` may run concurrently on one `self` */
  ASSAY_USES_INCREMENT = 1u << 3, /* reads F0 as well as F1; absent: total F (F1) alone */
  ASSAY_IN_PLANE = 1u << 4,       /* takes no deformation with F13, F23, F31 or F32 */
  ASSAY_GROWS = 1u << 5           /* its own strain changes with time, as of growth: work may come out of it */
};

/* One step of n points. F0, F1: deformation gradients at t and t + dt, 9 * n each. */
typedef struct assay_step {
  double t;  /* time at the beginning [s] */
  double dt; /* length [s]; > 0 */
  const double *F0;
  const double *F1;
} assay_step;

typedef struct assay_material {
  uint32_t abi_major;   /* ASSAY_ABI_MAJOR of the header it was built with */
  uint32_t struct_size; /* sizeof(assay_material) there; what lies beyond is null to the host */
  const char *name;     /* [a-z0-9_]+ */
  const char *version;
  const char *licence;
  const char *doc;      /* one line */
  int32_t symmetry;
  uint32_t flags;
  uint32_t parameter_count;
  uint32_t state_count;
  const assay_parameter *parameters;
  const assay_state_variable *state;

  /* New instance. parameters: in declared order, defaults filled, bounds checked. Null on failure, with a reason in
   * message[ASSAY_MESSAGE_SIZE]. */
  void *(*create)(const double *parameters, char *message);
  void (*destroy)(void *self);

  /* State of n points at rest under the initial Cauchy stress (9 * n, [Pa]). Writes every component; variables of
   * role `direction` are filled by the host afterwards. May be null when state_count is 0. Returns a status;
   * ASSAY_FAILED where the model cannot carry that stress. */
  int32_t (*initial_state)(void *self, size_t n, const double *cauchy, double *state);

  /* Stress and state at the end of the step. Pure: the outputs are a function of the arguments and of `self`, which
   * is not changed, so a step can be repeated, halved and replayed.
   *   state0 (in), state1 (out): sum of the components of the state * n;  cauchy (out): 9 * n, [Pa]
   *   status (out): n;  dt_factor (in/out): 1 on entry, below 1 asks for a shorter step, 0: none would do
   *   message (out): ASSAY_MESSAGE_SIZE, empty on entry. */
  void (*update)(void *self, const assay_step *step, size_t n, const double *state0, double *state1, double *cauchy,
                 int32_t *status, double *dt_factor, char *message);

  /* Optional abilities by name, null where absent; may itself be null. */
  const void *(*extension)(const char *id);

  /* Since 1.1. For libraries that build their tables at run time: as `create` and `extension`, with the table that was
   * asked for, which may be the first member of a larger struct. May be null; called in place of those where not. */
  void *(*create_of)(const struct assay_material *table, const double *parameters, char *message);
  const void *(*extension_of)(const struct assay_material *table, const char *id);
} assay_material;

/* index counts the tables of a library from 0; null past the last, or where host_major is not served. */
typedef const assay_material *(*assay_material_entry_function)(uint32_t host_major, uint32_t index);

/* ---- extensions ------------------------------------------------------------------------------------------------ */

/* Rate form: the ordinary differential equations that the increments approximate.
 * velocity_gradient: l = Fdot F^-1, 9 * n [1/s]. cauchy_rate [Pa/s]. */
#define ASSAY_EXTENSION_RATE "assay.rate/1"
typedef struct assay_rate {
  uint32_t struct_size;
  int32_t (*rate)(void *self, double t, size_t n, const double *F, const double *velocity_gradient,
                  const double *cauchy, const double *state, double *cauchy_rate, double *state_rate);
} assay_rate;

/* Tangent of one step: d cauchy / d F1, 81 * n, row i (component of stress), column j (component of F1):
 * tangent[(9 * i + j) * n + p], [Pa]. A field (ASSAY_ROLE_FIELD) has throughout the step the value that it has in
 * state0: its value at t + dt is not handed over. */
#define ASSAY_EXTENSION_TANGENT "assay.tangent/1"
typedef struct assay_tangent {
  uint32_t struct_size;
  int32_t (*tangent)(void *self, const assay_step *step, size_t n, const double *state0, double *tangent);
} assay_tangent;

/* Stored energy per reference volume, n [J/m^3]. */
#define ASSAY_EXTENSION_ENERGY "assay.energy/1"
typedef struct assay_energy {
  uint32_t struct_size;
  int32_t (*energy)(void *self, size_t n, const double *F, const double *state, double *energy);
} assay_energy;

/* Fastest acoustic wave in the current configuration, n [m/s]; density: in the reference configuration [kg/m^3]. */
#define ASSAY_EXTENSION_WAVE_SPEED "assay.wave_speed/1"
typedef struct assay_wave_speed {
  uint32_t struct_size;
  int32_t (*wave_speed)(void *self, double density, size_t n, const double *F, const double *cauchy,
                        const double *state, double *speed);
} assay_wave_speed;

/* Exact first Piola-Kirchhoff stress tau of a baseline F = I + eps D, and d tau / d eps, 9 * n each [Pa].
 * Returns ASSAY_FAILED for a baseline without closed form. */
#define ASSAY_EXTENSION_CLOSED_FORM "assay.closed_form/1"
enum {
  ASSAY_BASELINE_SIMPLE_SHEAR = 1,   /* (16): D = 2 E2 E1 */
  ASSAY_BASELINE_UNIAXIAL_STRAIN = 2 /* (38): D = E1 E1 */
};
typedef struct assay_closed_form {
  uint32_t struct_size;
  int32_t (*tau)(void *self, int32_t baseline, size_t n, const double *eps, double *tau, double *dtau_deps);
} assay_closed_form;

/* Why the last call of `initial_state` on `self`, or of an extension, returned ASSAY_FAILED: one sentence, empty where
 * there is none; valid until the next call on `self`. */
#define ASSAY_EXTENSION_REASON "assay.reason/1"
typedef struct assay_reason {
  uint32_t struct_size;
  const char *(*reason)(void *self);
} assay_reason;

/* Values of all parameters, in declared order, at which the model shows what it does (yields, relaxes, breaks): for
 * whoever tries a model whose parameters have no default. */
#define ASSAY_EXTENSION_EXAMPLE "assay.example/1"
typedef struct assay_example {
  uint32_t struct_size;
  const double *parameters;
} assay_example;

/* Class of an anisotropic material: the rotations of the undeformed body after which it answers as before. The axes are
 * the material's own; the host finds them. */
#define ASSAY_EXTENSION_SYMMETRY "assay.symmetry/1"
enum {
  ASSAY_MONOCLINIC = 1,             /* half turns about one axis */
  ASSAY_ORTHOTROPIC = 2,            /* half turns about three axes at right angles */
  ASSAY_TRIGONAL = 3,               /* turns by 120 degrees about one axis, half turns about one across */
  ASSAY_TETRAGONAL = 4,             /* turns by 90 degrees about one axis, half turns about one across */
  ASSAY_HEXAGONAL = 5,              /* turns by 60 degrees about one axis, half turns about one across */
  ASSAY_TRANSVERSELY_ISOTROPIC = 6, /* turns by any angle about one axis, half turns about any across */
  ASSAY_CUBIC = 7                   /* turns by 90 degrees about three axes at right angles */
};
typedef struct assay_symmetry {
  uint32_t struct_size;
  int32_t material_class;
} assay_symmetry;

#ifdef __cplusplus
}
#endif

#endif /* ASSAY_MATERIAL_H */
