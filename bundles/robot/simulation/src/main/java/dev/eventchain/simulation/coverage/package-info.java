/**
 * The values that messages have had in the scenarios of a project, signal by signal. Judges
 * nothing.
 */
package dev.eventchain.simulation.coverage;
