// SPDX-License-Identifier: BSD-3-Clause
// 10,000 damaged calls: null pointers, wrong sizes, numbers that are none, huge counts, handles of another kind. Each
// ends with a code, a null handle, and an error that is told.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "tests/drivers/library/handles.hpp"

namespace assay::library_test::test_damaged_calls {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();

/// Some of the damages, by a number; the same in each run.
class Damage {
 public:
  explicit Damage(unsigned number) : engine_(number) {}
  std::size_t one_of(std::size_t n) { return engine_() % n; }
  bool now() { return one_of(4) == 0; }
  template <class T>
  T* pointer(T* good) {
    return now() ? nullptr : good;
  }
  double number(double good) {
    const double bad[] = {NAN, infinite, -infinite, -1, 1e300, 5e-324, -0.0};
    return now() ? bad[one_of(std::size(bad))] : good;
  }
  std::size_t count(std::size_t good) {
    const std::size_t bad[] = {0, 3, huge, huge / 2, huge / sizeof(double) + 1, std::size_t{1} << 40};
    return now() ? bad[one_of(std::size(bad))] : good;
  }
  std::uint32_t size(std::size_t good) {
    const std::uint32_t bad[] = {0, 1, 4, 8, 0xffffffff, static_cast<std::uint32_t>(good - 4)};
    return now() ? bad[one_of(std::size(bad))] : static_cast<std::uint32_t>(good);
  }
  int whole(int good) {
    const int bad[] = {0, -1, 1, 4, 7, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
    return now() ? bad[one_of(std::size(bad))] : good;
  }
  /// A handle of another kind in its place.
  template <class Handle, class Other>
  const Handle* handle(const Handle* good, const Other* other) {
    return !now() ? good : now() ? reinterpret_cast<const Handle*>(other) : nullptr;
  }

 private:
  std::mt19937 engine_;
};

class DamagedCalls : public testing::Test {
 protected:
  static constexpr std::size_t n = 3;
  void SetUp() override {
    problem_ = opened(vortex_text());
    points_ = points_at(problem_, {.9, .2, .8, .1, 1, -.3}, 2);
    assay_cells* cells = nullptr;
    assay_cells_open(problem_.get(), 1, corners_, &cells, nullptr);
    cells_.reset(cells);
    assay_mesh* mesh = nullptr;
    const assay_mesh_options options = mesh_options();
    assay_mesh_open(problem_.get(), &options, &mesh, nullptr);
    mesh_.reset(mesh);
    ASSERT_TRUE(problem_ && points_ && cells_ && mesh_);
  }
  assay_mesh_options mesh_options() const {
    return {sizeof(assay_mesh_options), ASSAY_QUADRILATERAL, 4, 1, corners_, nodes_, 0, 0};
  }

  void open_problem(Damage& d) {
    const std::string whole = vortex_text();
    const std::string text = d.now() ? whole.substr(0, d.one_of(whole.size())) : "motion: {type: vortx}";
    const char* sets[] = {"time.end=-1", nullptr};
    assay_options options = ASSAY_OPTIONS_INIT;
    options.struct_size = d.size(sizeof options);
    options.api_major = static_cast<std::uint32_t>(d.whole(1));
    options.text = d.pointer(text.c_str());
    options.scene = d.now() ? "/nowhere/scene.yaml" : nullptr;
    options.end = d.number(1);
    options.threads = d.whole(1);
    options.set_count = d.now() ? 2 : 0;
    options.sets = d.pointer(sets);
    assay_problem* made = reinterpret_cast<assay_problem*>(this);
    const bool kept = !d.now();
    told(assay_open(d.pointer(&options), kept ? &made : nullptr, error(d)), kept && made != nullptr);
    if (kept) assay_close(made);
  }
  void open_points(Damage& d) {
    double X[2 * n] = {.9, d.number(.2), .8, .1, d.number(1), -.3};
    const assay_const_field field{d.pointer(static_cast<const double*>(X)), 2, 1};
    // what is huge is refused before it is read, or cannot be had: the strides stay at one place
    const assay_const_field still{field.data, 0, 1};
    const std::size_t count = d.count(n);
    assay_points* made = nullptr;
    const bool kept = !d.now();
    told(assay_points_open(d.handle(problem_.get(), points_.get()), count > 1000 ? 0 : count, d.whole(2),
                           d.pointer(count <= n ? &field : &still), kept ? &made : nullptr, error(d)),
         made != nullptr);
    assay_points_close(made);
  }
  void evaluate(Damage& d) {
    std::vector<Fields> fields(n);
    assay_view view = view_of(fields);
    view.struct_size = d.size(sizeof view);
    view.reserved = d.now() ? 1 : 0;
    if (d.now()) view.x = {};
    const std::size_t first = d.now() ? d.count(1) : 0;
    told(
        assay_eval(d.handle(points_.get(), cells_.get()), d.number(.3), first, d.count(n), d.pointer(&view), error(d)));
  }
  void tractions(Damage& d) {
    const double N[2 * n] = {d.number(1), 0, 0, 1, 1, d.number(1)};
    double t[2 * n];
    const assay_const_field normals{d.pointer(N), 2, 1};
    const assay_field out{d.pointer(t), 2, 1};
    told(assay_tractions(d.handle(points_.get(), problem_.get()), d.number(.3), d.now() ? huge : 0, d.count(n),
                         d.pointer(&normals), d.pointer(&out), error(d)));
  }
  void cells(Damage& d) {
    double corners[8];
    for (int k = 0; k < 8; ++k) corners[k] = d.one_of(8) == 0 ? d.number(corners_[k]) : corners_[k];
    assay_cells* made = nullptr;
    const std::size_t count = d.now() ? huge : 1;
    told(assay_cells_open(d.handle(problem_.get(), mesh_.get()), count, d.pointer(static_cast<const double*>(corners)),
                          &made, error(d)),
         made != nullptr);
    assay_cells_close(made);
    double b[2], volume = 0;
    const assay_field out{d.pointer(b), 2, 1};
    told(assay_cells_eval(d.handle(cells_.get(), problem_.get()), d.number(.3), d.pointer(&out), d.pointer(&volume),
                          error(d)));
  }
  void mesh(Damage& d) {
    assay_mesh_options options = mesh_options();
    const std::int64_t nodes[4] = {0, 1, d.now() ? -1 : 2, d.now() ? std::numeric_limits<std::int64_t>::max() : 3};
    options.struct_size = d.size(sizeof options);
    options.element = d.whole(ASSAY_QUADRILATERAL);
    options.nodes = d.now() ? huge : 4;
    options.elements = d.now() ? huge : 1;
    options.X = d.pointer(options.X);
    options.connectivity = d.pointer(static_cast<const std::int64_t*>(nodes));
    options.gauss = d.whole(0);
    assay_mesh* made = nullptr;
    told(assay_mesh_open(d.handle(problem_.get(), points_.get()), d.pointer(&options), &made, error(d)),
         made != nullptr);
    assay_mesh_close(made);
    double force[8];
    const assay_field out{d.pointer(force), 2, 1};
    told(assay_nodal_loads(d.handle(mesh_.get(), cells_.get()), d.number(.3), d.pointer(&out), error(d)));
  }
  void at_current(Damage& d) {
    const double x[2 * n] = {.9, d.number(.2), .8, d.number(.1), 1, -.3};
    double X[2 * n];
    const assay_const_field at{d.pointer(x), 2, 1};
    const assay_field from{d.pointer(X), 2, 1};
    std::vector<Fields> fields(n);
    assay_view view = view_of(fields);
    view.struct_size = d.size(sizeof view);
    told(assay_at_current(d.handle(problem_.get(), mesh_.get()), d.number(.3), n, d.whole(2), d.pointer(&at),
                          d.pointer(&from), d.pointer(&view), error(d)));
  }
  void words(Damage& d) {
    char buffer[16];
    std::size_t needed = 0;
    const assay_problem* given = d.handle(problem_.get(), points_.get());
    (d.now() ? assay_describe : assay_warnings)(given, d.pointer(buffer), d.now() ? 0 : sizeof buffer,
                                                d.pointer(&needed));
    assay_facts facts = ASSAY_FACTS_INIT;
    facts.struct_size = d.size(sizeof facts);
    told(assay_get_facts(given, d.pointer(&facts), error(d)));
  }

 private:
  assay_error* error(Damage& d) {
    error_ = ASSAY_ERROR_INIT;
    error_.struct_size = d.size(sizeof error_);
    asked_ = !d.now();
    return asked_ ? &error_ : nullptr;
  }
  /// A handle is there exactly where the call is done; an error tells the code that came back.
  void told(int code, std::optional<bool> made = std::nullopt) {
    EXPECT_GE(code, ASSAY_DONE);
    EXPECT_LE(code, ASSAY_OUTSIDE);
    EXPECT_EQ(made.value_or(code == ASSAY_DONE), code == ASSAY_DONE);
    if (!asked_ || error_.struct_size < sizeof error_) return;
    EXPECT_EQ(error_.code, code);
    EXPECT_EQ(error_.message[0] == '\0', code == ASSAY_DONE);
    EXPECT_LT(strnlen(error_.message, sizeof error_.message), sizeof error_.message);
  }

  const double corners_[8] = {.8, .1, .9, .1, .9, .2, .8, .2};
  const std::int64_t nodes_[4] = {0, 1, 2, 3};
  Owned<assay_problem> problem_;
  Owned<assay_points> points_;
  Owned<assay_cells> cells_;
  Owned<assay_mesh> mesh_;
  assay_error error_ = ASSAY_ERROR_INIT;
  bool asked_ = false;
};

TEST_F(DamagedCalls, EndWithCodes) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  for (unsigned k = 0; k < 1250; ++k) {
    Damage damage(k);
    open_problem(damage), open_points(damage), evaluate(damage), tractions(damage);
    cells(damage), mesh(damage), at_current(damage), words(damage);
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace assay::library_test::test_damaged_calls
