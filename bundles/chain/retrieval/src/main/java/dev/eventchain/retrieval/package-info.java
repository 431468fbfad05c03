/** Retrieval of the signals of a catalogue that a function may need, by words. */
package dev.eventchain.retrieval;
