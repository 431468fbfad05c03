/**
 * Nodes before they run: the manifest of the generated nodes, their limits, and the domain of nodes
 * that run elsewhere. Knows no world and no scenario.
 */
package dev.eventchain.simulation.node;
