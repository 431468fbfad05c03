/**
 * Faults injected into scenarios: their plan, its reader, and their effect on the messages of the
 * world. Does not judge their consequences.
 */
package dev.eventchain.simulation.fault;
