/** Readers of the parts of an OpenDRIVE file, and the check of its links. */
package dev.eventchain.roads.reader;
