/** Shapes on the ground, and their distances. */
package dev.eventchain.roads.ground;
