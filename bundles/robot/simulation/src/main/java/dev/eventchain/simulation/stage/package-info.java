/**
 * Scenarios in OpenSCENARIO XML on the stage of the world: their storyboard moves the actors, and
 * drives the ego until the software does.
 */
package dev.eventchain.simulation.stage;
