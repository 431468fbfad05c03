/** The roads of OpenDRIVE as a storyboard asks for them. */
package dev.eventchain.openscenario.storyboard.network;
