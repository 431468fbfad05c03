/**
 * Results of a simulation: verdicts of scenarios and faults, measurements and the flow of messages.
 * Knows no world, node or file.
 */
package dev.eventchain.simulation.verdict;
