/**
 * The road and everything that moves on it: the ego vehicle, its driver, the other actors,
 * contacts, and the trace. Knows no sensor, message or formula.
 */
package dev.eventchain.simulation.world;
