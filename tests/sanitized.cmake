# SPDX-License-Identifier: BSD-3-Clause
# How tests are registered under the address sanitizer. A watched program takes as long to start as a small test, so
# many tests share a process. A change runs the suites that are named here: readers with damaged input, each product
# once at a small size, workers, libassay. The rest has the label `long`: the stage `watched` of ./dev test --deep.
if(NOT ASSAY_SANITIZE MATCHES "address")
  return()
endif()
# The drivers' floor, which has no loop over particles, is watched but not optimised: half of its time.
target_compile_options(assay_drivers PRIVATE -O0)

set(watched_by_test_harness
  GuardedArrays Largest Limit NumberArchive Keys Places DeformationTable Interpolant Chebyshev VolumeRows
  TimedHistory HistoryTask PointDriver Response Bands BandMap BandSeries Parallel PathRecipe
  MaterialTable Material MaterialFields OfferedResults Scope Diagnosis Components StabilityProbe WaveSpeed
  ControlledHistory ElasticControl Hexahedra NodalLoads ExactFields Frame Motion ReferenceOf ReferenceDomain Vortex
  StackBelow)
set(watched_by_test_adapters
  AbaqusHost AbaqusUtilities AbsentRoutines AllModels Builtin Callbacks ComponentOrder Descendants ElfSymbols EveryModel
  FencedMisdeed FencedModel FieldsOf ForeignLibrary ForeignNeoHookean ForeignState Forked GoodForeignModel GuardedArrays
  Harmless HighFiles KeptOutput KeptProcess LastLine Library MalformedBehaviour Mfront MfrontMetadata
  MissingFile NeededLibraries OtherVendors OwnFolder PlaneStressUmat Probe ProcessWatch
  RemoteTable Replay SharedMemory SpinHabit Vumat VumatBlocks WrittenInputs)
set(watched_by_test_mpm
  AntiLocking Blocks ClippedLattice Compose Corners Crew Disturb GaussLattice GridPasses Images Lattice LiveNodes
  MassPreconditioner MassStencil Massless MaterialBatches Offload OnLines ParticleOrder PatchBench PatchBenchInSpace
  PolarLattice Simulation SmallMass)
set(watched_by_test_drivers
  # scenes and what they name
  DeformationCsv Dimension Expect InitialStress KeyValues Resolved SceneCheck SceneReader Schema Settings
  Slips Vortex3dScenes RelativePaths OpenFiles
  # other files that are read
  Csv CsvFields FileKind Npy NpyRowsTest ParticleTables UnitRows YamlReader YamlWriter ZipTest HistoryFile
  MtestDamage MtestFile MtestFormula NiemunisDamage NiemunisFile PathScene PathUnits PointGrids SharedColumn
  AxesReader StudyReader CaseStoreTest CaseList PointReaderTest
  # words and numbers
  CommandLine NumberFormat Numbers Sha256 Units Unseen Words WrappedText InputBytes InputError InputFile OutputBytes
  # materials from descriptions and sources
  AbaqusDeck BadForeignKey ForeignDescription FortranAdapted FortranColumns FortranForm FortranMessages FortranRoutines
  FortranText MaterialChoices Registry SourceDescriptionTest DamagedLibraries
  # what is written
  Decks ForcePieces ForceTables Npz TableRoutines CellsInVtk ErrorsCsv Junit OutputFolderTest PointColumns PointsCsv
  Report TimeList Vtu VtuCells JsonFigure ResultFields ResultJson Verdict Canvas ColorMap Drawing LabelPlacer
  LinePlot StrokeFont Ticks SpaceDrawing StabilityMap StudyMarkdown StudyTables StudyText StudyWords WorkPrecisionPlot
  # what is computed, each once
  Compare Eval EvalColumns EvalStatic PathFields Problem Rim Seeds ErrorFigures ExactStress
  HealthWatch KeptNumbers MemoryInSpace StepClock StandardSet BinnedErrors PerturbedScene JudgeMaps BeyondWords
  CheckReport CheckText MethodsTable Analysis Comparison Recommendation Survival Plan Sampling
  Selection Budget
  Interrupt)
set(watched_by_test_library Cells Mesh Structs DamagedCalls Points Problem Arithmetic OneRounding)
set(watched_by_test_fuzz_corpus FuzzCorpus)
set(watched_by_test_mutants Sample RunFaults)
set(watched_by_test_house "") # it reads the tree, and what it runs others run

set(watched_shards_harness 4)
set(watched_shards_adapters 4)
set(watched_shards_mpm 6)
set(watched_shards_drivers 12)
set(watched_shards_library 4)
set(watched_shards_fuzz_corpus 6)
set(watched_shards_mutants 6)

function(shard_tests target)
  string(REGEX REPLACE "^test_" "" name ${target})
  if(NOT watched_by_${target})
    return()
  endif()
  set(patterns ${watched_by_${target}})
  list(TRANSFORM patterns REPLACE "(.+)" "\\1.*:*/\\1.*:\\1/*.*")
  list(JOIN patterns ":" patterns)
  add_shards(${target} ${target} ${watched_shards_${name}} "${patterns}:-${long_suites}" COST 10)
  math(EXPR count "4 * ${watched_shards_${name}}")
  add_shards(${target} ${target}/rest ${count} "-${long_suites}:${patterns}" LABELS long)
endfunction()
function(discover_tests target)
  shard_tests(${target})
endfunction()
