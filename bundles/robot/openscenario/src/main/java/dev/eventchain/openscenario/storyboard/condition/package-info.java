/** The conditions of the standard, and triggers made of them. */
package dev.eventchain.openscenario.storyboard.condition;
