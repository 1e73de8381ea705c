// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/vtu.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/drivers/sample_vortex.hpp"

namespace assay::drivers::test_vtu {
namespace {

/// The value of an attribute of the DataArray called `name`.
std::string attribute(const std::string& file, const std::string& name, const std::string& key) {
  std::size_t at = file.find(" Name=\"" + name + "\"");
  if (at == std::string::npos) return {};
  at = file.rfind('<', at);
  const std::string tag = file.substr(at, file.find('>', at) - at);
  const std::size_t value = tag.find(" " + key + "=\"");
  if (value == std::string::npos) return {};
  const std::size_t begin = value + key.size() + 3;
  return tag.substr(begin, tag.find('"', begin) - begin);
}

/// Reads an array by the rules of the format: 8 bytes of length after the underscore plus the offset, then the values.
template <typename Value>
std::vector<Value> array(const std::string& file, const std::string& name) {
  const std::size_t start = file.find('_', file.find("<AppendedData encoding=\"raw\">")) + 1;
  const std::size_t at = start + std::stoull(attribute(file, name, "offset"));
  std::uint64_t bytes = 0;
  if (at + 8 > file.size()) return {};
  std::memcpy(&bytes, file.data() + at, 8);
  if (bytes > file.size() - at - 8) return {};
  std::vector<Value> out(bytes / sizeof(Value));
  if (!out.empty()) std::memcpy(out.data(), file.data() + at + 8, out.size() * sizeof(Value));
  return out;
}

struct Sample {
  std::vector<double> positions, velocity, stress, shear;
  std::vector<std::int64_t> id;
  std::string file() const {
    return vtu_text(positions, {{"id", 1, id}, {"velocity", 3, velocity}, {"stress", 9, stress}, {"shear", 1, shear}},
                    0.25);
  }
};

Sample sample() {
  Sample out;
  const ParticleFrame frame = sample_vortex(0.1, 0.25);
  for (std::size_t p = 0; p < frame.x.size(); ++p) {
    out.positions.insert(out.positions.end(), {frame.x[p], frame.y[p], 0});
    out.velocity.insert(out.velocity.end(), {-frame.y[p], frame.x[p], 0});
    for (int c = 0; c < 9; ++c) out.stress.push_back(static_cast<double>(p) + 0.1 * c);
    out.shear.push_back(frame.value[p]);
    out.id.push_back((std::int64_t{1} << 53) + 1 + static_cast<std::int64_t>(p));  // no double
  }
  return out;
}

TEST(Vtu, holds_every_value) {
  const Sample in = sample();
  const std::string file = in.file();
  const std::size_t n = in.id.size();
  ASSERT_GT(n, 200u);
  EXPECT_NE(file.find("NumberOfPoints=\"" + std::to_string(n) + "\" NumberOfCells=\"" + std::to_string(n) + "\""),
            std::string::npos);
  EXPECT_NE(file.find("byte_order=\"LittleEndian\" header_type=\"UInt64\""), std::string::npos);
  EXPECT_EQ(array<double>(file, "Points"), in.positions);
  EXPECT_EQ(array<double>(file, "velocity"), in.velocity);
  EXPECT_EQ(array<double>(file, "stress"), in.stress);
  EXPECT_EQ(array<double>(file, "shear"), in.shear);
  EXPECT_EQ(array<std::int64_t>(file, "id"), in.id);
  EXPECT_EQ(array<double>(file, "TimeValue"), std::vector<double>{0.25});
  EXPECT_EQ(attribute(file, "id", "type"), "Int64");
  EXPECT_EQ(attribute(file, "stress", "type"), "Float64");
  EXPECT_EQ(attribute(file, "stress", "NumberOfComponents"), "9");
  const auto connectivity = array<std::int64_t>(file, "connectivity"), offsets = array<std::int64_t>(file, "offsets");
  ASSERT_EQ(connectivity.size(), n);
  ASSERT_EQ(offsets.size(), n);
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_EQ(connectivity[p], static_cast<std::int64_t>(p));
    EXPECT_EQ(offsets[p], static_cast<std::int64_t>(p) + 1);
  }
  EXPECT_EQ(array<std::uint8_t>(file, "types"), std::vector<std::uint8_t>(n, 1));
  EXPECT_EQ(file, in.file());
}

TEST(Vtu, no_particles_is_a_file_too) {
  const std::string file = vtu_text({}, {{"id", 1, std::span<const std::int64_t>{}}}, 0);
  EXPECT_TRUE(array<double>(file, "Points").empty());
  EXPECT_NE(file.find("NumberOfPoints=\"0\""), std::string::npos);
}

TEST(Vtu, refuses_lengths_that_do_not_fit) {
  const std::vector<double> positions(6), four(4);
  EXPECT_THROW(vtu_text(four, {}, 0), std::invalid_argument);
  EXPECT_THROW(vtu_text(positions, {{"v", 3, four}}, 0), std::invalid_argument);
  EXPECT_NO_THROW(vtu_text(positions, {{"v", 2, four}}, 0));
}

TEST(Vtu, collection_lists_files_with_exact_times) {
  EXPECT_EQ(particles_name(7), "particles_0007.vtu");
  EXPECT_EQ(particles_name(12345), "particles_12345.vtu");
  const std::string file = pvd_text({{0, particles_name(0)}, {0.1, particles_name(1)}});
  EXPECT_NE(file.find("<DataSet timestep=\"0.1\" group=\"\" part=\"0\" file=\"particles_0001.vtu\"/>"),
            std::string::npos);
  EXPECT_NE(file.find("type=\"Collection\""), std::string::npos);
}

// The reader that users have.
TEST(Vtu, vtk_reads_it_back) {
  std::string python;  // Debian's has Debian's packages, whatever else is called python3
  for (const char* one : {"/usr/bin/python3", "python3"}) {
    const std::string probe = std::string(one) + " -c 'import vtkmodules.vtkIOXML' >/dev/null 2>&1";
    if (python.empty() && std::system(probe.c_str()) == 0) python = one;
  }
  if (python.empty()) GTEST_SKIP() << "VTK for Python is not installed (python3-vtk9)";
  const Sample in = sample();
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("assay_vtu_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "p.vtu", std::ios::binary) << in.file();
  std::ofstream(folder / "check.py") << R"py(
import sys
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
errors = []
reader.AddObserver('ErrorEvent', lambda *a: errors.append(a))
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
n = int(sys.argv[2])
assert not errors
assert grid.GetNumberOfPoints() == n and grid.GetNumberOfCells() == n
assert all(grid.GetCellType(c) == 1 for c in range(n))
data = grid.GetPointData()
assert data.GetArray('id').GetClassName() in ('vtkTypeInt64Array', 'vtkLongArray', 'vtkLongLongArray', 'vtkIdTypeArray')
assert int(data.GetArray('id').GetTuple1(3)) >= 2**53
stress = data.GetArray('stress')
assert stress.GetNumberOfComponents() == 9 and stress.GetComponentName(1) == '12'
assert stress.GetTuple(n - 1) == tuple((n - 1) + 0.1 * c for c in range(9))
for p in range(n):
    x, y, z = grid.GetPoint(p)
    assert data.GetArray('velocity').GetTuple(p) == (-y, x, 0.0) and z == 0.0
assert grid.GetFieldData().GetArray('TimeValue').GetTuple1(0) == 0.25
)py";
  const std::string command = python + " '" + (folder / "check.py").string() + "' '" + (folder / "p.vtu").string() +
                              "' " + std::to_string(in.id.size());
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace assay::drivers::test_vtu
