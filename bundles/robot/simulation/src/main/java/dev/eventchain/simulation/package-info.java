/**
 * Drives the generated nodes in a closed loop with a vehicle on a road, judges and measures them.
 */
package dev.eventchain.simulation;
