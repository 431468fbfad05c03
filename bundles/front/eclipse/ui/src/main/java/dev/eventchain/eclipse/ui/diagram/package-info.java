/** The view that draws an event chain, and its commands. */
package dev.eventchain.eclipse.ui.diagram;
