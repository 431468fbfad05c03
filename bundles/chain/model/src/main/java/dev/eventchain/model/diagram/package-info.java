/**
 * The diagram of an event chain: its contents and layout, independent of the renderer (record 032).
 * The same chain with the same text sizes gives the same diagram.
 */
package dev.eventchain.model.diagram;
