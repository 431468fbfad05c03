/** Signals of catalogues, and the interface of the formats that they are read from. */
package dev.eventchain.catalogue.signal;
