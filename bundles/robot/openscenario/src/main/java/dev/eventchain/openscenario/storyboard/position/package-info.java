/** The positions of the standard, and trajectories and routes made of them. */
package dev.eventchain.openscenario.storyboard.position;
