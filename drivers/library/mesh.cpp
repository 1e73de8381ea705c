// SPDX-License-Identifier: BSD-3-Clause
// Of assay.h: consistent nodal forces of a mesh.
#include <algorithm>
#include <limits>
#include <utility>

#include "drivers/library/exact_problem.hpp"
#include "drivers/library/fields.hpp"
#include "harness/exact/nodal_loads.hpp"

struct assay_mesh {
  assay::drivers::HandleMark mark = assay::drivers::HandleMark::mesh;
  std::shared_ptr<const assay::drivers::ExactProblem> problem;
  assay::NodalLoads loads;
};

namespace assay::drivers {

namespace {

ElementMesh::Shape shape_of(std::int32_t element) {
  using Shape = ElementMesh::Shape;
  constexpr std::pair<int, Shape> known[] = {{ASSAY_TRIANGLE, Shape::triangle},
                                             {ASSAY_QUADRILATERAL, Shape::quadrilateral},
                                             {ASSAY_TETRAHEDRON, Shape::tetrahedron},
                                             {ASSAY_HEXAHEDRON, Shape::hexahedron}};
  const auto found = std::ranges::find(known, element, [](const auto& row) { return row.first; });
  refuse_call_if(found == std::end(known), "mesh.element",
                 "is none of ASSAY_TRIANGLE, ASSAY_QUADRILATERAL, ASSAY_TETRAHEDRON, ASSAY_HEXAHEDRON");
  return found->second;
}

ElementMesh mesh_of(const assay_mesh_options& given, const ExactProblem& problem) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  ElementMesh mesh;
  mesh.shape = shape_of(given.element);
  const int dimension = problem.dimension();
  refuse_call_if(mesh.is_plane() != (dimension == 2), "mesh.element", "is not of the dimension of the problem");
  refuse_call_if(given.nodes > most || given.elements > most, "mesh.nodes", "there are too many nodes or elements");
  refuse_call_if(given.elements > 0 && !given.connectivity, "mesh.connectivity", "must not be null");
  mesh.X = vectors_of(given.nodes, dimension, {given.X, dimension, 1}, "mesh.X");
  if (given.elements > 0)
    mesh.connectivity.assign(given.connectivity, given.connectivity + given.elements * mesh.nodes_of_element());
  for (std::size_t i = 0; i < mesh.X.size(); ++i) {
    if (!problem.holds(mesh.X[i]))
      throw RefusedCall("mesh.X", "the node lies where the motion is not defined", ASSAY_BAD_INPUT,
                        static_cast<std::int64_t>(i));
  }
  return mesh;
}

}  // namespace

extern "C" {

ASSAY_API int assay_mesh_open(const assay_problem* problem, const assay_mesh_options* mesh, assay_mesh** handle,
                              assay_error* error) {
  if (handle) *handle = nullptr;
  return call_of_library(error, [&] {
    refuse_call_if(!handle, "handle", "must not be null");
    const auto& shared = known_handle(problem, HandleMark::problem, "problem").shared;
    const assay_mesh_options known = known_part(mesh, sizeof(assay_mesh_options), "mesh");
    refuse_call_if(known.gauss < 0 || known.gauss > NodalLoadRule::most_points, "mesh.gauss",
                   "must be 0 .. " + std::to_string(NodalLoadRule::most_points));
    try {
      NodalLoads loads(mesh_of(known, *shared), shared->solution(), shared->density(),
                       {.gauss = known.gauss, .quasi_static = known.quasi_static != 0 || shared->is_quasi_static()});
      *handle = new assay_mesh{HandleMark::mesh, shared, std::move(loads)};
    } catch (const MeshFault& fault) {
      throw RefusedCall("mesh." + fault.argument, fault.what(), ASSAY_BAD_INPUT, fault.index);
    }
    return ASSAY_DONE;
  });
}

ASSAY_API void assay_mesh_close(assay_mesh* mesh) { close_handle(mesh, HandleMark::mesh); }

ASSAY_API int assay_nodal_loads(const assay_mesh* mesh, double t, const assay_field* force, assay_error* error) {
  return call_of_library(error, [&] {
    const assay_mesh& known = known_handle(mesh, HandleMark::mesh, "mesh");
    const auto slice = known.problem->slice(t);
    refuse_call_if(!force || !force->data, "force", "must not be null");
    const std::vector<Vector3> forces = known.loads.at(*slice);
    check_strides(*force, forces.size(), "force");
    for (std::size_t i = 0; i < forces.size(); ++i) put_vector(*force, i, forces[i], known.problem->dimension());
    return ASSAY_DONE;
  });
}

}  // extern "C"

}  // namespace assay::drivers
