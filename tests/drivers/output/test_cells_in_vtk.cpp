// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra of particles in the reader that users have: VTK, where its Python packages are installed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>

#include "harness/numeric/tensor.hpp"
#include "tests/drivers/cells_sample.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/support/python.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_cells_in_vtk {
namespace {

const std::string& python_with_vtk() {
  static const std::string found = python_with("vtkmodules.vtkFiltersVerdict");
  return found;
}

/// Writes what VTK has found: a line with points, cells and their kinds; a line a name, range and size of each array of
/// cells; and, as bytes, volumes by tetrahedra and the smallest scaled Jacobian of each cell, which is above 0 only
/// where it is oriented as VTK wants it.
constexpr const char* measure_py = R"py(
import sys
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter, vtkMeshQuality
errors = []
def watched(filter):
    for event in ('ErrorEvent', 'WarningEvent'):
        filter.AddObserver(event, lambda *a: errors.append(a))
    return filter
reader = watched(vtkXMLUnstructuredGridReader())
reader.SetFileName(sys.argv[1])
sizes, quality = watched(vtkCellSizeFilter()), watched(vtkMeshQuality())
sizes.SetInputConnection(reader.GetOutputPort())
quality.SetInputConnection(reader.GetOutputPort())
quality.SetHexQualityMeasureToScaledJacobian()
sizes.Update()
quality.Update()
if errors:
    sys.exit('VTK complains')
grid, out = reader.GetOutput(), sys.argv[2]
n, data = grid.GetNumberOfCells(), grid.GetCellData()
with open(out + '/said', 'w') as said:
    print(grid.GetNumberOfPoints(), n, sorted({grid.GetCellType(c) for c in range(n)}), file=said)
    for k in range(data.GetNumberOfArrays()):
        a = data.GetArray(k)
        print(a.GetName(), a.GetNumberOfComponents(), a.GetNumberOfTuples(), *a.GetRange(-1), file=said)
def dump(name, a):
    with open(out + '/' + name + '.bytes', 'wb') as file:
        if n > 0:
            file.write(bytes(memoryview(a)))
dump('Volume', sizes.GetOutput().GetCellData().GetArray('Volume'))
dump('Quality', quality.GetOutput().GetCellData().GetArray('Quality'))
for k in range(data.GetNumberOfArrays()):
    dump(data.GetArray(k).GetName(), data.GetArray(k))
)py";

class CellsInVtk : public testing::Test {
 protected:
  void SetUp() override {
    if (python_with_vtk().empty()) GTEST_SKIP() << "VTK for Python is not installed (python3-vtk9)";
  }

  /// What is in the scratch folder then is what VTK has found.
  void measure(const std::string& text) {
    const std::string file = scratch_.write("p.vtu", text), program = scratch_.write("measure.py", measure_py);
    const std::string command = python_with_vtk() + " '" + program + "' '" + file + "' '" + scratch_ / "" + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  std::string first_line() const {
    const std::string said = bytes_of(scratch_ / "said");
    return said.substr(0, said.find('\n'));
  }
  std::vector<double> array(const std::string& name) const {
    const std::string found = bytes_of(scratch_ / (name + ".bytes"));
    std::vector<double> values(found.size() / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), found.data(), found.size());
    return values;
  }

  /// Runs a scene; VTK reads its last snapshot. Each cell has the volume J V0 of its particle. Returns their sum.
  double volume_of_run(const std::string& scene, const std::vector<std::string>& sets, double alike) {
    const ScratchFolder results;
    const std::string out = results / "out";
    EXPECT_EQ(run(quiet_run(scene, out, sets)), 0) << scene;
    const std::string text = bytes_of(out + "/particles_0002.vtu");
    measure(text);
    const VtuFile file(text);
    const std::vector<double> V0 = file.array<double>("volume"), F = file.array<double>("deformation_gradient");
    const std::vector<double> volumes = array("Volume"), quality = array("Quality");
    const std::string n = std::to_string(V0.size());
    EXPECT_EQ(first_line(), std::to_string(8 * V0.size()) + " " + n + " [12]");
    EXPECT_EQ(volumes.size(), V0.size());
    for (std::size_t p = 0; p < volumes.size(); ++p) {
      const double expected = V0[p] * tensor_of(F.data() + 9 * p).determinant();
      EXPECT_NEAR(volumes[p], expected, alike * expected) << scene << ", particle " << p;
      EXPECT_GT(quality[p], 0) << scene << ", particle " << p;
    }
    for (const char* name : {"position", "velocity", "stress", "displacement_error"})
      EXPECT_EQ(array(name), file.array<double>(name)) << name;
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
  }

  ScratchFolder scratch_;
};

TEST_F(CellsInVtk, are_hexahedra_of_their_size) {
  constexpr std::size_t n = 5000;
  measure(cells_text(n));
  EXPECT_EQ(first_line(), "40000 5000 [12]");
  for (const double volume : array("Volume")) EXPECT_NEAR(volume, 0.006, 1e-12);
  for (const double quality : array("Quality")) EXPECT_NEAR(quality, 1, 1e-9);
  EXPECT_EQ(array("stress"), values_of(sample_array("stress", 9), n));
  const std::string said = bytes_of(scratch_ / "said");
  EXPECT_NE(said.find("\nid 1 5000 0.0 4999.0\n"), said.npos) << said;
  EXPECT_NE(said.find("\nstress 9 5000 "), said.npos) << said;
}

/// The measure that the other tests rely on sees corners in another order.
TEST_F(CellsInVtk, that_are_turned_inside_out_are_seen) {
  measure(cells_text(3, {}, true));
  for (const double quality : array("Quality")) EXPECT_LE(quality, 0);
}

TEST_F(CellsInVtk, none_are_a_file_too) {
  measure(cells_text(0));
  EXPECT_EQ(first_line(), "0 0 []");
}

/// The cube of a homogeneous motion: its volume is det F, to the rounding of a run.
TEST_F(CellsInVtk, of_a_run_fill_the_body) {
  const std::vector<std::string> sets{"grid.spacing=0.5", "output.particles=2", "output.pictures=false"};
  Tensor F;
  F << 1.3, 0.2, -0.1, 0.05, 1.1, 0.15, 0.1, -0.2, 1.2;
  EXPECT_NEAR(volume_of_run("space/homogeneous", sets, 1e-11), F.determinant(), 1e-10);
}

/// By splines, whose cells are those of F. And in a frame that spins and flies by CPDI2, whose corners move one by one:
/// on this coarse grid the volume between them differs from J V0 by up to 6 %.
TEST_F(CellsInVtk, of_a_vortex_keep_its_volume) {
  const std::vector<std::string> sets{"grid.spacing=0.25", "output.particles=2", "output.pictures=false",
                                      "time.end=0.5"};
  const double cells = std::pow(0.125, 3);
  for (const auto& [scene, alike] : {std::pair{"space/frame", 0.1}, {"space/ball_mooney_rivlin", 1e-11}}) {
    const double volume = volume_of_run(scene, sets, alike);
    EXPECT_NEAR(volume, cells * static_cast<double>(array("Volume").size()), 0.01 * volume) << scene;
  }
}

}  // namespace
}  // namespace assay::drivers::test_cells_in_vtk
