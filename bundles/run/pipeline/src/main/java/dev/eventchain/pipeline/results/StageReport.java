package dev.eventchain.pipeline.results;

/** The part of a stage in the report of a run. */
public sealed interface StageReport permits StageReport.None, Answers, Validated, Simulated {

  /** The part of a stage that has nothing to report. */
  record None() implements StageReport {}
}
