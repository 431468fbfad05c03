/**
 * Drives one scenario: the bench publishes what the sensors see, the nodes answer, the vehicle
 * moves. Judges nothing.
 */
package dev.eventchain.simulation.run;
