/** The elements of a storyboard as they run: stories, acts, maneuvers, events and actions. */
package dev.eventchain.openscenario.storyboard.tree;
