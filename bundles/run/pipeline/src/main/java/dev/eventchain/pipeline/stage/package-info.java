/**
 * The framework of stages: the shared context of a run, inputs and results of stages, and the
 * memory that allows unchanged stages to be skipped. Depends on no particular stage.
 */
package dev.eventchain.pipeline.stage;
