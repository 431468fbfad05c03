/**
 * The scene that conditions look at and actions change: entities in motion, parameters, variables,
 * traffic signals, and the states of the storyboard's elements.
 */
package dev.eventchain.openscenario.storyboard.scene;
