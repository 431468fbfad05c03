/** The actions of the standard: what they do to the scene at once, and to entities over time. */
package dev.eventchain.openscenario.storyboard.action;
