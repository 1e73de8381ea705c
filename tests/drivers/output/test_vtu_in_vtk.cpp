// SPDX-License-Identifier: BSD-3-Clause
// VTU files in the reader that users have: VTK, where its Python packages are installed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "drivers/output/vtu.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/python.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_vtu_in_vtk {
namespace {

const std::string& python_with_vtk() {
  static const std::string found = python_with("vtkmodules.vtkIOXML");
  return found;
}

/// Writes what VTK has read: a line each of points, cells and their kinds, then a file a name of each array's bytes.
constexpr const char* dump_py = R"py(
import sys
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
errors = []
for event in ('ErrorEvent', 'WarningEvent'):
    reader.AddObserver(event, lambda *a: errors.append(a))
reader.SetFileName(sys.argv[1])
reader.Update()
if errors:
    sys.exit('VTK complains')
grid = reader.GetOutput()
out = sys.argv[2]
n = grid.GetNumberOfPoints()
data, cells = grid.GetPointData(), grid.GetCells()
with open(out + '/said', 'w') as said:
    print(n, grid.GetNumberOfCells(), sorted({grid.GetCellType(c) for c in range(grid.GetNumberOfCells())}), file=said)
    for k in range(data.GetNumberOfArrays()):
        a = data.GetArray(k)
        names = [a.GetComponentName(c) or '-' for c in range(a.GetNumberOfComponents())]
        print(a.GetName(), a.GetDataTypeAsString(), *names, file=said)
def dump(name, a):
    with open(out + '/' + name + '.bytes', 'wb') as file:
        if a is not None and a.GetNumberOfValues() > 0:
            file.write(bytes(memoryview(a)))
for k in range(data.GetNumberOfArrays()):
    dump(data.GetArray(k).GetName(), data.GetArray(k))
dump('TimeValue', grid.GetFieldData().GetArray('TimeValue'))
dump('Points', grid.GetPoints().GetData() if grid.GetPoints() else None)
dump('connectivity', cells.GetConnectivityArray())
dump('offsets', cells.GetOffsetsArray())
)py";

class VtuInVtk : public testing::Test {
 protected:
  void SetUp() override {
    if (python_with_vtk().empty()) GTEST_SKIP() << "VTK for Python is not installed (python3-vtk9)";
  }

  /// Reads a file by VTK. What is in the scratch folder then is what VTK has found.
  void read(const std::string& text) {
    const std::string file = scratch_.write("p.vtu", text), program = scratch_.write("dump.py", dump_py);
    const std::string command = python_with_vtk() + " '" + program + "' '" + file + "' '" + scratch_ / "" + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  std::string said() const { return bytes_of(scratch_ / "said"); }
  std::string bytes(const std::string& name) const { return bytes_of(scratch_ / (name + ".bytes")); }

  ScratchFolder scratch_;
};

template <typename Value>
std::string as_bytes(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

TEST_F(VtuInVtk, every_array_is_what_was_written) {
  constexpr std::size_t n = 5000;  // several blocks, the last of them shorter
  std::vector<double> positions(3 * n), stress(9 * n), shear(n);
  std::vector<std::int64_t> id(n), first(n), last{0};
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = std::sin(0.37 * static_cast<double>(k));
  for (std::size_t k = 0; k < positions.size(); ++k) positions[k] = std::cos(0.11 * static_cast<double>(k));
  for (std::size_t p = 0; p < n; ++p) {
    shear[p] = stress[9 * p] - positions[3 * p];
    id[p] = (std::int64_t{1} << 53) + 1 + static_cast<std::int64_t>(p);  // no double
    first[p] = static_cast<std::int64_t>(p);
    last.push_back(first[p] + 1);  // VTK keeps the 0 in front
  }
  read(vtu_text(positions, {{"id", 1, id}, {"stress", 9, stress}, {"shear", 1, shear}}, 0.25));
  EXPECT_EQ(said(), "5000 5000 [1]\nid long long -\nstress double 11 12 13 21 22 23 31 32 33\nshear double -\n");
  EXPECT_EQ(bytes("Points"), as_bytes(positions));
  EXPECT_EQ(bytes("stress"), as_bytes(stress));
  EXPECT_EQ(bytes("shear"), as_bytes(shear));
  EXPECT_EQ(bytes("id"), as_bytes(id));
  EXPECT_EQ(bytes("connectivity"), as_bytes(first));
  EXPECT_EQ(bytes("offsets"), as_bytes(last));
  EXPECT_EQ(bytes("TimeValue"), as_bytes(std::vector<double>{0.25}));
}

/// The file whose numbers are put into their places one after the other, in any order.
TEST_F(VtuInVtk, a_layout_that_is_filled_by_and_by) {
  constexpr std::size_t n = 7;
  std::vector<double> positions(3 * n), stress(9 * n);
  for (std::size_t k = 0; k < positions.size(); ++k) positions[k] = std::cos(0.11 * static_cast<double>(k));
  for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = std::sin(0.37 * static_cast<double>(k));
  const VtuLayout layout(n, {{"stress", 9}}, 0.25);
  std::string text;
  const auto write = [&](std::uint64_t at, std::string_view bytes) {
    if (text.size() < at + bytes.size()) text.resize(at + bytes.size());
    text.replace(at, bytes.size(), bytes);
  };
  write(layout.begin(1), as_bytes(positions));
  write(layout.begin(0), as_bytes(stress));
  layout.write_rest(write);
  read(text);
  EXPECT_EQ(said(), "7 7 [1]\nstress double 11 12 13 21 22 23 31 32 33\n");
  EXPECT_EQ(bytes("Points"), as_bytes(positions));
  EXPECT_EQ(bytes("stress"), as_bytes(stress));
  EXPECT_EQ(bytes("TimeValue"), as_bytes(std::vector<double>{0.25}));
}

TEST_F(VtuInVtk, no_particles_is_a_file_too) {
  read(vtu_text({}, {{"shear", 1, std::span<const double>{}}}, 0.5));
  EXPECT_EQ(said().substr(0, 7), "0 0 []\n") << said();
  EXPECT_EQ(bytes("shear"), "");
  EXPECT_EQ(bytes("TimeValue"), as_bytes(std::vector<double>{0.5}));
}

TEST_F(VtuInVtk, the_snapshots_of_a_run) {
  const ScratchFolder results;
  const std::string out = results / "out";
  ASSERT_EQ(run(quiet_run("paper/vortex_cpdi", out, {"grid.spacing=0.125", "output.particles=1", "time.end=0.1"})), 0);
  const std::string text = bytes_of(out + "/particles_0001.vtu");
  read(text);
  const VtuFile file(text);
  for (const std::string& name : file.names()) {
    if (name == "offsets" || name == "types") continue;  // VTK keeps them in another way
    EXPECT_EQ(bytes(name), file.bytes(name)) << name;
  }
  EXPECT_EQ(bytes("TimeValue"), as_bytes(std::vector<double>{0.1}));
}

/// The reader that this test relies on does complain.
TEST_F(VtuInVtk, a_damaged_block_is_found) {
  std::string text = vtu_text(std::vector<double>(3000, 0.5), {}, 0.5);
  text[text.rfind("\n</AppendedData>") - 5] ^= 0x10;
  const std::string file = scratch_.write("p.vtu", text), program = scratch_.write("dump.py", dump_py);
  const std::string command =
      python_with_vtk() + " '" + program + "' '" + file + "' '" + scratch_ / "" + "' > '" + scratch_ / "log" + "' 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0) << bytes_of(scratch_ / "log");
}

}  // namespace
}  // namespace assay::drivers::test_vtu_in_vtk
