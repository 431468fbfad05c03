/**
 * The nodes before they run: the manifest of what was generated, their limits, and where those are
 * that others run. Knows no world and no scenario.
 */
package dev.eventchain.simulation.node;
