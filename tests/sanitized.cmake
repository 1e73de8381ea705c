# SPDX-License-Identifier: BSD-3-Clause
# How tests are registered under the address sanitizer: many a process, for a watched program takes as long to start as
# a small test. What is left out runs nothing that others do not, and takes half a minute and more when watched; all of
# it is run by the release build.
if(NOT ASSAY_SANITIZE MATCHES "address")
  return()
endif()
# The drivers' floor, which has no loop over particles, is watched but not optimised: half of its time.
target_compile_options(assay_drivers PRIVATE -O0)

# Of each program: in how many processes, and what is left out.
set(shards_of_test_harness 8)
set(left_out_of_test_harness # searches, sheets and batteries over many models
  SymmetryClass.KnownC* Battery.NamesWhatIsPlanted* Battery.PassesSingle* BatteryInPlane.* AcousticTensor.Search*
  History.GivesUpAMotion* Disturbed.NoiseOfIncrements* Shadow.ConvergesToTheSheet* ForceError.Bounds*)

set(shards_of_test_adapters 8)
set(left_out_of_test_adapters # orders of convergence, and models whose sheets take long
  BodyForceNegativeControl.* SheetNegative* */Disguised.*tolerance J2Multiplicative.Increments* J2Multiplicative.Other*
  Models/SheetOfEvery*/hypo* Models/SheetOfEvery*/zener* Models/BodyForceOfEvery*/hypo* Models/BodyForceOfEvery*/zener*)

set(shards_of_test_mpm 16)
set(left_out_of_test_mpm # of the pairs of a basis and a transfer some, and runs of many steps
  Method/Accounts* Method/EveryPatchedMethod*consistent* Methods/Traction.HoldsToR* Sweep.Results* Space.ABall* Space.AL* Stages.A* PatchTests.CatchEvery* Stages.K*)
foreach(basis IN ITEMS linear ugimp cpgimp bspline3 bspline4)
  foreach(transfer IN ITEMS xpic fmpm apic aflip flip_usl_series)
    list(APPEND left_out_of_test_mpm "Method/*/${basis}_${transfer}*")
  endforeach()
  if(NOT basis STREQUAL "cpgimp")
    list(APPEND left_out_of_test_mpm "Method/*/${basis}_*_total")
  endif()
endforeach()

set(shards_of_test_drivers 64)
set(left_out_of_test_drivers # whole runs of full size; studies, which start the program many times; timing; a browser
  CutBodies* StudyShards.M* StudyShards.O* StudyShards.T* StudyFailures.AF* StudyFailures.AM* Clusters* CaseKey.Changes*
  Files/TornCases* StudyResume.C* StudyResume.F* StudyResume.K* StudyResume.M* Plan.* StudyJson.Host*
  Cases/EvalReferences*ring* *BoxRun.ConvergesAt* PlantedInTheBox* Interfaces/ForeignVortex* Interfaces/FaultOfAComponent* ForceInSpace* */closes_everything*
  CheckForeign.AModelOfPlaneStrainAloneRuns* CheckMethods.RunsEvery* CheckMethods.WritesJson* Check.JUnit*
  Check.AllChecks* Cached.ADamaged* Cached.EverythingThat* Cached.ASheetOfABuiltIn* ForeignModels.TwoCores* ForeignModels.AUmat*
  CheckSource.IsTaken* CheckSizeOfStress.TheWholeBattery* EndOfProcess.A* */exit_pause */destroy_deaf
  StoppedProcesses* */destroy_pause */destroy_first_pause *KilledFromOutside* */leak
  Limits/Shortage* HardLimit.OfMem* # the sanitizer itself needs more
  */UnsetMemory.*local_* # it keeps arrays of ours elsewhere than on the stack that a UMAT finds
  */exit_null */destroy_null # which the sanitizer would tell in its own words
  Frames.TheMethodErrs* Frames.BodiesOf* Frames.AMaterialWith* RimOfARun.CoarseGrids*
  Run.ACylindrically* Run.Repeats* Run.AnExpect* Run.AnUnst* Run.EveryField* Run.Square* Run.ItsFig*
  Replay.OfAH* Replay.OfAR* Screening.E* Screening.I* Screening.C* Screening.W* Tabulate.AnswersPoints* Tabulate.W* Tabulate.C* TractionTable.Holds* TractionTable.AnEntry*
  TractionTable.One* TractionTable.Paper*
  CheckSource.AFileThatIsNot* CheckSource.ADeck* CheckUndeclared.AFailure* Cached.Nothing* RelativePaths.TheSearch*
  TimeControl.Finds* CheckComponents.AModel* Run.LeavesAC* Run.AMaterialThat* Frames.ATurned* Simulation.Ugimp*
  Host.WhatMay* */CheckSymmetry.*turned_on TimeAccounts.ATab* Screening.O* ViscousShort*
  CheckForeign.ModuliOf* CheckSource.IsReg* CheckSource.IsLinked* CheckSource.ItsOwn* AroundTheSteps.WhatIsNot* Host.AVumat* Host.ACounter*
  */StressInWorkers.*of_2* CheckScope.TheL* CheckScope.AStress* Interfaces/DamagedLibrary.*native RunJUnit.ARun*
  Tabulate.AnExp* CheckSymmetryOfRings* Signals/StudySignals.*0 InputFile.AHyphen* Check.AFail* StateBlocks.ThoseThat*
  Kinds/WritingModel* CheckUndeclared.Dir* FailuresInWorkers.AChanged* Terminal.Paths* Screening.SaysN* Advice.OfAR*
  # of the kinds of misdeeds those that leave different marks on whoever looks on
  *MisbehavingModel*kills_* *MisbehavingModel*calls_xit *MisbehavingModel*traps_* *MisbehavingModel*rounds_*
  *MisbehavingModel*shortens_* *MisbehavingModel*flushes_* *MisbehavingModel*ignores_* *MisbehavingModel*exits
  *MisbehavingModel.*ByARun*closes_output
  EvalStreams.MemoryDoes* # memory that was freed is kept from use
  JudgeClocks.OfAM* MistakesOfP* Judge.CountsP* */JudgeOfRuns.*scene_9 */JudgeOfRuns.*scene_1? # runs of full size, each of minutes
  SceneReader.EveryTrunc* ReportInBrowser* EffectList.Owns* TimeNoise.Noise* ParticlePicture*)

set(shards_of_test_library 8)
set(left_out_of_test_library # a second copy of the sanitizer; most motions; workers, which start as slowly as programs
  ProgramOfWorkers* Workers.OfA* Workers.That* Workers.Whose* Workers.Try* */SameAs*plastic */SameAs*viscous
  Points.BeyondTheEnd*)

set(shards_of_test_house 0) # it reads the tree, and what it runs others run
set(shards_of_test_fuzz_corpus 8)
set(left_out_of_test_fuzz_corpus FuzzCorpus.M* FuzzCorpus.D*)
set(shards_of_test_mutants 8)

function(discover_tests target)
  list(JOIN left_out_of_${target} ":" left_out)
  if(shards_of_${target} GREATER 0)
    add_shards(${target} ${shards_of_${target}} "${left_out}")
  endif()
endfunction()
