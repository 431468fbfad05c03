/**
 * The order of the stages: selects those that run or are skipped, keeps or withdraws results of an
 * earlier run, and draws the conclusion. Depends on every stage, but not on evaluations or
 * commands.
 */
package dev.eventchain.pipeline.engine;
