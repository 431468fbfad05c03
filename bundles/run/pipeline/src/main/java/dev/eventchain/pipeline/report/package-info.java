/**
 * The report of a run as one page, with the trace from requirements to proofs. Only reads what the
 * stages made.
 */
package dev.eventchain.pipeline.report;
