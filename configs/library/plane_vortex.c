/* SPDX-License-Identifier: BSD-3-Clause */
/* A finite element code of its own, verified: total Lagrangian, bilinear quadrilaterals, lumped mass, explicit.
 *   cc -O2 plane_vortex.c -o plane_vortex $(pkg-config --cflags --libs assay) -lm
 *   ./plane_vortex plane_vortex.yaml */
#include <assay.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void need(int code, const assay_error *error) {
  if (code) fprintf(stderr, "%s\n", error->message), exit(code);
}

/* The author's material: neo-Hookean, P = mu (F - F^-T) + lambda ln J F^-T in plane strain. */
static void stress(const double F[4], double P[4]) {
  const double E = 1e3, nu = 0.3, mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const double J = F[0] * F[3] - F[1] * F[2], inverse_t[4] = {F[3] / J, -F[2] / J, -F[1] / J, F[0] / J};
  for (int c = 0; c < 4; ++c) P[c] = mu * (F[c] - inverse_t[c]) + lambda * log(J) * inverse_t[c];
}

/* Adds the internal forces of n x n elements of the size h: f_I -= P Grad N_I, at 2 x 2 Gauss points. */
static void internal_forces(int n, double h, double (*x)[2], double (*f)[2]) {
  const int corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int e = 0; e < n * n; ++e) {
    const int first = e / n * (n + 1) + e % n, node[4] = {first, first + 1, first + n + 2, first + n + 1};
    for (int g = 0; g < 4; ++g) {
      double slope[4][2], F[4] = {0}, P[4];
      for (int k = 0; k < 4; ++k)
        for (int d = 0; d < 2; ++d) {
          slope[k][d] = corner[k][d] * (1 + corner[k][1 - d] * corner[g][1 - d] / sqrt(3)) / (2 * h);
          for (int i = 0; i < 2; ++i) F[2 * i + d] += x[node[k]][i] * slope[k][d];
        }
      stress(F, P);
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 2; ++i) f[node[k]][i] -= h * h / 4 * (P[2 * i] * slope[k][0] + P[2 * i + 1] * slope[k][1]);
    }
  }
}

/* Of the part of the square [-1.5, 1.5]^2 that belongs to a node. */
static double width(double X, double h) { return fabs(X) > 1.5 - h / 2 ? h / 2 : h; }

/* The largest error over time [m]: root mean square over the nodes of the ring. */
static double error_of(const assay_problem *problem, int n) {
  assay_error error = ASSAY_ERROR_INIT;
  assay_facts facts = ASSAY_FACTS_INIT;
  need(assay_get_facts(problem, &facts, &error), &error);
  const size_t nodes = (size_t)(n + 1) * (n + 1), bytes = nodes * sizeof(double[2]);
  const double h = 3.0 / n;
  const int steps = (int)ceil(facts.end * facts.wave_speed / (0.3 * h));
  const double dt = facts.end / steps;
  double(*X)[2] = malloc(bytes), (*x)[2] = malloc(bytes), (*v)[2] = malloc(bytes), (*f)[2] = malloc(bytes);
  double(*b)[2] = malloc(bytes), (*exact)[2] = malloc(bytes), largest = 0;
  for (size_t p = 0; p < nodes; ++p) X[p][0] = -1.5 + h * (p % (n + 1)), X[p][1] = -1.5 + h * (p / (n + 1));

  assay_points *points; /* 1. the seeds: x and v at t = 0 */
  const assay_const_field given = {&X[0][0], 2, 1};
  need(assay_points_open(problem, nodes, 2, &given, &points, &error), &error);
  assay_view seeds = ASSAY_VIEW_INIT, force = ASSAY_VIEW_INIT, judge = ASSAY_VIEW_INIT;
  seeds.x = (assay_field){&x[0][0], 2, 1}, seeds.v = (assay_field){&v[0][0], 2, 1};
  force.b = (assay_field){&b[0][0], 2, 1}, judge.x = (assay_field){&exact[0][0], 2, 1};
  need(assay_eval(points, 0, 0, nodes, &seeds, &error), &error);
  for (int k = 0; k < steps; ++k) {
    need(assay_eval(points, k * dt, 0, nodes, &force, &error), &error); /* 2. the force: b at the nodes, now */
    for (size_t p = 0; p < nodes; ++p) f[p][0] = f[p][1] = 0;
    internal_forces(n, h, x, f);
    for (size_t p = 0; p < nodes; ++p) {
      const double mass = facts.density * width(X[p][0], h) * width(X[p][1], h);
      for (int i = 0; i < 2; ++i) {
        v[p][i] += (k ? dt : dt / 2) * (b[p][i] + f[p][i] / mass); /* to the middle of the step */
        x[p][i] += dt * v[p][i];
      }
    }
    need(assay_eval(points, (k + 1) * dt, 0, nodes, &judge, &error), &error); /* 3. the judgement: the exact x */
    double sum = 0, count = 0;
    for (size_t p = 0; p < nodes; ++p)
      if (fabs(hypot(X[p][0], X[p][1]) - 1) < 0.25)
        sum += pow(x[p][0] - exact[p][0], 2) + pow(x[p][1] - exact[p][1], 2), ++count;
    largest = fmax(largest, sqrt(sum / count));
  }
  assay_points_close(points);
  free(X), free(x), free(v), free(f), free(b), free(exact);
  return largest;
}

int main(int argc, char **argv) {
  assay_problem *problem;
  assay_error error = ASSAY_ERROR_INIT;
  assay_options options = ASSAY_OPTIONS_INIT;
  options.scene = argc > 1 ? argv[1] : "plane_vortex.yaml";
  need(assay_open(&options, &problem, &error), &error);
  const double coarse = error_of(problem, 32), fine = error_of(problem, 64);
  printf("errors %.3e and %.3e m, order %.2f\n", coarse, fine, log2(coarse / fine));
  assay_close(problem);
  return 0;
}
