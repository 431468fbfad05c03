/**
 * Statements of a run about each requirement: its components, tests and scenarios, and a verdict.
 */
package dev.eventchain.pipeline.evidence;
