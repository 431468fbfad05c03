/** Catalogues of signals, in any format that is read, and the topics that they stand for. */
package dev.eventchain.catalogue;
