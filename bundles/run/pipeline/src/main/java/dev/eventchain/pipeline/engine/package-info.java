/**
 * The order of the stages: which run, which are skipped, when results of an earlier run stand or
 * are withdrawn, and the conclusion. Knows every stage, and neither evaluations nor commands.
 */
package dev.eventchain.pipeline.engine;
