/**
 * The report of a run as one page, with the trace from requirements to proofs. Only reads results
 * of the stages.
 */
package dev.eventchain.pipeline.report;
