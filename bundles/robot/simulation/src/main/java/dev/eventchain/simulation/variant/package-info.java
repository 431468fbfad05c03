/** Variants of components: what the scenarios of a passed simulation notice of them. */
package dev.eventchain.simulation.variant;
