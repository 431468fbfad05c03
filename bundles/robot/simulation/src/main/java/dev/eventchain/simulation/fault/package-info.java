/**
 * Faults that scenarios are also run with: their plan, its reader, and what they do to the messages
 * of the world. Does not judge what comes of them.
 */
package dev.eventchain.simulation.fault;
