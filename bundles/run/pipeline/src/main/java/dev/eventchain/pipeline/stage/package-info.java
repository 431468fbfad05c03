/**
 * The frame of every stage: what the stages of a run share, what each one reads and makes, and the
 * memory by which an unchanged stage is skipped. Knows no particular stage.
 */
package dev.eventchain.pipeline.stage;
