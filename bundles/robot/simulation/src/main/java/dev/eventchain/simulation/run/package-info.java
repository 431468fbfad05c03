/**
 * Drives one scenario: the bench publishes sensor data, the nodes answer, the vehicle moves. Judges
 * nothing.
 */
package dev.eventchain.simulation.run;
