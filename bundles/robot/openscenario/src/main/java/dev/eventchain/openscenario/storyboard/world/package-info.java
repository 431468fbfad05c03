/**
 * World of a storyboard: poses and boxes, entities and their states, roads as far as a storyboard
 * needs them.
 */
package dev.eventchain.openscenario.storyboard.world;
