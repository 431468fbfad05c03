/**
 * Signal Temporal Logic over the trace of a scenario: signals, the parser, and the evaluation with
 * margins. Knows no bench and no scenario.
 */
package dev.eventchain.simulation.formula;
