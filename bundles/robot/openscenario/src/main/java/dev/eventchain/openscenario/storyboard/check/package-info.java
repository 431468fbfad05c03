/** Checks of a scenario before its storyboard is played. */
package dev.eventchain.openscenario.storyboard.check;
