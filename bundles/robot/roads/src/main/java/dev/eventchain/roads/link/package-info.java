/** Lanes that are linked: their ends, and walks along them. */
package dev.eventchain.roads.link;
