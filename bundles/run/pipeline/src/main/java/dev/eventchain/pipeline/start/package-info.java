/**
 * The files of a new project. Knows no language model and no simulation: its caller says how the
 * bench is filled in.
 */
package dev.eventchain.pipeline.start;
