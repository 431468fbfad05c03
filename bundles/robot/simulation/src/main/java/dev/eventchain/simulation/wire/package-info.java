/**
 * Runs nodes on DDS, in simulated or in real time, or meets nodes that others run: domains, end
 * points, deliveries and supervision. Knows no world and no scenario.
 */
package dev.eventchain.simulation.wire;
