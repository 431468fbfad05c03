/**
 * What of a chain is simulated: its nodes, times and topics, the signals on them, and the
 * configuration that its process gets. Runs nothing.
 */
package dev.eventchain.simulation.chain;
