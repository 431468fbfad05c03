/**
 * The simulated part of a chain: its nodes, times and topics, the signals on them, and the
 * configuration of the process. Runs nothing.
 */
package dev.eventchain.simulation.chain;
