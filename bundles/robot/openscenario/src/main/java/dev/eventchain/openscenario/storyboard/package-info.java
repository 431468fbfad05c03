/** Plays storyboards: which entity is where, and what happens when, step by step. */
package dev.eventchain.openscenario.storyboard;
