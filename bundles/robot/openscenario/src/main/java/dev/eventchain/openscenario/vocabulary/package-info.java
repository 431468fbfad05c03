/**
 * The vocabulary of OpenSCENARIO XML: which elements, attributes and values there are, since which
 * version, and where they may stand.
 */
package dev.eventchain.openscenario.vocabulary;
