/** The view that draws an event chain, and what leads to it. */
package dev.eventchain.eclipse.ui.diagram;
