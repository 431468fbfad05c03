/** A road of OpenDRIVE and its parts: lanes, surface, objects, signals, links. */
package dev.eventchain.roads.road;
