/**
 * Measurements of runs: latencies along the chain, hops of messages, ages of inputs, silent
 * components, and the measured model. Decides no criterion.
 */
package dev.eventchain.simulation.measure;
