/**
 * Drives nodes on DDS, in simulated or in real time, started here or elsewhere: domains, end
 * points, deliveries and supervision. Knows no world and no scenario.
 */
package dev.eventchain.simulation.wire;
