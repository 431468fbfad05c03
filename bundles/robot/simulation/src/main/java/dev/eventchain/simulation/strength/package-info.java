/**
 * Strength of requirements: standard faults of the outputs of components, the scenarios in which
 * each is tried, and the criteria that notice it.
 */
package dev.eventchain.simulation.strength;
