// SPDX-License-Identifier: BSD-3-Clause
// The list of passes, and that what is absent costs nothing.
#include "mpm/compose.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/mass/mass_matrix.hpp"
#include "mpm/material/stress_blocks.hpp"

#include <algorithm>

#include "tests/mpm/vortex_setup.hpp"
#include "tests/support/test_materials.hpp"

namespace assay::mpm::test_compose {
namespace {

template <int Dim>
std::vector<std::string> names_of(const std::vector<Pass<Dim>>& passes) {
  std::vector<std::string> names;
  for (const auto& pass : passes) names.push_back(pass.name);
  return names;
}

/// The vortex without anything that can be left out.
Setup<2> bare(Update update = Update::usl) {
  mpm::Setup<2> setup = vortex_setup(4, {Basis::cpdi, Transfer::flip, update});
  setup.body_force = false;
  return setup;
}

Setup<2> with_everything(const Method& way) {
  mpm::Setup<2> setup = vortex_setup(4, way);
  setup.seeds.held = {{0.1, 0.1}};
  setup.hold_outside = setup.accounts = true;
  setup.material =
      std::make_shared<const Material>(test_materials::hypoelastic_table(), std::map<std::string, double>{});
  return setup;
}

using Names = std::vector<std::string>;

TEST(Compose, OrdersThePassesOfEachUpdate) {
  EXPECT_EQ(names_of(compose(bare(Update::usl))),
            (Names{"weights", "particles_to_grid", "grid_update", "grid_to_particles", "stress"}));
  EXPECT_EQ(names_of(compose(bare(Update::usf))),
            (Names{"weights", "particles_to_grid", "grid_velocity", "velocity_gradient", "stress", "grid_forces",
                   "grid_update", "grid_to_particles"}));
  EXPECT_EQ(names_of(compose(bare(Update::musl))),
            (Names{"weights", "particles_to_grid", "grid_update", "grid_to_particles", "particles_to_grid_again",
                   "grid_velocity", "velocity_gradient", "stress"}));
}

TEST(Compose, AnEffectIsAPassMoreAndNothingElse) {
  mpm::Setup<2> setup = bare();
  setup.body_force = true;
  EXPECT_EQ(names_of(compose(setup)),
            (Names{"body_force", "weights", "particles_to_grid", "grid_update", "grid_to_particles", "stress"}));
  setup.frame = Frame{0.7, 0, {0.4, -0.2, 0}};
  EXPECT_EQ(names_of(compose(setup)).size(), 6u) << "only a frame that spins has forces";
  setup.frame->spin = 1.3;
  EXPECT_EQ(names_of(compose(setup))[1], "moving_frame");
  setup.frame.reset();
  setup.accounts = setup.hold_outside = true;
  EXPECT_EQ(names_of(compose(setup)), (Names{"body_force", "weights", "particles_to_grid", "grid_update", "hold_nodes",
                                             "grid_to_particles", "accounts", "stress"}));
  setup.method.update = Update::musl;
  const Names musl = names_of(compose(setup));
  EXPECT_EQ(std::count(musl.begin(), musl.end(), "hold_nodes"), 2);  // the gradient's velocities are held too
}

TEST(Compose, NamesWhatEveryPassIsForAndWhoCalledForIt) {
  for (const Method& way : all_methods()) {
    for (const auto& pass : compose(with_everything(way))) {
      EXPECT_FALSE(pass.doc.empty()) << pass.name;
      EXPECT_FALSE(pass.called_for_by.empty()) << pass.name;
      EXPECT_TRUE(pass.bind) << pass.name;
    }
  }
}

TEST(Compose, AbsentEffectsHaveNoColumn) {
  const auto columns_in = [](const mpm::Setup<2>& setup) {
    std::vector<Column> columns;
    for (const auto& use : columns_of(compose(setup), setup)) columns.push_back(use.column);
    return columns;
  };
  const auto has = [](const std::vector<Column>& list, Column c) {
    return std::find(list.begin(), list.end(), c) != list.end();
  };
  const auto least = columns_in(bare());
  EXPECT_FALSE(has(least, Column::body_force));
  EXPECT_FALSE(has(least, Column::history));
  const auto most = columns_in(with_everything({}));
  EXPECT_TRUE(has(most, Column::body_force));
  EXPECT_TRUE(has(most, Column::history));
  for (const Column column : least) EXPECT_TRUE(has(most, column));
}

std::size_t allocated(const State<2>& s, const ColumnUse& use) {
  if (use.column == Column::history) {
    const auto* history = s.find<MaterialHistory>();
    return history ? history->begin.bytes() + history->end.bytes() : 0;
  }
  return s.columns[static_cast<std::size_t>(use.column)].bytes();
}

// To the byte: what `explain` says is what a run allocates, for every way through the method.
TEST(Compose, ColumnsAndGridTakeTheBytesThatAreTold) {
  for (const Method& way : all_methods()) {
    for (const bool everything : {false, true}) {
      mpm::Setup<2> setup = everything ? with_everything(way) : bare();
      setup.method = way;
      Simulation<2> simulation(setup);
      State<2>& s = simulation.state();
      std::array<bool, column_count> told{};
      for (const ColumnUse& use : columns_of(compose(setup), setup)) {
        told[static_cast<std::size_t>(use.column)] = true;
        if (use.column == Column::weights) continue;  // the basis states and asserts its own size
        EXPECT_EQ(allocated(s, use), use.bytes * s.particles) << info(use.column).name;
      }
      for (std::size_t k = 0; k < column_count; ++k) {
        if (told[k]) continue;
        EXPECT_TRUE(s.columns[k].empty()) << info(static_cast<Column>(k)).name;
      }
      EXPECT_EQ(s.own<MaterialHistory>().begin.empty(), !everything);
      EXPECT_EQ(s.own<Held>().nodes.empty(), !everything);
      std::size_t grid = s.inertia.bytes() + s.force.bytes() + s.motion.bytes();
      const auto& solver = s.own<SolverFields<2>>();
      for (const auto& field : solver.vectors) grid += field.bytes();
      for (const auto& copy : s.tile_copies) grid += copy.inertia.bytes() + copy.force.bytes();
      if (const int across = mass_nodes_across<2>(way)) {  // made in the first step
        grid += MassStencil<2>::entries(across) * sizeof(double) * setup.grid.nodes();
      }
      grid += (s.own<Held>().mass.size() + solver.inverse_mass.size()) * sizeof(double);
      EXPECT_EQ(grid, grid_bytes_per_node(setup) * setup.grid.nodes());
    }
  }
}

TEST(Compose, DomainsOfTheirOwnAreAColumnOfTheBasesThatHaveDomains) {
  const auto bytes = [](Basis basis, bool polar) {
    const mpm::Setup<2> setup = averaged_setup(4, polar, {basis, Transfer::flip, Update::usl});
    const Simulation<2> simulation(setup);
    for (const ColumnUse& use : columns_of(compose(setup), setup)) {
      if (use.column != Column::domain) continue;
      EXPECT_EQ(allocated(simulation.state(), use), use.bytes * setup.seeds.size());
      return use.bytes;
    }
    EXPECT_FALSE(simulation.state().has(Column::domain));
    return std::size_t{0};
  };
  EXPECT_EQ(bytes(Basis::cpdi, true), 32u);
  EXPECT_EQ(bytes(Basis::ugimp, true), 16u);
  EXPECT_EQ(bytes(Basis::linear, true), 0u);
  EXPECT_EQ(bytes(Basis::cpdi, false), 0u);
}

TEST(Compose, TheAveragedForceIsAPassThatReadsNoColumn) {
  mpm::Setup<2> setup = vortex_setup(4);
  const auto point = compose(setup).front();
  setup.evaluation = Evaluation::domain_average;
  const auto average = compose(setup).front();
  EXPECT_EQ(point.name, "body_force");
  EXPECT_EQ(average.name, "body_force");
  EXPECT_NE(point.doc, average.doc);
  EXPECT_EQ(average.called_for_by, "force.evaluation");
  EXPECT_TRUE(average.reads.empty());
  EXPECT_EQ(average.writes, (std::vector<Column>{Column::body_force}));
}

TEST(Compose, ARunProfilesThePassesThatWereComposed) {
  for (const Method& way : all_methods()) {
    const mpm::Setup<2> setup = with_everything(way);
    const Simulation<2> simulation(setup);
    Names timed;
    for (const PassTime& time : simulation.times()) timed.push_back(time.name);
    EXPECT_EQ(timed, names_of(compose(setup)));
  }
}

// Every column that a pass reads was written by the start or by a pass: none is read that nobody fills.
TEST(Compose, NothingIsReadThatNobodyWrites) {
  for (const Method& way : all_methods()) {
    const auto passes = compose(with_everything(way));
    std::vector<Column> filled{
        Column::reference_position,   Column::position, Column::velocity, Column::mass, Column::volume,
        Column::deformation_gradient, Column::stress,   Column::history};
    if (way.is_affine()) filled.push_back(affine_column(way));
    if (way.basis == Basis::cpdi2) filled.push_back(Column::corners);
    for (const auto& pass : passes) {
      for (const Column column : pass.reads) {
        EXPECT_TRUE(std::find(filled.begin(), filled.end(), column) != filled.end())
            << pass.name << " reads " << info(column).name;
      }
      filled.insert(filled.end(), pass.writes.begin(), pass.writes.end());
    }
  }
}

}  // namespace
}  // namespace assay::mpm::test_compose
