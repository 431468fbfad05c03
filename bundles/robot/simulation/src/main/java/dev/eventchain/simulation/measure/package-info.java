/**
 * Figures of runs: latencies along the chain, hops of messages, ages of inputs, silent components,
 * and the model that holds the numbers. Decides no criterion.
 */
package dev.eventchain.simulation.measure;
