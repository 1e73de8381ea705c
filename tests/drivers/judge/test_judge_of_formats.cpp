// SPDX-License-Identifier: BSD-3-Clause
// The same particles have the same errors in every format; with fewer digits they differ by no more than these hide.
#include <gtest/gtest.h>

#ifdef ASSAY_HDF5
#include <hdf5.h>
#endif

#include <fmt/core.h>

#include "drivers/format/npz.hpp"
#include "tests/drivers/judge/planted.hpp"

namespace assay::drivers::test_judge_of_formats {
namespace {

namespace fs = std::filesystem;

constexpr double exactly = 1e-12;

/// Numbers of a frame under a name, `width` a particle.
struct Column {
  std::string name;
  std::size_t width;
  std::vector<double> values;
};

std::vector<Column> columns_of(const JudgedFrame& f) {
  std::vector<Column> all{{"id", 1, f.id}, {"X", 3, {}}, {"x", 3, {}}, {"v", 3, {}}, {"F", 9, {}}, {"sigma", 6, {}}};
  for (std::size_t p = 0; p < f.x.size(); ++p) {
    for (int d = 0; d < 3; ++d) {
      all[1].values.push_back(f.X[p][d]), all[2].values.push_back(f.x[p][d]), all[3].values.push_back(f.v[p][d]);
      for (int e = 0; e < 3; ++e) all[4].values.push_back(f.F[p](d, e));
    }
    const Tensor& s = f.sigma[p];
    all[5].values.insert(all[5].values.end(), {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)});
  }
  return all;
}

std::string npz(const std::vector<Column>& columns, double t) {
  std::vector<NpzArray> arrays;
  for (const Column& each : columns) {
    NpzArray array{each.name, {each.values.size() / each.width}, each.values};
    if (each.width > 1) array.shape.push_back(each.width);
    arrays.push_back(array);
  }
  arrays.push_back({"t", {1}, {&t, 1}});
  return npz_bytes(arrays);
}

std::string dump(const JudgedFrame& f, std::size_t step) {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: TIME\n" + fmt::format("{:.17g}", f.t) +
                     "\nITEM: NUMBER OF ATOMS\n" + std::to_string(f.x.size()) +
                     "\nITEM: BOX BOUNDS ss ss ss\n-2 2\n-2 2\n-2 2\nITEM: ATOMS id x y z vx vy vz\n";
  for (std::size_t p = 0; p < f.x.size(); ++p) {
    text += std::to_string(p + 1);
    for (const Vector3& v : {f.x[p], f.v[p]}) text += fmt::format(" {:.17g} {:.17g} {:.17g}", v[0], v[1], v[2]);
    text += "\n";
  }
  return text;
}

#ifdef ASSAY_HDF5
void write_hdf5(const std::string& file, const std::vector<JudgedFrame>& frames) {
  const hid_t out = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(out, 0);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const hid_t group = H5Gcreate2(out, ("/step_" + std::to_string(k)).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t scalar = H5Screate(H5S_SCALAR);
    const hid_t time = H5Acreate2(group, "time", H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(time, H5T_NATIVE_DOUBLE, &frames[k].t);
    H5Aclose(time), H5Sclose(scalar);
    for (const Column& each : columns_of(frames[k])) {
      const hsize_t extents[] = {each.values.size() / each.width, each.width};
      const hid_t space = H5Screate_simple(each.width > 1 ? 2 : 1, extents, nullptr);
      const hid_t data =
          H5Dcreate2(group, each.name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, each.values.data());
      H5Dclose(data), H5Sclose(space);
    }
    H5Gclose(group);
  }
  H5Fclose(out);
}
#endif

class JudgeOfFormats : public testing::Test {
 protected:
  JudgeOfFormats() { fs::create_directory(scratch_ / "run"); }
  Verdict judged(const std::string& map = {}) {
    return verdict_of(planted_.scene_file, {scratch_ / "run"}, scratch_, map);
  }
  Verdict of_text(int digits) {
    scratch_.write("run/run.csv", planted_.text({"id", "X", "x", "v", "F", "sigma"}, digits));
    return judged();
  }
  static void expect_same(const Verdict& found, const Verdict& expected, bool all_fields) {
    EXPECT_EQ(found.status, 0);
    EXPECT_NEAR(found.l2(), expected.l2(), exactly);
    for (const char* field : all_fields ? std::vector<const char*>{"velocity", "deformation_gradient", "stress"}
                                        : std::vector<const char*>{"velocity"}) {
      const double wanted = expected.run()["error"][field]["l2_max"], size = field == std::string("stress") ? 1e3 : 1;
      EXPECT_NEAR(found.run()["error"][field]["l2_max"].get<double>(), wanted, exactly * size) << field;
    }
  }
  Planted planted_;
  ScratchFolder scratch_;
};
using LongJudgeOfFormats = JudgeOfFormats;

TEST_F(LongJudgeOfFormats, TheSameNumbersHaveTheSameErrors) {
  const Verdict text = of_text(17);
  fs::remove(scratch_ / "run/run.csv");
  for (std::size_t k = 0; k < planted_.frames.size(); ++k)
    scratch_.write("run/step_" + std::to_string(k) + ".npz", npz(columns_of(planted_.frames[k]), planted_.frames[k].t));
  expect_same(judged(), text, true);
  fs::remove_all(scratch_ / "run"), fs::create_directory(scratch_ / "run");
  for (std::size_t k = 0; k < planted_.frames.size(); ++k)
    scratch_.write("run/dump." + std::to_string(7 * k), dump(planted_.frames[k], 7 * k));
  expect_same(judged("lammps"), text, false);
#ifdef ASSAY_HDF5
  fs::remove_all(scratch_ / "run"), fs::create_directory(scratch_ / "run");
  write_hdf5(scratch_ / "run/run.h5", planted_.frames);
  expect_same(judged(), text, true);
#endif
}

TEST_F(LongJudgeOfFormats, FewerDigitsHideWhatIsStated) {
  const Verdict whole = of_text(17);
  EXPECT_LT(whole.run()["rounding"].get<double>(), 1e-15);
  for (const int digits : {4, 6, 9}) {
    const Verdict found = of_text(digits);
    const double stated = found.run()["rounding"];
    EXPECT_NEAR(stated, 0.5 * std::pow(10, 1 - digits), 1e-3 * stated);  // positions are from 1 to 10
    EXPECT_LT(std::abs(found.l2() - whole.l2()), stated);
    EXPECT_TRUE(found.causes().empty());
  }
  planted_.for_each([](JudgedFrame& f) {
    for (Vector3& x : f.x) x = x.cast<float>().cast<double>();
  });
  const Verdict single = of_text(17);
  const double stated = single.run()["rounding"];
  EXPECT_GT(stated, 1e-8);
  EXPECT_LT(stated, 1e-7);
  EXPECT_LT(std::abs(single.l2() - whole.l2()), stated);
}

TEST_F(JudgeOfFormats, AnErrorThatDigitsMakeIsSaid) {
  planted_ = Planted(planted_.scene_file, 0);
  const Verdict found = of_text(5);
  EXPECT_EQ(found.status, 0);
  ASSERT_EQ(found.json["warnings"].size(), 1u);
  EXPECT_NE(found.json["warnings"][0].get<std::string>().find("Write more digits"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_judge_of_formats
