/**
 * The picture of an event chain: what is in it and where, whatever draws it. The same chain with
 * the same sizes of texts gives the same picture.
 */
package dev.eventchain.eclipse.diagram;
