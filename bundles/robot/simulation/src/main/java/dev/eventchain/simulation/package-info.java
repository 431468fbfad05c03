/**
 * Simulates the generated nodes of a chain in scenarios: the request, the run and its result. The
 * top layer: it connects all other rooms, and none of them knows it.
 */
package dev.eventchain.simulation;
